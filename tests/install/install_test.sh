#!/usr/bin/env bash
# install_test.sh BUILD SOURCE LIBDIR: installs to a temporary prefix, and builds and runs a small
# program on what is there, by pkg-config and by CMake's find_package.
set -euo pipefail
build=$1 source=$2 libdir=$3
prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT

cmake --install "$build" --prefix "$prefix/usr" >"$prefix/log" || { cat "$prefix/log"; exit 1; }
# Moved: nothing may know the prefix that it was installed to.
mv "$prefix/usr" "$prefix/moved"
installed=$prefix/moved

"$installed/bin/ffgpu" --version
# What the shells and man look for: a page for each verb that --help lists.
bash -c "source '$installed/share/bash-completion/completions/ffgpu'; complete -p ffgpu" >/dev/null
test -s "$installed/share/zsh/site-functions/_ffgpu" -a -s "$installed/share/fish/vendor_completions.d/ffgpu.fish"
for verb in $("$installed/bin/ffgpu" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p'); do
  test -s "$installed/share/man/man1/ffgpu-$verb.1" || { echo "no manual page of $verb" >&2; exit 1; }
done
test -s "$installed/share/man/man1/ffgpu.1"
"$installed/bin/ffgpu" run -- sh -c 'case $LD_LIBRARY_PATH in */ffgpu*) exit 3;; esac' && exit 1 || test $? -eq 3

export PKG_CONFIG_PATH=$installed/$libdir/pkgconfig
cc "$source/square.c" -o "$prefix/by_pkg_config" $(pkg-config --cflags --libs ffgpu)
"$prefix/by_pkg_config"
# The extension's example, as its page has it.
cc "$source/../../docs/examples/texture_filter.c" -o "$prefix/texture_filter" $(pkg-config --cflags --libs ffgpu)
"$prefix/texture_filter"

cmake -S "$source/consumer" -B "$prefix/consumer" -DCMAKE_PREFIX_PATH="$installed" >/dev/null
cmake --build "$prefix/consumer" >/dev/null
"$prefix/consumer/square"
"$prefix/consumer/mapping"
echo "installed package: the program runs by pkg-config and by find_package"
