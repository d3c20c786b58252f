-- SPDX-License-Identifier: GPL-3.0-or-later
-- The edge of an opening that is only 4 mm wide, drawn apart by hook and cannula.

local narrow = { ["capsulorhexis.diameter_mm"] = 4 }
local height = 0.7  -- of their ends: behind the edge, and not so far that their shafts slip off it

-- Both ends behind the edge, then apart until a condition holds.
local function draw_apart(t, stop)
    t.hook:enter({ speed = 20 })
    t.hook:move_to({ 0, 0, 2.2 }, { speed = 12 })
    t.hook:move_to({ 1.6, 0, height }, { speed = 6 })
    t.cannula:enter({ speed = 20 })
    t.cannula:move_to({ 0, 0, 2.2 }, { speed = 12 })
    t.cannula:move_to({ -1.6, 0, height }, { speed = 6 })
    local pull = { speed = 1, motion = "even", stop = stop }
    t:together(function() t.hook:move_to({ 6, 0, height }, pull) end,
        function() t.cannula:move_to({ -6, 0, height }, pull) end)
    t:expect(stop)
end

local function let_go(t)
    t:together(function() t.hook:move_to({ 0, 0, height }, { speed = 8 }) end,
        function() t.cannula:move_to({ 0, -0.5, height }, { speed = 8 }) end)
end

local overstretched, split = "bag.rim_stretch > 1.26", "bag.rim_split"

return scenarios {
    patient = { age = 68, pupil_mm = 8 },

    scenario "rim overstretched, and let go" {
        set = narrow,
        function(t)
            draw_apart(t, overstretched)
            t:expect_event("Rim overstretched")
            let_go(t)
            t:expect_event("Rim overstretched", { recovered = true })
            t:expect_no_event("Rim split")
        end },

    scenario "rim overstretched, and held" {
        set = narrow,
        silent_twin_of = "Rim split",
        near = "bag.rim_stretch > 1.25",
        function(t)
            draw_apart(t, overstretched)
            t:expect_event("Rim overstretched", { recovered = false, within = 4 })
        end },

    scenario "rim stretched by a sixth" {
        set = narrow,
        silent_twin_of = "Rim overstretched",
        near = "bag.rim_stretch > 1.17",
        function(t)
            draw_apart(t, "bag.rim_stretch > 1.17")
            t:wait(1)
        end },

    scenario "rim split, and let go" {
        set = narrow,
        function(t)
            draw_apart(t, split)
            t:expect_event("Rim split")
            let_go(t)
            t:expect_event("Rim split", { recovered = true, within = 3 })
        end },

    scenario "rim split, and held" {
        recover_within_s = 3,
        set = narrow,
        function(t)
            draw_apart(t, split)
            t:expect_event("Rim split", { recovered = false, within = 6 })
        end },
}
