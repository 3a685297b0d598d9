#!/usr/bin/env bash
# read_all.sh TOOL RTL_FOLDER [--only] MORE.sv...: verilator or yosys reads every file of the folder,
# and the others, without a warning; each module as a design of its own. --only: the packages of the
# folder, and the others. 77: the tool is not installed.
set -euo pipefail

readonly Tool=$1 Folder=$2
shift 2
if ! command -v "$Tool" >/dev/null; then
    echo "skipped: $Tool is not installed"
    exit 77
fi

# In the order of their use.
packages=("$Folder"/ffgpu_registers_pkg.sv "$Folder"/ffgpu_pkg.sv "$Folder"/ffgpu_texture_pkg.sv
    "$Folder"/ffgpu_pipe_pkg.sv)
modules=()
if [ "${1:-}" = --only ]; then
    shift
else
    for file in "$Folder"/*.sv; do
        [[ $file == *_pkg.sv ]] || modules+=("$file")
    done
fi
modules+=("$@")

# Modules may stand in each other: all are read, one is the top.
yosys_commands="read_verilog -sv ${packages[*]} ${modules[*]}; design -save read"
for file in "${modules[@]}"; do
    top=$(basename "$file" .sv)
    case $Tool in
    verilator)
        echo "verilator: $top"
        verilator --lint-only -Wall --assert --top-module "$top" -y "$Folder" \
            "$Folder/lint.vlt" "${packages[@]}" "$file"
        ;;
    yosys)
        yosys_commands+="; design -load read; log yosys: $top; hierarchy -check -top $top; proc; check -assert"
        yosys_commands+="; select -assert-none t:\$dlatch t:\$_DLATCH_*"
        ;;
    esac
done
# -e: an implicit wire, a latch or a second driver is a warning otherwise.
[ "$Tool" != yosys ] || yosys -q -e 'implicitly declared' -e 'multiple conflicting drivers' \
    -e 'latch' -p "$yosys_commands"
