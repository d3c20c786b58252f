-- SPDX-License-Identifier: GPL-3.0-or-later
-- The tear: led round, run out, brought back, lost at the zonules. All begin with a flap whose tear goes a quarter of
-- the way round, or has been pulled outwards from there.

local rhexis_hand = require "rhexis_hand"

local full = { ["viscoelastic.fill"] = 1 }
local shallow = { ["viscoelastic.fill"] = 0.3, ["vitreous.pressure_mmhg"] = 20,
    ["capsule.toughness"] = 0.6 }

local brittle = { ["viscoelastic.fill"] = 0.7, ["vitreous.pressure_mmhg"] = 20,
    ["capsule.toughness"] = 0.2 }

local place, open_jaws = rhexis_hand.place, rhexis_hand.open_jaws

local function come_in(t) t.forceps:enter({ speed = 20 }) end

-- Holds the flap; returns where the tear ended then, and the lift of the lens.
local function take_hold(t, behind, inside)
    local radius, angle, lift = rhexis_hand.tear_end(t)
    rhexis_hand.take_hold(t, behind, inside)
    t:expect("forceps.holding")
    return radius, angle, lift
end

local out = "rhexis.tip_radius_mm > 3.07 and rhexis.tip_heading_deg > 30 or rhexis.tip_radius_mm > 3.37"

local back = "rhexis.tip_radius_mm < 2.9 and rhexis.tip_heading_deg < 20"

-- Pulled at and let go, again and again until a condition holds.
local function pull_until(t, stop)
    come_in(t)
    for _ = 1, 4 do
        local stopped = rhexis_hand.pull(t, 2, 1, stop)
        open_jaws(t)
        if stopped then break end
    end
end

local function run_out(t)
    come_in(t)
    for _ = 1, 6 do
        if rhexis_hand.pull(t, 2, 1, out) then break end
        open_jaws(t)
    end
    t:wait(0.05)
    t:expect_event("Tear runs out")
end

-- Held near the end of the tear: back along the way it came, then to the middle; if it does not turn, taken hold of
-- anew and led farther ahead.
local function bring_back(t)
    t.forceps:enter({ speed = 50 })
    for try = 1, 5 do
        local radius, angle = take_hold(t, 0.4, 0.3)
        t.forceps:move_to(place(radius - 0.3, angle - 18, 0.2), { speed = 2 })
        if t.forceps:move_to(place(0.5, angle + 30 + 15 * try, 0.2), { speed = 2, stop = back }) then break end
        open_jaws(t)
    end
end

-- Pulled on outwards, again and again.
local function lose_edge(t)
    come_in(t)
    rhexis_hand.lose_edge(t)
    t:wait(0.05)
    t:expect_event("Edge lost")
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "the flap led round: no error" {
        set = full,
        start = "flap",
        function(t)
            come_in(t)
            local _, angle = take_hold(t, 0.7, 0.4)
            local way = {}
            for i = 1, 12 do way[i] = place(1.7, angle - 10 + 10 * i, 0.2) end
            t.forceps:move_to(place(1.7, angle - 10, 0.4), { speed = 2 })
            t.forceps:path(way, { speed = 1.5, motion = "even" })
            t:expect("rhexis.turned_deg > 118")
            t:expect_no_event()
        end },

    scenario "pulled outwards until it is nearly out, and let go" {
        set = shallow,
        start = "pulled",
        silent_twin_of = "Tear runs out",
        near = "rhexis.tip_radius_mm > 2.98 and rhexis.tip_heading_deg > 30",
        function(t)
            pull_until(t, "rhexis.tip_radius_mm > 2.95")
            t:wait(1)
        end },

    scenario "the tear has run out and is pulled on, nearly to the zonules" {
        set = shallow,
        start = "run_out",
        silent_twin_of = "Edge lost",
        near = "rhexis.tip_radius_mm > 3.5",
        function(t)
            pull_until(t, "rhexis.tip_radius_mm > 3.5")
            t:wait(1)
        end },

    scenario "the tear runs out, and is brought back" {
        set = shallow,
        start = "run_out",
        function(t)
            t:wait(0.05)
            t:expect_event("Tear runs out")
            rhexis_hand.fill(t, { press = 1, speed = 50 })
            bring_back(t)
            t:expect_event("Tear runs out", { recovered = true, within = 0.2 })
        end },

    scenario "the tear runs out, and one lets it" {
        recover_within_s = 3,
        set = shallow,
        start = "pulled",
        function(t)
            run_out(t)
            open_jaws(t)
            t.forceps:withdraw({ speed = 20 })
            t:expect_event("Tear runs out", { recovered = false, within = 4 })
        end },

    scenario "one pulls on: the edge is lost" {
        recover_within_s = 3,
        set = brittle,
        start = "nearly_lost",
        function(t)
            lose_edge(t)
            t:expect_event("Edge lost", { recovered = false, within = 4 })
        end },

    scenario "the edge is lost: the chamber is filled, and a new cut from the other end meets the tear" {
        set = brittle,
        start = "lost",
        function(t)
            t:wait(0.05)
            t:expect_event("Edge lost")
            rhexis_hand.fill(t, { to = 0.92, press = 1 })
            rhexis_hand.cut_from_other_end(t, { at = 20, from = 2.8, radius = 2.3, by = 360, longest = 6,
                stop = "rhexis.loose_mm2 > 5" })
            rhexis_hand.meet_tear(t)
            t:expect_event("Edge lost", { recovered = true, within = 0.1 })
        end },
}
