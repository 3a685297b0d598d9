#!/usr/bin/env bash
# Builds the programs of this folder and records their traces into traces/ with apitrace, on Mesa's
# software driver. Needs Debian's apitrace, xvfb, libgl1-mesa-dri, libgl-dev, libglu1-mesa-dev.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for program in corridor light_maps chrome; do
    g++ -std=c++20 -O1 "$program.cpp" -o "$work/$program" -lGLU -lGL -lX11
    rm -f "../$program.trace"
    LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a -s '-screen 0 1024x768x24' \
        apitrace trace -o "../$program.trace" "$work/$program"
done
ls -l ../*.trace
