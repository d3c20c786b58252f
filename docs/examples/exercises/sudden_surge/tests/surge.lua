-- SPDX-License-Identifier: GPL-3.0-or-later
-- Tip into the nucleus and held there by suction, chamber full.
local function occlude(t)
    local p = t.phaco
    p:enter()
    p:pedal(1)
    p:move_to({ 0, -1.5, 2.6 }, { speed = 8 })
    p:pedal(3)
    p:move_to({ 0, 1.5, 0.9 }, { speed = 2 })
    p:pedal(2)
    p:move_to({ 0, 1.8, 0.7 }, { speed = 1, stop = "phaco.occlusion > 0.95" })
    t:wait_until("panel.vacuum_mmhg > 400", 3)
end
local out = { 0, -2.5, 3.2 }

return scenarios {
    scenario "surge, foot up" {
        function(t)
            occlude(t)
            t.phaco:pedal(3)  -- clears what shuts the mouth
            t:wait_until("chamber.depth_lost_share > 0.3", 2)
            t:expect_event("Surge", { within = 0.5 })
            t.phaco:pedal(1)
            t:request("Bottle up")
            t:expect_event("Surge", { recovered = true, within = 3 })
        end },
    scenario "surge, foot stays down" {
        function(t)
            occlude(t)
            t.phaco:pedal(3)
            t:expect_event("Surge", { recovered = false, within = 4 })
        end },
    scenario "foot up before it breaks" {
        silent_twin_of = { "Surge", "Capsule caught" },
        function(t)
            occlude(t)
            t.phaco:pedal(1)
            t:wait(0.8)
            t.phaco:move_to(out, { speed = 8 })
        end },
}
