#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Operations: exercises one after the other on one eye; what each leaves for the next, the score over all, and what is
# wrong with them.
set -u
. "$(dirname "$0")/expect.sh"
cd "$work" || exit 2

# Two small exercises: fill the chamber, and look how full it was left.
exercise fill >/dev/null <<'L'
return exercise {
    title = "Fill", tissues = { "viscoelastic" }, instruments = { "cannula" },
    settings = { ["viscoelastic.fill"] = 0.5 },
    goals = { fill = { 0.7, from = 0.1, to = 1.1 } },
    steps = { step "fill" { done = "viscoelastic.fill > goal.fill", time_limit_s = 20 } },
    errors = { error_event "Overfilled" { when = "viscoelastic.fill > 1.05", advice = "Less.", items = { "T3" } } },
    scoring = osacss { "T3" },
}
L
cat >fill/surgeon.lua <<'L'
return function(me)
    me.take_up({ 0, -8, 3 }, "cannula")
    me.go({ 0, 0, 3 }, 20)
    me.jaw(0.5)
    me.wait(30)
end
L
cp -r fill look
sed -i 's/title = "Fill"/title = "Look"/; s/step "fill" .*/step "look" { done = "step.time_s > 0.5" } },/' look/curriculum.lua
sed -i 's/    settings.*//' look/curriculum.lua
cat >look/surgeon.lua <<'L'
return function(me) me.wait(30) end
L
operation() {
    mkdir -p "$1"
    cat >"$1/curriculum.lua"
}
operation both <<'L'
return operation {
    title = "Both",
    patient = { age = 70 },
    parts = {
        part "fill" { exercise = "../fill" },
        part "look" { exercise = "../look", step_s = 0.02,
            begins_with = { ["viscoelastic.fill"] = "viscoelastic.fill - 0.1" } },
        part "look again" { exercise = "../look", continues = true,
            settings = { ["viscoelastic.fill"] = 1 } },
    },
    scoring = osacss { "T3", "T5" },
}
L
value() { python3 -c "import json,sys; print(eval('json.load(open(sys.argv[1]))' + sys.argv[2]))" "$1" "$2"; }

# More than the next model knows is the most that it knows.
operation beyond <<'L'
return operation {
    title = "Beyond",
    parts = {
        part "fill" { exercise = "../fill" },
        part "look" { exercise = "../look", begins_with = { ["viscoelastic.fill"] = "viscoelastic.fill + 5" } },
    },
    scoring = osacss { "T3" },
}
L
expect 0 "" "$rhexis" run beyond --no-pictures --out beyond_run
[ "$(value beyond_run/parts/02_look/series.json "['measures']['viscoelastic.fill']['values'][0]")" = 1.2 ] || fail "not within the range"

expect 0 "" "$rhexis" check both
expect 0 "" "$rhexis" run both --no-pictures --out whole
says "look_again"
[ "$(value whole/report.json "['completed']")" = True ] || fail "not completed"
[ "$(value whole/report.json "['patient']['age']")" = 70.0 ] || fail "the patient of the operation is not that of its parts"
[ "$(value whole/report.json "['steps'][2]['part']")" = look_again ] || fail "steps do not name their parts"
python3 - whole <<'P' || fail "what a part leaves is not what the next begins with"
import json, sys
left = [json.load(open(f"{sys.argv[1]}/parts/{name}/operation.json"))["carried"] for name in
        ("01_fill", "02_look", "03_look_again")]
filled, looked, again = (part["facts"]["viscoelastic.fill"] for part in left)
assert filled > 0.7, filled
assert abs(looked - (filled - 0.1)) < 0.02, (filled, looked)
assert abs(again - looked) < 0.02, (looked, again)   # the state goes on, whatever the setting says
whole = json.load(open(f"{sys.argv[1]}/report.json"))
parts = [json.load(open(f"{sys.argv[1]}/{part['folder']}/report.json")) for part in whole["parts"]]
steps = [len(json.load(open(f"{sys.argv[1]}/{part['folder']}/series.json"))["time_s"]) / part["duration_s"]
         for part in whole["parts"]]
