-- SPDX-License-Identifier: GPL-3.0-or-later
-- A flap of Descemet's membrane at the inner lip in the end of the operation.

local flap = { wounds = { main_peel_mm = 0.9 } }

return scenarios {
    scenario "a flap, laid flat with viscoelastic" {
        set = flap,
        function(t)
            t:wait(0.1)
            t:expect_event("Descemet's membrane peeled")
            t.cannula:enter()
            t.cannula:move_to({ 0, -3.2, 3.0 }, { speed = 6 })
            t.cannula:jaw(0.6)
            t:wait_until("wounds.main_peel_mm < 0.05", 4)
            t.cannula:jaw(0)
            t.cannula:withdraw()
            t:expect_event("Descemet's membrane peeled", { recovered = true, within = 1 })
        end },

    scenario "a flap, left" {
        recover_within_s = 3,
        set = flap,
        function(t)
            t:expect_event("Descemet's membrane peeled", { recovered = false, within = 4 })
        end },

    scenario "the cannula pushed against the inner lip peels it" {
        function(t)
            t.cannula:enter()
            t.cannula:move_to({ 0, -4.6, 3.1 }, { speed = 6 })
            t.cannula:move_to({ 0, -3.4, 3.36 }, { speed = 6 })
            t.cannula:move_to({ 0, -2.6, 3.3 }, { speed = 6 })
            t:expect_event("Descemet's membrane peeled")
        end },

    scenario "the cannula through the opening does not" {
        silent_twin_of = "Descemet's membrane peeled",
        function(t)
            t.cannula:enter()
            t.cannula:move_to({ 0, -2.6, 2.9 }, { speed = 6 })
            t.cannula:withdraw()
        end },
}
