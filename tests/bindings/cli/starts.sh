#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# States to start from: kept by a run, prepared by an exercise, started from, replayed; and what is wrong with them.
set -u
. "$(dirname "$0")/expect.sh"
export RHEXIS_CACHE=$work/cache
repository=$PWD
cd "$work" || exit 2
small=(--no-pictures --set patient.tetrahedra=500)

# Kept at the end, at a time, at a moment; the run itself does not change by it.
expect 0 "" "$rhexis" run groove "${small[@]}" --limit 7 --out plain
expect 0 "" "$rhexis" run groove "${small[@]}" --limit 7 --out kept --save-state "half.rhxs@lens.removed_mm3 > 0.01"
says "state      half.rhxs"
expect 0 "" "$rhexis" run groove "${small[@]}" --limit 1 --out end --save-state end.rhxs
expect 0 "" "$rhexis" run groove "${small[@]}" --limit 1 --out at --save-state at.rhxs@0.5
hash_of() { sed -n 's/.*"state_hash": "\([0-9a-f]*\)".*/\1/p' "$1/report.json"; }
[ "$(hash_of plain)" = "$(hash_of kept)" ] || fail "keeping a state changed the run"
expect 0 "" "$rhexis" replay kept --verify
for file in half end at; do [ -s $file.rhxs ] || fail "no $file.rhxs"; done
[ -z "$(find . -name '*.unfinished' -o -name '*.part')" ] || fail "half-written files are left"

# Started from.
expect 0 "" "$rhexis" run groove "${small[@]}" --limit 1 --surgeon none --start half.rhxs --out from --json
says '"start": "half.rhxs"'
expect 0 "" "$rhexis" replay from --verify
says "identical: all 50 steps"
expect 0 "" "$rhexis" run groove "${small[@]}" --limit 1 --surgeon none --out fresh --json
[ "$(hash_of from)" != "$(hash_of fresh)" ] || fail "the state made no difference"
head -c $(($(stat -c %s from/recording.rhx) - 3000)) from/recording.rhx >cut.rhx
expect 0 "cut short" "$rhexis" replay cut.rhx --verify
says "identical"

# What is wrong.
from=("$rhexis" run groove "${small[@]}" --limit 1 --surgeon none --out bad --start)
expect 2 "the state was made for another scene: patient.age 68 there, 80 here" "${from[@]}" half.rhxs --set patient.age=80
expect 2 "patient.tetrahedra 500 there, 600 here" "${from[@]}" half.rhxs --set patient.tetrahedra=600
head -c 5000 half.rhxs >cut.rhxs
expect 2 "cut.rhxs: the state is cut short" "${from[@]}" cut.rhxs
cp half.rhxs changed.rhxs
printf 'X' | dd of=changed.rhxs bs=1 seek=9000 conv=notrunc status=none
expect 2 "changed.rhxs: the state is damaged" "${from[@]}" changed.rhxs
(printf 'rhexis state 99\n'; tail -c +17 half.rhxs) >other.rhxs
expect 2 "other.rhxs: the state has format version 99" "${from[@]}" other.rhxs
expect 2 "from/recording.rhx: this is not a state" "${from[@]}" from/recording.rhx
expect 2 "nowhere.rhxs: does not exist" "${from[@]}" nowhere.rhxs
[ ! -e bad ] || fail "a run that could not start left $(ls bad)"
expect 2 "there is no such folder" "$rhexis" run groove "${small[@]}" --save-state nowhere/a.rhxs
expect 2 "--save-state: time is 9000 (0 to 7200)" "$rhexis" run groove "${small[@]}" --save-state a.rhxs@9000
expect 2 "lacks its file or moment" "$rhexis" run groove "${small[@]}" --save-state a.rhxs@
expect 1 "unknown measure 'lens.remved_mm3' (did you mean lens.removed_mm3" "$rhexis" run groove "${small[@]}" --limit 1 \
    --out bad --save-state "a.rhxs@lens.remved_mm3 > 1"
expect 1 "no state was kept: its moment did not come" "$rhexis" run groove "${small[@]}" --limit 1 --out bad \
    --save-state "a.rhxs@lens.removed_mm3 > 1"
[ ! -e a.rhxs ] || fail "a state was kept although its moment did not come"

