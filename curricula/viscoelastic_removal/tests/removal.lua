-- SPDX-License-Identifier: GPL-3.0-or-later
-- Viscoelastic before and behind the implant.

local function enter(t)
    t.ia_tip:enter()
    t.ia_tip:pedal(1)
    t.ia_tip:move_to({ 0, 0.3, 0.9 }, { speed = 10 })
end

local function front(t)
    t.ia_tip:pedal(2)
    t:wait_until("viscoelastic.front_mm3 < 15", 6)
end

local function behind(t)
    t.ia_tip:pedal(1)
    t.ia_tip:path({ { 3.75, 0.3, -0.4 }, { 3.4, 0.3, -1.2 }, { 1.6, 0.3, -1.9 } }, { speed = 10 })
    t.ia_tip:pedal(2)
    t:wait_until("viscoelastic.behind_mm3 < 2", 4)
    t.ia_tip:pedal(1)
    t.ia_tip:path({ { 3.4, 0.3, -1.2 }, { 3.75, 0.3, -0.4 }, { 0, 0.3, 0.9 } }, { speed = 10 })
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "in front, then behind the optic" {
        function(t)
            enter(t)
            front(t)
            t:expect("viscoelastic.behind_percent > 15")
            behind(t)
            t.ia_tip:withdraw { speed = 12 }
            t:wait(0.1)
            t:expect("viscoelastic.behind_percent <= 5 and not capsule.captured")
            t:expect_no_event("Viscoelastic left behind the implant")
        end },

    scenario "only in front, and again behind" {
        set = { viscoelastic = { front_mm3 = 60 } },
        function(t)
            enter(t)
            front(t)
            t.ia_tip:withdraw { speed = 12 }
            t:wait(0.1)
            t:expect_event("Viscoelastic left behind the implant")
            enter(t)
            behind(t)
            t:wait(0.2)
            t.ia_tip:pedal(2)
            t:expect_event("Viscoelastic left behind the implant", { recovered = true, within = 6 })
        end },

    scenario "only in front" {
        recover_within_s = 3,
        set = { viscoelastic = { front_mm3 = 60 } },
        function(t)
            enter(t)
            front(t)
            t.ia_tip:withdraw { speed = 12 }
            t:expect_event("Viscoelastic left behind the implant", { recovered = false, within = 4 })
        end },

    scenario "the optic is rocked, and a little is left behind it" {
        set = { viscoelastic = { front_mm3 = 20 } },
        silent_twin_of = "Viscoelastic left behind the implant",
        near = "viscoelastic.behind_percent > 3 and viscoelastic.left_percent < 90 and not ia_tip.present",
        function(t)
            enter(t)
            t.ia_tip:move_to({ 0, 2.4, -0.75 }, { speed = 5 })
            t.ia_tip:pedal(2)
            t:wait_until("viscoelastic.behind_percent < 5", 8)
            t:expect("viscoelastic.rocked > 0.5 and not viscoelastic.under_optic")
            t.ia_tip:pedal(1)
            t.ia_tip:withdraw { speed = 12 }
            t:wait(0.1)
        end },

    scenario "the mouth turned down behind the optic draws the capsule in" {
        function(t)
            enter(t)
            t.ia_tip:path({ { 3.75, 0.3, -0.4 }, { 3.4, 0.3, -1.2 }, { 1.0, 0, -2.0 } }, { speed = 8 })
            t.ia_tip:turn(180)
            t.ia_tip:move_to({ 0.1, -1.4, -3.05 }, { speed = 3 })
            t.ia_tip:pedal(2)
            t:wait_until("capsule.captured", 2)
            t:expect_event("Posterior capsule drawn in")
            t.ia_tip:pedal(0)
            t:expect_event("Posterior capsule drawn in", { recovered = true, within = 1 })
        end },

    scenario "drawn in behind the optic, and pulled away" {
        set = { ia = { vacuum_mmhg = 600 } },
        function(t)
            enter(t)
            t.ia_tip:path({ { 3.75, 0.3, -0.4 }, { 3.4, 0.3, -1.2 }, { 1.0, 0, -2.0 } }, { speed = 8 })
            t.ia_tip:turn(180)
            t.ia_tip:move_to({ 0.1, -1.4, -3.05 }, { speed = 3 })
            t.ia_tip:pedal(2)
            t:wait_until("capsule.captured", 2)
            t:wait(0.5)
            t.ia_tip:move_by({ 0, 0.3, 2 }, { speed = 3 })
            t:expect_event("Posterior capsule drawn in", { recovered = false, within = 3 })
        end },

    scenario "as low behind the optic, with the mouth turned to the capsule and hardly any vacuum" {
        silent_twin_of = "Posterior capsule drawn in",
        near = "ia_tip.tip_posterior_mm < 0.05 and ia_tip.suction_mmhg > 15",
        function(t)
            t:set { ["ia.vacuum_mmhg"] = 15 }
            enter(t)
            t.ia_tip:path({ { 3.75, 0.3, -0.4 }, { 3.4, 0.3, -1.2 }, { 1.0, 0, -2.0 } }, { speed = 8 })
            t.ia_tip:turn(180)
            t.ia_tip:move_to({ 0.1, -1.4, -3.05 }, { speed = 3 })
            t.ia_tip:pedal(2)
            t:wait(2)
            t:expect("not capsule.open")
        end },

    scenario "as low behind the optic, with the mouth up" {
        silent_twin_of = "Posterior capsule drawn in",
        near = "ia_tip.tip_posterior_mm < 0 and ia_tip.suction_mmhg > 20",
        function(t)
            enter(t)
            t.ia_tip:path({ { 3.75, 0.3, -0.4 }, { 3.4, 0.3, -1.2 }, { 1.0, 0, -2.0 } }, { speed = 8 })
            t.ia_tip:move_to({ 0.1, -1.4, -3.05 }, { speed = 3 })
            t.ia_tip:pedal(2)
            t:wait(1)
            t:expect("not capsule.open and not ia_tip.port_down")
        end },
}
