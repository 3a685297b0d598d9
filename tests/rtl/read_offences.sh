#!/usr/bin/env bash
# read_offences.sh RTL_FOLDER STYLE_PAGE: the readers refuse each file of offences/, those that its
# second line names; and the waivers are those that the page counts, each explained. 77: neither
# reader is installed.
set -euo pipefail

readonly Folder=$1 Page=$2 Here=$(dirname "$0")
failures=0 tried=0

fail() {
    echo "FAILED: $*"
    failures=$((failures + 1))
}

# Who refuses everything refuses no offence.
for tool in verilator yosys; do
    command -v "$tool" >/dev/null || continue
    "$Here/read_all.sh" "$tool" "$Folder" --only "$Folder/cache_ages.sv" >/dev/null 2>&1 ||
        fail "$tool refuses a file that offends nothing"
done

for offence in "$Here"/offences/*.sv; do
    for tool in $(sed -n 's,^// Refused by: ,,p' "$offence"); do
        command -v "$tool" >/dev/null || continue
        tried=$((tried + 1))
        if "$Here/read_all.sh" "$tool" "$Folder" --only "$offence" >/dev/null 2>&1; then
            fail "$tool accepts $(basename "$offence")"
        fi
    done
done

# waivers FOLDER PAGE: complains of uncounted and unexplained ones.
waivers() {
    local count counted
    count=$(grep -c '^lint_off' "$1/lint.vlt")
    counted=$(sed -n 's/^\*\*Waivers: \([0-9]*\)\.\*\*.*/\1/p' "$2")
    [ "$count" = "$counted" ] || echo "lint.vlt has $count waivers, $(basename "$2") counts $counted"
    awk '/^lint_off/ && before == "" { print "no reason before: " $0 } { before = $0 }' "$1/lint.vlt"
    grep -n 'lint_off\|lint_on' "$1"/*.sv || true
}

found=$(waivers "$Folder" "$Page")
[ -z "$found" ] || fail "$found"

# One more waiver without a word, and one in a unit's file, are seen.
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cp "$Folder"/lint.vlt "$Folder"/alpha_test.sv "$scratch"
printf '\nlint_off -rule WIDTH\n' >>"$scratch/lint.vlt"
echo '// verilator lint_off WIDTH' >>"$scratch/alpha_test.sv"
found=$(waivers "$scratch" "$Page")
[ "$(grep -c . <<<"$found")" = 3 ] || fail "planted waivers: $found"

echo "$tried offences tried"
[ $failures -eq 0 ] || exit 1
[ $tried -gt 0 ] || { echo "skipped: neither verilator nor yosys is installed"; exit 77; }
