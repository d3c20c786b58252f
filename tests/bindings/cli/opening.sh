#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A bag with the opening that a run of a capsulorhexis has left: from its state, its recording, or a start of its
# exercise; and what is refused.
set -u
. "$(dirname "$0")/expect.sh"
repository=$PWD
cd "$work" || exit 2

# A capsulorhexis on a coarse sheet, kept on its way and when it has come round.
torn=(--no-pictures --surgeon expert --seed 103 --set capsule.triangles=300)
capsulorhexis() { timeout 400 "$rhexis" run capsulorhexis "${torn[@]}" "$@" >said.txt 2>&1 || fail "$*: $(cat said.txt)"; }
capsulorhexis --out whole --save-state "round.rhxs@rhexis.closed"
capsulorhexis --out begun --save-state half.rhxs --limit 40
expect 0 "" "$rhexis" run capsulorhexis "${torn[@]}" --out shut --save-state shut.rhxs --limit 0.1

mkdir -p mine/tests
cat >mine/curriculum.lua <<'L'
return exercise {
    title = "Look at the bag",
    tissues = { "implant", "bag", "viscoelastic" },
    instruments = { "injector", "hook" },
    settings = { ["implant.triangles"] = 400 },
    step_s = 0.02,
    steps = { step "look" { done = "time_s > 10" } },
}
L
run=("$rhexis" run mine --no-pictures --surgeon none --limit 0.1)
hash_of() { sed -n 's/.*"state_hash": "\([0-9a-f]*\)".*/\1/p' "$1/report.json"; }
radii_of() { tr -d ' \n' <"$1/report.json" | sed -n 's/.*"opening_mm":\(\[[^]]*\]\|null\).*/\1/p'; }

# State, recording and folder say the same; the recording of what they begin holds it.
for given in round.rhxs whole whole/recording.rhx; do
    expect 0 "" "${run[@]}" --opening $given --out "from_$(basename $given)"
done
[ "$(radii_of from_round.rhxs | tr ',' '\n' | grep -c .)" = 64 ] || fail "no 64 radii: $(radii_of from_round.rhxs)"
for other in whole recording.rhx; do
    [ "$(radii_of from_$other)" = "$(radii_of from_round.rhxs)" ] || fail "state and $other differ"
    [ "$(hash_of from_$other)" = "$(hash_of from_round.rhxs)" ] || fail "runs from state and $other differ"
done
expect 0 "" "${run[@]}" --out circle
[ "$(radii_of circle)" = null ] || fail "a circle has radii: $(radii_of circle)"
[ "$(hash_of circle)" != "$(hash_of from_whole)" ] || fail "the opening made no difference"
mkdir apart
mv from_whole apart
(cd apart && expect 0 "" "$rhexis" replay from_whole --verify && says "identical: all 5 steps") || fail "it does not replay alone"

# A state keeps it, too; another one does not go with it.
expect 0 "" "${run[@]}" --opening round.rhxs --out kept --save-state open.rhxs
expect 0 "" "${run[@]}" --start open.rhxs --out on
[ "$(radii_of on)" = "$(radii_of kept)" ] || fail "the state lost its opening"
expect 0 "" "${run[@]}" --start open.rhxs --opening whole --out on
expect 0 "" "${run[@]}" --out kept --save-state circle.rhxs
expect 2 "the state was made for another scene: opening a circle there, torn, " "${run[@]}" --start circle.rhxs \
    --opening round.rhxs --out bad

# An exercise says it in its starts: a file beside them, a start of another exercise; alone, or with a hand after it.
cp round.rhxs mine/torn.rhxs
cat >mine/starts.lua <<'L'
return starts {
    begin = { opening = "torn.rhxs" },
    later = { opening = "torn.rhxs", function(t) t:wait(0.1) end },
    again = { opening = "mine:later" },
    closed = { opening = "./tears:shut" },
}
L
cp -r "$repository/curricula/capsulorhexis" tears
cat >tears/starts.lua <<'L'
return starts {
    shut = { set = { ["capsule.triangles"] = 300 }, function(t) t:wait(0.1) end },
    round = { set = { ["capsule.triangles"] = 300 }, surgeon = "expert", seed = 103, when = "rhexis.closed" },
}
L
cat >mine/tests/look.lua <<'L'
return scenarios {
    scenario "the rim is as it was torn" { function(t) t:expect_near("bag.rim_stretch", 1, 0.1) end },
    scenario "and after a while" { start = "later", function(t) t:wait(0.1) end },
}
L
expect 0 "" "${run[@]}" --out named
[ "$(radii_of named)" = "$(radii_of from_round.rhxs)" ] || fail "the start has another opening than its file"
expect 0 "" "${run[@]}" --start later --out later
[ "$(radii_of later)" = "$(radii_of named)" ] || fail "the start that waits has another opening"
expect 0 "" "$rhexis" replay later --verify
expect 0 "" "$rhexis" test mine
says "2 passed, 0 failed"
(cd mine && expect 0 "" "$rhexis" check .) || fail "check does not find the file beside the starts"
timeout 400 "${run[@]}" --opening ./tears:round --out from_start >said.txt 2>&1 || fail "EXERCISE:START: $(cat said.txt)"
[ "$(radii_of from_start)" = "$(radii_of named)" ] || fail "the start of the exercise was torn otherwise"

