#!/usr/bin/env bash
# Installs a Debian package of ffgpu in a fresh Debian, runs it there and removes it again. As root.
#
#   tests/install/package_test.sh PACKAGE.deb
#
# The fresh system needs a Debian mirror: that of the host. Exit status 0: it installed with nothing
# but what it says that it needs, drew, and left nothing behind.
set -euo pipefail

readonly Package=$(realpath "$1")
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
fail() { echo "package_test: $*" >&2; exit 1; }
inside() { chroot "$root" "$@"; }
files() { (cd "$root" && find . -xdev \( -path ./var -o -path ./tmp -o -path ./proc -o -path ./etc/ld.so.cache \) -prune -o -print | sort); }

echo "A fresh Debian in $root"
mmdebstrap --quiet --variant=apt bookworm "$root"
cp /etc/resolv.conf "$root/etc/resolv.conf"
# What the package needs is installed first, so that the list of files tells its own.
cp "$Package" "$root/tmp/ffgpu.deb"
needs=$(dpkg-deb -f "$Package" Depends | sed 's/([^)]*)//g; s/ //g; s/|[^,]*//g; s/,/ /g')
inside apt-get update -qq
# shellcheck disable=SC2086
inside env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $needs zsh fish >/dev/null
files >"$root/tmp/before"

inside dpkg -i /tmp/ffgpu.deb >/dev/null
[ "$(inside ffgpu --version)" != "" ] || fail "no version"
inside ffgpu replay /usr/share/ffgpu/traces/corridor.trace -o /tmp/out --frames 0-1 --timing
[ -s "$root/tmp/out/frame_0001.png" ] || fail "no picture"
[ -s "$root/tmp/out/stats.json" ] || fail "no statistics"
[ -e "$root/usr/share/man/man1/ffgpu-replay.1" ] || [ -e "$root/usr/share/man/man1/ffgpu-replay.1.gz" ] ||
    fail "no manual page"
[ "$(inside zsh -c 'autoload -U compinit; compinit -u -d /tmp/zcompdump; print $_comps[ffgpu]')" = _ffgpu ] ||
    fail "zsh knows no completion"
[ "$(inside env HOME=/tmp fish -c 'complete -C "ffgpu repl"' | cut -f1)" = replay ] || fail "fish knows no completion"

inside dpkg --purge ffgpu >/dev/null
files >"$root/tmp/after"
diff "$root/tmp/before" "$root/tmp/after" || fail "these files are left or gone"
echo "$(basename "$Package"): installed, drew, and left nothing behind"
