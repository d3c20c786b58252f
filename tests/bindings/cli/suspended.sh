#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A script that errs in the middle of an operation: it ends there, what was recorded stays, and the report is made of what
# there is. A script that is changed while it runs: taken up between two steps, or refused, and the run goes on.
set -u
. "$(dirname "$0")/expect.sh"

# exercise_of NAME 'DONE' ['MORE']: one step in a small eye.
exercise_of() {
    exercise "operation/$1" >/dev/null <<L
return exercise {
    title = "$1", patient = { tetrahedra = 500 }, tissues = { "lens", "iris" }, instruments = { "phaco" },
    steps = { step "look" { done = $2 } },
    errors = { error_event "Early" { when = "time_s > 0.1", recovered = "time_s > 0.2", advice = "Wait." } },
    scoring = osacss { "G5", "G6" }, reference = { time_s = 1, path_mm = 1 },
}
L
}
exercise_of good '"time_s > 0.5"'
exercise_of bad 'function(eye) if eye.time_s > 0.3 then return eye.nothing.here end return false end'
exercise_of never '"time_s > 0.5"'
cat >"$work/operation/curriculum.lua" <<'L'
return operation {
    title = "Three parts",
    parts = { part "good" {}, part "bad" {}, part "never" {} },
    scoring = osacss { "G5", "G6" },
}
L
expect 1 "part bad: bad/curriculum.lua:3:" "$rhexis" run "$work/operation" --surgeon none --no-pictures --json \
    --out "$work/out"
grep -qF "in step 'look'" "$work/stderr" || fail "the step is not named: $(cat "$work/stderr")"
grep -qF "the operation ended there; its recordings are kept" "$work/stderr" || fail "not said that recordings are kept"
for part in 01_good 02_bad; do
    expect 0 "" "$rhexis" replay "$work/out/parts/$part" --verify
    [ -s "$work/out/parts/$part/report.json" ] || fail "no report of $part"
done
[ ! -e "$work/out/parts/03_never" ] || fail "the part after the mistake was begun"
[ -s "$work/out/report.html" ] || fail "no page of the operation"
report() { grep -qF -- "$2" "$work/$1" || fail "$1 lacks $2"; }
report out/report.json '"error": "part bad: bad/curriculum.lua:3:'
report out/report.json '"id": "early"'  # what was judged before the mistake
report out/parts/02_bad/report.json '"outcome": "'
report out/parts/02_bad/report.json '"completed": false'

# Changed while it runs. The first step takes a minute of simulated time, some seconds: the change is there before it ends.
text() { # text DEADLINE 'THIRD STEP' POWER
    cat <<L
return exercise {
    title = "Watched", patient = { tetrahedra = 500 }, tissues = { "lens", "iris" }, instruments = { "phaco" },
    settings = { ["phaco.power_limit"] = $3 },
    time_limit_s = 90,
    steps = {
        step "first" { done = "time_s > 60" },
        step "second" { title = "$2", done = "time_s > $1" },
    },
    errors = { error_event "Early" { when = "time_s > 1 and time_s < 2", recovered = "time_s > 2", advice = "Wait." } },
    scoring = osacss { "G6" }, reference = { time_s = 60, path_mm = 1 },
}
L
}
# watched NAME: runs what $work/NAME/curriculum.lua says, and gives it its text from $work/changed once the run has begun.
watched() {
    rm -rf "$work/out"
    "$rhexis" run "$work/watched" --surgeon none --no-pictures --watch --out "$work/out" >"$work/stdout" \
        2>"$work/stderr" &
    local run=$! waited=0
    until [ -s "$work/out/recording.rhx.part" ] || [ "$waited" -ge 300 ]; do
        sleep 0.1
        waited=$((waited + 1))
    done
    mv "$work/changed" "$work/watched/curriculum.lua"
    wait "$run" || fail "the watched run ended with $?: $(cat "$work/stderr")"
}
mkdir "$work/watched"
text 80 Before 1 >"$work/watched/curriculum.lua"
text 61 After 0.5 >"$work/changed"
watched
grep -qF "the changed exercise is taken up" "$work/stderr" || fail "not taken up: $(cat "$work/stderr")"
report out/report.json '"title": "After"'
report out/report.json '"completed": true'
report out/report.json '"reloads": ['
report out/report.json '"id": "early"'  # from before the change
report out/report.json '"recovered": true'
grep -q '"duration_s": 61' "$work/out/report.json" || fail "the new condition did not hold: $(grep duration "$work/out/report.json")"
grep -q '"start_s": 0' "$work/out/report.json" || fail "the first step was forgotten"
expect 0 "" "$rhexis" replay "$work/out" --verify

text 61 Before 1 >"$work/watched/curriculum.lua"
echo 'return exercise { title = ' >"$work/changed"
watched
grep -qF "watched/curriculum.lua:" "$work/stderr" || fail "the mistake is not told: $(cat "$work/stderr")"
grep -qF "the run goes on unchanged" "$work/stderr" || fail "not told what follows: $(cat "$work/stderr")"
report out/report.json '"title": "Before"'
report out/report.json '"completed": true'
report out/report.json '"refused": "watched/curriculum.lua:'

text 61 Before 1 >"$work/watched/curriculum.lua"
text 61 After 1 | sed 's/tetrahedra = 500/tetrahedra = 600/' >"$work/changed"
watched
grep -qF "the changed exercise wants another patient" "$work/stderr" || fail "another scene: $(cat "$work/stderr")"
report out/report.json '"title": "Before"'
finished
