"""The gallery's page: one HTML file, pictures and sources within."""

import html
import pathlib
import re
import string

import pictures

FOLDER = pathlib.Path(__file__).resolve().parent / "page"

# Comments, strings, GL's functions and GL's tokens of an escaped C++ source, the first that matches.
TOKENS = re.compile(r"(?P<comment>//[^\n]*)|(?P<text>&quot;.*?&quot;)|(?P<call>\bglu?[A-Z]\w*)|(?P<token>\bGL_\w+)"
                    r"|(?P<key>\b(?:if|else|for|const|return|void|int|float|double|bool|struct|namespace|auto)\b)")


def highlighted(source):
    def mark(match):
        return f'<span class="{match.lastgroup}">{match.group()}</span>'
    return TOKENS.sub(mark, html.escape(source))


def number(value):
    return f"{value:,.0f}".replace(",", " ")


def hit_rate(cost):
    return "–" if cost["hit_rate"] is None else f"{100 * cost['hit_rate']:.1f} %"


def figures(technique):
    """Rows of (what, value)."""
    found, broken, cost = technique["found"], technique["broken"], technique["cost"]
    mesa = technique["mesa"]
    return [
        ("cycles", f"{number(cost['cycles'])} ({cost['cycles_per_fragment']:.1f} a fragment)"),
        ("fragments written", number(cost["fragments"])),
        ("texel reads a fragment", f"{cost['texel_reads_per_fragment']:.2f}"),
        ("texel-cache hit rate", hit_rate(cost)),
        ("memory traffic", f"{number(cost['bytes'] / 1024)} KiB, of it textures "
                           f"{number(cost['texture_bytes'] / 1024)} KiB"),
        ("error against the oracle", f"rms {found['rms']:.2f} of {technique['rms_allowed']} allowed, worst "
                                     f"{found['worst']:.1f} of {technique['worst_allowed']}, in 1/255"),
        ("why not 0", technique["reason"]),
        ("how exactly a place is known", f"{float(technique['reach']):g} pixels"),
        ("Mesa, the same program", "not installed" if mesa is None else
         f"rms {mesa['rms']:.2f}, worst {mesa['worst']:.1f}"),
        ("broken on purpose", f"{technique['mutation']}: rms {broken['rms']:.2f}, worst {broken['worst']:.1f}"),
    ]


def section(technique):
    row, title = html.escape(technique["row"]), html.escape(technique["title"])
    captions = ("drawn by ffgpu", "the formula, in double precision", f"difference × {pictures.GAIN}")
    shown = "".join(f'<figure><img src="{data}" width="320" height="240" alt="{title}: {caption}">'
                    f"<figcaption>{caption}</figcaption></figure>"
                    for data, caption in zip(technique["pictures"], captions))
    rows = "".join(f"<tr><th scope=row>{html.escape(what)}</th><td>{html.escape(value)}</td></tr>"
                   for what, value in figures(technique))
    return (f'<section id="{row}" tabindex="-1" aria-labelledby="{row}-title"><h2 id="{row}-title">'
            f'<a href="#{row}">{row}</a> {title}</h2><p class="formula">{html.escape(technique["formula"])}</p>'
            f'<div class="pictures">{shown}</div><table class="figures">{rows}</table>'
            f"<details><summary>programs/{html.escape(technique['name'])}.cpp</summary>"
            f"<pre tabindex=0><code>{highlighted(technique['source'])}</code></pre></details></section>")


def overview_row(technique):
    cost, found = technique["cost"], technique["found"]
    cells = (number(cost["cycles"]), f"{cost['cycles_per_fragment']:.1f}",
             f"{cost['texel_reads_per_fragment']:.2f}", hit_rate(cost), number(cost["bytes"] / 1024),
             f"{found['rms']:.2f}", f"{technique['broken']['rms']:.2f}")
    return (f'<tr><th scope=row><a href="#{technique["row"]}">{technique["row"]} '
            f'{html.escape(technique["title"])}</a></th>' + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>")


def write(techniques):
    template = string.Template((FOLDER / "page.html").read_text())
    held = sum(t["found"]["holds"] and not t["broken"]["holds"] for t in techniques)
    return template.substitute(
        style=(FOLDER / "page.css").read_text(),
        script=(FOLDER / "page.js").read_text(),
        held=held,
        count=len(techniques),
        overview="".join(map(overview_row, techniques)),
        sections="".join(map(section, techniques)))
