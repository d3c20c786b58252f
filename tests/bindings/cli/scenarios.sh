#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# rhexis test: what passes passes, a wrong expectation fails on its line, and whatever is wrong with a scenario is said.
set -u
. "$(dirname "$0")/expect.sh"
cd "$work" || exit 2  # kept states go to runs/ here

# An exercise on a small eye: one error is the tip beyond the middle, another never happens.
demo=$(exercise demo <<'L'
return exercise {
    title = "demo",
    patient = { tetrahedra = 500 },
    tissues = { "lens", "bag", "iris", "cornea" },
    instruments = { "phaco", "probe" },
    goals = { side = 1 },
    steps = { step "look" { done = "time_s > 60" } },
    errors = {
        error_event "Too far" { when = "phaco.tip_x_mm > goal.side", recovered = "phaco.tip_x_mm < goal.side - 0.2",
            deadline_s = 0.5, near_miss_s = 0, advice = "Go back." },
        error_event "Never" { when = "time_s > 250", advice = "-" },
    },
}
L
)
mkdir "$demo/tests"

# scenario NAME 'BODY' ['FIELDS']: a file with one scenario; its body begins on line 3.
scenario() {
    printf 'return scenarios {\n    scenario "%s" { %s function(t)\n%s\nend } }\n' "$1" "${3:-}" "$2" >"$demo/tests/$1.lua"
    echo "$demo/tests/$1.lua"
}
into='t.phaco:enter() t.phaco:move_to({ 0, 0, 3 }, { speed = 40 })'

# passes NAME BODY; fails NAME LINE 'TEXT' BODY: status 1, and stdout has file:line and the text.
passes() {
    local file
    file=$(scenario "$@")
    expect 0 "" "$rhexis" test "$file"
    says "1 passed, 0 failed"
}
fails() {
    local file
    file=$(scenario "$1" "$4" "${5:-}")
    expect 1 "" "$rhexis" test "$file"
    says "$file:$2: $3"
    says "0 passed, 1 failed"
}

passes calm 't:wait(0.1)' 'silent_twin_of = "Too far",'
passes close "$into t.phaco:move_to({ 0.9, 0, 3 }) t.phaco:move_to({ 0, 0, 3 })" \
    'silent_twin_of = "Too far", near = "phaco.tip_x_mm > 0.8",'
passes far "$into t.phaco:move_to({ 1.2, 0, 3 }, { speed = 10 }) t:expect_event('Too far')
t.phaco:move_to({ 0, 0, 3 }, { speed = 10 }) t:expect_event('too_far', { recovered = true })"
passes stays "$into t.phaco:move_to({ 1.2, 0, 3 }, { speed = 10 }) t:expect_event('Too far', { recovered = false, within = 1 })"
passes settings 't:set { ["phaco.power_limit"] = 0.5 } t.phaco:enter() t.phaco:pedal(3) t:wait(0.02)
t:expect("phaco.power == 0.5")'
passes patient 't.phaco:enter() t:expect("phaco.present and not probe.present")' 'set = { patient = { age = 80 } },'
passes both 't:together(
function() t.phaco:enter() t.phaco:move_to({ -1, 0, 3 }) t.phaco:withdraw() end,
function() t.probe:enter() t.probe:path({ { 1, 0, 3 }, { 1, 1, 3 } }, { motion = "even" }) end)
t:expect("probe.present and not phaco.present") t:expect_near("probe.tip_y_mm", 1, 1e-6)'
passes shaft "$into t.phaco:move_to({ 0, 0, 3 }, { shaft = { 1, 0, 0 }, seconds = 0.2 })
t.phaco:move_by({ 0, 0, 0.1 }) t.phaco:move_by({ 0, 0, -0.1 }, { shaft = 'wound', seconds = 0.2 })
t:expect_near('phaco.tip_z_mm', 3, 1e-9)"
passes stopped "$into assert(t.phaco:move_to({ 1, 0, 3 }, { stop = 'phaco.tip_x_mm >= 0.5' }) == true)
t:wait_until('phaco.speed_mm_s == 0', 0.1) t:expect_near('phaco.tip_x_mm', 0.52, 0.03)
assert(t:value('phaco.tip_x_mm') == t.phaco:tip()[1])"
passes late 't:wait(2) t:expect_no_event() t:expect(function(eye) return eye.time_s > 1.99 end)'