# Prepared by an exercise of one's own, for its scenarios and for a run.
cp -r "$repository/curricula/groove" mine
rm -r mine/tests
mkdir mine/tests
cat >mine/starts.lua <<'L'
return starts {
    begun = { surgeon = "d", seed = 5, when = "lens.removed_mm3 > 0.01", limit_s = 20 },
    by_hand = { function(t)
        t.phaco:enter()
        t.phaco:move_to({ 0, 0, 3 }, { speed = 20 })
        t.phaco:pedal(3)
        t.phaco:move_to({ 0, 0, 1.2 }, { speed = 3 })
        t:expect("lens.removed_mm3 > 0.01")
    end },
    wrong = { function(t)
        t:wait(0.1)
        t:expect("lens.removed_mm3 > 0.01")
    end },
    never = { when = "lens.removed_mm3 > 1e6", limit_s = 0.5 },
}
L
cat >mine/tests/begun.lua <<'L'
return scenarios {
    scenario "what was removed is gone, and the clock is new" {
        start = "begun", set = { patient = { tetrahedra = 500 } },
        function(t)
            t:expect("lens.removed_mm3 > 0.01 and time_s < 0.1 and phaco.path_mm == 0 and not phaco.present")
            t.phaco:enter()
            t.phaco:withdraw()
            t:expect("not phaco.present and phaco.path_mm > 1")
        end },
}
L
expect 0 "" "$rhexis" test mine
says "1 passed, 0 failed"
state=$(echo "$RHEXIS_CACHE"/states/mine-begun-*.rhxs)
[ -s "$state" ] || fail "no state is kept"
made() { stat -c %Y.%i "$state"; }
before=$(made)
expect 0 "" "$rhexis" test mine
[ "$(made)" = "$before" ] || fail "the state was made again for nothing"
echo '-- changed' >>mine/curriculum.lua
expect 0 "" "$rhexis" test mine
[ "$(made)" != "$before" ] || fail "the exercise changed, the state did not"
before=$(made)
echo X >"$state"
expect 0 "" "$rhexis" run mine "${small[@]}" --limit 0.5 --surgeon none --start begun --out from_name
[ "$(made)" != "$before" ] || fail "a damaged state was kept"
expect 0 "" "$rhexis" replay from_name --verify
expect 0 "" "$rhexis" run mine "${small[@]}" --limit 5 --start begun --out by_expert
"$rhexis" replay by_expert | grep -q '250 steps' || fail "an expert who starts from a state did not begin to operate"
expect 0 "" "$rhexis" replay by_expert --verify --score-with mine
says "identical: all 250 steps"
expect 2 "there is no start 'begin' (did you mean begun?)" "$rhexis" run mine "${small[@]}" --start begin
expect 0 "" "$rhexis" run mine "${small[@]}" --limit 0.1 --surgeon none --start by_hand --out from_hand
expect 2 "mine/starts.lua:12: expected \"lens.removed_mm3 > 0.01\", seen: lens.removed_mm3 = 0" "$rhexis" run mine \
    "${small[@]}" --start wrong
expect 2 "mine/starts.lua:14: start never: its moment did not come in 0.5 s" "$rhexis" run mine "${small[@]}" --start never
echo 'return starts { begun = { surgeon = "x", when = "time_s > 1" } }' >mine/starts.lua
expect 2 "mine/starts.lua:1: start begun: surgeon: there is no surgeon 'x'" "$rhexis" run mine "${small[@]}" --start begun
cp half.rhxs mine/tests
sed -i 's/"begun"/"half.rhxs"/' mine/tests/begun.lua
expect 0 "" "$rhexis" test mine
cp cut.rhxs mine/tests/half.rhxs
expect 2 "half.rhxs: the state is cut short" "$rhexis" test mine
echo 'return starts { begun = { when = 3 } }' >mine/starts.lua
expect 2 "mine/starts.lua:1: start begun: when must be a text in quotes, not 3" "$rhexis" run mine "${small[@]}" --start begun
echo 'return starts { begun = { seed = 3 } }' >mine/starts.lua
expect 2 "mine/starts.lua:1: start begun lacks 'when' (or a function(t) ... end, or opening)" "$rhexis" run mine --start begun
echo 'return starts { begun = { when = "time_s > 1", function(t) end } }' >mine/starts.lua
expect 2 "start begun has a function: neither surgeon nor when goes with it" "$rhexis" run mine --start begun
echo 'return starts { begun = { when = "lens.removed_mm3 >" } }' >mine/starts.lua
expect 2 "mine/starts.lua:1: a number or a measure is missing" "$rhexis" run mine "${small[@]}" --start begun
cd / || exit 2
finished
