-- SPDX-License-Identifier: GPL-3.0-or-later
-- The opening once its flap has come off: too small, too large, off-centre. The needle cuts all of the circle in one.

local rhexis_hand = require "rhexis_hand"

local full = { ["viscoelastic.fill"] = 1 }

-- Cuts a circle; the needle stays in the eye. aside: of its middle from the axis [mm].
local function cut_round(t, radius, aside)
    local closed = rhexis_hand.cut_circle(t, { radius = radius, aside = aside, by = 430, stop = "rhexis.closed" })
    if not closed then t:expect("rhexis.closed") end
    t:wait(0.05)
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "too small, and enlarged by a second cut from the rim" {
        set = full,
        function(t)
            cut_round(t, 1.85)
            t:expect_event("Opening too small")
            t.cystotome:move_by({ 0, 0, 0.8 }, { speed = 12 })
            rhexis_hand.cut_anew(t, { at = 120, from = 2.6, radius = 2.4, by = 420, speed = 4.5,
                stop = "rhexis.diameter_mm > 4.5" })
            t:expect("rhexis.diameter_mm > 4.74")
            t:expect_event("Opening too small", { recovered = true, within = 0.1 })
        end },

    scenario "too small, and left so" {
        recover_within_s = 3,
        set = full,
        function(t)
            cut_round(t, 1.85)
            rhexis_hand.lift_out(t)
            t:expect_event("Opening too small", { recovered = false, within = 4 })
        end },

    scenario "rather small" {
        set = full,
        silent_twin_of = "Opening too small",
        near = "rhexis.diameter_mm < 4.7",
        function(t)
            cut_round(t, 2.15)
        end },

    scenario "too large, and recorded" {
        set = full,
        function(t)
            cut_round(t, 3.15)
            t:expect_event("Opening too large")
            rhexis_hand.lift_out(t)
            t:request("Opening recorded")
            t:expect_event("Opening too large", { recovered = true, within = 0.2 })
        end },

    scenario "too large, and nothing said" {
        recover_within_s = 3,
        set = full,
        function(t)
            cut_round(t, 3.15)
            rhexis_hand.lift_out(t)
            t:expect_event("Opening too large", { recovered = false, within = 4 })
        end },

    scenario "rather large" {
        set = full,
        silent_twin_of = "Opening too large",
        near = "rhexis.diameter_mm > 5.75",
        function(t)
            cut_round(t, 2.68)
        end },

    scenario "off-centre, and enlarged on its near side" {
        set = full,
        function(t)
            cut_round(t, 2.6, 0.75)
            t:expect_event("Opening off-centre")
            t.cystotome:move_by({ 0, 0, 0.8 }, { speed = 12 })
            rhexis_hand.cut_anew(t, { at = 120, from = 3.1, radius = 2.5, by = 200, speed = 4,
                stop = "rhexis.centre_offset_mm < 0.5" })
            t:expect_event("Opening off-centre", { recovered = true, within = 0.1 })
        end },

    scenario "off-centre, and left so" {
        recover_within_s = 3,
        set = full,
        function(t)
            cut_round(t, 2.6, 0.75)
            rhexis_hand.lift_out(t)
            t:expect_event("Opening off-centre", { recovered = false, within = 4 })
        end },

    scenario "a little off-centre" {
        set = full,
        silent_twin_of = "Opening off-centre",
        near = "rhexis.centre_offset_mm > 0.38",
        function(t)
            cut_round(t, 2.6, 0.4)
        end },
}
