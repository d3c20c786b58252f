-- SPDX-License-Identifier: GPL-3.0-or-later
-- Descemet's membrane peeled off at the inner lip in the end of the operation, by the cannula.

-- Against the lip's roof, and on by so much [mm].
local function push(t, by)
    t.cannula:enter()
    t.cannula:move_to({ 0, -4.6, 3.1 }, { speed = 6 })
    t.cannula:move_to({ 0, -3.4, 3.36 }, { speed = 6 })
    t.cannula:move_to({ 0, -3.4 + by, 3.3 }, { speed = 6 })
end

local function lay_flat(t)
    t.cannula:enter()
    t.cannula:move_to({ 0, -3.2, 3.0 }, { speed = 6 })
    t.cannula:jaw(0.6)
    t:wait_until("wounds.main_peel_mm < 0.05", 4)
    t.cannula:jaw(0)
    t.cannula:withdraw()
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 6 },

    scenario "pushed against the lip: out, in again below the flap, and laid flat with viscoelastic" {
        function(t)
            push(t, 0.7)
            t:expect("wounds.main_peel_mm > 0.5")
            t:expect_event("Descemet's membrane peeled")
            t.cannula:withdraw()
            lay_flat(t)
            t:expect_event("Descemet's membrane peeled", { recovered = true, within = 1 })
        end },

    scenario "pushed against the lip, and left so" {
        recover_within_s = 3,
        function(t)
            push(t, 0.9)
            t:expect("wounds.main_peel_mm > 1")
            t.cannula:withdraw()
            t:expect_event("Descemet's membrane peeled", { recovered = false, within = 4 })
        end },

    scenario "a flap that an earlier part left, laid flat with viscoelastic" {
        set = { wounds = { main_peel_mm = 0.9 } },
        function(t)
            t:wait(0.1)
            t:expect_event("Descemet's membrane peeled")
            lay_flat(t)
            t:expect_event("Descemet's membrane peeled", { recovered = true, within = 1 })
        end },

    scenario "a little of it is caught, and given up at once" {
        silent_twin_of = "Descemet's membrane peeled",
        near = "wounds.main_peel_mm > 0.4",
        function(t)
            push(t, 0.3)
            t.cannula:withdraw()
        end },

    scenario "the cannula through the opening peels nothing" {
        function(t)
            t.cannula:enter()
            t.cannula:move_to({ 0, -2.6, 2.9 }, { speed = 6 })
            t.cannula:withdraw()
            t:expect("wounds.main_most_peel_mm <= 0")
        end },
}
