#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The exercises in docs/examples/exercises: each is checked without a word of complaint, passes its scenario tests (the
# quick ones), and is run for a moment by a virtual surgeon and by hands that go anywhere.
set -u
. "$(dirname "$0")/expect.sh"
export LANG=C
all=docs/examples/exercises

for exercise in "$all"/*/; do
    expect 0 "" "$rhexis" check "$exercise"
    says "good"
    if grep -q "note:" "$work/stdout"; then fail "notes: $(cat "$work/stdout")"; fi
done

# tests EXERCISE TEXT: the scenarios with that text in their name pass
tests() {
    expect 0 "" "$rhexis" test "$all/$1" --jobs 1 --filter "$2"
    says " 0 failed"
}
tests steady_hand ""
tests small_pupil "put right"
tests two_wounds "hydrated"
tests sudden_surge "surge, foot up"

# runs EXERCISE SURGEON SECONDS
runs() {
    expect 0 "" "$rhexis" run "$all/$1" --surgeon "$2" --limit "$3" --no-pictures --out "$work/$1-$2"
    [ -s "$work/$1-$2/report.html" ] || fail "no report: $1 by $2"
}
runs steady_hand expert 60
says "expert, seed 1: completed"
says "Steady hand"
runs small_pupil expert 2
runs two_wounds novice 3
runs sudden_surge random 3

short="--set wounds.time_limit_s=2 --set opening.time_limit_s=2 --set surge.time_limit_s=2"
# shellcheck disable=SC2086
expect 0 "" "$rhexis" run "$all/three_parts" $short --no-pictures --out "$work/parts"
for part in wounds opening surge; do says "  $part"; done
finished
