-- SPDX-License-Identifier: GPL-3.0-or-later
-- The cartridge on the iris by the wound: it rests there on its way under the rim, and may be pressed too hard.

local implant_hand = require "implant_hand"

return scenarios {
    patient = { age = 68, pupil_mm = 8 },

    scenario "cartridge pressed into the iris, and led up again" {
        function(t)
            implant_hand.bring(t, { 0, -1.7, 0.4 })
            t.injector:move_to({ 0, -2.4, -0.8 }, { speed = 4, stop = "iris.gap_mm < -1.05" })
            t:expect_event("Iris touched")
            t.injector:move_to({ 0, -1.7, 2.4 }, { speed = 8 })
            t:expect_event("Iris touched", { recovered = true, within = 2 })
        end },

    scenario "cartridge that rests on the iris, rather hard" {
        silent_twin_of = "Iris touched",
        near = "iris.touch and iris.gap_mm < -0.8",
        function(t)
            implant_hand.bring(t, { 0, -1.7, 0.4 })
            t.injector:move_to({ 0, -2.4, -0.8 }, { speed = 4, stop = "iris.gap_mm < -0.8" })
            t:wait(1)
        end },
}
