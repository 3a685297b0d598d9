#!/usr/bin/env python3
"""Frame times of two builds, measured in turn in one run.

    tests/benchmarks/compare_builds.py OLD NEW [--workloads DIR] [--pairs N] [--traces A,B] [--seconds S]

OLD and NEW are build folders. Each trace's last frame is repeated for about S seconds by one build, then
by the other, N times. Time is the processor's, on one thread: of a long run less a short one, so that
start-up and the frames before fall out. Printed: the best time of each, their ratio, and the least, middle
and greatest ratio of a pair. A ratio below 1 is a gain.
"""
import argparse
import glob
import os
import resource
import statistics
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def processor_seconds(build, trace, loops):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    command = [os.path.join(build, "tools", "ffgpu"), "replay", trace, "--threads", "1", "--benchmark", str(loops)]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        sys.exit(done.stderr.strip())
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return (after.ru_utime + after.ru_stime) - (before.ru_utime + before.ru_stime)


def loops_for(build, trace, seconds):
    """How often the frame is repeated in that time."""
    few = 5
    start = processor_seconds(build, trace, 1)
    while True:
        spent = processor_seconds(build, trace, few) - start
        if spent > seconds / 5:
            return max(few, round(few * seconds / spent))
        few *= 4


def frame_milliseconds(build, trace, loops):
    short = processor_seconds(build, trace, 1)
    return 1000 * (processor_seconds(build, trace, loops + 1) - short) / loops


def compare(old, new, trace, options):
    loops = loops_for(new, trace, options.seconds)
    pairs = [(frame_milliseconds(old, trace, loops), frame_milliseconds(new, trace, loops))
             for _ in range(options.pairs)]
    best_old, best_new = (min(times) for times in zip(*pairs))
    ratios = sorted(of_new / of_old for of_old, of_new in pairs)
    print(f"{os.path.basename(trace)[:-6]:16s} {best_old:9.3f} {best_new:9.3f} {best_new / best_old:7.3f}"
          f"   {ratios[0]:.3f} {statistics.median(ratios):.3f} {ratios[-1]:.3f}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("--workloads", default=os.path.join(ROOT, "traces"), help="folder of traces")
    parser.add_argument("--traces", help="names, with commas between; all if not given")
    parser.add_argument("--pairs", type=int, default=5)
    parser.add_argument("--seconds", type=float, default=1.0)
    options = parser.parse_args()
    traces = sorted(glob.glob(os.path.join(options.workloads, "*.trace")))
    if options.traces:
        names = options.traces.split(",")
        traces = [trace for trace in traces if os.path.basename(trace)[:-6] in names]
    if not traces:
        sys.exit(f"no traces in {options.workloads}")
    print(f"{'trace':16s} {'old ms':>9s} {'new ms':>9s} {'best':>7s}   pairs: least, middle, greatest")
    for trace in traces:
        compare(options.old, options.new, trace, options)


main()
