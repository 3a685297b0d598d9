#!/usr/bin/env bash
# Makes docs/pictures/montage.png anew: four pictures that ffgpu draws from the traces in traces/; and report.png.
# Needs oiiotool (Debian package openimageio-tools), chromium and python3-pil.
#
#     docs/pictures/make.sh [build/tools/ffgpu]
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
ffgpu=${1:-$root/build/tools/ffgpu}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

for trace in corridor light_maps chrome; do
    "$ffgpu" replay "$root/traces/$trace.trace" -o "$folder/$trace" --timing --heatmap cycles >"$folder/log" 2>&1
done
panels=()
for picture in corridor/frame_0004 light_maps/frame_0003 chrome/frame_0002 chrome/heat_cycles_0002; do
    oiiotool "$folder/$picture.png" --ch R,G,B --resize 352x264 -o "$folder/panel_${#panels[@]}.png"
    panels+=("$folder/panel_${#panels[@]}.png")
done
oiiotool "${panels[@]}" --mosaic 2x2 -o "$root/docs/pictures/montage.png"
FFGPU_BINARY="$ffgpu" "$root/docs/pictures/report_page.py"
