-- SPDX-License-Identifier: GPL-3.0-or-later
-- The eye rolls after a shaft that is carried sideways.

local rolled = require "globe_scenarios"

return scenarios(rolled(scenario, { age = 68, cataract = "NO3", pupil_mm = 7.5 }))
