#!/usr/bin/env bash
# Builds the fuzz targets with clang's libFuzzer, AddressSanitizer and UndefinedBehaviorSanitizer, and
# runs each for so many minutes.
#
#   tests/fuzz/fuzz.sh [MINUTES|HOURSh [TARGET ...]]
#
# Inputs that reach new code go to out/fuzz/TARGET; one that breaks ffgpu to out/fuzz/TARGET-crash-...
# Exit status 0: nothing was found.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

length=${1:-1}
shift || true
case $length in
*[!0-9]*h | h | *[!0-9h]*) echo "fuzz: '$length' is neither minutes nor hours (90, 2h)" >&2; exit 2 ;;
*h) readonly Minutes=$((60 * ${length%h})) ;;
*) readonly Minutes=$length ;;
esac
targets=("$@")
[ ${#targets[@]} -gt 0 ] || targets=(trace capture work_file configuration calls)
readonly Build=${FFGPU_FUZZ_BUILD:-build-fuzz} Jobs=${FFGPU_JOBS:-$(nproc)}
# The scalar specifications and one width of vectors: with every width that Highway knows the build
# takes three times as long, and the widths differ by nothing that a file could reach.
readonly Flags="-O1 -g1 -march=x86-64-v3 -DHWY_COMPILE_ONLY_STATIC"
# An input allocates no more than this, whatever it claims (docs/security.md).
readonly MemoryMiB=2048
# Short stacks at each allocation, and few freed blocks kept: a third of the time.
export ASAN_OPTIONS=malloc_context_size=2:quarantine_size_mb=8${ASAN_OPTIONS:+:$ASAN_OPTIONS}
# Without the schedule by rare features, which takes longer than most inputs.
readonly Schedule=-entropic=0
# Bytes of an input at most. Most of what a parser can be told fits into a line or two, and short
# inputs run a hundred times as often.
declare -rA Lengths=([trace]=16384 [capture]=16384 [work_file]=16384 [configuration]=4096 [calls]=4096)

launcher=()
command -v ccache >/dev/null && launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
cmake -S . -B "$Build" -G Ninja "${launcher[@]}" -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
    -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="$Flags" -DFFGPU_FUZZ=ON \
    -DFFGPU_RTL=OFF -DFFGPU_SANITIZE=fuzzer-no-link,address,undefined >/dev/null
cmake --build "$Build" -j "$Jobs" --target "${targets[@]/#/fuzz_}"

status=0
total=0
for target in "${targets[@]}"; do
    mkdir -p "out/fuzz/$target"
    log="out/fuzz/$target.log"
    found=
    if ! "$Build/tests/fuzz/fuzz_$target" "out/fuzz/$target" "tests/fuzz/corpus/$target" \
        -max_total_time=$((60 * Minutes)) -timeout=60 -rss_limit_mb=$MemoryMiB -max_len="${Lengths[$target]}" \
        "$Schedule" -print_final_stats=1 -artifact_prefix="out/fuzz/$target-" >"$log" 2>&1; then
        status=1 found=", see $log"
        tail -40 "$log"
    fi
    runs=$(sed -n 's/stat::number_of_executed_units: *//p' "$log")
    total=$((total + ${runs:-0}))
    printf '%s: %s executions in %s minutes%s\n' "$target" "${runs:-0}" "$Minutes" "$found"
done
printf '%s executions in all\n' "$total"
exit $status
