#!/usr/bin/env bash
# record.sh BUILD [NAME ...]: records the programs of the gallery, all if none is named, into
# traces/gallery with apitrace, on ffgpu's own libGL, whose extensions the programs then use.
# The calls are the same each time, and wherever the build is; only addresses of X's structures may
# differ. Recordings of 1 MB and more, of meshes vertex by vertex, are not kept. Needs Debian's
# apitrace and xvfb.
set -euo pipefail
build=$(realpath "$1")
shift
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=/tmp/ffgpu_programs
rm -rf "$work" && mkdir "$work"
trap 'rm -rf "$work"' EXIT
cp "$build/tests/gallery/gallery_window" "$build/driver/GL/libGL.so.1" "$work"
names=("$@")
[ $# -gt 0 ] ||
    mapfile -t names < <("$build/tests/gallery/gallery_offscreen" --list | grep ^T | cut -f2)
mkdir -p "$root/traces/gallery"
cd "$work"
for name in "${names[@]}"; do
    xvfb-run -a -n 1000 -s '-screen 0 640x480x24' \
        sh -c 'exec env -i PATH="$PATH" HOME=/ DISPLAY="$DISPLAY" XAUTHORITY="$XAUTHORITY" \
            LD_LIBRARY_PATH="$PWD" TRACE_LIBGL="$PWD/libGL.so.1" setarch --addr-no-randomize \
            apitrace trace -o recorded.trace ./gallery_window "$1"' sh "$name" 2>log ||
        { cat log >&2; exit 1; }
    if [ "$(stat -c %s recorded.trace)" -lt 1000000 ]; then
        mv recorded.trace "$root/traces/gallery/$name.trace"
    else
        echo "$name: too large" && rm recorded.trace
    fi
done
du -cb "$root/traces/gallery/"*.trace | tail -1
