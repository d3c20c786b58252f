-- SPDX-License-Identifier: GPL-3.0-or-later
-- The way of sculpting without ultrasound, and with it.

local over = 2.4
local half_length = 2.2

-- A stroke away from the surgeon, one across it, each at two depths.
local function sculpt(t, pedal)
    for _, height in ipairs { 0.9, 0.4 } do
        for _, way in ipairs { { 0, half_length }, { half_length, 0 } } do
            local x, y = way[1], way[2]
            t.phaco:move_to({ -x, -y, over }, { speed = 30 })
            t.phaco:pedal(pedal)
            t.phaco:move_to({ -x, -y, height }, { speed = 12 })
            t.phaco:move_to({ x, y, height }, { speed = 3, motion = "even" })
            t:expect("phaco.in_contact and phaco.aspirating")
            t.phaco:move_to({ x, y, over }, { speed = 30 })
            t.phaco:pedal(1)
        end
    end
end

local function come_in(t)
    t.phaco:enter({ speed = 20 })
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, -half_length, over }, { speed = 20 })
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "pedal at most 2 along the way of sculpting removes nothing" {
        set = { patient = { tetrahedra = 1000 } },
        function(t)
            come_in(t)
            sculpt(t, 2)
            t:expect("lens.removed_mm3 == 0 and grooves.count == 0")
        end },

    scenario "pedal 3 along the way of sculpting removes tissue" {
        set = { patient = { tetrahedra = 1000 } },
        function(t)
            come_in(t)
            sculpt(t, 3)
            t:expect("lens.removed_mm3 > 5 and grooves.count == 2")
        end },
}
