#!/usr/bin/env python3
"""gallery.py [--build DIR] [-o DIR]: draws every program of the gallery on ffgpu with the timing model and on
Mesa, compares each picture with its oracle, and writes DIR/gallery.html, one page that needs nothing else."""

import argparse
import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys

import page
import pictures

LONGEST = 240  # seconds that any one program may take
ROOT = pathlib.Path(__file__).resolve().parents[2]
FIELDS = ("row", "name", "title", "formula", "reason", "mutation", "reach", "worst_allowed", "rms_allowed",
          "supersampling")


def output_of(*command, **options):
    return subprocess.run([str(part) for part in command], check=True, stdout=subprocess.PIPE, text=True,
                          timeout=LONGEST, **options).stdout


class XServer:
    """An X server of our own, without a screen that anybody sees."""

    def __enter__(self):
        readable, writable = os.pipe()
        self.process = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writable), "-screen", "0", "640x480x24", "-noreset", "-nolisten", "tcp"],
            pass_fds=[writable], stderr=subprocess.DEVNULL)
        os.close(writable)
        with os.fdopen(readable) as number:
            return ":" + number.readline().strip()

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()


def measured(line):
    """What gallery_offscreen prints of a picture against its oracle."""
    row, name, worst, rms, rms_at_centres, place, verdict = line.split("\t")
    return {"row": row, "name": name, "worst": float(worst), "rms": float(rms),
            "rms_at_centres": float(rms_at_centres), "place": place, "holds": verdict == "holds"}


def costs(stats):
    """The figures of the page from stats.json (docs/stats.md)."""
    functional, timing = stats["totals"]["functional"], stats["totals"]["timing"]
    fragments = max(functional["fragments_written"], 1)
    accesses = timing["texel_cache_accesses"]
    traffic = sum(value for key, value in timing.items()
                  if key.startswith("memory_") and key.endswith(("_read_bytes", "_written_bytes")))
    return {"cycles": timing["total_cycles"],
            "fragments": functional["fragments_written"],
            "cycles_per_fragment": timing["total_cycles"] / fragments,
            "texel_reads_per_fragment": timing["texture_texel_reads"] / fragments,
            "texel_reads_per_pixel": timing["texture_texel_reads"] / stats["totals"]["pixels"],
            "hit_rate": timing["texel_cache_hits"] / accesses if accesses else None,
            "bytes": traffic,
            "texture_bytes": timing["memory_texture_read_bytes"]}


class Gallery:
    def __init__(self, build, folder):
        programs = build / "tests" / "gallery"
        self.offscreen, self.window = programs / "gallery_offscreen", programs / "gallery_window"
        self.ffgpu, self.folder = build / "tools" / "ffgpu", folder

    def techniques(self):
        lines = output_of(self.offscreen, "--list").splitlines()
        return [dict(zip(FIELDS, line.split("\t"))) for line in lines]

    def on_oracles(self, *arguments):
        lines = output_of(self.offscreen, *arguments).splitlines()
        return {found["name"]: found for found in map(measured, lines)}

    def timed(self, name, supersampling, display):
        """Through GLX, with the timing model; the picture must be the one drawn off-screen."""
        folder = self.folder / "timed" / name
        environment = dict(os.environ, DISPLAY=display)
        output_of(self.ffgpu, "run", "-o", folder, "--timing", "--set", f"gpu.supersampling={supersampling}",
                  "--", self.window, name, env=environment, stderr=subprocess.DEVNULL)
        windowed = pictures.read_png(folder / "frame_0000.png")
        if windowed != pictures.read_ppm(self.folder / "pictures" / f"{name}.ppm"):
            raise RuntimeError(f"{name}: the window's picture is not the one drawn off-screen")
        return costs(json.loads((folder / "stats.json").read_text()))

    def on_mesa(self, name, display):
        """The same program on the system's libGL, against the same oracle; nothing where there is none."""
        picture = self.folder / "mesa" / f"{name}.ppm"
        picture.parent.mkdir(parents=True, exist_ok=True)
        environment = dict(os.environ, DISPLAY=display, LIBGL_ALWAYS_SOFTWARE="1")
        done = subprocess.run([self.window, name, "-o", picture], env=environment, stderr=subprocess.DEVNULL)
        if done.returncode != 0:
            return None
        return measured(output_of(self.offscreen, "--compare", picture, name).strip())

    def collect(self):
        """Everything that the page tells of each technique, and of each filter of the strip."""
        found = self.on_oracles("-o", self.folder / "pictures")
        broken = self.on_oracles("--break")
        techniques = self.techniques()
        with XServer() as display, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            timed = pool.map(lambda t: self.timed(t["name"], t["supersampling"], display), techniques)
            mesa = pool.map(lambda t: self.on_mesa(t["name"], display), techniques)
            for technique, cost, witness in zip(techniques, timed, mesa):
                technique.update(found=found[technique["name"]], broken=broken.get(technique["name"]), cost=cost,
                                 mesa=witness)
                print(f"{technique['row']:4} {technique['name']:28} {cost['cycles']:9} cycles, rms "
                      f"{technique['found']['rms']:.2f}", flush=True)
        for technique in techniques:
            base = self.folder / "pictures" / technique["name"]
            drawn = pictures.read_ppm(f"{base}.ppm")
            oracle = pictures.read_ppm(f"{base}_oracle.ppm")
            technique["pictures"] = [pictures.png(drawn), pictures.png(oracle),
                                     pictures.png(pictures.difference(drawn, oracle))]
            name = "filter_strip" if technique["row"].startswith("F") else technique["name"]
            technique["source"] = (ROOT / "tests" / "gallery" / "programs" / f"{name}.cpp").read_text()
        return ([t for t in techniques if t["row"].startswith("T")],
                [t for t in techniques if t["row"].startswith("F")])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build")
    parser.add_argument("-o", dest="folder", type=pathlib.Path, default=ROOT / "out" / "gallery")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    techniques, strip = Gallery(arguments.build.resolve(), arguments.folder.resolve()).collect()
    path = arguments.folder / "gallery.html"
    path.write_text(page.write(techniques, strip))
    failed = [t["row"] for t in techniques if not t["found"]["holds"] or t["broken"]["holds"]]
    print(f"{path}: {len(techniques)} techniques, {path.stat().st_size / 1e6:.1f} MB; "
          f"{'all hold' if not failed else 'failed: ' + ' '.join(failed)}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
