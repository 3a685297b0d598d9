#!/bin/sh
# make_once.sh FILE COMMAND...: runs COMMAND with one more word, a name beside FILE to write to, and
# gives what it wrote the name FILE. Where FILE is there already, or comes there meanwhile, that one
# stays as it is: what is finished is never made again, whoever starts a job twice.
file=$1
shift
[ -e "$file" ] && exit 0
part=$(mktemp "$file.XXXXXX.part") || exit 2
trap 'rm -f "$part"' EXIT
"$@" "$part"
status=$?
# 3: a machine that is stuck, which is a result, too.
[ $status = 0 ] || [ $status = 3 ] || exit $status
[ -s "$part" ] || { echo "ffgpu: $file: nothing was written: its trace has no frame that was asked for" >&2; exit 2; }
chmod "$(printf '%o' $((0666 & ~0$(umask))))" "$part" && mv -n "$part" "$file"
