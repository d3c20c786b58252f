-- SPDX-License-Identifier: GPL-3.0-or-later
-- Where the tip is to be: places in the anterior chamber from the pupil's middle, to the right, away from the surgeon
-- and towards the microscope from the lens equator, in mm; and a circle about the middle. Change them to your liking.

return {
    { name = "middle", place = { 0, 0, 3.0 } },
    { name = "right", place = { 2, 0, 3.0 } },
    { name = "far", place = { 0, 2, 3.0 } },
    { name = "left", place = { -2, 0, 3.0 } },
    circle = { radius = 2, height = 3.0 },
}
