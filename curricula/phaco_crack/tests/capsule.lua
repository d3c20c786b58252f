-- SPDX-License-Identifier: GPL-3.0-or-later
-- The posterior capsule struck by a tip, and torn.

local function come_in(t)
    t.phaco:enter({ speed = 30 })
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, 0, 2.6 }, { speed = 30 })
    t:wait(0.5)
end

-- The phaco tip pressed through the floor of the groove.
local function press(t, stop)
    come_in(t)
    t.phaco:move_to({ 0, 0, -6 }, { speed = 2, motion = "even", stop = stop })
end

-- Down the groove, then with ultrasound to the capsule, and on until it gives way.
local function tear(t)
    come_in(t)
    t.phaco:move_to({ 0, 0, -1.2 }, { speed = 10 })
    t.phaco:pedal(3)
    t.phaco:move_to({ 0, 0, -6 }, { speed = 1.5, motion = "even", stop = "capsule.open" })
    t:expect_event("Capsule torn")
end

return scenarios {
    patient = { age = 68, cataract = "NO4", pupil_mm = 7.5 },

    scenario "capsule struck, lifted" {
        function(t)
            press(t, "phaco.tip_posterior_mm < 0.25")
            t:expect_event("Capsule struck")
            t.phaco:move_to({ 0, 0, 2.6 }, { speed = 10 })
            t:expect_event("Capsule struck", { recovered = true, within = 2 })
        end },

    scenario "capsule struck, and kept there" {
        function(t)
            press(t, "phaco.tip_posterior_mm < 0.25")
            t:expect_event("Capsule struck", { recovered = false, within = 3 })
        end },

    scenario "close to the capsule" {
        silent_twin_of = "Capsule struck",
        near = "phaco.tip_posterior_mm < 0.45",
        function(t)
            press(t, "phaco.tip_posterior_mm < 0.45")
            t:wait(2)
            t:expect("phaco.tip_posterior_mm < 0.5")
            t.phaco:move_to({ 0, 0, 2.6 }, { speed = 10 })
        end },

    scenario "capsule pressed without ultrasound" {
        silent_twin_of = "Capsule torn",
        near = "capsule.strain_share > 0.6",
        function(t)
            press(t, "capsule.strain_share > 0.6")
            t:wait(0.5)
            t.phaco:move_to({ 0, 0, 2.6 }, { speed = 10 })
            t:wait(0.5)
        end },

    scenario "capsule torn; irrigation only, then out" {
        function(t)
            tear(t)
            t.phaco:pedal(1)
            t:wait(2)
            t.phaco:move_to({ 0, 0, 2.6 }, { speed = 4 })
            t.phaco:withdraw({ speed = 20 })
            t:expect_event("Capsule torn", { recovered = true, within = 2 })
        end },

    scenario "capsule torn, and vacuum goes on" {
        recover_within_s = 3,
        function(t)
            tear(t)
            t.phaco:pedal(2)
            t:expect_event("Capsule torn", { recovered = false, within = 4 })
        end },
}
