#!/usr/bin/env python3
"""make.py [--ffgpu PROGRAM] [--check]: draws traces/tour.trace, and writes the pictures of these pages and their figures
anew. With --check it writes nothing, and fails where a page or a picture is another."""

import argparse
import pathlib
import sys
import tempfile

import stages_back
import stages_front
from canvas import Canvas
from scene import Scene

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
STAGES = [
    ("scene", stages_front.scene_as_a_whole),
    ("vertex_fetch", stages_front.vertex_fetch),
    ("transform_and_lighting", stages_front.transform_and_lighting),
    ("clipping", stages_front.clipping),
    ("triangle_set_up", stages_front.triangle_set_up),
    ("coverage", stages_front.coverage),
    ("interpolation", stages_front.interpolation),
    ("early_depth", stages_front.early_depth),
    ("level_of_detail", stages_back.level_of_detail),
    ("texel_cache", stages_back.texel_cache),
    ("filtering", stages_back.filtering),
    ("environments", stages_back.environments),
    ("fog", stages_back.fog),
    ("alpha_test", stages_back.alpha_test),
    ("stencil_and_depth", stages_back.stencil_and_depth),
    ("blend", stages_back.blend),
    ("scan_out", stages_back.scan_out),
]
BEGIN, END = "<!-- written by ./dev pipeline_pictures -->\n", "<!-- end -->\n"


def block(rows, example):
    """What a page holds between its marks. A worked example is text of ffgpu's, or a table."""
    lines = ["| of the scene's frame | |", "|---|---:|"]
    lines += [f"| {what} | {value:,} |" if isinstance(value, int) else f"| {what} | {value} |"
              for what, value in rows]
    text = "\n".join(lines) + "\n" if rows else ""
    if example:
        text += ("\n" if rows else "") + (example if example.startswith("|") else f"```\n{example}\n```\n")
    return text


def with_block(page, text):
    """The page with the text between its marks."""
    head, rest = page.split(BEGIN)
    return head + BEGIN + text + END + rest.split(END)[1]


def is_held(path, picture):
    if not path.exists():
        return False
    held = Canvas.read(path)
    return (held.width, held.pixels()) == (picture.width, picture.pixels())


def make(scene, check):
    """Names of what was not as it has to be; it is written, unless only checked."""
    stale = []
    for name, stage in STAGES:
        picture, rows, example = stage(scene)
        path = HERE / "pictures" / f"{name}.png"
        page = HERE / ("README.md" if name == "scene" else f"{name}.md")
        if not is_held(path, picture):
            stale.append(path.name)
            if not check:
                path.write_bytes(picture.png())
        text = page.read_text()
        renewed = with_block(text, block(rows, example))
        if renewed != text:
            stale.append(page.name)
            if not check:
                page.write_text(renewed)
    return stale


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--ffgpu", type=pathlib.Path, default=ROOT / "build" / "tools" / "ffgpu")
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        scene = Scene(arguments.ffgpu.resolve(), ROOT / "traces" / "tour.trace",
                      pathlib.Path(folder))
        stale = make(scene, arguments.check)
    if arguments.check and stale:
        print("docs/pipeline is not what ffgpu draws: " + ", ".join(stale) +
              "; look at the pictures after ./dev pipeline_pictures")
        return 1
    print(f"docs/pipeline: {len(STAGES)} pages, " + (f"new: {', '.join(stale)}" if stale else "as they were"))
    return 0


if __name__ == "__main__":
    sys.exit(main())
