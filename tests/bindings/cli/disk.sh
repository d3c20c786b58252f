#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A disk that cannot be written, from the start or from some moment on.
set -u
. "$(dirname "$0")/expect.sh"
small=(--limit 3 --no-pictures --set patient.tetrahedra=500)

expect 2 "cannot make this folder" "$rhexis" run groove "${small[@]}" --out /dev/null/folder
expect 2 "cannot make this folder" "$rhexis" run groove "${small[@]}" --out /proc/no_such_folder
touch "$work/file"
expect 2 "$work/file" "$rhexis" run groove "${small[@]}" --out "$work/file"

# A limit on the size of files stands for a disk that fills up (the signal that comes with it is ignored).
limited() { (trap '' XFSZ; ulimit -f "$1"; shift; exec "$@"); }
export -f limited
expect 2 "recording.rhx.part: cannot write" bash -c 'limited 1 "$@"' _ "$rhexis" run groove "${small[@]}" --out "$work/a"
expect 2 "recording.rhx.part: cannot write" bash -c 'limited 100 "$@"' _ "$rhexis" run groove "${small[@]}" --out "$work/b"
[ -z "$(find "$work/a" -type f)" ] || fail "files are left of a run that never began"
[ ! -e "$work/b/recording.rhx" ] || fail "a recording that was not finished has its final name"
[ ! -e "$work/b/report.json" ] || fail "a run that could not be recorded left a report"
expect 0 "cut short" "$rhexis" replay "$work/b" --verify
says "identical"
finished
