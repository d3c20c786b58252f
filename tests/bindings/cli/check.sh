#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# rhexis check: one line per mistake, with file and line, and status 1; and what it says of an exercise that is good.
set -u
. "$(dirname "$0")/expect.sh"

# curriculum STEPS ERRORS REST: a small exercise; what is given stands on lines 5, 6 and 7.
curriculum() {
    printf 'return exercise {\n title = "T", patient = { tetrahedra = 500 },\n tissues = { "lens", "iris" },' >"$work/c.lua"
    printf ' instruments = { "phaco" },\n goals = { deep_mm = { 3, from = 1, to = 5 } },\n steps = { %s },\n' "$1" >>"$work/c.lua"
    printf ' errors = { %s },\n %s\n}\n' "$2" "$3" >>"$work/c.lua"
    mkdir -p "$work/mine"
    mv "$work/c.lua" "$work/mine/curriculum.lua"
}
good_step='step "work" { done = "phaco.tip_depth_mm > goal.deep_mm" }'
good_event='error_event "deep" { when = "phaco.tip_depth_mm > 4", recovered = "phaco.tip_depth_mm < 3", advice = "Up." }'
# wrong LINE TEXT: of the curriculum as it stands.
wrong() { expect 1 "rhexis: $work/mine/curriculum.lua:$1: $2" "$rhexis" check "$work/mine"; }