# What is refused.
bad=("${run[@]}" --out bad --opening)
expect 2 "nowhere.rhxs: does not exist" "${bad[@]}" nowhere.rhxs
expect 2 "mine/curriculum.lua: this is neither a state nor a recording" "${bad[@]}" mine/curriculum.lua
expect 2 "mine/recording.rhx: does not exist" "${bad[@]}" mine
(printf 'rhexis state 9\n'; tail -c +17 round.rhxs) >old.rhxs
expect 2 "old.rhxs: the state has format version 9 (this program reads version" "${bad[@]}" old.rhxs
(printf 'rhexis recording 9\n'; tail -c +21 whole/recording.rhx) >old.rhx
expect 2 "old.rhx: the recording has format version 9" "${bad[@]}" old.rhx
head -c 9000 round.rhxs >cut.rhxs
expect 2 "cut.rhxs: the state is cut short" "${bad[@]}" cut.rhxs
cp whole/recording.rhx damaged.rhx
printf 'X' | dd of=damaged.rhx bs=1 seek=2000000 conv=notrunc status=none
expect 2 "damaged.rhx: the recording is damaged at byte" "${bad[@]}" damaged.rhx
expect 2 "circle.rhxs: it holds no anterior capsule" "${bad[@]}" circle.rhxs
expect 2 "shut.rhxs: the anterior capsule is not open" "${bad[@]}" shut.rhxs
expect 2 "half.rhxs: the opening is not closed: its tear has come round by" "${bad[@]}" half.rhxs
expect 2 "begun/recording.rhx: the opening is not closed" "${bad[@]}" begun
expect 2 "an opening is given, but the scene has no bag that one is torn in" "$rhexis" run groove --surgeon none \
    --no-pictures --out bad --opening round.rhxs
expect 2 "the opening is that of round.rhxs, and capsulorhexis.diameter_mm is set too (the one or the other)" "${bad[@]}" \
    round.rhxs --set capsulorhexis.diameter_mm=5
expect 2 "there is no start 'torn'" "${bad[@]}" ./tears:torn
expect 2 "mine/starts.lua:3: start later takes its opening from elsewhere: none can be taken from it" "${run[@]}" --out bad \
    --start again
grep -qF "mine/starts.lua:4: start again: opening: " "$work/stderr" || fail "not at its line: $(cat "$work/stderr")"
timeout 100 "${run[@]}" --out bad --start closed >said.txt 2>&1 && fail "a closed capsule made an opening"
grep -qF "the anterior capsule is not open" said.txt || fail "why is not said: $(cat said.txt)"
[ ! -e bad ] || fail "a run that could not start left $(ls bad)"
# In an operation an opening that no bag can have, here none at all, is a round one, and the report says so.
mkdir leave operation
cat >leave/curriculum.lua <<'L'
return exercise {
    title = "Leave", tissues = { "anterior_capsule" }, instruments = { "cystotome" },
    settings = { ["capsule.triangles"] = 300 },
    steps = { step "look" { done = "step.time_s > 0.1" } },
}
L
rm -f mine/starts.lua
echo 'return function(me) me.wait(1) end' | tee leave/surgeon.lua >mine/surgeon.lua
cat >operation/curriculum.lua <<'L'
return operation {
    title = "Not opened",
    parts = { part "leave" { exercise = "../leave" },
        part "lay" { exercise = "../mine", opening = "leave", time_limit_s = 1 } },
    scoring = osacss { "G6" },
}
L
expect 0 "" "$rhexis" run operation --no-pictures --out unopened
grep -q "begins with a round opening, not with what was torn: the anterior capsule is not open" unopened/report.json ||
    fail "no word of the round opening: $(cat "$work/stdout")"
grep -q "“.*” began with a round opening of the bag" unopened/report.html || fail "the page has no word of it"

finished