# What a scenario prints goes to stderr, and the results to stdout.
expect 0 "seen	1.5	true" "$rhexis" test "$(scenario prints 'print("seen", 1.5, t:value("time_s") == 0)')"
says "1 passed, 0 failed"

# Wrong expectations: their line, what was expected, what was seen.
fails wrong 4 'expected "phaco.tip_x_mm > 1", seen: phaco.tip_x_mm = 0 (after' "$into
t:expect('phaco.tip_x_mm > 1')"
fails near 4 'expected phaco.tip_z_mm within 0.1 of 2, seen: phaco.tip_z_mm = 3' "$into
t:expect_near('phaco.tip_z_mm', 2, 0.1)"
fails no_event 3 'expected error event "Too far" recovered within 0.1 s, seen: no error event' \
    't:expect_event("Too far", { recovered = true, within = 0.1 })'
fails an_event 4 'expected no error event "Too far", seen: "Too far" at ' "$into t.phaco:move_to({ 1.2, 0, 3 })
t:expect_no_event('Too far')"
fails never_came 3 'expected "time_s > 9" within 0.1 s, seen after it: time_s = 0.1' 't:wait_until("time_s > 9", 0.1)'
fails no_twin 2 'expected to the end no error event "Too far", seen: "Too far" at' \
    "$into t.phaco:move_to({ 1.2, 0, 3 })" 'silent_twin_of = "Too far",'
fails far_away 2 'expected the silent twin to come near at some time, seen: phaco.tip_x_mm from ' \
    "$into t.phaco:move_to({ 0.3, 0, 3 })" 'silent_twin_of = "Too far", near = "phaco.tip_x_mm > 0.8",'
says ' to 0.3 (after'
fails near_what 2 "unknown measure 'phaco.tip_q_mm'" 't:wait(0.1)' 'silent_twin_of = "Too far", near = "phaco.tip_q_mm > 1",'
fails both_fail 4 'expected "false", seen: no measure' 't:expect("time_s > 5")
t:expect("false")'
says "both_fail.lua:3: expected"
fails endless_time 3 'expected an end within 0.5 s of simulated time' 'while true do t:wait(0.1) end' 'time_limit_s = 0.5,'

# Mistakes of who writes them.
fails instrument 3 "t has no 'phacoo' (did you mean phaco?)" 't.phacoo:enter()'
fails word 3 "phaco has no 'mvoe_to' (did you mean move_to?)" 't.phaco:mvoe_to({ 0, 0, 0 })'
fails event 3 "the exercise has no error event 'Too fra' (did you mean Too far?)" 't:expect_event("Too fra")'
fails measure 3 "unknown measure 'phaco.tip_q_mm' (did you mean phaco.tip_x_mm" 't:expect("phaco.tip_q_mm > 1")'
fails unset 3 "there is no setting 'phaco.power_limti' (did you mean phaco.power_limit?)" 't:set { ["phaco.power_limti"] = 1 }'
fails range 3 "phaco.power_limit = 7 is out of range (0" 't:set { ["phaco.power_limit"] = 7 }'
fails fixed 3 "zonules.strength can only be set before the first step" 't:set { ["zonules.strength"] = 1 }'
fails nan_place 3 "phaco:move_to: x must be a number, not " "$into t.phaco:move_to({ 0/0, 0, 3 })"
fails far_place 3 "phaco:move_to: z = 1e+300 is out of range (-50 to 50)" "$into t.phaco:move_to({ 0, 0, 1e300 })"
fails no_place 3 "phaco:move_to must be given { x, y, z } in mm" "$into t.phaco:move_to(3)"
fails pedal 3 "phaco:pedal = 7 is out of range (0 to 3)" "$into t.phaco:pedal(7)"
fails pedal_nan 3 "phaco:pedal must be a number" "$into t.phaco:pedal(0/0)"
fails jaw 3 "phaco:jaw = 2 is out of range (0 to 1)" "$into t.phaco:jaw(2)"
fails jaw_nan 3 "phaco:jaw must be a number" "$into t.phaco:jaw(0/0)"
fails speed 3 "phaco:move_to: speed = 0 is out of range (0.01 to 200)" "$into t.phaco:move_to({ 1, 0, 3 }, { speed = 0 })"
fails option 3 "phaco:move_to has no field 'sped' (did you mean speed?)" "$into t.phaco:move_to({ 1, 0, 3 }, { sped = 1 })"
fails outside 3 "phaco:move_to: phaco is not in the eye; phaco:enter() brings it in" 't.phaco:move_to({ 0, 0, 3 })'
fails no_direction 3 "shaft = { 0, 0, 0 } is no direction" "$into t.phaco:move_to({ 0, 0, 3 }, { shaft = { 0, 0, 0 } })"
fails wound 3 "phaco:enter: the eye has no 'incison' (did you mean incision?)" 't.phaco:enter { through = "incison" }'
fails backwards 3 "wait: seconds = -1 is out of range (0 to 7200)" 't:wait(-1)'
fails endless 3 "stopped: used up its budget" 'while true do end'
fails no_wait 3 "scripts/" 'while true do t:wait(0) end'  # wherever the budget ends there
fails swallowed 3 "stopped: used up its budget" 'while true do pcall(function() while true do end end) end'
fails change 3 "t cannot be changed" 't.failures = {}'
fails tampered 3 "t has no 'failures'" 't.failures[1] = nil'
fails twice 3 "phaco:move_to: it still moves" "$into t:together(function() t.phaco:move_to({ 1, 0, 3 }) end, function() t.phaco:move_to({ 0, 1, 3 }) end)"

