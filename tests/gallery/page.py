"""The gallery's page: one HTML file, pictures and sources within."""

import html
import math
import pathlib
import re
import string

import pictures

FOLDER = pathlib.Path(__file__).resolve().parent / "page"
COMMON = FOLDER.parents[2] / "tools" / "page" / "web" # what all pages of ffgpu share

# Comments, strings, GL's functions and GL's tokens of an escaped C++ source, the first that matches.
TOKENS = re.compile(r"(?P<comment>//[^\n]*)|(?P<text>&quot;.*?&quot;)|(?P<call>\bglu?[A-Z]\w*)|(?P<token>\bGL_\w+)"
                    r"|(?P<key>\b(?:if|else|for|const|return|void|int|float|double|bool|struct|namespace|auto)\b)")


def highlighted(source):
    def mark(match):
        return f'<span class="{match.lastgroup}">{match.group()}</span>'
    return TOKENS.sub(mark, html.escape(source))


def number(value):
    return f"{value:,.0f}".replace(",", "\u202f")


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


def chart(strip):
    """Error over price, the price on a logarithmic scale; a point a filter."""
    width, height, margin = 640, 300, 46
    prices = [math.log(t["cost"]["cycles"]) for t in strip]
    least, most = min(prices), max(prices)
    most_error = 1.1 * max(t["found"]["rms"] for t in strip)
    parts = [f'<svg viewBox="0 0 {width} {height}" role="img" aria-label="Error over cycles, a point a filter">'
             f'<path class="axis" d="M{margin} 10V{height - margin}H{width - 10}"/>'
             f'<text x="{width - 10}" y="{height - 28}" text-anchor="end">{number(math.exp(most))} cycles</text>'
             f'<text x="{margin}" y="{height - 28}">{number(math.exp(least))} cycles</text>'
             f'<text transform="translate({margin - 10} {height - margin}) rotate(-90)">rms error, up to '
             f"{most_error / 1.1:.1f}</text>"]
    labels = []
    for technique in strip:
        x = margin + 20 + (width - margin - 70) * (math.log(technique["cost"]["cycles"]) - least) / (most - least)
        y = height - margin - (height - margin - 10) * technique["found"]["rms"] / most_error
        over = any(abs(x - other[0]) < 24 and abs(y - 5 - other[1]) < 11 for other in labels)
        label = y + (14 if over else -5)
        labels.append((x, label))
        parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4"><title>{html.escape(technique["title"])}</title>'
                     f'</circle><text x="{x + 7:.1f}" y="{label:.1f}">{technique["row"]}</text>')
    return "".join(parts) + "</svg>"


def filter_section(strip):
    """Quality against cost: the same floor with one filter after the other."""
    head = "".join(f"<th scope=col>{what}</th>" for what in (
        "filter", "rms from the area average", "cycles", "texel reads a pixel", "texel-cache hits", "KiB"))
    rows = "".join(
        f'<tr><th scope=row>{t["row"]} {html.escape(t["title"])}</th><td>{t["found"]["rms"]:.2f}</td>'
        f'<td>{number(t["cost"]["cycles"])}</td><td>{t["cost"]["texel_reads_per_pixel"]:.2f}</td>'
        f'<td>{hit_rate(t["cost"])}</td><td>{number(t["cost"]["bytes"] / 1024)}</td></tr>' for t in strip)
    shown = [(f'{t["row"]} {t["title"]}', t["pictures"][0]) for t in strip]
    shown.append(("the area average, 256 points a pixel", strip[0]["pictures"][1]))
    figures_ = "".join(f'<figure><img src="{data}" width="320" height="240" alt="The floor: {html.escape(name)}">'
                       f"<figcaption>{html.escape(name)}</figcaption></figure>" for name, data in shown)
    return ('<section id="filters" tabindex="-1" aria-labelledby="filters-title"><h2 id="filters-title">'
            '<a href="#filters">Filters</a> Quality against cost</h2><p>One floor at a grazing angle, drawn with '
            "each filter; the error is the distance from the mean of each pixel's area.</p>" + chart(strip) +
            f'<div class="scroll"><table class="numbers"><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>'
            f'</div><div class="pictures">{figures_}</div><details><summary>programs/filter_strip.cpp</summary>'
            f'<pre tabindex=0><code>{highlighted(strip[0]["source"])}</code></pre></details></section>')


def write(techniques, strip):
    template = string.Template((FOLDER / "page.html").read_text())
    held = sum(t["found"]["holds"] and not t["broken"]["holds"] for t in techniques)
    return template.substitute(
        style=(COMMON / "page.css").read_text(),
        script=(COMMON / "theme.js").read_text() + (FOLDER / "page.js").read_text(),
        held=held,
        count=len(techniques),
        overview="".join(map(overview_row, techniques)),
        filters=filter_section(strip),
        sections="".join(map(section, techniques)))
