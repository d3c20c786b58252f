#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Exercises that begin with a folded implant: it is folded when it is asked for first, by one process, kept and shared.
set -u
. "$(dirname "$0")/expect.sh"
export RHEXIS_CACHE=$work/cache
cd "$work" || exit 2

mkdir -p mine/tests other
cat >mine/curriculum.lua <<'L'
return exercise {
    title = "Push it out",
    tissues = { "implant", "iris", "cornea", "viscoelastic" },
    instruments = { "hook", "injector" },
    settings = { ["implant.triangles"] = 400 },
    step_s = 0.02,
    steps = { step "push" { done = "implant.delivered > 0.1" } },
}
L
sed 's/"hook", "injector"/"injector"/; s/"iris", "cornea", "viscoelastic"/"iris"/; s/step_s = 0.02,/patient = { age = 80 },/' \
    mine/curriculum.lua >other/curriculum.lua
cat >mine/starts.lua <<'L'
return starts {
    brought = { function(t)
        t.injector:enter()
        t.injector:move_to({ 0, -2, 1.5 }, { speed = 20 })
        t:wait(0.1)
    end },
}
L
cp mine/starts.lua other
cat >mine/tests/folded.lua <<'L'
return scenarios {
    scenario "it lies in the injector" {
        function(t)
            t:expect("not implant.released and implant.delivered == 0 and not injector.present")
        end },
    scenario "it has come into the eye with the injector" {
        start = "brought",
        function(t)
            t:expect("implant.released")  -- nobody holds it any more
        end },
}
L

run=("$rhexis" run mine --no-pictures --surgeon none --limit 0.1)
expect 2 "cartridge.bore_mm is 1.8, too small for the implant (at least 2." "${run[@]}" \
    --set cartridge.bore_mm=1.8 --set cartridge.nozzle_mm=1.8 --out refused
expect 2 "mine/starts.lua:2: start brought: cartridge.bore_mm is 1.8, too small for the implant" "${run[@]}" \
    --start brought --set cartridge.bore_mm=1.8 --set cartridge.nozzle_mm=1.8 --out refused
[ ! -e refused ] || fail "a run that could not start left something"
[ -z "$(ls "$RHEXIS_CACHE"/states/*.rhxs 2>/dev/null)" ] || fail "a lens that cannot be folded was kept"

# Two at once: one folds, the other waits for it.
for one in first second; do "${run[@]}" --out $one >$one.txt 2>&1 & done
wait
for one in first second; do
    [ -s $one/report.json ] || fail "of two runs at once, the $one failed: $(cat $one.txt)"
done
state=$(echo "$RHEXIS_CACHE"/states/folded-*.rhxs)
[ -s "$state" ] || fail "no folded implant is kept, or more than one: $state"
made() { stat -c %Y.%i "$state"; }
before=$(made)
hash_of() { sed -n 's/.*"state_hash": "\([0-9a-f]*\)".*/\1/p' "$1/report.json"; }
[ "$(hash_of first)" = "$(hash_of second)" ] || fail "two runs from one implant differ"
expect 0 "" "$rhexis" replay first --verify

# Shared by tests, other exercises and patients; kept whatever the exercise says.
expect 0 "" "$rhexis" test mine
says "2 passed, 0 failed"
expect 0 "" "$rhexis" run other --no-pictures --surgeon none --limit 0.1 --out other_eye
echo '-- changed' >>mine/curriculum.lua
expect 0 "" "${run[@]}" --out again
[ "$(made)" = "$before" ] || fail "the implant was folded again for nothing"
[ -z "$(find . -name '*.unfinished' -o -name '*.part')" ] || fail "half-written files are left"

# A file of its own, for what else differs it is refused.
expect 0 "" "${run[@]}" --start "$state" --out from_file
expect 2 "the implant was folded with other settings: implant.haptic_mm 0.4 there, 0.3 here" "${run[@]}" \
    --start "$state" --set implant.haptic_mm=0.3 --out refused
sed -i 's/"hook", "injector"/"hook"/; s/implant.delivered > 0.1/time_s > 1/' mine/curriculum.lua
expect 2 "the scene names no instrument injector" "${run[@]}" --start "$state" --out refused

echo 'return starts { begin = {} }' >mine/starts.lua
expect 2 "mine/starts.lua:1: start begin lacks 'when' (or a function(t) ... end, or opening)" "${run[@]}"
echo 'return starts { begin = { opening = "a.rhxs", surgeon = "d" } }' >mine/starts.lua
expect 2 "start begin names a surgeon, but lacks 'when'" "${run[@]}"
finished
