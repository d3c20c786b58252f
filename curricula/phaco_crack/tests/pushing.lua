-- SPDX-License-Identifier: GPL-3.0-or-later
-- Tips that move the same way push the nucleus, and load the zonules.

-- Both tips at the floor in the middle of the groove.
local function engage(t)
    t.phaco:enter({ speed = 30 })
    t.phaco:pedal(1)
    t.phaco:move_to({ 0.3, 0, 2.6 }, { speed = 30 })
    t.spatula:enter({ speed = 30 })
    t.spatula:move_to({ -0.3, 0, 2.6 }, { speed = 30 })
    t:together(function() t.phaco:move_to({ 0.3, 0.3, -1.6 }, { speed = 6 }) end,
        function() t.spatula:move_to({ -0.3, -0.3, -1.6 }, { speed = 6 }) end)
end

-- Both to the right by a way.
local function push(t, way, stop)
    local options = { speed = 1.5, motion = "even", stop = stop }
    t:together(function() t.phaco:move_by({ way, 0, 0 }, options) end,
        function() t.spatula:move_by({ way, 0, 0 }, options) end)
end

local function lift(t)
    t:together(function() t.phaco:move_to({ 0.3, 0, 2.6 }, { speed = 10 }) end,
        function() t.spatula:move_to({ -0.3, 0, 2.6 }, { speed = 10 }) end)
end

return scenarios {
    patient = { age = 68, cataract = "NO4", pupil_mm = 7.5 },

    scenario "nucleus pushed aside, let go" {
        function(t)
            engage(t)
            push(t, 3, "lens.displacement_mm > 0.52")
            t:expect_event("Pushing the nucleus")
            lift(t)
            t:expect_event("Pushing the nucleus", { recovered = true, within = 2 })
        end },

    scenario "nucleus pushed aside, and held there" {
        function(t)
            engage(t)
            push(t, 3, "lens.displacement_mm > 0.6")
            t:expect_event("Pushing the nucleus", { recovered = false, within = 4 })
        end },

    scenario "nucleus pushed a little" {
        silent_twin_of = { "Pushing the nucleus", "Zonules overstrained" },
        near = "lens.displacement_mm > 0.4 and zonules.strain > 0.25",
        function(t)
            engage(t)
            push(t, 3, "lens.displacement_mm > 0.4")
            t:wait(2)
            t:expect("lens.displacement_mm > 0.3")
            lift(t)
        end },

    scenario "zonules overstrained, let go" {
        function(t)
            engage(t)
            push(t, 4, "zonules.strain > 0.37")
            t:expect_event("Zonules overstrained")
            lift(t)
            t:expect_event("Zonules overstrained", { recovered = true, within = 2 })
        end },

    scenario "zonules overstrained, and held there" {
        function(t)
            engage(t)
            push(t, 4, "zonules.strain > 0.45")
            t:expect_event("Zonules overstrained", { recovered = false, within = 4 })
        end },
}
