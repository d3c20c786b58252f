#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Studies: groups of virtual surgeons on a small exercise; resumed; and what is wrong with them.
set -u
. "$(dirname "$0")/expect.sh"
root=$(cd "$(dirname "$0")/../../.." && pwd)
cd "$work" || exit 2

exercise fill >/dev/null <<'L'
return exercise {
    title = "Fill", tissues = { "viscoelastic" }, instruments = { "cannula" },
    settings = { ["viscoelastic.fill"] = 0.5 },
    steps = { step "fill" { done = "viscoelastic.fill > 0.8", time_limit_s = 8 } },
    errors = { error_event "Overfilled" { when = "viscoelastic.fill > 1.05", advice = "Less.", items = { "T3" } } },
    scoring = osacss { "T3" },
}
L
cat >fill/surgeon.lua <<'L'
return function(me)
    me.take_up({ 0, -8, 3 }, "cannula")
    me.go({ 0, 0, 3 }, 20)
    me.jaw(me.about(0.5))
    me.wait(30)
end
L
plan() { cat >"$1.json"; }
plan small <<'J'
{"title": "Small", "groups": ["a", "d"], "seeds": [1, 2], "limit_s": 5, "exercises": [{"exercise": "fill"}],
 "published": {"source": "nobody", "groups": {"a": {"n": 3, "mean": 40.0, "sd": 2.0}}}}
J
expect 0 "" "$rhexis" study small.json --out study --jobs 2
says "| a | 2 |"
says "40.0 ± 2.0 (3)"
says "| a and d |"
python3 - <<'P' || fail "study.json is not what its runs say"
import json, statistics
study = json.load(open("study/study.json"))
scores = {group: [20 * json.load(open(f"study/1-fill-{group}-{seed}/report.json"))["osacss"]["items"][0]["score"]
                  for seed in (1, 2)] for group in "ad"}
for group in study["groups"]:
    own = scores[group["group"]]
    assert abs(group["mean"] - statistics.mean(own)) < 1e-9, (group, own)
    assert abs(group["sd"] - statistics.stdev(own)) < 1e-9, (group, own)
assert [s["seed"] for s in study["surgeons"]] == [1, 2, 1, 2]
assert len(study["groups_sha256"]) == 64
P
cp study/study.json before.json
touch -d '2000-01-01' study/1-fill-a-1/recording.rhx study/1-fill-d-2/recording.rhx
rm study/1-fill-d-2/study_run.json
expect 0 "" "$rhexis" study small.json --out study --resume
[ study/1-fill-a-1/recording.rhx -ot small.json ] || fail "an attempt that was there was made again"
[ study/1-fill-d-2/recording.rhx -nt small.json ] || fail "an attempt that was not whole was kept"
python3 -c "
import json
a, b = (json.load(open(f)) for f in ('before.json', 'study/study.json'))
a.pop('cpu_s'), b.pop('cpu_s')
assert a == b" || fail "a resumed study finds something else"

# Gates tried some seeds at a time: the table of the earlier ones is added to, each seed once.
if "$rhexis" records --help >/dev/null 2>&1; then
    plan tried <<'J'
{"title": "Tried", "groups": ["a", "d"], "seeds": [1, 2], "limit_s": 5, "gates": true, "exercises": [{"exercise": "fill"}]}
J
    expect 0 "" "$rhexis" study tried.json --seeds 1-1 --out tried_1
    expect 0 "" "$rhexis" study tried.json --seeds 2-2 --with tried_1/gates_accepted.json --out tried_2
    python3 - <<'P' || fail "the table of two seeds is not the sum of both"
import json
tables = [json.load(open(f"tried_{i}/gates_accepted.json")) for i in (1, 2)]
assert tables[0]["seeds"] == [1] and tables[1]["seeds"] == [1, 2]
for group in "ad":
    one, both = (table["exercises"]["fill"]["groups"][group] for table in tables)
    assert one["of"] == 1 and both["of"] == 2 and both["passed"] in (one["passed"], one["passed"] + 1)
P
    expect 2 "seed 1 is in this table already" "$rhexis" study tried.json --seeds 1-1 --out tried_1 --resume \
        --with tried_1/gates_accepted.json
    sed 's/"decides": "./"decides": "x/' tried_1/gates_accepted.json >other.json
    expect 2 "tried with another exercise or gate: fill" "$rhexis" study tried.json --seeds 2-2 --with other.json \
        --out never
    expect 2 "cannot read" "$rhexis" study tried.json --seeds 2-2 --with nowhere.json --out never
    expect 2 "excludes" "$rhexis" study gates --check --seeds 9305-9306
    # The gates that there are, and what they gave when they were tried.
    # Exercises with a lens are others since they were tried (docs/study.md); nothing else may be amiss.
    "$rhexis" study gates --check >check.txt 2>&1 || true
    if grep -v "is another exercise than the one that was tried" check.txt; then
        fail "a gate is not what was tried"
    fi
    expect 0 "" python3 "$root/scripts/dev/gates.py" "$root/rubrics/cohorts.json" "$root/rubrics/gate_marks.json" --check
    expect 2 "--with is for a study of gates" "$rhexis" study small.json --with tried_1/gates_accepted.json --out never