assert steps[1] < 0.7 * steps[0], steps  # the part's own step, and of what continues it
assert steps[2] < 0.7 * steps[0], steps
assert abs(whole["duration_s"] - sum(part["duration_s"] for part in parts)) < 1e-9
assert whole["steps"][1]["start_s"] >= whole["steps"][0]["end_s"], whole["steps"]
items = {item["id"]: item for item in whole["osacss"]["items"]}
assert items["T5"].get("score") is None and items["T3"]["score"] >= 1, items
pressures = [part["measures"]["T3.pressure"] for part in parts]
assert whole["measures"]["T3.pressure"] == max(pressures), (whole["measures"], pressures)
series = json.load(open(f"{sys.argv[1]}/series.json"))
times = series["time_s"]
assert times == sorted(times) and abs(times[-1] - whole["duration_s"]) < 0.5, times[-1]
assert all(len(m["values"]) == len(times) for m in series["measures"].values())
P

# The same again gives the same; a part that is whole is not done again; a missing one is.
rm -r whole/parts/03_look_again
expect 0 "" "$rhexis" run both --no-pictures --out whole --resume
[ "$(value whole/report.json "['completed']")" = True ] || fail "not resumed"
touch -d '2000-01-01' whole/parts/01_fill/recording.rhx
expect 0 "" "$rhexis" run both --no-pictures --out whole --resume
[ whole/parts/01_fill/recording.rhx -ot both ] || fail "a part was done again"
expect 0 "" "$rhexis" run both --no-pictures --out whole --resume --seed 2
[ whole/parts/01_fill/recording.rhx -nt both ] || fail "a part of another seed was taken up"

# From the middle, and only so far.
expect 0 "" "$rhexis" run both --no-pictures --out middle --from look --to look
says "look again             not begun"
[ "$(ls middle/parts)" = 02_look ] || fail "not the middle: $(ls middle/parts)"
[ "$(value middle/report.json "['completed']")" = False ] || fail "a part counts as the whole"
[ "$(value middle/report.json "['begun_at']")" = look ] || fail "it does not say that it began in the middle"
[ "$(value middle/report.json "['osacss'].get('standing')")" = None ] || fail "a part is compared with whole ones"
[ "$(value middle/report.json "['not_begun']")" = "['fill', 'look again']" ] || fail "what was not begun is not named"
grep -qF "not begun: “fill”, “look again”." middle/report.html || fail "the page does not name what was not begun"
! grep -q not_begun whole/report.json || fail "all parts were begun"

# For one part, and for all.
expect 0 "" "$rhexis" run both --no-pictures --out set --set fill.goal.fill=0.6 --set patient.age=60
[ "$(value set/report.json "['patient']['age']")" = 60.0 ] || fail "--set is not for all parts"
[ "$(value set/parts/01_fill/report.json "['goals']['fill']")" = 0.6 ] || fail "--set is not for one part"

# Replayed, and judged again by other rules.
expect 0 "" "$rhexis" replay whole --verify
says "identical"
cp -r both other
sed -i 's/osacss { "T3", "T5" }/osacss { "T3", "G6" }/' other/curriculum.lua
expect 0 "" "$rhexis" replay whole --score-with other --json
says '"id": "G6"'
sed -i 's/scoring = .*/scoring = osacss.all,/' other/curriculum.lua
expect 0 "" "$rhexis" replay whole --score-with other --json
for item in T1 T14 G6; do says "\"id\": \"$item\""; done
expect 2 "these are the parts of an operation" "$rhexis" replay whole --score-with fill
expect 0 "" "$rhexis" replay whole --score-with ico_oscar --json
says '"rubric": "ICO-OSCAR"'
mv both elsewhere
expect 2 "both" "$rhexis" replay whole --score-with ico_oscar
mv elsewhere both

