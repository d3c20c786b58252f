-- SPDX-License-Identifier: GPL-3.0-or-later
-- Surge when an occlusion breaks: pedal up at once, too late, as it begins, and with stiffer tubing.

local quarter_hand = require "quarter_hand"

local stiffer = { machine = { tubing_mm3_mmhg = 0.4 } }  -- half as soft as in the exercise

local function occlude(t)
    quarter_hand.come_in(t, nil, 6)
    quarter_hand.press_on_piece(t)
    t:wait_until("phaco.occlusion > 0.9 and panel.vacuum_mmhg > 180", 6)
end

local function tear_away(t) t.phaco:move_to({ 1.2, -0.6, 3 }, { speed = 30 }) end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "the occlusion breaks, pedal up at once" {
        function(t)
            occlude(t)
            t.phaco:pedal(3)
            t:wait_until("chamber.depth_lost_share > 0.3", 8)
            t.phaco:pedal(1)
            t:expect_event("Surge", { recovered = true, within = 3 })
        end },

    scenario "the occlusion breaks, and the pedal stays down" {
        function(t)
            occlude(t)
            t:wait(2)
            tear_away(t)
            t:expect_event("Surge", { recovered = false, within = 6 })
        end },

    scenario "pedal to 1 and the vacuum gone before the piece is left" {
        function(t)
            occlude(t)
            t.phaco:pedal(1)
            t:wait_until("panel.vacuum_mmhg < 20", 3)
            tear_away(t)
            t:wait(1)
            t:expect("chamber.depth_share > 0.9")
            t:expect_no_event("Surge")
        end },

    scenario "the occlusion begins to break, and the pedal is let go at once" {
        silent_twin_of = "Surge",
        near = "chamber.depth_lost_share > 0.2",
        function(t)
            occlude(t)
            t.phaco:pedal(3)
            t:wait_until("chamber.depth_lost_share > 0.2", 8)
            t.phaco:pedal(1)
            t:wait(1)
            t:expect("chamber.depth_share > 0.9")
        end },

    scenario "stiffer tubing" {
        set = stiffer,
        silent_twin_of = "Surge",
        near = "chamber.depth_lost_share > 0.2",
        function(t)
            occlude(t)
            t:wait(1)
            tear_away(t)
            t:wait(1)
            t:expect("chamber.surges == 0")
        end },
}