fi
expect 2 "FIRST-LAST within 1-2" "$rhexis" study small.json --seeds 2-3 --out never
expect 2 "FIRST-LAST within 1-2" "$rhexis" study small.json --seeds 2 --out never

# Judged again: by the same rules the same, by others not; nothing is simulated, and study.json stays.
same_scores() {  # study.json and judged_again.json of a folder
    python3 - "$1" <<'P'
import json, sys
a, b = (json.load(open(f"{sys.argv[1]}/{name}.json")) for name in ("study", "judged_again"))
a.pop("cpu_s"), b.pop("cpu_s")
sys.exit(a != b)
P
}
cp study/study.json before.json
expect 0 "" "$rhexis" study small.json --out study --judge-again
says "study/judged_again.md"
same_scores study || fail "judged by the same rules it is another study"
sed -i 's/osacss { "T3" }/osacss { "T3", "G6" }/' fill/curriculum.lua
expect 0 "" "$rhexis" study small.json --out study --judge-again
says "| G6 |"
cmp -s before.json study/study.json || fail "judging again has changed study.json"
sed -i 's/osacss { "T3", "G6" }/osacss { "T3" }/' fill/curriculum.lua
expect 1 "cannot read" "$rhexis" study small.json --out nowhere --judge-again
[ ! -e nowhere ] || fail "what is not there was made"
expect 2 "excludes" "$rhexis" study small.json --out study --judge-again --resume

# An operation in place of an exercise.
mkdir twice
cat >twice/curriculum.lua <<'L'
return operation { title = "Twice", scoring = osacss { "T3" }, parts = {
    part "fill" { exercise = "../fill" }, part "once more" { exercise = "../fill" } } }
L
plan whole <<'J'
{"title": "Whole", "groups": ["a"], "seeds": [1, 1], "limit_s": 5, "exercises": [{"exercise": "twice"}]}
J
expect 0 "" "$rhexis" study whole.json --out whole
says "1 of 1"
expect 0 "" "$rhexis" study whole.json --out whole --judge-again
same_scores whole || fail "an operation judged by the same rules is another"
rm whole/1-twice-a-1/study_run.json
touch -d '2000-01-01' whole/1-twice-a-1/parts/01_fill/recording.rhx
expect 0 "" "$rhexis" study whole.json --out whole --resume
[ whole/1-twice-a-1/parts/01_fill/recording.rhx -ot whole.json ] || fail "a part that was there was done again"

wrong() {  # TEXT: the study on stdin is refused so
    plan wrong
    expect 2 "$1" "$rhexis" study wrong.json --out never
    [ ! -e never ] || { fail "a wrong study left files"; rm -r never; }
}
expect 2 "there is no study 'part_exercise' (did you mean part_exercises?)" "$rhexis" study part_exercise
wrong "wrong.json: this is no JSON object" <<<'{'
wrong 'wrong.json: title: is missing (a text)' <<<'{"groups": ["a"], "seeds": [1, 2], "exercises": [{"exercise": "fill"}]}'
wrong 'seeds: [2,1] ([first, last], at most 1000)' <<<'{"title": "x", "groups": ["a"], "seeds": [2, 1], "exercises": [{"exercise": "fill"}]}'
wrong "seed: is no field of a study (did you mean seeds?)" <<<'{"title": "x", "groups": ["a"], "seeds": [1, 2], "seed": 1, "exercises": [{"exercise": "fill"}]}'
wrong "exercise 1: starts: is no field of a study (did you mean start?)" <<<'{"title": "x", "groups": ["a"], "seeds": [1, 2], "exercises": [{"exercise": "fill", "starts": "x"}]}'
wrong "start is for exercises, and twice is an operation" <<<'{"title": "x", "groups": ["a"], "seeds": [1, 1], "exercises": [{"exercise": "twice", "start": "begin"}]}'
wrong "there is no surgeon 'e'" <<<'{"title": "x", "groups": ["e"], "seeds": [1, 2], "exercises": [{"exercise": "fill"}]}'
wrong "there is no curriculum 'fil'" <<<'{"title": "x", "groups": ["a"], "seeds": [1, 2], "exercises": [{"exercise": "fil"}]}'
finished
