-- SPDX-License-Identifier: GPL-3.0-or-later
-- The shaft turns about the wound: a tip that is lifted presses its shaft on the iris of a small pupil.
local middle = { 0, 0, 2.3 }

local function enter(t)
    t.cystotome:enter()
    t.cystotome:path({ { 0, -2.5, 2.4 }, middle }, { speed = 8 })
end

local function to_the_iris(t, stop)
    enter(t)
    t.cystotome:move_to({ 3.2, 0, 2 }, { speed = 4, stop = stop })
end

local function under_the_iris(t)
    enter(t)
    t.cystotome:path({ { 1.8, 0, 1.6 }, { 3.6, 0, 1.1 } }, { speed = 4, stop = "instruments.hidden" })
end

local function pierce_and_cut(t, far)
    enter(t)
    t.cystotome:move_to({ 0, 0, 1 }, { speed = 2, stop = "rhexis.opened" })
    t.cystotome:move_by({ far, 0, 0 }, { speed = 3 })
end

return scenarios {
    scenario "iris touched, put right" {
        function(t)
            to_the_iris(t, "iris.touch")
            t:expect_event("Iris touched")
            t.cystotome:move_to(middle, { speed = 8 })
            t:expect_event("Iris touched", { recovered = true })
        end },
    scenario "iris touched, and stays" {
        function(t)
            to_the_iris(t, "iris.touch")
            t:expect_event("Iris touched", { recovered = false, within = 3 })
        end },
    scenario "turns back before the iris" {
        silent_twin_of = { "Iris touched", "Tip out of sight" },
        function(t)
            to_the_iris(t, "iris.gap_mm < 0.15")
            t.cystotome:move_to(middle, { speed = 8 })
        end },
    scenario "under the iris and back" {
        function(t)
            under_the_iris(t)
            t:wait(0.5)
            t:expect_event("Tip out of sight")
            t.cystotome:move_to(middle, { speed = 8 })
            t:expect_event("Tip out of sight", { recovered = true })
        end },
    scenario "stays under the iris" {
        function(t)
            under_the_iris(t)
            t:expect_event("Tip out of sight", { recovered = false, within = 3 })
        end },
    scenario "the needle cuts too far" {
        set = { goal = { limit_mm = 1.2 } },
        function(t)
            pierce_and_cut(t, 2)
            t:expect_event("Tear under the iris", { recovered = false, within = 7 })
        end },
    scenario "the needle stops in time" {
        silent_twin_of = "Tear under the iris",
        function(t) pierce_and_cut(t, 1.4) end },
}
