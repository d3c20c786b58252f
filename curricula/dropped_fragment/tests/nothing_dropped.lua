-- SPDX-License-Identifier: GPL-3.0-or-later
-- A tip in an eye from which nothing has fallen yet.

return scenarios {
    scenario "an open capsule with all pieces before it" {
        start = "untouched",
        silent_twin_of = "Dropped piece",
        function(t)
            t.phaco:enter()
            t.phaco:pedal(1)
            t.phaco:move_to({ 0, 0, 3 }, { speed = 8 })
            t:wait(2)
            t:expect("capsule.open and fragments.sunk_mm <= 1")
            t.phaco:withdraw()
        end },
}
