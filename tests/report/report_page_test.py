#!/usr/bin/env python3
"""The page of `ffgpu report` in a browser: every chart is drawn, the table sorts, a draw shows its pixels, nothing is
asked of a network. Exit status 77 where there is no Chromium. With a folder as argument it leaves screenshots there."""

import json
import pathlib
import re
import sys
import unittest

import browser
import runs

DESKTOP, PHONE = {"width": 1280, "height": 900}, {"width": 390, "height": 844, "is_phone": True}

# Of each chart: how many of its canvas' pixels have a colour that a series has.
DRAWN = """[...document.querySelectorAll('.chart canvas')].map(canvas => {
  const chart = Chart.getChart(canvas), colors = chart.data.datasets.map(one => one.backgroundColor);
  const {width, height} = canvas, dots = canvas.getContext('2d').getImageData(0, 0, width, height).data;
  const wanted = new Set(colors.map(color => parseInt(color.slice(1), 16)));
  let count = 0;
  for (let i = 0; i < dots.length; i += 4)
    count += dots[i + 3] === 255 && wanted.has(dots[i] << 16 | dots[i + 1] << 8 | dots[i + 2]);
  return {title: canvas.closest('figure').querySelector('figcaption').textContent, count,
          legend: canvas.closest('figure').querySelectorAll('.keys .key').length,
          units: Object.values(chart.scales).some(scale => scale.options.title.display && scale.options.title.text)};
})"""
# Names of rows that take more room than their axis has.
CUT_LABELS = """charts.filter(one => one.options.isHorizontal).flatMap(({chart}) => {
  const {ticks, width, options} = chart.scales.y;
  chart.ctx.font = Chart.helpers.toFont(options.ticks.font).string;
  return ticks.map(tick => tick.label).filter(label => chart.ctx.measureText(label).width > width);
})"""
OVERLAY = """[...document.querySelectorAll('.over')].map(canvas => {
  const dots = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
  const counts = {w: 0, k: 0};
  for (let i = 0; i < dots.length; i += 4) {
    if (dots[i + 3] !== 0x90) continue;
    if (dots[i] > 240 && dots[i + 1] < 60) ++counts.w;
    if (dots[i] > 240 && dots[i + 1] > 160) ++counts.k;
  }
  return counts;
})"""
CELLS = """(column => [...document.querySelectorAll('#draw-table tbody tr')]
    .map(row => row.cells[column].textContent))"""
HEADS = "[...document.querySelectorAll('#draw-table thead th')].map(head => head.textContent)"


def value(text):
    digits = re.sub(r"[^0-9.\-]", "", text.replace("\u2212", "-"))
    return float(digits) if digits else 0.0


def luminance(color):
    parts = [int(part) / 255 for part in re.findall(r"\d+", color)[:3]]
    linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


