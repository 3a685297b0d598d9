#!/usr/bin/env python3
"""Makes docs/pictures/report.png anew: the page of a run, a draw picked, in headless Chromium.

    FFGPU_BINARY=build/tools/ffgpu docs/pictures/report_page.py"""

import pathlib
import sys

from PIL import Image

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "tests" / "report"))
import browser  # noqa: E402
import runs  # noqa: E402

WIDTH, HEIGHT = 1000, 1500

with runs.folder() as folder, browser.Browser() as page:
    run = runs.replay(folder / "corridor", "--per-draw", "--draw-pixels", "--heatmap", "overdraw,level,cycles",
                      "--set", "series.interval_cycles=2000", frames="1-6")
    page.open(runs.report(run), WIDTH, HEIGHT)
    page.run("select({frame: 3, entry: first.commands[3].pieces.findLastIndex(count => count > 0)})")
    page.run("document.querySelector('nav').style.position = 'static'")
    page.settle()
    page.picture(folder / "page.png")
    picture = Image.open(folder / "page.png").convert("RGB").crop((0, 0, WIDTH, HEIGHT))
    picture.save(HERE / "report.png", optimize=True)
