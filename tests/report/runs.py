"""Runs for the tests of `ffgpu report`: a few frames of traces/corridor.trace with all that a page can show."""

import contextlib
import json
import os
import pathlib
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
CORRIDOR = ROOT / "traces" / "corridor.trace"
FFGPU = os.environ["FFGPU_BINARY"]
INTERVAL = 5000


def ffgpu(*arguments, status=0):
    """What it prints on standard error; of a failure this has to be one line."""
    done = subprocess.run([FFGPU, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode != status:
        raise AssertionError(f"{arguments}: exit status {done.returncode}: {done.stderr}")
    return done.stderr


def replay(folder, *options, frames="2-4"):
    ffgpu("replay", CORRIDOR, "-o", folder, "--frames", frames, "--timing", *options)
    return pathlib.Path(folder)


def full_run(folder, *settings):
    return replay(folder, "--draw-pixels", "--per-draw", "--heatmap", "overdraw,cycles", "--heatmap-npy", "--set",
                  f"series.interval_cycles={INTERVAL}", *settings)


@contextlib.contextmanager
def folder():
    with tempfile.TemporaryDirectory(prefix="ffgpu_report") as path:
        yield pathlib.Path(path)


def report(*arguments, output="report.html"):
    """The path of the page."""
    ffgpu("report", *arguments)
    return pathlib.Path(arguments[-1]) / output


def data_of(page):
    text = pathlib.Path(page).read_text()
    begin = text.index('id="data">') + len('id="data">')
    return json.loads(text[begin:text.index("</script>", begin)])


def stats_of(run):
    return json.loads((run / "stats.json").read_text())
