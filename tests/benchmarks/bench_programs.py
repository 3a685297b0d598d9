"""What bench.py measures of whole programs: frames of live ones beside Mesa's, what it costs to record, how soon and in
how little memory the command starts, and what a replay holds."""
import os
import re
import shutil
import statistics
import subprocess
import tempfile

HACKS = "/usr/libexec/xscreensaver"
# Programs of OpenGL 1 that draw as fast as they can; those that are not installed are left out.
PROGRAMS = [["glxgears"]] + [[os.path.join(HACKS, name), "-delay", "0"] for name in
                             ("gears", "superquadrics", "morph3d", "stonerview", "atunnel", "sierpinski3d", "pipes")]
SWAPS = re.compile(r"swap_rate: (\d+) frames, ([\d.]+) s of the clock, ([\d.]+) s of the processor")


def live_rate(command, environment, preload, of_processor):
    """Frames a second of a live program; None where it does not draw."""
    environment = dict(environment, LD_PRELOAD=preload, FFGPU_SWAP_SECONDS="1")
    try:
        out = subprocess.run(command, env=environment, capture_output=True, text=True, errors="replace", timeout=30)
    except subprocess.TimeoutExpired:
        return None
    found = SWAPS.search(out.stderr)
    return int(found[1]) / float(found[3 if of_processor else 2]) if found else None


def bench_live(options, display, mesa_environment, cell, spread):
    of_processor = options.threads == 1
    preload = os.path.join(options.build, "tests", "benchmarks", "libswap_rate.so")
    mesas = dict(mesa_environment("llvmpipe", options.threads), DISPLAY=display)
    print(f"\nFrames a second of live programs in their windows, {options.threads} thread(s), "
          f"{'processor' if of_processor else 'wall'} time,")
    print(f"middle of {options.rounds} rounds in which each takes its turn. Ratios: least, middle, greatest of the rounds.")
    print(f"{'program':16s}{'ffgpu':>9s}{'llvmpipe':>9s}{'/ llvmpipe':>22s}")
    medians = []
    with tempfile.TemporaryDirectory() as folder:
        ours = [options.ffgpu, "run", "-o", folder, "--no-images", "--threads", str(options.threads), "--"]
        for program in PROGRAMS:
            if not shutil.which(program[0]):
                continue
            rounds = [(live_rate(ours + program, dict(os.environ, DISPLAY=display), preload, of_processor),
                       live_rate(program, mesas, preload, of_processor)) for _ in range(options.rounds)]
            rounds = [pair for pair in rounds if all(pair)]
            ratios = [a / b for a, b in rounds]
            middles = [statistics.median(rates) for rates in zip(*rounds)] or [None, None]
            medians += [statistics.median(ratios)] if ratios else []
            print(f"{os.path.basename(program[0]):16s}{cell(middles[0])}{cell(middles[1])}{spread(ratios)}", flush=True)
    if medians:
        print(f"median {statistics.median(medians):.2f} x llvmpipe, least {min(medians):.2f} x")


def processor_seconds(command):
    """None where it fails."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return None if process.returncode else used.ru_utime + used.ru_stime


def resident_megabytes(command):
    """At most. By GNU time: what Python starts is said to hold what Python held."""
    out = subprocess.run(["/usr/bin/time", "-f", "%M", *command], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    return None if out.returncode else int(out.stderr.split()[-1]) / 1024


def ratios_of(first, second, rounds):
    """Processor time of the second command over that of the first, a ratio a round.

    A round is a burst in which they run in turn until they have taken a second: the least of the one over
    the least of the other, as what takes some milliseconds differs by half from run to run.
    """
    ratios = []
    for _ in range(rounds):
        burst = []
        while sum(map(sum, burst)) < 1:
            pair = processor_seconds(first), processor_seconds(second)
            if not all(pair):
                return []
            burst.append(pair)
        ones, others = zip(*burst)
        ratios.append(min(others) / min(ones))
    return ratios


def spread(ratios):
    return f"{min(ratios):6.2f} {statistics.median(ratios):6.2f}x{max(ratios):7.2f}"


def bench_recording(options, traces):
    """Frames drawn with their work recorded, for nobody and in a file, beside the same without."""
    print("\nRecording: processor time of drawing on one thread with its work recorded, over that of drawing alone: the")
    print("stream itself, which nobody reads, and a whole replay without pictures that saves it (--save-work). Least,")
    print(f"middle, greatest of {options.rounds} rounds; megabytes of the file.")
    stream = os.path.join(options.build, "tests", "benchmarks", "work_stream")
    with tempfile.TemporaryDirectory() as folder:
        work = os.path.join(folder, "work.ffw")
        replay = ["replay", "--threads", "1", "--no-images", "-o", folder]
        for trace in traces:
            alone = ratios_of([stream, "draw", trace], [stream, "record", trace], options.rounds)
            saved = ratios_of([options.ffgpu, *replay, trace], [options.ffgpu, *replay, trace, "--save-work", work],
                              options.rounds)
            if alone and saved:
                print(f"{os.path.basename(trace)[:-6]:16s}{spread(alone)}   {spread(saved)}"
                      f" {os.path.getsize(work) / 1e6:9.1f} MB", flush=True)


def bench_start(options, traces):
    help_text = [options.ffgpu, "--help"]
    seconds = [processor_seconds(help_text) for _ in range(20)]
    print(f"\nffgpu --help: {1000 * min(seconds):.0f} ms of the processor at best, "
          f"{1000 * statistics.median(seconds):.0f} in the middle of {len(seconds)} runs", end="")
    if not os.path.exists("/usr/bin/time"):
        print("; no memory without GNU time")
        return
    print(f", {resident_megabytes(help_text):.1f} MB")
    print("Resident megabytes of a replay without pictures, at most:")
    for trace in traces:
        drawn = [options.ffgpu, "replay", trace, "--no-images", "--threads", str(options.threads), "--benchmark", "1"]
        megabytes = resident_megabytes(drawn)
        if megabytes:
            print(f"{os.path.basename(trace)[:-6]:16s}{megabytes:9.1f}", flush=True)
