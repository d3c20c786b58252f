-- SPDX-License-Identifier: GPL-3.0-or-later
-- Along the slope of the cornea, then level, and back the same way.
local function tunnel(t)
    t.keratome:enter()
    t.keratome:path({ { 0, -4.15, 3.4 }, { 0, -1.5, 3.3 } }, { speed = 4 })
    t.keratome:path({ { 0, -4.15, 3.4 }, { 0, -5.85, 2.2 } }, { speed = 6 })
    t.keratome:withdraw()
end

-- Straight in at the limbus: short.
local function straight(t)
    t.keratome:enter()
    t.keratome:move_by({ 0, 4, 0.2 }, { speed = 6, stop = "wounds.main_width_mm > 2.3" })
    t.keratome:withdraw()
end

return scenarios {
    scenario "two planes" {
        silent_twin_of = { "Short tunnel", "Side port before the main wound", "Blade touches iris or lens" },
        function(t)
            tunnel(t)
            t:expect("wounds.main_cut and wounds.main_tunnel_mm > 1.6")
            t.side_port_blade:enter()
            t.side_port_blade:move_by({ 2.8, 0.5, 0.6 }, { speed = 6 })
            t.side_port_blade:withdraw()
            t:expect("wounds.side_cut")
        end },
    scenario "short, hydrated" {
        function(t)
            straight(t)
            t:expect_event("Short tunnel")
            t.hydration_cannula:enter()
            t.hydration_cannula:move_to({ 0, -5.3, 2.4 }, { speed = 5 })
            t.hydration_cannula:jaw(1)
            t:wait(2.5)
            t:expect_event("Short tunnel", { recovered = true })
        end },
    scenario "short, left so" {
        function(t)
            straight(t)
            t:expect_event("Short tunnel", { recovered = false, within = 16 })
        end },
    scenario "side port first" {
        function(t)
            t.side_port_blade:enter()
            t.side_port_blade:move_by({ 2.8, 0.5, 0.6 }, { speed = 6 })
            t.side_port_blade:withdraw()
            t:expect_event("Side port before the main wound")
            tunnel(t)
            t:expect_event("Side port before the main wound", { recovered = true })
        end },
    scenario "over the lens" {
        function(t)
            t.keratome:enter()
            t.keratome:move_by({ 0, 3, -0.5 }, { speed = 6 , stop = "wounds.touches > 0"})
            t:expect_event("Blade touches iris or lens")
        end },
}
