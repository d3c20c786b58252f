#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A run leaves what it says it leaves, and what it recorded comes back bit for bit.
set -u
. "$(dirname "$0")/expect.sh"
small=(--limit 6 --set patient.tetrahedra=500)

expect 0 "" "$rhexis" run groove "${small[@]}" --no-pictures --out "$work/a"
for file in report.json report.html series.json recording.rhx; do
    [ -s "$work/a/$file" ] || fail "no $file"
    says "$([ $file = series.json ] && echo report.json || echo $file)"
done
[ -z "$(find "$work/a" -name '*.part')" ] || fail "half-written files are left"
hash_of() { sed -n 's/.*"state_hash": "\([0-9a-f]*\)".*/\1/p' "$1/report.json"; }

# The same seed gives the same end, with two threads as well; another seed another.
expect 0 "" "$rhexis" run groove "${small[@]}" --no-pictures --threads 2 --out "$work/b"
expect 0 "" "$rhexis" run groove "${small[@]}" --no-pictures --seed 2 --out "$work/c"
[ -n "$(hash_of "$work/a")" ] || fail "no state hash in the report"
[ "$(hash_of "$work/a")" = "$(hash_of "$work/b")" ] || fail "two threads end in another state"
[ "$(hash_of "$work/a")" != "$(hash_of "$work/c")" ] || fail "another seed ends in the same state"

# Replay.
expect 0 "" "$rhexis" replay "$work/a" --verify
says "identical: all 300 steps"
expect 0 "" "$rhexis" replay "$work/a" --verify --threads 2
says "identical"
expect 0 "" "$rhexis" replay "$work/a" --score-with groove --json
expect 0 "" "$rhexis" report "$work/a" --language fr
grep -q '<html lang="fr"' "$work/a/report.html" || fail "the page is not in French"
expect 2 "--language xx: there are no texts in it" "$rhexis" report "$work/a" --language xx
grep -q '<html lang="fr"' "$work/a/report.html" || fail "a language that is not there spoilt the page"
expect 0 "" "$rhexis" report "$work/a"
grep -q '<html lang="en"' "$work/a/report.html" || fail "the page is not in the language of the run"

# Judged by another rubric: same recording, nothing simulated again, its own items and levels; the run's report stays.
before=$(sha256sum <"$work/a/report.json")
expect 0 "" "$rhexis" replay "$work/a" --score-with rubrics/ico_oscar.lua --json
says '"rubric": "ICO-OSCAR"'
says '"simulated_from_step": 0'
says '"judged_steps": 300'
says '"id": "P9"'
expect 0 "" "$rhexis" replay "$work/a" --score-with rubrics/ico_oscar.lua
says "ICO-OSCAR"
expect 0 "" "$rhexis" report "$work/a" --score-with rubrics/ico_oscar.lua
says report_ico_oscar.html
grep -q "ICO-OSCAR" "$work/a/report_ico_oscar.html" || fail "the page does not name its rubric"
[ "$(sha256sum <"$work/a/report.json")" = "$before" ] || fail "judging again changed report.json"
sed 's/five = 1.1, four = 1.4/five = 1.1, fuor = 1.4/' "$(dirname "$0")/../../../rubrics/ico_oscar.lua" >"$work/misspelt.lua"
expect 2 "item P20, measure P20.time" "$rhexis" replay "$work/a" --score-with "$work/misspelt.lua"

# Also what somebody did who was told not to react.
expect 0 "" "$rhexis" run groove "${small[@]}" --no-pictures --set surgeon.recovery=0 --set goal.length_mm=3 --out "$work/d"
expect 0 "" "$rhexis" replay "$work/d" --score-with groove --json
says '"judged_steps": 300'

# Cut short: used up to its last whole step. Damaged: said, and status 2.
size=$(stat -c %s "$work/a/recording.rhx")
head -c $((size * 2 / 3)) "$work/a/recording.rhx" >"$work/cut.rhx"
expect 0 "cut short at byte" "$rhexis" replay "$work/cut.rhx" --verify
says "identical"
cp "$work/a/recording.rhx" "$work/damaged.rhx"
printf 'XXXX' | dd of="$work/damaged.rhx" bs=1 seek=$((size / 2)) conv=notrunc status=none
expect 2 "damaged at byte" "$rhexis" replay "$work/damaged.rhx" --verify

# --json prints the report and nothing else.
expect 0 "" "$rhexis" run groove --limit 0.5 --set patient.tetrahedra=500 --no-pictures --json --out "$work/d"
cmp -s "$work/stdout" "$work/d/report.json" || fail "--json is not report.json"

# Without a device to draw with: no pictures and a line that says so; a demanded video is an error.
blind=(env __EGL_VENDOR_LIBRARY_DIRS=/nonexistent __EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent)
expect 0 "no pictures:" "${blind[@]}" "$rhexis" run groove --limit 0.5 --set patient.tetrahedra=500 --out "$work/e"
expect 2 "rhexis: " "${blind[@]}" "$rhexis" run groove --limit 0.5 --set patient.tetrahedra=500 --video --out "$work/f"
[ ! -e "$work/f/report.json" ] || fail "a run without its video left a report"

# Killed in the middle: what was done is there.
"$rhexis" run groove --set patient.tetrahedra=500 --no-pictures --out "$work/g" >/dev/null 2>&1 &
kill_when_recorded "$work/g" $!
if [ -e "$work/g/recording.rhx.part" ]; then
    expect 0 "cut short" "$rhexis" replay "$work/g" --verify
    says "identical"
fi
finished