# What is wrong before anything runs: status 2 and one line.
refused() { # refused NAME 'TEXT' 'FILE'
    printf '%b' "$3" >"$demo/tests/$1.lua"
    expect 2 "$2" "$rhexis" test "$demo/tests/$1.lua"
    expect 1 "$2" "$rhexis" check "$demo/tests/$1.lua"
    rm "$demo/tests/$1.lua"
}
refused syntax "tests/syntax.lua:3: '}' expected" 'return scenarios {\n  scenario "x" { function(t) end }\n  scenario "y" { function(t) end } }\n'
refused nothing "the file must end with: return scenarios" 'return 3\n'
refused loop "tests/loop.lua:1: stopped: used up its budget" 'while true do end\n'
refused field "tests/field.lua:2: scenario 'x' has no field 'sede' (did you mean seed or set?)" 'return scenarios {\n scenario "x" { sede = 3, function(t) end } }\n'
refused near "tests/near.lua:2: scenario 'x' has near, but names no error event in silent_twin_of" 'return scenarios {\n scenario "x" { near = "time_s > 1", function(t) end } }\n'
refused empty "scenario 'x' lacks what happens in it" 'return scenarios { scenario "x" { seed = 3 } }\n'
refused same "scenario 'x' is there twice" 'return scenarios { scenario "x" { function(t) end }, scenario "x" { function(t) end } }\n'
refused value "scenario 'x': --set patient.aeg=70: nothing is called 'patient.aeg' (did you mean patient.age" 'return scenarios { scenario "x" { set = { patient = { aeg = 70 } }, function(t) end } }\n'
refused whose "there is no curriculum 'groov' (did you mean 'groove'?)" 'return scenarios "groov" { scenario "x" { function(t) end } }\n'
refused start "there is no start 'half'" 'return scenarios { scenario "x" { start = "half", function(t) end } }\n'
expect 2 "there is no such file, folder or exercise (did you mean 'groove'?)" "$rhexis" test grove
mkdir "$work/bare"
expect 2 "there are no scenario tests here" "$rhexis" test "$work/bare"
expect 2 "path is required" "$rhexis" test
expect 2 "--jobs" "$rhexis" test "$demo" --jobs 0
expect 2 "no scenario has 'nowhere' in its name" "$rhexis" test "$demo" --filter nowhere