class PageTest(unittest.TestCase):
    pictures = None

    @classmethod
    def setUpClass(cls):
        place = runs.folder()
        folder = place.__enter__()
        cls.addClassCleanup(place.__exit__, None, None, None)
        cls.run_folder = runs.full_run(folder / "four_ways")
        runs.ffgpu("cache", runs.CORRIDOR, "--frames", "2-2", "-o", cls.run_folder, "--line", "64")
        cls.page = runs.report(cls.run_folder)
        other = runs.full_run(folder / "one_way", "texel_cache.ways=1")
        cls.difference = runs.report(cls.run_folder, other, output="difference.html")
        cls.data = runs.data_of(cls.page)["runs"][0]
        program = browser.Browser()
        cls.browser = program.__enter__()
        cls.addClassCleanup(program.__exit__, None, None, None)

    def setUp(self):
        self.browser.complaints.clear()
        self.browser.requests.clear()

    def tearDown(self):
        # Reading canvases again and again is the test's own doing.
        self.assertEqual([one for one in self.browser.complaints if "willReadFrequently" not in one], [])
        for url in self.browser.requests:
            self.assertRegex(url, "^(file|data):")

    def open(self, page):
        """At its first frame."""
        self.browser.open(page, **DESKTOP)
        self.browser.run("select({frame: 0})")
        self.browser.settle()

    def leave(self, name):
        if self.pictures:
            self.browser.picture(pathlib.Path(self.pictures) / f"{name}.png")

    def test_every_chart_is_drawn_with_units_at_each_size_and_look(self):
        for page, charts in ((self.page, 10), (self.difference, 11)):
            for size, name in ((DESKTOP, "desktop"), (PHONE, "phone")):
                for dark in (False, True):
                    with self.subTest(page=page.name, size=name, dark=dark):
                        self.browser.open(page, dark=dark, **size)
                        drawn = self.browser.run(DRAWN)
                        self.assertEqual(len(drawn), charts)
                        for chart in drawn:
                            self.assertGreater(chart["count"], 100, chart["title"])
                            self.assertTrue(chart["units"] and chart["legend"] > 0, chart["title"])
                        self.assertLessEqual(self.browser.run("document.documentElement.scrollWidth"), size["width"])
                        self.leave(f"{page.stem}_{name}_{'dark' if dark else 'light'}")

    def test_a_run_without_heat_maps_and_draws_and_with_a_long_name_fits_a_phone(self):
        with runs.folder() as folder:
            page = runs.report(runs.replay(folder / ("M" * 200), frames="2-2"))
            self.browser.open(page, **PHONE)
            self.assertGreater(self.browser.run("document.querySelectorAll('.note').length"), 2)
            self.assertLessEqual(self.browser.run("document.documentElement.scrollWidth"), PHONE["width"])
            self.assertEqual(self.browser.run(CUT_LABELS), [])
            self.assertIn("M…M", self.browser.run("charts[0].chart.scales.y.ticks[0].label"))

    def shown(self, *folders, output="report.html", size=DESKTOP):
        """Titles of the charts, all drawn, and the text, of a page of its own, which fits the window."""
        self.browser.open(runs.report(*folders, output=output), **size)
        self.assertLessEqual(self.browser.run("document.documentElement.scrollWidth"), size["width"])
        drawn = self.browser.run(DRAWN)
        for chart in drawn:
            self.assertGreater(chart["count"], 100, chart["title"])
        return [chart["title"] for chart in drawn], self.browser.run("document.body.innerText")

    def test_curves_of_caches_that_nobody_looks_into_are_told_and_not_drawn(self):
        with runs.folder() as folder:
            run = runs.replay(folder / "run", frames="2-2")
            runs.ffgpu("cache", runs.CORRIDOR, "--frames", "2-2", "-o", run, "--line", "64", "--client", "texel,depth")
            path = run / "curves.csv"
            for client, is_drawn in (("texel", True), ("depth", False)):
                rows = [line.split(",") for line in path.read_text().splitlines()]
                reads = rows[0].index("reads")
                path.write_text("".join(",".join(row[:reads] + ["0"] * (len(row) - reads) if row[0] == client else row)
                                        + "\n" for row in rows))
                titles, text = self.shown(run)
                self.assertEqual(any("LRU" in title for title in titles), is_drawn)
                self.assertRegex(text, f"there is no curve: .*{client}, blocked")

    def test_a_run_whose_waits_were_not_reckoned_says_so_and_draws_its_cycles(self):
        with runs.folder() as folder:
            plain = runs.replay(folder / "plain", "--set", "bottlenecks.enable=false", frames="2-2")
            titles, text = self.shown(plain)
            self.assertIn("Cycles of each frame (a click shows the frame)", titles)
            self.assertFalse([title for title in titles if "waited" in title or "waits" in title])
            self.assertIn("bottlenecks.enable=false", text)
            self.assertNotIn("waited for .", text)
            titles, text = self.shown(runs.replay(folder / "other", frames="2-2"), plain, output="difference.html")
            self.assertIn("Cycles by what the machine waited for", titles)
            self.assertNotIn("waited for .", text)

    def long_run(self, folder, frames):
        """A run's statistics, as if its frame had come again and again."""
        stats = runs.stats_of(runs.replay(folder / "short", frames="2-2"))
        one = stats["frames"][0]
        stats["frames"] = [dict(one, frame=number) for number in range(frames)]
        run = folder / "long"
        run.mkdir()
        (run / "stats.json").write_text(json.dumps(stats))
        return run

    def test_a_thousand_frames_are_drawn_in_full_colour_on_a_phone(self):
        with runs.folder() as folder:
            run = self.long_run(folder, 1000)
            for folders, output in (((run,), "report.html"), ((run, run), "difference.html")):
                self.shown(*folders, output=output, size=PHONE)

    def test_many_parameters_that_differ_fit_a_phone(self):
        with runs.folder() as folder:
            pair = [runs.replay(folder / name, *options, frames="2-2") for name, options in
                    (("immediate_machine", ()), ("a_tile_based_machine", ("--config", "preset:kyro")))]
            self.shown(*pair, output="difference.html", size=PHONE)

    def test_two_runs_that_did_the_same_say_so(self):
        with runs.folder() as folder:
            run = runs.replay(folder / "run", frames="2-2")
            self.assertIn("No figure differs.", self.shown(run, run, output="difference.html")[1])

    def test_text_is_readable_in_light_and_dark(self):
        for dark in (False, True):
            self.browser.open(self.page, dark=dark, **DESKTOP)
            paper = luminance(self.browser.run("getComputedStyle(document.body).backgroundColor"))
            self.assertEqual(paper < 0.1, dark)
            for element in ("body", "caption", "a", ".keys", ".tile span"):
                ink = luminance(self.browser.run(f"getComputedStyle(document.querySelector('{element}')).color"))
                least, most = sorted((paper, ink))
                self.assertGreater((most + 0.05) / (least + 0.05), 4.5, element)
            before = self.browser.run("Chart.defaults.color")
            self.browser.run("document.getElementById('theme').click()")
            self.assertNotEqual(self.browser.run("Chart.defaults.color"), before)

    def sort_by(self, column):
        """The order that a click on the column's head leads to."""
        return self.browser.run(f"""(head => {{ head.firstChild.click(); return head.getAttribute('aria-sort'); }})(
            document.querySelectorAll('#draw-table thead th')[{column}])""")

    def test_the_table_of_draws_sorts_by_each_column(self):
        self.open(self.page)
        heads = self.browser.run(HEADS)
        is_word = self.browser.run("""[...document.querySelectorAll('#draw-table thead th')]
            .map(head => head.classList.contains('word'))""")
        self.assertEqual(len(self.data["commands"][0]["cycles"]), len(self.browser.run(f"{CELLS}(0)")))
        self.assertIn("textures", heads)
        for column, head in enumerate(heads):
            if head == "cycles":  # It is sorted by these at first, or was by another column.
                self.sort_by(heads.index("command"))
            for order in ("ascending", "descending") if is_word[column] else ("descending", "ascending"):
                self.assertEqual(self.sort_by(column), order, head)
                shown = self.browser.run(f"{CELLS}({column})")
                values = shown if is_word[column] else list(map(value, shown))
                if head != "command":
                    self.assertEqual(values, sorted(values, reverse=order == "descending"), head)
        cycles = list(map(value, self.browser.run(f"{CELLS}({heads.index('cycles')})")))
        self.assertEqual(sum(cycles), self.data["timing"]["total_cycles"][0])

    def test_the_table_of_draws_filters(self):
        self.open(self.page)
        self.browser.run("""{ const find = document.getElementById('find'); find.value = 'clear';
                              find.dispatchEvent(new Event('input')); }""")
        names = self.browser.run(f"{CELLS}(0)")
        self.assertTrue(names and all(name == "clear" for name in names))
        self.browser.run("""{ const find = document.getElementById('find'); find.value = 'no such thing';
                              find.dispatchEvent(new Event('input')); }""")
        self.assertEqual(self.browser.run(f"{CELLS}(0)"), [])

    def counts_of(self, entry):
        pixels = re.findall(r"([nkw])(\d+)", self.data["pixels"][0][entry][4])
        return {letter: sum(int(count) for kind, count in pixels if kind == letter) for letter in "wk"}

    def test_a_click_on_a_draw_shows_its_pixels_and_one_on_a_pixel_its_draw(self):
        self.open(self.page)
        draws = [entry for entry, box in enumerate(self.data["pixels"][0]) if box]
        for entry in draws[:3]:
            number = self.data["commands"][0]["draw"][entry]
            self.browser.run(f"""[...document.querySelectorAll('#draw-table .pick')]
                .find(pick => pick.textContent === 'draw {number}').closest('tr').cells[1].click()""")
            self.browser.settle()
            self.assertEqual(self.browser.run(OVERLAY), [self.counts_of(entry)])
            self.assertEqual(self.browser.run("""[...document.querySelectorAll('.pick[aria-pressed=true]')]
                .map(pick => pick.textContent)"""), [f"draw {number}"])
        self.leave("draw_picked")
        left, top, width, _, pixels = self.data["pixels"][0][draws[-1]]
        before = re.match("n(\\d+)", pixels)
        at = int(before.group(1)) if before else 0
        x, y = left + at % width + 0.5, top + at // width + 0.5
        where = self.browser.run("""(() => { const over = document.querySelector('.over');
            over.scrollIntoView({block: "center"}); const box = over.getBoundingClientRect();
            return [box.left, box.top, box.width / over.width]; })()""")
        self.browser.click(where[0] + x * where[2], where[1] + y * where[2])
        self.browser.settle()
        self.assertEqual(self.browser.run(OVERLAY), [self.counts_of(draws[-1])])

    def test_all_of_it_works_from_the_keyboard(self):
        self.open(self.page)
        self.browser.run("document.querySelector('input[type=range]').focus()")
        self.browser.key("ArrowRight")
        self.browser.settle()
        shown = self.browser.run("document.querySelector('#frames figcaption').textContent")
        self.assertTrue(shown.startswith(f"Frame {self.data['frames'][1]['frame']},"), shown)
        self.browser.run("document.querySelector('#draw-table .pick').focus()")
        self.browser.key("Enter")
        self.browser.settle()
        self.assertEqual(self.browser.run("document.querySelectorAll('.pick[aria-pressed=true]').length"), 1)
        self.browser.run("document.querySelector('input[type=radio]:checked').focus()")
        before = self.browser.run("document.querySelector('.picture').ariaLabel")
        self.browser.key("ArrowRight")
        self.browser.settle()
        self.assertNotEqual(self.browser.run("document.querySelector('.picture').ariaLabel"), before)
        self.assertFalse(self.browser.run("document.querySelector('.legend').hidden"))

    def test_a_screen_reader_finds_names_headings_and_descriptions(self):
        for page in (self.page, self.difference):
            self.open(page)
            nodes = self.browser.call("Accessibility.getFullAXTree")["nodes"]
            roles = {"button", "link", "slider", "combobox", "searchbox", "radio", "image", "img", "columnheader"}
            named = [(node["role"]["value"], node.get("name", {}).get("value", "")) for node in nodes
                     if not node["ignored"] and node["role"]["value"] in roles]
            self.assertEqual([role for role, name in named if not name.strip()], [])
            self.assertLessEqual({"button", "link", "slider", "combobox", "searchbox", "radio"},
                                 {role for role, _ in named})
            levels = self.browser.run("[...document.querySelectorAll('h1, h2, h3')].map(one => one.tagName)")
            self.assertEqual((levels[0], levels.count("H1")), ("H1", 1))
            self.assertEqual(self.browser.run("""[...document.querySelectorAll('canvas')].filter(canvas =>
                !canvas.ariaLabel && canvas.ariaHidden !== 'true' && !canvas.hidden).length"""), 0)

    def test_the_numbers_of_a_chart_are_there_as_a_table(self):
        self.open(self.page)
        self.browser.run("document.querySelector('.chart details').open = true")
        self.browser.settle()
        cells = self.browser.run("""[...document.querySelectorAll('#summary .chart details td')]
            .map(cell => cell.textContent)""")
        self.assertEqual(sum(map(value, cells)), sum(self.data["timing"]["total_cycles"]))

    def test_the_chart_of_bytes_shows_what_each_client_read_and_wrote(self):
        self.open(self.page)
        rows = self.browser.run("""(() => { const figure = [...document.querySelectorAll('.chart')]
            .find(one => one.querySelector('figcaption').textContent === 'Bytes by client');
            const chart = Chart.getChart(figure.querySelector('canvas'));
            return chart.data.datasets.map(set => [set.label, chart.data.labels.map((label, i) => [label, set.data[i]])]); })()""")
        timing = self.data["timing"]
        for name, values in rows:
            for label, shown in values:
                counter = f"memory_{label.replace(' ', '_')}_{name}_bytes"
                self.assertEqual(shown, sum(timing[counter]), counter)
        self.assertEqual(sorted(name for name, _ in rows), ["read", "written"])

    def test_two_runs_show_the_parameter_and_effects_by_size(self):
        self.open(self.difference)
        self.assertEqual(self.browser.run("""[...document.querySelectorAll('#parameters tbody tr')]
            .map(row => [...row.cells].map(cell => cell.textContent))"""), [["texel_cache.ways", "4", "1"]])
        effects = self.browser.run("""[...document.querySelectorAll('#effects tbody tr')]
            .map(row => row.cells[1].textContent)""")
        sizes = [abs(value(effect)) for effect in effects]
        self.assertGreater(len(sizes), 5)
        self.assertEqual(sizes, sorted(sizes, reverse=True))


if __name__ == "__main__":
    if not browser.find_program():
        print("skipped: Chromium is not installed")
        sys.exit(77)
    if len(sys.argv) > 1 and not sys.argv[1].startswith("-"):
        PageTest.pictures = sys.argv.pop(1)
    unittest.main()
