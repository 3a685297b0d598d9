#!/usr/bin/env bash
# Builds ffgpu with gcc and clang, optimised and not, replays two traces with each build and with
# several thread counts, single-sampled and multisampled, and compares all pictures and statistics
# byte for byte. Then aarch64 beside this machine, where its compiler and qemu-user are installed.
#
#   tests/determinism/determinism.sh [OUT]     OUT defaults to out; the builds stay there for the next time
#
# FFGPU_JOBS sets the number of compilers at once. Exit status 0: all equal; 1: something differs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

readonly Out=${1:-out}
readonly Jobs=${FFGPU_JOBS:-$(nproc)}
readonly Traces=(corridor light_maps)
readonly Frames=0-2 # Without optimisation a frame takes seconds.
readonly Builds=("gcc-O3 gcc g++ -O3" "gcc-O0 gcc g++ -O0" "clang-O3 clang clang++ -O3")
readonly ThreadCounts=(1 2 3)

say() { printf '%s\n' "$*" >&2; }

build() { # NAME CC CXX LEVEL
    local launcher=()
    command -v ccache >/dev/null && launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
    say "Building $1"
    cmake -S . -B "$Out/determinism-$1" -G Ninja "${launcher[@]}" -DBUILD_TESTING=OFF \
        -DCMAKE_C_COMPILER="$2" -DCMAKE_CXX_COMPILER="$3" \
        -DCMAKE_C_FLAGS_RELEASE="$4 -DNDEBUG" -DCMAKE_CXX_FLAGS_RELEASE="$4 -DNDEBUG" >/dev/null
    cmake --build "$Out/determinism-$1" -j "$Jobs" --target ffgpu >"$Out/determinism-$1.log" ||
        { tail -20 "$Out/determinism-$1.log" >&2; return 1; }
}

replay() { # NAME THREADS TRACE SAMPLES
    local to="$Out/determinism-frames/$1-threads$2/$3-samples$4"
    rm -rf "$to"
    "$Out/determinism-$1/tools/ffgpu" replay "traces/$3.trace" -o "$to" --frames "$Frames" \
        --threads "$2" --samples "$4" --timing --heatmap overdraw,level,texture_misses,cycles 2>/dev/null
}

# Prints the names of the files that differ or are there only once.
differences() { # FOLDER FOLDER
    { diff -rq "$1" "$2" || true; } | head -5
}

mkdir -p "$Out"
rm -rf "$Out/determinism-frames"
reference=
failed=0
for line in "${Builds[@]}"; do
    read -r name cc cxx level <<<"$line"
    if ! command -v "$cxx" >/dev/null; then
        say "$name: skipped, $cxx is not installed"
        continue
    fi
    build "$name" "$cc" "$cxx" "$level"
    for threads in "${ThreadCounts[@]}"; do
        for trace in "${Traces[@]}"; do
            for samples in 1 4; do
                replay "$name" "$threads" "$trace" "$samples"
            done
        done
        folder="$Out/determinism-frames/$name-threads$threads"
        if [ -z "$reference" ]; then
            reference=$folder
            files=$(find "$folder" -type f | wc -l)
            # Three frames of a picture and four heat maps, their list, and the statistics; of one and
            # four samples.
            [ "$files" -eq $((${#Traces[@]} * 2 * 17)) ] || { say "$folder: $files files"; exit 1; }
            say "$name, $threads threads: $files files, the reference"
            continue
        fi
        found=$(differences "$reference" "$folder")
        if [ -z "$found" ]; then
            say "$name, $threads threads: equal"
        else
            say "$name, $threads threads: DIFFERS"
            say "$found"
            failed=1
        fi
    done
done
[ -n "$reference" ] || { say "no compiler found"; exit 1; }
native=${reference##*/}
status=0
tests/determinism/aarch64.sh "$Out/determinism-${native%-threads*}/tools/ffgpu" "$Out" || status=$?
[ $status -eq 0 ] || [ $status -eq 77 ] || failed=1
exit $failed
