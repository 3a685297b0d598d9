#!/usr/bin/env bash
# read_all.sh TOOL RTL_FOLDER MORE.sv...: verilator or yosys reads every file of the folder, and the
# others, without a warning; each module as a design of its own. 77: the tool is not installed.
set -euo pipefail

readonly Tool=$1 Folder=$2
shift 2
if ! command -v "$Tool" >/dev/null; then
    echo "skipped: $Tool is not installed"
    exit 77
fi

packages=("$Folder"/*_pkg.sv)
modules=("$@")
for file in "$Folder"/*.sv; do
    [[ $file == *_pkg.sv ]] || modules+=("$file")
done

# Modules may stand in each other: all are read, one is the top.
for file in "${modules[@]}"; do
    top=$(basename "$file" .sv)
    echo "$Tool: $top"
    case $Tool in
    verilator)
        verilator --lint-only -Wall --assert --top-module "$top" -y "$Folder" \
            "$Folder/lint.vlt" "${packages[@]}" "$file"
        ;;
    yosys)
        # -e: an implicit wire, a latch or a second driver is a warning otherwise.
        yosys -q -e 'implicitly declared' -e 'multiple conflicting drivers' -e 'latch' \
            -p "read_verilog -sv ${packages[*]} ${modules[*]}; hierarchy -check -top $top; proc; check -assert; select -assert-none t:\$dlatch t:\$_DLATCH_*"
        ;;
    esac
done
