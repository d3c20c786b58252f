-- SPDX-License-Identifier: GPL-3.0-or-later
-- What one does first decides: fill, or pull.

-- A place by its distance from the middle [mm], angle [degrees] and height over the front of the lens [mm].
local function place(radius, angle, height)
    local a = math.rad(angle)
    return { radius * math.cos(a), radius * math.sin(a), 1.878 * math.sqrt(1 - (radius / 4.82) ^ 2) + height }
end

return scenarios {
    scenario "the chamber filled at once" {
        silent_twin_of = { "Pulled in a shallow chamber", "Overfilled", "Edge lost", "Iris touched" },
        function(t)
            t:expect("rhexis.tip_radius_mm > 3.2")
            t.cannula:enter({ speed = 20 })
            t.cannula:move_to({ 0, -1.5, 4 }, { speed = 12 })
            t.cannula:jaw(0.7)
            t:wait_until("viscoelastic.fill > 0.98", 20)
            t.cannula:jaw(0)
            t.cannula:withdraw({ speed = 20 })
            t:expect("lens.lift_mm < 0.2")
        end },

    scenario "touched with the forceps in the shallow chamber" {
        function(t)
            t.forceps:enter({ speed = 20 })
            t.forceps:move_to(place(1.5, 100, 0.6 + t:value("lens.lift_mm")), { speed = 12 })
            t.forceps:move_to(place(1.5, 100, -0.1 + t:value("lens.lift_mm")), { speed = 3 })
            t:wait(0.5)
            t:expect_event("Pulled in a shallow chamber")
        end },
}