# Several: found in a folder, in order, the same with one job or more; JUnit; what no test raises.
rm "$demo"/tests/*.lua
scenario b_calm 't:wait(0.1)' 'silent_twin_of = "Too far",' >/dev/null
scenario a_far "$into t.phaco:move_to({ 1.2, 0, 3 }) t:expect_event('Too far')
t.phaco:move_to({ 0, 0, 3 }) t:expect_event('Too far', { recovered = true })" >/dev/null
scenario c_wrong 't:expect("1 < 0 and time_s >= 0")' >/dev/null
expect 1 "" "$rhexis" test "$demo" --jobs 1 --junit "$work/junit.xml"
sed 's/ s of CPU//; s/[0-9.]*$//' "$work/stdout" >"$work/one"
says "2 passed, 1 failed"
says "demo: 2 error events"
says "  never raised: Never"
says "  never raised and not recovered: Too far"
grep -q '<testsuites name="rhexis" tests="3" failures="1" errors="0"' "$work/junit.xml" || fail "junit: $(head -3 "$work/junit.xml")"
grep -q 'message="expected &quot;1 &lt; 0 and' "$work/junit.xml" || fail "junit: the message"
python3 -c 'import sys, xml.dom.minidom as m; m.parse(sys.argv[1])' "$work/junit.xml" || fail "junit: no XML"
[ ! -e "$work/junit.xml.part" ] || fail "junit: half-written"
expect 1 "" "$rhexis" test "$demo" --jobs 3
sed 's/ s of CPU//; s/[0-9.]*$//' "$work/stdout" >"$work/three"
cmp -s "$work/one" "$work/three" || fail "three jobs say something else than one: $(diff "$work/one" "$work/three")"
expect 0 "" "$rhexis" test "$demo" --filter far

# Names and messages of any bytes, and the same ones in two files of one name: XML that a parser reads, each case once.
bytes='caf\233 \237\191\190\237\160\128\239\191\190\239\191\191\240\159\145\129\195\169 a\1b\tc ]]> <&\" \192\128'
odd='return scenarios {
    scenario "'"$bytes"'" { function(t) error("'"$bytes"'") end },
    scenario "caf\\xE9" { function(t) t:wait(0.02) end },
    scenario "caf\233" { function(t) t:wait(0.02) end },
}'
mkdir "$demo/tests/one" "$demo/tests/two"
printf '%s\n' "$odd" | tee "$demo/tests/one/odd_test.lua" >"$demo/tests/two/odd_test.lua"
expect 1 "" "$rhexis" test "$demo/tests/one/odd_test.lua" "$demo/tests/two/odd_test.lua" --junit "$work/odd.xml"
python3 - "$work/odd.xml" <<'P' || fail "junit: odd names: $(cat "$work/odd.xml")"
import sys, xml.etree.ElementTree as tree
cases = [c.attrib for c in tree.parse(sys.argv[1]).iter("testcase")]
want = r"caf\xE9 \xED\xBF\xBE\xED\xA0\x80\u{FFFE}\u{FFFF}" + "\U0001F441\u00e9 a" + r"\x01b" + "\tc ]]> <&\" " + r"\xC0\x80"
names = [c["name"] for c in cases]
assert names == [want, r"caf\xE9", r"caf\xE9 (2)"] * 2, names
assert [c["classname"] for c in cases] == ["demo.tests.one.odd_test"] * 3 + ["demo.tests.two.odd_test"] * 3, cases
failed = [e.get("message") for e in tree.parse(sys.argv[1]).iter() if e.tag in ("failure", "error")]
assert len(failed) == 2 and all(want in m for m in failed), failed
P
rm -r "$demo/tests/one" "$demo/tests/two"
expect 2 "nowhere/junit.xml" "$rhexis" test "$demo" --filter far --junit "$work/nowhere/junit.xml"
rm "$demo/tests/c_wrong.lua"
expect 0 "" "$rhexis" test "$demo"
expect 1 "" "$rhexis" test "$demo" --require-all
expect 0 "" "$rhexis" check "$demo/tests/a_far.lua"
expect 0 "" "$rhexis" check "$demo"
echo 'return 3' >"$demo/tests/d_broken.lua"
expect 1 "tests/d_broken.lua:1: the file must end with: return scenarios" "$rhexis" check "$demo"
# All files are told at once, and nothing follows from the curriculum that does not load.
echo 'return exercise {' >"$demo/curriculum.lua"
echo 'return starts {' >"$demo/starts.lua"
"$rhexis" check "$demo" >"$work/stdout" 2>"$work/stderr"
[ $? = 1 ] || fail "check: status of three mistakes"
grep -q "demo/curriculum.lua:" "$work/stderr" || fail "check: curriculum: $(cat "$work/stderr")"
grep -q "starts.lua:" "$work/stderr" || fail "check: starts: $(cat "$work/stderr")"
grep -q "tests/d_broken.lua:1:" "$work/stderr" || fail "check: tests: $(cat "$work/stderr")"
[ "$(grep -c . "$work/stderr")" = 3 ] || fail "check: three mistakes: $(cat "$work/stderr")"
cd / || exit 2
finished
