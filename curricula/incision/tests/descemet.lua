-- SPDX-License-Identifier: GPL-3.0-or-later
-- A blunt tip that is pushed against the inner lip peels Descemet's membrane.

local cut = { wounds = { uncut = 0 } }

-- Against the lip's roof, and on by so much [mm].
local function push(t, by)
    t.cannula:enter()
    t.cannula:move_to({ 0, -4.6, 3.1 }, { speed = 6 })
    t.cannula:move_to({ 0, -3.4, 3.36 }, { speed = 6 })
    t.cannula:move_to({ 0, -3.4 + by, 3.3 }, { speed = 6 })
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7 },

    scenario "pushed against the lip: out, in again below it, and laid flat" {
        set = cut,
        function(t)
            push(t, 0.9)
            t:expect("wounds.main_peel_mm > 0.5")
            t:expect_event("Descemet's membrane peeled")
            t.cannula:withdraw()
            t.cannula:enter()
            t.cannula:move_to({ 0, -3.2, 3.0 }, { speed = 6 })
            t.cannula:jaw(0.6)
            t:wait_until("wounds.main_peel_mm < 0.05", 4)
            t.cannula:jaw(0)
            t.cannula:withdraw()
            t:expect_event("Descemet's membrane peeled", { recovered = true, within = 1 })
        end },

    scenario "pushed against the lip, and left so" {
        recover_within_s = 3,
        set = cut,
        function(t)
            push(t, 1.6)
            t:expect("wounds.main_peel_mm > 1")
            t.cannula:withdraw()
            t:expect_event("Descemet's membrane peeled", { recovered = false, within = 4 })
        end },

    scenario "a little of it is caught, and given up at once" {
        set = cut,
        silent_twin_of = "Descemet's membrane peeled",
        near = "wounds.main_peel_mm > 0.4",
        function(t)
            push(t, 0.3)
            t.cannula:withdraw()
        end },

    scenario "through the opening it peels nothing" {
        set = cut,
        function(t)
            t.cannula:enter()
            t.cannula:move_to({ 0, -2, 3.0 }, { speed = 6 })
            t:expect("wounds.main_peel_mm <= 0")
        end },
}