expect_lines() { # expect_lines STATUS TEXT...: each text on a line of its own
    local status=$1 got=0
    shift
    "$rhexis" check "$work/mine" >"$work/stdout" 2>"$work/stderr" || got=$?
    [ "$got" = "$status" ] || fail "status $got instead of $status ($(head -c 300 "$work/stderr"))"
    [ "$(wc -l <"$work/stderr")" = $# ] || fail "not $# lines: $(cat "$work/stderr")"
    for text in "$@"; do grep -qF -- "$text" "$work/stderr" || fail "no '$text': $(cat "$work/stderr")"; done
}
curriculum "$good_step" "$good_event" 'objectives = { "See depth" }, levels = { easy = { meaning = "young", patient = { age = 40 } } },'
expect 0 "" "$rhexis" check "$work/mine"
says "mine: good"
says "objective: See depth"
says "level easy: young"

# Names.
event() { echo "error_event \"e\" { when = \"iris.touch\", advice = \"Up.\", $1 }"; }
curriculum "$good_step" "$(event 'steps = { "wrok" }')" ''
wrong 6 "error_event 'e': there is no step 'wrok' (did you mean work?)"
curriculum 'step "work" { done = "iris.touch", next = "finsh" }, step "finish" { done = "iris.touch" }' '' ''
wrong 5 "step 'work': next: there is no step 'finsh' (did you mean finish?)"
curriculum "$good_step" "$(event 'items = { "G44" }')" 'scoring = osacss { "G4" },'
wrong 6 "error_event 'e': unknown item 'G44' (did you mean G4"
curriculum "$good_step" '' 'scoring = osacss { "GG4" },'
wrong 7 "unknown item 'GG4' (did you mean G4"
curriculum "$good_step" '' ''
sed -i 's/"iris"/"irsi"/' "$work/mine/curriculum.lua"
wrong 3 "exercise: tissues = \"irsi\" is not allowed (did you mean iris"
curriculum "$good_step" '' ''
sed -i 's/"phaco"/"phcao"/' "$work/mine/curriculum.lua"
wrong 3 "exercise: instruments = \"phcao\" is not allowed (did you mean phaco? one of: cannula,"
curriculum 'step "work" { done = "phaco.tip_dpeth_mm > 1" }' '' ''
wrong 5 "unknown measure 'phaco.tip_dpeth_mm' (did you mean phaco.tip_depth_mm"
curriculum 'step "work" { done = "hook.tip_x_mm > 1" }' '' ''
wrong 5 "unknown measure 'hook.tip_x_mm' (the exercise does not name 'hook' among its tissues and instruments)"
curriculum 'step "work" { done = "phaco.tip_depth_mm > goal.deep" }' '' ''
wrong 5 "unknown measure 'goal.deep' (did you mean goal.deep_mm?)"
curriculum "$good_step" '' 'settings = { ["phaco.power_limti"] = 0.5 },'
wrong 7 "settings: there is no setting 'phaco.power_limti' (did you mean phaco.power_limit?)"
curriculum "$good_step" '' 'settings = { phaco = { power_limit = 5 } },'
wrong 7 "settings: phaco.power_limit = 5 is out of range (0 to 1)"
curriculum "$good_step" "$(event 'consequences = { ["implant.triangles"] = 500 }')" ''
wrong 6 "error_event 'e': consequences: implant.triangles is fixed before the first step"
curriculum "$good_step" '' 'levels = { easy = { pateint = {} } },'
wrong 7 "level 'easy' has no field 'pateint' (did you mean patient?)"

# Many mistakes at once, of the exercise and of what lies beside it, by file and line.
cat >"$work/mine/curriculum.lua" <<L
return exercise {
    title = "Many", patientt = { age = 40 }, patient = { age = 400, tetrahedra = 500 },
    tissues = { "lens", "iris" }, instruments = { "phaco" },
    goals = { deep_mm = { 9, from = 1, to = 5 } },
    settings = { ["phaco.power_limti"] = 0.5, ["phaco.power_limit"] = 5 },
    steps = {
        step "a" { done = "phaco.tip_depth_mm >", nxt = "b" },
        step "b" { hint = 3, done = "phaco.tip_dpeth_mm > goal.deep_mm", next = "z" } },
    errors = { error_event "e" { when = "iris.touch" } },
    levels = { easy = { pateint = {} } },
}
L
mkdir -p "$work/mine/tests"
echo 'return {' >"$work/mine/surgeon.lua"
printf 'return scenarios {\n scenario "x" { sed = 1, function(t) end },\n scenario "x" { function(t) end } }\n' >"$work/mine/tests/t.lua"
expect_lines 1 "curriculum.lua:2: exercise has no field 'patientt'" "curriculum.lua:2: patient: age = 400 is out of range" \
    "curriculum.lua:4: goal deep_mm = 9 is out of range" "curriculum.lua:5: settings: phaco.power_limit = 5 is out of range" \
    "curriculum.lua:5: settings: there is no setting 'phaco.power_limti'" "curriculum.lua:7: step 'a' has no field 'nxt'" \
    "curriculum.lua:7: a number or a measure is missing" "curriculum.lua:8: step 'b': hint must be a text" \
    "curriculum.lua:8: step 'b': next: there is no step 'z'" "curriculum.lua:9: error_event 'e' lacks 'advice'" \
    "curriculum.lua:10: level 'easy' has no field 'pateint'" "curriculum.lua:8: unknown measure 'phaco.tip_dpeth_mm'" \
    "surgeon.lua:2: unexpected symbol near <eof>" "tests/t.lua:2: scenario 'x' has no field 'sed'" "tests/t.lua:3: scenario 'x' is there twice"
expect 2 "exercise has no field 'patientt' (did you mean patient?) (and 10 more, which rhexis check tells)" "$rhexis" run "$work/mine"
expect 2 "exercise has no field 'patientt'" "$rhexis" words "$work/mine" iris gap  # all the same
says "Least gap between an instrument and the iris"
rm -r "$work/mine/surgeon.lua" "$work/mine/tests"
curriculum "$good_step" '' 'objectives = { tostrng(3) },'
wrong 7 "there is no word 'tostrng' (did you mean tostring?)"
curriculum "$good_step" '' 'objectives = { zzzzzz.x },'
wrong 7 "there is no word 'zzzzzz'"
curriculum "$good_step" '' ''
echo 'return speed_of_hand(1)' >"$work/mine/surgeon.lua"
expect 1 "mine/surgeon.lua:1: there is no word 'speed_of_hand'" "$rhexis" check "$work/mine"
rm "$work/mine/surgeon.lua"
printf 'error("first\\nsecond \\27[31m")\n' >"$work/mine/curriculum.lua"
wrong 1 'first second \27[31m'

# Steps that are never reached.
curriculum 'step "a" { done = "iris.touch", next = "c" }, step "b" { done = "iris.touch" }, step "c" { done = "iris.touch" }' '' ''
wrong 5 "step 'b' is never reached: the steps before it lead past it"
twice='phaco.tip_depth_mm > 2 and phaco.tip_depth_mm < 1'
curriculum "step \"a\" { done = \"$twice\", time_limit_s = 5 }, step \"b\" { done = \"iris.touch\" }" '' ''
wrong 5 "step 'a': done: \"$twice\" can never hold"
curriculum "step \"a\" { enter_when = \"$twice\", done = \"iris.touch\" }, step \"b\" { done = \"iris.touch\" }" '' ''
expect_lines 1 "mine/curriculum.lua:5: step 'a': enter_when: \"$twice\" can never hold" \
    "mine/curriculum.lua:5: step 'b' is never reached: step 'a' before it never ends"

# Conditions that never change, or never hold.
curriculum 'step "work" { done = "3 > 2" }' '' ''
wrong 5 "step 'work': done: \"3 > 2\" never changes: it holds no measure"
curriculum "$good_step" 'error_event "e" { when = "goal.deep_mm > 2", advice = "Up." }' ''
wrong 6 "error_event 'e': when: \"goal.deep_mm > 2\" never changes: it holds no measure"
curriculum "$good_step" '' 'over = "time_s > 500", time_limit_s = 60,'
wrong 7 "over: \"time_s > 500\" can never hold"
curriculum 'step "work" { done = "phaco.present > 1" }' '' ''
wrong 5 "what is true or false has no size"
# condition TEXT COMPLAINT: where it stands as `done`. What no measure can be; clocks and counts are never negative, and never fall.
condition() {
    curriculum "step \"work\" { done = $1 }" '' ''
    expect 1 "$2" "$rhexis" check "$work/mine"
    grep -q "mine/curriculum.lua:5: " "$work/stderr" || fail "not its line: $(head -c 300 "$work/stderr")"
}
never() { condition "\"$1\"" "step 'work': done: \"$1\" can never hold"; }
never "iris.gap_mm > 0/0"
never "iris.gap_mm * 0 > 1"
never "abs(iris.gap_mm) < -1"
never "sqrt(iris.gap_mm) < 0"
never "iris.touches < 0"
never "iris.touch_s + time_s < 0"
never "iris.touch and iris.touches < 1"
condition '{ "time_s > 5", "time_s < 3" }' "\"time_s < 3\" can never hold once \"time_s > 5\" has held"
condition '{ "step.time_s > 5", "iris.touch", "step.time_s < 3" }' "\"step.time_s < 3\" can never hold once what stands before it has held"
condition '"time_s >= 0 or iris.touch"' "always holds"
curriculum "$good_step" '' 'over = "time_s >= 0",'
wrong 7 "over: \"time_s >= 0\" always holds, from the first moment on"
for good in '"iris.touches >= 0"' '{ "step.time_s > 3", "step.time_s < 5" }' '"iris.gap_mm == iris.gap_mm"' \
    '"sqrt(iris.gap_mm) > 0 and iris.touches < 1"' '"iris.touch == phaco.present"'; do
    curriculum "step \"work\" { done = $good }" '' ''
    expect 0 "" "$rhexis" check "$work/mine"
done

# What does not go together in a condition.
condition '"phaco.present == 0"' 'phaco.present is true or false, and no number: write "not phaco.present"'
condition '"phaco.present ~= 0"' 'phaco.present is true or false, and no number: write "phaco.present"'
condition '"iris.gap_mm + 1"' 'iris.gap_mm + 1 is a number, which holds whatever it is: compare it'
condition '"iris.touch + 1 > 1"' "iris.touch is true or false: nothing can be reckoned with it (in step 'work')"
condition '"phaco.tip_posterior_mm > 1"' "(the tissue 'bag' brings it, and the exercise does not name that)"
condition '"rhexis.closed"' "(the tissue 'anterior_capsule' brings it, and the exercise does not name that)"
condition '("not "):rep(100000) .. "iris.touch"' "is longer than 4000 characters"
condition '("("):rep(150) .. "iris.touch" .. (")"):rep(150)' "is nested more than 100 deep"

# Recoveries.
recovery() { echo "error_event \"e\" { when = \"iris.touch\", advice = \"Up.\", $1 }"; }
curriculum "$good_step" "$(recovery 'recovered = "iris.touch and not iris.touch"')" ''
wrong 6 "error_event 'e': recovered: \"iris.touch and not iris.touch\" can never hold"
curriculum "$good_step" "$(recovery 'recovered = "not iris.touch", deadline_s = 0')" ''
wrong 6 "error_event 'e': recovery can never hold: deadline_s = 0 leaves no time for it"
# What the error needs never falls again.
grown() { # grown WHEN RECOVERED
    curriculum "$good_step" "error_event \"e\" { when = $1, recovered = \"$2\", advice = \"Up.\" }" ''
}
for when in '"iris.touch"' '"iris.touches > 1"' '"2 * iris.gap_mm < 1 and iris.touches >= 1"' '{ "iris.touch", "phaco.present" }'; do
    grown "$when" "iris.touches < 1"
    wrong 6 "error_event 'e': recovered: \"iris.touches < 1\" can never hold once 'when' has held"
done
grown '"iris.touch"' "iris.touch_s <= 0"
wrong 6 "error_event 'e': recovered: \"iris.touch_s <= 0\" can never hold once 'when' has held"
for when in '"iris.touch or phaco.present"' '"iris.gap_mm < 0.1"' '"iris.touches >= 0"'; do
    grown "$when" "iris.touches < 1"
    expect 0 "" "$rhexis" check "$work/mine"
done
# At one level only: a goal makes it impossible.
curriculum "$good_step" "$(recovery 'recovered = "phaco.tip_depth_mm > goal.deep_mm and phaco.tip_depth_mm < 4"')" \
    'levels = { hard = { goals = { deep_mm = 4.5 } } },'
expect 1 "can never hold (at level hard)" "$rhexis" check "$work/mine"

# What is well formed and means something else: a number that stands alone, a recovery that the error brings along.
curriculum "$good_step" 'error_event "e" { when = "phaco.tip_depth_mm", advice = "Up." }' ''
wrong 6 "phaco.tip_depth_mm is a number, which holds whatever it is: compare it, as in \"phaco.tip_depth_mm > 1\" (in error event 'e')"
curriculum "$good_step" "$(recovery 'recovered = "iris.touch or phaco.tip_depth_mm > 1"')" ''
wrong 6 "error_event 'e': recovered: \"iris.touch or phaco.tip_depth_mm > 1\" holds whenever 'when' does"
curriculum "$good_step" "$(recovery 'recovered = "iris.gap_mm > 0.2"')" ''
expect 0 "" "$rhexis" check "$work/mine"

# The slips of who does not program.
curriculum "$good_step" 'error_event "e" { when = "iris.touch" advice = "Up." }' ''
wrong 6 "'}' expected near 'advice': most often a comma is missing before it"
curriculum "$good_step" 'error_event "e" { when = "iris.touch, advice = 3 }' ''
wrong 6 "unfinished string"
grep -q "a quotation mark is missing" "$work/stderr" || fail "no advice: $(cat "$work/stderr")"

# Notes: no mistakes, status 0.
noted() {
    expect 0 "" "$rhexis" check "$work/mine"
    says "note: $1"
}
curriculum "$good_step" "$(event 'items = { "G4" }')" 'scoring = osacss { "G5", "T10" },'
noted "error_event 'e': item G4 is not among those of \`scoring\`"
says "note: scoring: item T10 (Nucleus: rotation and manipulation) cannot be scored here"
curriculum 'step "work" { done = "not phaco.present" }' 'error_event "e" { when = "not phaco.present", advice = "In." }' ''
noted "error_event 'e' happens at the first moment"
says "note: step 'work' is done at the first moment"
curriculum "$good_step" "$good_event" 'texts = { fr = { T = "T", ["Upp."] = "Haut." } },'
noted 'texts in fr: nothing here says "Upp." (did you mean "Up."?)'

# A rubric of its own: where it is required if it is wrong, and what it names that is not there.
rubric() {
    cat >"$work/mine/own.lua" <<L
local scoring = require "scoring"
return scoring.rubric { name = "Own", caps = {}, items = { { id = "S", name = "Still", measures = { { id = "S.m", name = "m",
    of = "$1", take = "$2", unit = "1", five = 0, three = 1, one = 2, source = "own" } } } } }
L
    curriculum "$good_step" '' 'scoring = (require "own") { "S" },'
}
rubric "iris.touch" "coutn"
expect 1 "mine/curriculum.lua:7: item S, measure 'S.m': take = \"coutn\" is not allowed (did you mean count? one of:" "$rhexis" check "$work/mine"
rubric "iris.tuoch" "count"
noted "scoring: measure S.m of item S counts for nothing here: unknown measure 'iris.tuoch' (did you mean iris.touch"

# The plan of a virtual surgeon.
curriculum "$good_step" '' ''
expect 2 "the exercise has no surgeon.lua, the plan of a virtual surgeon" "$rhexis" run "$work/mine" --no-pictures --out "$work/run"
echo 'return function(me) me.wait(1 end' >"$work/mine/surgeon.lua"
expect 1 "mine/surgeon.lua:1: ')' expected near 'end'" "$rhexis" check "$work/mine"
rm "$work/mine/surgeon.lua"

# An operation: what begins_with names, and whose opening is taken over.
operation() {
    mkdir -p "$work/two"
    printf 'return operation { title = "T", parts = { part "one" { exercise = "../mine" },\n' >"$work/two/curriculum.lua"
    printf ' part "two" { exercise = "../mine", %s } } }\n' "$1" >>"$work/two/curriculum.lua"
}
operation 'begins_with = { ["phaco.power_limit"] = "min(1, lens.removed_mm3)" }'
expect 0 "" "$rhexis" check "$work/two"
operation 'begins_with = { ["phaco.power_limti"] = "lens.removed_mm3" }'
expect 1 "two/curriculum.lua:2: part 'two': begins_with: there is no setting 'phaco.power_limti'" "$rhexis" check "$work/two"
operation 'begins_with = { ["phaco.power_limit"] = "lens.removed_mm33" }'
expect 1 "no part before it measures 'lens.removed_mm33' (did you mean lens.removed_mm3" "$rhexis" check "$work/two"
operation 'opening = "one"'
expect 1 "part two: opening: part one tears none" "$rhexis" check "$work/two"

# Every name that may be written.
expect 0 "" "$rhexis" words "$work/mine"
for name in iris.touch goal.deep_mm step.time_s machine.vacuum_mmhg T10; do says "  $name "; done
expect 0 "" "$rhexis" words "$work/mine" IRIS gap
says "Least gap between an instrument and the iris"
! grep -q "phaco.power" "$work/stdout" || fail "words that were not chosen"
expect 1 "no line holds all of these words" "$rhexis" words "$work/mine" xyzzy
expect 2 "there is no curriculum 'grooove' (did you mean" "$rhexis" words grooove
finished
