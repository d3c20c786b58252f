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

# Something stands where a file is to go, seen only when the run has come so far.
blocked() { # blocked FILE STATUS TEXT ARGUMENT...
    local out=$work/blocked file=$1
    rm -rf "$out"
    mkdir -p "$out/$file/full"
    shift
    expect "$1" "$2" "$rhexis" run groove --limit 0.3 --set patient.tetrahedra=500 --out "$out" "${@:3}"
    [ -d "$out/$file/full" ] || fail "$file: what stood there is gone"
    [ -z "$(find "$out" -name '*.part' ! -name recording.rhx.part)" ] || fail "$file: half-written files are left"
    [ "$file" = report.html ] || [ ! -f "$out/report.json" ] || fail "$file: a run that failed left a report"
}
blocked frames/01-start.png 2 "01-start.png: cannot write the picture"
blocked video.mp4 2 "video.mp4: cannot write the video" --video
blocked recording.rhx.part 2 "recording.rhx.part" --no-pictures
blocked recording.rhx 2 "recording.rhx" --no-pictures
blocked report.json 2 "report.json" --no-pictures
blocked series.json 2 "series.json" --no-pictures
blocked report.html 2 "no report.html" --no-pictures

expect 2 "recording.rhx.part: cannot write" bash -c 'limited 1 "$@"' _ "$rhexis" run groove "${small[@]}" --out "$work/a"
expect 2 "recording.rhx.part: cannot write" bash -c 'limited 100 "$@"' _ "$rhexis" run groove "${small[@]}" --out "$work/b"
[ -z "$(find "$work/a" -type f)" ] || fail "files are left of a run that never began"
[ ! -e "$work/b/recording.rhx" ] || fail "a recording that was not finished has its final name"
[ ! -e "$work/b/report.json" ] || fail "a run that could not be recorded left a report"
expect 0 "cut short" "$rhexis" replay "$work/b" --verify
says "identical"
finished
