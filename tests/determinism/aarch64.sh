#!/usr/bin/env bash
# Builds ffgpu for aarch64 with Debian's cross compiler, replays every trace of traces/ with it under
# qemu-user, and compares pictures, heat maps and statistics byte for byte with those of this machine.
#
#   tests/determinism/aarch64.sh FFGPU [OUT]
#
# FFGPU is this machine's program. The libraries of arm64 are unpacked into OUT/aarch64-root, once;
# nothing of the host is touched. Exit status 0: all equal; 1: something differs; 77: what it wants
# is missing (g++-aarch64-linux-gnu, qemu-user-static, mmdebstrap), which is said.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

readonly Native=$(realpath "$1") Out=$(realpath -m "${2:-out}")
readonly Jobs=${FFGPU_JOBS:-$(nproc)}
readonly Root=$Out/aarch64-root Build=$Out/determinism-aarch64 Frames=$Out/determinism-frames
# What `ffgpu` is made of; no tests, no pictures other than PNG.
readonly Packages=libc6-dev,libstdc++-12-dev,libsystemc-dev,libpng-dev,libhwy-dev,libcli11-dev,\
libtomlplusplus-dev,nlohmann-json3-dev,libfmt-dev,libspdlog-dev,libsnappy-dev,libzstd-dev,zlib1g-dev,\
libx11-dev,libxext-dev,libgl-dev,libegl-dev,libglm-dev

say() { printf '%s\n' "$*" >&2; }

for program in aarch64-linux-gnu-g++ qemu-aarch64-static; do
    command -v "$program" >/dev/null || { say "aarch64: skipped, $program is not installed"; exit 77; }
done
if [ ! -e "$Root/complete" ]; then
    command -v mmdebstrap >/dev/null || { say "aarch64: skipped, mmdebstrap is not installed"; exit 77; }
    say "Unpacking the libraries of arm64 into $Root"
    rm -rf "$Root"
    mkdir -p "$Out"
    mmdebstrap --quiet --architectures=arm64 --variant=extract --include="$Packages" bookworm "$Root" \
        2>"$Root.log" || { tail -5 "$Root.log" >&2; exit 1; }
    touch "$Root/complete"
fi

launcher=()
command -v ccache >/dev/null && launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
say "Building aarch64"
cmake -S . -B "$Build" -G Ninja "${launcher[@]}" -DBUILD_TESTING=OFF -DFFGPU_RTL=OFF -DFFGPU_PICTURES=OFF \
    -DCMAKE_C_FLAGS_RELEASE="-O1 -DNDEBUG" -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" \
    -DCMAKE_TOOLCHAIN_FILE="$PWD/cmake/aarch64-linux-gnu.cmake" -DFFGPU_ARM64_ROOT="$Root" >/dev/null
cmake --build "$Build" -j "$Jobs" --target ffgpu >"$Build.log" || { tail -20 "$Build.log" >&2; exit 1; }

replay() { # FOLDER TRACE FFGPU...
    local to="$Frames/$1/${2%.trace}"
    rm -rf "$to"
    "${@:3}" replay "traces/$2" -o "$to" --timing --heatmap overdraw,level,texture_misses,cycles 2>/dev/null
}

failed=0
for trace in $(cd traces && find . -name '*.trace' | sed 's,^\./,,' | sort); do
    replay native "$trace" "$Native"
    replay aarch64 "$trace" qemu-aarch64-static -L "$Root" "$Build/tools/ffgpu"
    name=${trace%.trace}
    files=$(find "$Frames/native/$name" -type f | wc -l)
    [ "$files" -ge 6 ] || { say "$name: $files files"; exit 1; }
    if found=$(diff -rq "$Frames/native/$name" "$Frames/aarch64/$name"); then
        say "aarch64, $name: $files files equal"
    else
        say "aarch64, $name: DIFFERS"
        say "$(head -5 <<<"$found")"
        failed=1
    fi
done
exit $failed
