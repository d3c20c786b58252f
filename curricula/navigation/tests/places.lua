-- SPDX-License-Identifier: GPL-3.0-or-later
-- The places held, the circle followed and left, iris and cornea touched.

local middle, right, far, left = { 0, 0, 3 }, { 2, 0, 3 }, { 0, 2, 3 }, { -2, 0, 3 }
local circle = { radius = 2, height = 3 }

local function hold(t, place, seconds)
    t.probe:move_to(place, { speed = 20 })
    t:wait(seconds or 0.7)
end

local function hold_all(t)
    t.probe:enter()
    for _, place in ipairs({ middle, right, far, left }) do hold(t, place) end
end

local function on_circle(degrees, out)
    local angle = math.rad(degrees)
    return { (circle.radius + (out or 0)) * math.cos(angle), (circle.radius + (out or 0)) * math.sin(angle),
        circle.height }
end

local function round(t, from, to, out)
    local places = {}
    for angle = from, to, 15 do places[#places + 1] = on_circle(angle, out) end
    for _, place in ipairs(places) do t.probe:move_to(place, { speed = 20 }) end
end

local quick = { set = { ["goal.hold_s"] = 0.5 } }

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "all places held, the circle led round, out" {
        set = quick.set,
        function(t)
            hold_all(t)
            round(t, 180, 540)
            t.probe:move_to({ 0, -2, 3 }, { speed = 20 })
            t.probe:withdraw()
            t:expect("not probe.present")
            t:expect_no_event()
        end },

    scenario "a quarter of the circle, most of the way to where it counts as left" {
        set = quick.set,
        silent_twin_of = "Path left",
        near = function(eye)
            local probe = eye.probe
            return probe.present and math.sqrt(probe.tip_x_mm ^ 2 + probe.tip_y_mm ^ 2) - circle.radius > 0.65
        end,
        function(t)
            hold_all(t)
            round(t, 180, 270, 0.7)
        end },

    scenario "a place left before its time is up does not count: the circle has not begun" {
        set = quick.set,
        function(t)
            t.probe:enter()
            for _, place in ipairs({ middle, right, far }) do hold(t, place) end
            hold(t, left, 0.1)
            t.probe:move_to(on_circle(180, -1.5), { speed = 20 })
            t:wait(1)
            t:expect_no_event("Path left")
        end },

    scenario "circle left, and back on it" {
        set = quick.set,
        function(t)
            hold_all(t)
            t.probe:move_to(on_circle(180, -1), { speed = 5 })
            t:expect_event("Path left")
            t.probe:move_to(on_circle(180), { speed = 5 })
            t:expect_event("Path left", { recovered = true })
        end },

    scenario "circle left for good" {
        set = quick.set,
        function(t)
            hold_all(t)
            t.probe:move_to(on_circle(180, -1), { speed = 5 })
            t:expect_event("Path left", { recovered = false, within = 3 })
        end },

    scenario "iris touched, put right" {
        function(t)
            t.probe:enter()
            t.probe:move_to({ 3.6, 0, 3 }, { speed = 8 })
            t.probe:move_to({ 4.6, 0, 0.5 }, { speed = 4, stop = "iris.gap_mm < -0.05" })
            t:expect_event("Iris touched")
            t.probe:move_to({ 1.5, 0, 3 }, { speed = 8 })
            t:expect_event("Iris touched", { recovered = true })
        end },

    scenario "iris touched, and the tip stays" {
        function(t)
            t.probe:enter()
            t.probe:move_to({ 3.6, 0, 3 }, { speed = 8 })
            t.probe:move_to({ 4.6, 0, 0.5 }, { speed = 4, stop = "iris.gap_mm < -0.05" })
            t:expect_event("Iris touched", { recovered = false, within = 2 })
        end },

    scenario "turns back before the iris" {
        silent_twin_of = "Iris touched",
        near = "iris.gap_mm < 0.15",
        function(t)
            t.probe:enter()
            t.probe:move_to({ 3.6, 0, 3 }, { speed = 8 })
            t.probe:move_to({ 4.6, 0, 0.5 }, { speed = 4, stop = "iris.gap_mm < 0.15" })
            t.probe:move_to({ 1.5, 0, 3 }, { speed = 8 })
        end },

    scenario "cornea touched, put right" {
        function(t)
            t.probe:enter()
            t.probe:move_to({ 0, 0, 3 }, { speed = 8 })
            t.probe:move_to({ 0, 0, 8 }, { speed = 4, stop = "probe.endothelium_mm < 0.05" })
            t:expect_event("Cornea touched")
            t.probe:move_to({ 0, 0, 3 }, { speed = 8 })
            t:expect_event("Cornea touched", { recovered = true })
        end },

    scenario "cornea touched, and the tip stays" {
        function(t)
            t.probe:enter()
            t.probe:move_to({ 0, 0, 3 }, { speed = 8 })
            t.probe:move_to({ 0, 0, 8 }, { speed = 4, stop = "probe.endothelium_mm < 0.05" })
            t:expect_event("Cornea touched", { recovered = false, within = 2 })
        end },

    scenario "turns back before the cornea" {
        silent_twin_of = "Cornea touched",
        near = "probe.endothelium_mm < 0.2 and probe.tip_y_mm > -2.5",
        function(t)
            t.probe:enter()
            t.probe:move_to({ 0, 0, 3 }, { speed = 8 })
            t.probe:move_to({ 0, 0, 8 }, { speed = 4, stop = "probe.endothelium_mm < 0.2" })
            t.probe:move_to({ 0, 0, 3 }, { speed = 8 })
        end },
}
