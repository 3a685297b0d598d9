#!/usr/bin/env bash
# Builds ffgpu with AddressSanitizer (leaks included) and UndefinedBehaviorSanitizer, or with
# ThreadSanitizer, and runs the test suite, traces, a live program and tests of piglit with it.
#
#   tests/sanitize/sanitize.sh [--thread] [--short] [BUILD]     BUILD defaults to build-asan, build-tsan
#
# --short leaves out the programs that live in an X server. FFGPU_JOBS sets the number of compilers
# at once. Exit status 0: nothing was found.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

short= sanitizers=address,undefined build=build-asan runtime=libasan.so
[ "${1:-}" = --thread ] && sanitizers=thread build=build-tsan runtime=libtsan.so && shift
[ "${1:-}" = --short ] && short=1 && shift
readonly Build=${1:-$build}
readonly Jobs=${FFGPU_JOBS:-$(nproc)}
readonly Traces=(corridor light_maps)
readonly Piglit=${PIGLIT_DIR:-/usr/lib/x86_64-linux-gnu/piglit}/bin
readonly PiglitTests=(
    'fbo-depthstencil blit default_fb' 'copyteximage 2D' texsubimage read-front vbo-map-remap copy-pixels
    'draw-vertices user' 'primitive-restart VBO_SEPARATE_VERTEX_AND_INDICES' lodbias getteximage-formats
    gl-1.0-blend-func 'ext_fog_coord-modes' occlusion_query degenerate-prims
)

say() { printf '\033[1m%s\033[0m\n' "$*" >&2; }

launcher=()
command -v ccache >/dev/null && launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
say "Building with sanitizers in $Build/"
cmake -S . -B "$Build" -G Ninja "${launcher[@]}" -DCMAKE_BUILD_TYPE=RelWithDebInfo \
    -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1" -DFFGPU_SANITIZE="$sanitizers" >/dev/null
cmake --build "$Build" -j "$Jobs"

export ASAN_OPTIONS=${ASAN_OPTIONS:-strict_string_checks=1:detect_stack_use_after_return=1}
export UBSAN_OPTIONS=${UBSAN_OPTIONS:-print_stacktrace=1}
# Tests fork hundreds of children: ThreadSanitizer would have each of them sleep for a second.
export TSAN_OPTIONS=${TSAN_OPTIONS:-halt_on_error=1:second_deadlock_stack=1:atexit_sleep_ms=20}
# ThreadSanitizer's map of the memory has no place for libraries that the kernel put just anywhere.
[ "$sanitizers" = thread ] && [ -z "${FFGPU_FIXED_ADDRESSES:-}" ] &&
    FFGPU_FIXED_ADDRESSES=1 exec setarch --addr-no-randomize tests/sanitize/sanitize.sh --thread ${short:+--short} "$Build"

say "Test suite"
ctest --test-dir "$Build" --output-on-failure -j "$Jobs" --timeout 3600

say "Traces"
frames=$(mktemp -d)
trap 'rm -rf "$frames"' EXIT
for trace in "${Traces[@]}"; do
    "$Build/tools/ffgpu" replay "traces/$trace.trace" -o "$frames" --frames 0-2 --timing \
        --threads 3 --heatmap overdraw,cycles --capture "$frames/$trace.ffc"
done

[ -n "$short" ] && exit 0

# A program that knows nothing of sanitizers: their runtime has to be there before it. What it leaks
# itself is not ours.
say "Programs"
runtime=$(g++ -print-file-name="$runtime")
export LSAN_OPTIONS=suppressions=$PWD/tests/sanitize/leaks_of_others.txt:print_suppressions=0
exec {display}< <(exec Xvfb -displayfd 1 -screen 0 1280x1024x24 +extension GLX -noreset -nolisten tcp 2>/dev/null)
server=$!
trap 'kill "$server"; rm -rf "$frames"' EXIT
read -r number <&"$display"
live() { # COMMAND ARGUMENTS
    env DISPLAY=":$number" LD_PRELOAD="$runtime" LD_LIBRARY_PATH="$(realpath "$Build")/driver/GL" "$@"
}
live timeout 600 "$Build/tools/ffgpu" run --frames 0-9 -o "$frames" -- glxgears
for line in "${PiglitTests[@]}"; do
    read -ra command <<<"$line"
    [ -x "$Piglit/${command[0]}" ] || continue
    say "${command[*]}"
    PIGLIT_PLATFORM=glx live timeout 600 "$Piglit/${command[0]}" "${command[@]:1}" -auto -fbo
done