# What is wrong.
expect 2 "--from nothing: the operation has no such part (one of fill, look, look_again)" "$rhexis" run both --from nothing
expect 2 "--from look comes after --to fill" "$rhexis" run both --from look --to fill
expect 2 "--start is for exercises" "$rhexis" run both --start x.rhxs
expect 2 "are for operations, and fill is an exercise" "$rhexis" run fill --resume
wrong() {  # TEXT: check refuses the operation on stdin so
    operation wrong
    expect 1 "$1" "$rhexis" check wrong
    expect 2 "$1" "$rhexis" run wrong --out never
    [ ! -e never ] || { fail "a wrong operation left files"; rm -r never; }
}
wrong "wrong/curriculum.lua:2: circular composition: part me leads back to wrong (an operation is made of exercises)" <<'L'
return operation { title = "Wrong", parts = {
    part "me" { exercise = "../wrong" } } }
L
operation ring <<'L'
return operation { title = "Ring", parts = { part "back" { exercise = "../wrong" } } }
L
wrong "circular composition: part back leads back to wrong" <<'L'
return operation { title = "Wrong", parts = {
    part "ring" { exercise = "../ring" } } }
L
wrong "part both: both is itself an operation" <<'L'
return operation { title = "Wrong", parts = { part "both" { exercise = "../both" } } }
L
wrong "wrong/curriculum.lua:1: part nowhere: there is no curriculum 'nowhere'" <<'L'
return operation { title = "Wrong", parts = { part "nowhere" {} } }
L
wrong "part set_upp: there is no curriculum 'set_upp' (did you mean 'set_up'?) (or a folder, as seen from" <<'L'
return operation { title = "Wrong", parts = { part "set_upp" {} } }
L
wrong "a rubric has no 'al' (did you mean all?)" <<'L'
return operation { title = "Wrong", parts = { part "fill" { exercise = "../fill" } }, scoring = osacss.al }
L
wrong "part 'a' is the first: it has nothing to continue" <<'L'
return operation { title = "Wrong", parts = { part "a" { exercise = "../fill", continues = true } } }
L
wrong "part 'b' continues the one before it, whose step_s is its own as well" <<'L'
return operation { title = "Wrong", parts = { part "a" { exercise = "../fill" },
    part "b" { exercise = "../look", continues = true, step_s = 0.02 } } }
L
wrong "part 'a': step_s = 0.1 is out of range (0.001 to 0.02)" <<'L'
return operation { title = "Wrong", parts = { part "a" { exercise = "../fill", step_s = 0.1 } } }
L
wrong "part 'b': there is no part 'c' before it" <<'L'
return operation { title = "Wrong", parts = { part "a" { exercise = "../fill" },
    part "b" { exercise = "../look", opening = "c" } } }
L
wrong "part 'a' has no field 'continue' (did you mean continues?)" <<'L'
return operation { title = "Wrong", parts = { part "a" { exercise = "../fill", continue = true } } }
L
wrong "the exercise has no goal 'fil' (did you mean fill?)" <<'L'
return operation { title = "Wrong", parts = { part "a" { exercise = "../fill", goals = { fil = 1 } } } }
L
wrong "there is no setting viscoelastic.fil" <<'L'
return operation { title = "Wrong", parts = { part "a" { exercise = "../fill",
    settings = { ["viscoelastic.fil"] = 1 } } } }
L

# A script that fails in the middle of it: what was done stays, and there is a report.
cp -r look broken
sed -i 's/done = "step.time_s > 0.5"/done = function(eye) return eye.time_s > 0.3 and eye.nothing.x end/' broken/curriculum.lua
operation half <<'L'
return operation { title = "Half", scoring = osacss { "T3" }, parts = {
    part "fill" { exercise = "../fill" }, part "broken" { exercise = "../broken" }, part "look" { exercise = "../look" } } }
L
expect 1 "part broken: broken/curriculum.lua:" "$rhexis" run half --no-pictures --out half_run
[ -s half_run/report.html ] && [ -s half_run/parts/02_broken/recording.rhx ] || fail "nothing is left of a broken operation"
[ ! -e half_run/parts/03_look ] || fail "the operation went on after its script broke"
[ "$(value half_run/report.json "['not_begun']")" = "['look']" ] || fail "a broken operation does not name what was not begun"
expect 1 "half_run/parts/02_broken: broken/curriculum.lua:" "$rhexis" replay half_run --score-with half
says "for what was done"
expect 1 "half_run/parts/02_broken: broken/curriculum.lua:" "$rhexis" replay half_run --score-with half --json
says '"osacss"'
finished
