-- SPDX-License-Identifier: GPL-3.0-or-later
-- Saline under the rim: the wave, and the lens that turns or does not.

-- angle: of the quadrant, anticlockwise from the surgeon's right [deg].
local function at(radius, angle, z)
    return { radius * math.cos(math.rad(angle)), radius * math.sin(math.rad(angle)), z }
end

local function under_rim(t, angle, speed)
    t.saline_cannula:path({ at(2.0, angle, 2.7), at(3.0, angle, 1.15) }, { speed = speed or 6 })
end

-- Sunk into the front and led round.
local function turn(t, from, to, seconds, speed)
    local points = {}
    for i = 1, 8 do points[i] = at(2.0, from + (to - from) * i / 8, 0.7) end
    t.saline_cannula:path({ at(2.0, from, 2.7), at(2.0, from, 0.7) }, { speed = speed or 6 })
    t.saline_cannula:path(points, { seconds = seconds })
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "a gentle wave crosses" {
        function(t)
            t.saline_cannula:enter()
            under_rim(t, 90)
            t:expect("hydro.under_rim")
            t.saline_cannula:jaw(0.34)
            t:wait_until("hydro.wave_share > 0.95", 10)
            t.saline_cannula:jaw(0)
            t:wait(0.3)
            t:expect("hydro.freed_share > 0.9 and hydro.injected_ml < 1 and not hydro.burst")
            t:expect_no_event()
        end },

    scenario "in vain above the capsule, then under the rim, and turned" {
        set = { hydrodissection = { freed = 0.25 } },
        function(t)
            t.saline_cannula:enter({ speed = 30 })
            t.saline_cannula:move_to({ 0, 1, 2.8 }, { speed = 30 })
            t.saline_cannula:jaw(1)
            t:wait_until("hydro.injected_ml > 1", 6)
            t.saline_cannula:jaw(0)
            t:wait(0.25)
            t:expect_event("No wave or no rotation")
            under_rim(t, 270, 20)
            t.saline_cannula:jaw(0.7)
            t:wait_until("hydro.wave_share > 0.999", 4)
            t.saline_cannula:jaw(0)
            turn(t, 0, 130, 3, 20)
            t:expect_event("No wave or no rotation", { recovered = true, within = 1 })
        end },

    scenario "turned by force while the cortex adheres" {
        recover_within_s = 3,
        function(t)
            t.saline_cannula:enter()
            t.saline_cannula:move_to({ 0, 1, 2.8 }, { speed = 10 })
            turn(t, 0, 90, 3)
            t:expect("bag.slip_deg < 10")
            t:expect_event("No wave or no rotation", { recovered = false, within = 6 })
        end },

    scenario "a little less in vain" {
        silent_twin_of = "No wave or no rotation",
        near = "hydro.injected_ml > 0.9 and hydro.wave_share < 0.01",
        function(t)
            t.saline_cannula:enter()
            t.saline_cannula:move_to({ 0, 1, 2.8 }, { speed = 10 })
            t.saline_cannula:jaw(1)
            t:wait_until("hydro.injected_ml > 0.9", 6)
            t.saline_cannula:jaw(0)
            t:wait(0.3)
            t:expect("hydro.wave_share < 0.01")
        end },
}
