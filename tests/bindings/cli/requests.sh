#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What a virtual surgeon asks of the staff is recorded, replayed bit for bit, judged again and shown in the report; names
# that are wrong are told.
set -u
. "$(dirname "$0")/expect.sh"

exercise ask >/dev/null <<'L'
return exercise {
    title = "Asking", patient = { tetrahedra = 500 }, instruments = { "phaco" },
    tissues = { "lens", "bag", "capsule", "iris", "cornea", "chamber" },
    requests = {
        request "Bottle down" { settings = { ["machine.bottle_cm"] = 40 }, meaning = "to 40", answer = "Bottle at 40." },
    },
    steps = { step "low" { done = "requested.bottle_down and chamber.pressure_mmhg < 35" } },
    time_limit_s = 6,
}
L
cat >"$work/ask/surgeon.lua" <<'L'
return function(me)
    me.wait_until(function(seen) return seen and seen.landmarks.incision end, 2)
    local wound = me.see().landmarks.incision.position
    me.take_up({ wound[1], wound[2] - 2, wound[3] + 1 })
    me.pedal(1)
    me.go({ 0, 0, 3 }, 12)
    me.request("Bottle down")
end
L
expect 0 "" "$rhexis" check "$work/ask"
says "request Bottle down: to 40"
expect 0 "" "$rhexis" run "$work/ask" --surgeon d --seed 3 --no-pictures --json --out "$work/asked"
for text in '"completed": true' '"id": "bottle_down"' '"machine.bottle_cm": 40' '"text": "Bottle at 40."'; do says "$text"; done
grep -qF 'Asked and declared' "$work/asked/report.html" || fail "the time line does not show it"

expect 0 "" "$rhexis" replay "$work/asked" --verify
says "identical: all"
expect 0 "" "$rhexis" replay "$work/asked" --score-with "$work/ask" --json
says '"completed": true'
says '"simulated_from_step": 0'

# another answer to the same request: what follows is simulated again, and the request heard as it was
cp -r "$work/ask" "$work/other"
sed -i 's/= 40 }/= 45 }/' "$work/other/curriculum.lua"
expect 0 "now sets machine.bottle_cm = 45, recorded was machine.bottle_cm = 40" \
    "$rhexis" replay "$work/asked" --score-with "$work/other" --json
says '"id": "bottle_down"'

# names that are wrong
sed -i 's/me.request("Bottle down")/me.request("Botle down")/' "$work/other/surgeon.lua"
expect 1 "surgeon.lua:7: the exercise has no request 'Botle down' (did you mean Bottle down?)" \
    "$rhexis" run "$work/other" --surgeon d --seed 3 --no-pictures --json --out "$work/wrong"
sed -i 's/requested.bottle/requested.botle/' "$work/other/curriculum.lua"
expect 1 "unknown measure 'requested.botle_down' (did you mean requested.bottle_down?)" "$rhexis" check "$work/other"
sed -i 's/requested.botle/requested.bottle/; s/bottle_cm/botle_cm/' "$work/other/curriculum.lua"
expect 1 "there is no setting 'machine.botle_cm' (did you mean machine.bottle_cm?)" "$rhexis" check "$work/other"
sed -i 's/machine.botle_cm.] = 45/wound.leak_ml_min"] = 4/' "$work/other/curriculum.lua"
expect 1 "wound.leak_ml_min is fixed before the first step" "$rhexis" check "$work/other"
finished
