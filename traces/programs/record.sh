#!/usr/bin/env bash
# record.sh [PROGRAM ...]: builds programs of this folder, all if none is named, and records their
# traces into traces/ with apitrace, on Mesa's software driver. The program's path stands in a trace
# and is the same each time, as the calls are; only addresses may differ. Needs Debian's apitrace,
# xvfb, libgl1-mesa-dri, libgl-dev, libglu1-mesa-dev.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
work=/tmp/ffgpu_programs
rm -rf "$work" && mkdir "$work"
trap 'rm -rf "$work"' EXIT
[ $# -gt 0 ] || set -- corridor light_maps chrome tour
for program in "$@"; do
    g++ -std=c++20 -O1 "$program.cpp" -o "$work/$program" -lGLU -lGL -lX11
    rm -f "../$program.trace"
    LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a -s '-screen 0 1024x768x24' \
        setarch --addr-no-randomize apitrace trace -o "../$program.trace" "$work/$program"
done
ls -l ../*.trace
