-- SPDX-License-Identifier: GPL-3.0-or-later
-- Iris in the wound: how it comes, how it goes back, and what a push does.

-- Through the wound and out again, with what pressure the bottle gives.
local function go_through(t, bottle_cm)
    t:set { ["machine.bottle_cm"] = bottle_cm }
    t.phaco:enter({ speed = 12 })
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, 0, 2.6 }, { speed = 12 })
    t:wait(1)
    t.phaco:withdraw({ speed = 12 })
end

-- The lip of the side port pressed aside by the spatula until the eye is soft.
local function burp(t)
    t.spatula:enter({ speed = 10 })
    t.spatula:move_by({ 0.2, 0, -0.5 }, { speed = 6 })
    t.spatula:move_by({ 0, 0.9, 0 }, { speed = 6 })
    t:wait_until("chamber.pressure_mmhg < 10", 5)
    t.spatula:move_by({ 0, -0.9, 0.5 }, { speed = 6 })
end

-- Out of the side port, and to and fro over the outer lip of the main wound.
local function stroke(t, times)
    local hand = { shaft = { -0.3, -1, 0.6 } }
    t.spatula:path({ { -6.5, -2, 4.5 }, { -3, -7.5, 4 } }, { speed = 15, shaft = hand.shaft })
    t.spatula:move_to({ -1.2, -6.3, 1.9 }, { speed = 10, shaft = hand.shaft })
    for _ = 1, times or 6 do
        t.spatula:move_to({ 1.2, -6.3, 1.9 }, { speed = 8, shaft = hand.shaft, stop = "iris.prolapse_mm < 0.05" })
        t.spatula:move_to({ -1.2, -6.3, 1.9 }, { speed = 8, shaft = hand.shaft, stop = "iris.prolapse_mm < 0.05" })
    end
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 6 },

    scenario "let down through the side port, and stroked home" {
        function(t)
            t:expect_event("Iris prolapse", { within = 1 })
            burp(t)
            t:expect("iris.prolapse_mm > 0.3")
            stroke(t)
            t:expect_event("Iris prolapse", { recovered = true, within = 2 })
            t:expect("iris.prolapse_damage < 0.05")
        end },

    scenario "stroked without letting the pressure out" {
        start = "before",
        function(t)
            go_through(t, 80)
            t:expect_event("Iris prolapse", { within = 2 })
            t.spatula:enter({ speed = 10 })
            stroke(t, 3)
            t:expect("iris.prolapse_mm > 0.3")
        end },

    scenario "pushed back through the wound under pressure: it comes again, and worse" {
        recover_within_s = 3,
        start = "before",
        function(t)
            go_through(t, 80)
            t:expect_event("Iris prolapse", { within = 2 })
            for _ = 1, 2 do
                t.phaco:enter({ speed = 12 })
                t.phaco:move_to({ 0, -3, 2.2 }, { speed = 12 })
                t:expect("iris.prolapse_mm < 0.2 and iris.prolapse_damage > 0.1")
                t.phaco:withdraw({ speed = 12 })
                t:wait_until("iris.prolapse_mm > 0.3", 2)
            end
            t:expect("iris.pushed_back_mm > 1")
            t:expect_event("Iris prolapse", { recovered = false, within = 4 })
        end },

    scenario "the bottle is let down before the tip leaves" {
        start = "before",
        silent_twin_of = "Iris prolapse",
        near = "iris.prolapse_mm > 0.18",
        function(t)
            go_through(t, 40)
            t:wait(3)
        end },
}
