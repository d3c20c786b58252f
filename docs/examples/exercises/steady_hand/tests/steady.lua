-- SPDX-License-Identifier: GPL-3.0-or-later
return scenarios {
    scenario "drifts, comes back" {
        function(t)
            t.probe:enter()
            t.probe:move_to({ 0, 0, 2.6 }, { speed = 6 })
            t.probe:move_to({ 0.8, 0, 2.6 }, { speed = 4 })
            t:wait(0.3)
            t:expect_event("Drifts out of the ring")
            t.probe:move_to({ 0, 0, 2.6 }, { speed = 6 })
            t:expect_event("Drifts out of the ring", { recovered = true })
        end },
    scenario "drifts, stays" {
        function(t)
            t.probe:enter()
            t.probe:move_to({ 0, 0, 2.6 }, { speed = 6 })
            t.probe:move_to({ 0.8, 0, 2.6 }, { speed = 4 })
            t:expect_event("Drifts out of the ring", { recovered = false, within = 2 })
        end },
    scenario "iris" {
        function(t)
            t.probe:enter()
            t.probe:move_to({ 0, 0, 2.6 }, { speed = 6 })
            t.probe:move_to({ 4, 0, 1.5 }, { speed = 6, stop = "iris.touch" })
            t:expect_event("Iris touched")
            t.probe:move_to({ 0, 0, 2.6 }, { speed = 6 })
            t:expect_event("Iris touched", { recovered = true })
        end },
    scenario "iris, stays" {
        function(t)
            t.probe:enter()
            t.probe:move_to({ 0, 0, 2.6 }, { speed = 6 })
            t.probe:move_to({ 4, 0, 1.5 }, { speed = 6, stop = "iris.touch" })
            t:expect_event("Iris touched", { recovered = false, within = 3 })
        end },
    scenario "all well" {
        silent_twin_of = { "Drifts out of the ring", "Iris touched" },
        function(t)
            t.probe:enter()
            t.probe:move_to({ 0, 0, 2.6 }, { speed = 6 })
            t.probe:move_to({ 0.2, 0, 2.6 }, { speed = 4 })
            t:wait(3)
            t.probe:path({ { 2.2, 0, 2.6 }, { -2.2, 0, 2.6 }, { 0, 0, 2.6 } }, { speed = 6 })
            t.probe:withdraw()
        end },
}
