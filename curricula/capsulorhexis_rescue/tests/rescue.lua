-- SPDX-License-Identifier: GPL-3.0-or-later
-- A tear that has run out: what one does first decides. Fill, or pull.

local rhexis_hand = require "rhexis_hand"

local place, open_jaws = rhexis_hand.place, rhexis_hand.open_jaws

local back = "rhexis.tip_radius_mm < 2.9 and rhexis.tip_heading_deg < 20"

-- Held near the end of the tear: from beside it to the middle; if it does not turn, taken hold of
-- anew and led farther ahead.
local function bring_back(t)
    for try = 1, 5 do
        local _, angle, lift = rhexis_hand.tear_end(t)
        rhexis_hand.take_hold(t, 0.4, 0.4)
        t.forceps:move_to(rhexis_hand.by_tear(t, 0, 1, 0.2), { speed = 2 })
        if t.forceps:move_to(place(0.5, angle + 30 + 15 * try, 0.2, lift), { speed = 2, stop = back }) then break end
        open_jaws(t)
    end
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "the chamber filled, the tear brought back" {
        silent_twin_of = "Edge lost",
        near = "rhexis.tip_radius_mm > 3.25",
        function(t)
            rhexis_hand.fill(t, { press = 1, speed = 50 })
            t:expect("lens.lift_mm < 0.2")
            t.forceps:enter({ speed = 50 })
            bring_back(t)
            t:expect(back)
        end },

    scenario "forceps on the capsule in a chamber that is just full enough" {
        silent_twin_of = "Pulled in a shallow chamber",
        near = "forceps.in_contact and viscoelastic.fill < 0.78",
        function(t)
            rhexis_hand.fill(t, { to = 0.78, press = 1, speed = 50 })
            t.forceps:enter({ speed = 50 })
            rhexis_hand.take_hold(t, 0.5, 0.4)
            t:wait(0.5)
        end },

    scenario "forceps on the capsule before the chamber is filled, then filled" {
        function(t)
            t.forceps:enter({ speed = 20 })
            rhexis_hand.take_hold(t, 0.5, 0.4)
            t:wait(0.5)
            t:expect_event("Pulled in a shallow chamber")
            open_jaws(t)
            t.forceps:withdraw({ speed = 20 })
            rhexis_hand.fill(t, { press = 1 })
            t:expect_event("Pulled in a shallow chamber", { recovered = true })
        end },

    scenario "pulled in the shallow chamber: the edge is lost" {
        recover_within_s = 3,
        function(t)
            t.forceps:enter({ speed = 20 })
            rhexis_hand.pull_on(t)
            t:expect_event("Pulled in a shallow chamber", { recovered = false, within = 4 })
            t:expect_event("Edge lost", { recovered = false, within = 4 })
        end },

    scenario "the edge is lost: a new cut from the other end that meets the tear" {
        start = "edge_lost",
        function(t)
            rhexis_hand.cut_from_other_end(t, { at = -35, from = 1, radius = 2.5, by = 360, longest = 4,
                stop = "rhexis.turned_deg > 125" })
            rhexis_hand.meet_tear(t)
            t:expect_event("Edge lost", { recovered = true, within = 0.1 })
        end },
}
