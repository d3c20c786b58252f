-- SPDX-License-Identifier: GPL-3.0-or-later
-- Zonules tear by force: a tip that is deep in a hard lens goes on without ultrasound.

local set = { patient = { tetrahedra = 1000, cataract = "NO5" }, zonules = { lost_deg = 0 } }

local hole = { 0, -0.8, -0.2 }
local over_hole = { 0, -0.8, 3.8 }

-- Deep into the lens with ultrasound, then away from the surgeon without, until so much is torn [degrees].
local function push(t, torn)
    t.phaco:enter({ speed = 20 })
    t.phaco:pedal(1)
    t.phaco:move_to(over_hole, { speed = 15 })
    t.phaco:pedal(3)
    t.phaco:move_to(hole, { speed = 1.6, motion = "even" })
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, 2, -0.2 }, { speed = 2, motion = "even", stop = "zonules.torn_deg >= " .. torn })
end

local function draw_back(t)
    t.phaco:move_to(hole, { speed = 8 })
    t.phaco:move_to(over_hole, { speed = 12 })
end

local function cover(t)
    t.cannula:enter({ speed = 20 })
    t.cannula:move_to({ 0, -3.2, 2.2 }, { speed = 12 })
    t.cannula:jaw(1)
    t:wait_until("tamponade.gap_cover > 0.95", 4)
    t.cannula:jaw(0)
    t.cannula:withdraw({ speed = 25 })
end

return scenarios {
    scenario "pushed on until they tear, and left so" {
        set = set,
        function(t)
            push(t, 30)
            t:expect("bag.tilt_deg > 1 or bag.offset_mm > 0.3")
            t:expect_event("Zonular dialysis", { recovered = false, within = 61 })
        end },

    scenario "pushed until nearly one tears, and drawn back" {
        set = set,
        silent_twin_of = "Zonular dialysis",
        function(t)
            push(t, 7)
            draw_back(t)
            t:expect("zonules.torn_deg < 30")
        end },
}
