"""Makes mutants of SystemVerilog files: many in one file, one of which is chosen when it runs.

A statement's right-hand side, a condition or a port's expression e becomes
    (M == 7 ? (mutated e) : M == 9 ? (...) : (e))
with M a number that the test program is given. So a unit is built once for all its mutants.
"""
import re

Variable = "ffgpu_rtl_mutant"
Chosen = f'$c32("[]{{extern int {Variable}; return {Variable};}}()")'

# kind, pattern, replacements: each replacement of each place is a mutant.
Rules = [
    ("comparison", r"(?<![<>=!])<=?(?![<=])|(?<![<>=\-])>=?(?![>=])", {
        "<": ["<=", ">"], ">": [">=", "<"], ">=": [">", "<"], "<=": ["<", ">"]}),
    ("comparison", r"[=!]=(?!=)", {"==": ["!="], "!=": ["=="]}),
    ("operator", r"(?<![+])\+(?![+:])", {"+": ["-"]}),
    # Of a selection's bound alone not: what is outside of a vector every reader refuses.
    ("operator", r"(?<![-])-(?![->:]|1:)", {"-": ["+"]}),
    ("operator", r"&&|\|\|", {"&&": ["||"], "||": ["&&"]}),
    ("operator", r"(?<![&])&(?![&])|(?<![|])\|(?![|])", {"&": ["|"], "|": ["&"]}),
    ("operator", r"\^", {"^": ["|"]}),
    ("operator", r"!(?![=])|~", {"!": [""], "~": [""]}),
    ("width", r"<<<?|>>>?", {"<<": [">>"], ">>": ["<<"], "<<<": [">>>"], ">>>": ["<<<"]}),
]


def mutate_constants(text):
    """Sized constants: one more, one less, and without their highest bit."""
    for match in re.finditer(r"(\d+)'([bdh])([0-9a-fA-F_]+)", text):
        width, base, digits = int(match[1]), match[2], match[3].replace("_", "")
        value = int(digits, {"b": 2, "d": 10, "h": 16}[base])
        kind = "rounding" if value and value & (value - 1) == 0 and width > 4 else "constant"
        for other in {value + 1, value - 1, value ^ (1 << max(value.bit_length() - 1, 0))}:
            if 0 <= other < 1 << width and other != value:
                yield kind, match.start(), match.end(), f"{width}'d{other}"


def mutate_slices(text):
    """Bit selections one place off."""
    for match in re.finditer(r"\[(\d+):(\d+)\]", text):
        high, low = int(match[1]), int(match[2])
        if low > 0:
            yield "width", match.start(), match.end(), f"[{high - 1}:{low - 1}]"
        elif high > low:
            yield "width", match.start(), match.end(), f"[{high}:{low}] & ~{high + 1 - low}'d1"


def mutate_state(text):
    """The other draw's registers, or one draw's for both."""
    for match in re.finditer(r"(\w+\.tag|in_data_i\.tag) \? state_1_i : state_0_i", text):
        for bank in ("state_0_i", "state_1_i"):
            yield "stale state", match.start(), match.end(), bank


def mutate_lanes(text):
    """Another lane's, channel's or unit's bits; bits of the number itself stay."""
    for match in re.finditer(r"(?<!\.)\b(lane|channel|pair|unit)\b(?!\[)", text):
        for other in (f"(0 * {match[1]})", f"({match[1]} ^ 1)"):
            yield "lane", match.start(), match.end(), other


def mutate_value(text):
    """All bits inverted, or none set."""
    if not re.fullmatch(r"\s*[\w']+\s*", text):
        yield "value", 0, len(text), f"~({text})"
    if re.fullmatch(r"\s*\w+_[dq]?\s*|\s*[a-z]\w+\s*", text):
        yield "value", 0, len(text), f"~{text.strip()}"


def mutants_of(expression):
    """(kind, mutated expression) for each mutant of an expression."""
    places = []
    for kind, pattern, replacements in Rules:
        for match in re.finditer(pattern, expression):
            places += [(kind, match.start(), match.end(), new) for new in replacements[match[0]]]
    for source in (mutate_constants, mutate_slices, mutate_state, mutate_lanes, mutate_value):
        places += list(source(expression))
    if re.fullmatch(r"\s*in_valid_i\s*", expression):
        places.append(("dropped valid", 0, len(expression), "in_valid_i && !out_valid_o"))
    for kind, start, end, new in places:
        yield kind, expression[:start] + new + expression[end:]


Statement = re.compile(
    r"(?P<head>^\s*(?:assign\s+[\w.\[\]{}:+*\-/%, ()']+?\s=\s|"      # continuous
    r"[\w.\[\]{}:+*\-/%, ()']+?\s<?=\s|"                            # procedural
    r"(?:default|[\w:,\s']+?):\s*[\w.\[\]{}:+*\-/%, ()']+?\s=\s|"   # of a case
    r"(?:end else )?if \(|\.\w+\s*\())"
    r"(?P<body>[^;]*?)(?P<tail>;|\) begin\n|\),?\n)", re.M)


def is_expression(text):
    return text.strip() != "" and text.count("(") == text.count(")") and text.count("{") == text.count("}")


def schemata(text, first, keep):
    """The file with its mutants, numbered from `first`, of those that keep(kind, line) lets in; and
    what each is: (number, line, kind, from, to)."""
    made, out, at = [], [], 0
    number = first
    for match in Statement.finditer(text):
        head, body = match["head"], match["body"]
        line = text.count("\n", 0, match.start("body")) + 1
        before = text.rfind("\n", 0, match.start("body")) + 1
        skipped = ("localparam", "for (", "parameter", "typedef", "//", "genvar", ".Width", ".Most",
                   ".Pairs", ".Channel", ".Stage", ".QuotientBits", "clk_i", "rst_ni", "if (Stage",
                   ".Lane", ".Element", ".Axis", ".Depth", ".SetBits", ".WayBits", ".NumberWidth",
                   ".FillBits", ".LineBits",
                   "if (side", "MostInside")
        is_output = re.search(r"\.\w+_o\s*\($", head)
        if is_output or any(word in text[before:match.end()] for word in skipped):
            continue
        if not is_expression(body):
            continue
        choices = ""
        for kind, mutated in mutants_of(body):
            if not keep(kind, line):
                continue
            choices += f"({Chosen} == {number}) ? ({mutated.strip()}) : "
            made.append((number, line, kind, " ".join(body.split()), " ".join(mutated.split())))
            number += 1
        if choices:
            out.append(text[at:match.start("body")] + f"({choices}({body.strip()}))")
            at = match.end("body")
    return "".join(out) + text[at:], made
