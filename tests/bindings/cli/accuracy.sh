#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Error budgets on the command line: what is chosen, what is said where nothing keeps them, tables that are missing or
# changed, replays that do not care, and rhexis run --accuracy measure.
set -u
. "$(dirname "$0")/expect.sh"
repository=$PWD

# a program's folder whose tables may be changed
home="$work/home"
mkdir -p "$home/assets"
for part in scripts curricula courses rubrics; do ln -s "$repository/$part" "$home/$part"; done
cp -r "$repository/assets/accuracy" "$home/assets/accuracy"
export RHEXIS_HOME="$home"

# chosen FILE PYTHON: what an expression over a report's accuracy gives.
chosen() { python3 -c 'import json, sys; a = json.load(open(sys.argv[1]))["accuracy"]; print(eval(sys.argv[2]))' "$1" "$2"; }
is() { [ "$1" = "$2" ] || fail "'$1' is not '$2'"; }

# lens REST: an exercise at a lens; what is given stands on line 4
lens() {
    exercise mine >/dev/null <<END
return exercise {
    title = "T", patient = { age = 68 }, tissues = { "lens", "bag", "iris" }, instruments = { "phaco" },
    goals = {},
    $1
    steps = { step "work" { done = "phaco.tip_depth_mm > 3" } }, time_limit_s = 1,
}
END
}
run() { "$rhexis" run "$work/mine" --surgeon none --no-pictures --out "$work/out" "$@" >"$work/stdout" 2>"$work/stderr"; }

# Bad input: one clear line.
lens 'accuracy = { forse = 0.5 },'
expect 1 "curriculum.lua:4: accuracy has no field 'forse' (did you mean force?)" "$rhexis" check "$work/mine"
lens 'accuracy = { force = 0.001 },'
expect 1 "curriculum.lua:4: accuracy: no mesh and step of the lens keeps force 0.001, volume 0.1 (the nearest is" \
    "$rhexis" check "$work/mine"
lens 'accuracy = { tear = 0.1 },'
expect 1 "curriculum.lua:4: accuracy: nothing in this scene is judged by tear (one of force, time, volume)" \
    "$rhexis" check "$work/mine"
lens ''
expect 2 "accuracy.force" "$rhexis" run "$work/mine" --set accuracy.forse=1 --out "$work/none"
sed -i 's/table 1/table 7/' "$home/assets/accuracy/lens.csv"
expect 2 "lens.csv: the accuracy table has version 7 (this program reads version 1" "$rhexis" run "$work/mine" --out "$work/none"
rm "$home/assets/accuracy/lens.csv"
expect 2 "the accuracy table of lens cannot be read" "$rhexis" run "$work/mine" --out "$work/none"
[ ! -e "$work/none" ] || fail "a run that could not begin left a folder"

# What is chosen is the cheapest, stands in the report, and is replayed as it was when the tables have changed.
cat >"$home/assets/accuracy/lens.csv" <<'END'
# rhexis accuracy table 1
# answer: made up
# machine: made up
way,not_with,patient.tetrahedra,step_ms,cost,volume,force,depth
explicit,,500,20,0.1,0.2,0.7,0.02
explicit,,500,10,0.2,0.2,0.6,0.02
explicit,,1000,20,0.3,0.05,0.5,0.02
explicit,,1000,10,0.4,0.05,0.4,0.02
explicit,,1500,10,1.5,0.01,0.1,0.02
END
lens 'accuracy = { volume = 0.3, force = 0.75 },'
run || fail "no run: $(cat "$work/stderr")"
is "$(chosen "$work/out/report.json" 'a["step_s"], a["models"][0]["mesh"]["patient.tetrahedra"], a["models"][0]["expected"]["force"]')" \
    "(0.01, 500.0, 0.6)"
is "$(chosen "$work/out/report.json" 'a["cost"], a["models"][0]["by_hand"], a["measured"]')" "(0.2, False, None)"
grep -q "How finely it was simulated" "$work/out/report.html" || fail "the page does not tell of it"
sed -i 's/explicit,,500,10,0.2,0.2,0.6/explicit,,500,10,0.2,0.9,0.9/' "$home/assets/accuracy/lens.csv"
expect 0 "" "$rhexis" replay "$work/out" --verify
says "identical"
expect 0 "" "$rhexis" replay "$work/out" --score-with "$work/mine" --json
rm -r "$work/out"
run || fail "no run: $(cat "$work/stderr")"
is "$(chosen "$work/out/report.json" 'a["models"][0]["mesh"]["patient.tetrahedra"]')" "1000.0"
mv "$home/assets/accuracy" "$home/assets/gone"
expect 0 "" "$rhexis" replay "$work/out" --verify
says "identical"
expect 0 "" "$rhexis" replay "$work/out" --score-with "$work/mine" --json
mv "$home/assets/gone" "$home/assets/accuracy"
run --set accuracy.time=0.02 --set accuracy.volume=0.95 --set accuracy.force=1 || fail "no run: $(cat "$work/stderr")"
is "$(chosen "$work/out/report.json" 'a["step_s"], a["models"][0]["mesh"]["patient.tetrahedra"]')" "(0.02, 500.0)"

# Warnings: what is by hand, what is not in real time, what is for nothing.
lens 'accuracy = { volume = 0.02, force = 0.2 },'
expect 0 "" "$rhexis" check "$work/mine"
says "warning: accuracy: not in real time on one core: 1.5 CPU s per simulated s by the tables, measured on made up"
lens 'accuracy = { volume = 0.1, force = 0.5 },'
sed -i 's/age = 68/age = 68, tetrahedra = 500/; s/"iris" }/"iris", "cornea", "globe" }/' "$work/mine/curriculum.lua"
expect 0 "" "$rhexis" check "$work/mine"
says "warning: accuracy: lens: patient.tetrahedra = 500 by hand does not keep its budget"
says "the budget alone would take patient.tetrahedra = 1000"
says "warning: tissues: no step, event, measure, score or picture of this exercise uses globe"
run || fail "no run: $(cat "$work/stderr")"
is "$(chosen "$work/out/report.json" 'a["models"][0]["by_hand"], a["models"][0]["instead"]["patient.tetrahedra"]')" "(True, 1000.0)"

# Measured: again at twice the resolution, by the same hand.
unset RHEXIS_HOME
timeout 500 "$rhexis" run groove --surgeon expert --seed 1 --set patient.tetrahedra=500 --limit 8 --no-pictures --accuracy measure \
    --out "$work/groove" >"$work/stdout" 2>"$work/stderr" || fail "not measured: $(cat "$work/stderr")"
says "accuracy   against twice the resolution, "
is "$(chosen "$work/groove/report.json" 'a["measured"]["mesh"]["patient.tetrahedra"], a["measured"]["step_s"]')" "(4000.0, 0.01)"
is "$(chosen "$work/groove/report.json" '0 < a["measured"]["compared_s"] <= a["measured"]["of_s"] == 8.0')" "True"
is "$(chosen "$work/groove/report.json" '0 < a["measured"]["errors"]["force"] < 10')" "True"
grep -q "Measured error" "$work/groove/report.html" || fail "the page does not tell what was measured"
expect 2 "--accuracy is for exercises" "$rhexis" run full_operation --accuracy measure --out "$work/none"
finished
