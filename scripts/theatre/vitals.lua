-- SPDX-License-Identifier: GPL-3.0-or-later
-- The patient's constants on the theatre's monitor, and what moves them: see engine/vitals.lua. An exercise puts others
-- in their place with its field `vitals`:
--
--   vitals = { heart_per_min = 88, reactions = { { when = "iris.touch", heart_per_min = 15, after_s = 2 } } }
--
-- They are scripted, not simulated: a reaction is added while its condition holds, and is there after about after_s.
-- Pressure on the eye slows the heart, by more than a fifth where it does (oculocardiac reflex, [StatPearlsOCR]); the
-- other numbers are proposals.

return {
    heart_per_min = 74,
    systolic_mmhg = 138,
    diastolic_mmhg = 82,
    saturation_percent = 97,
    reactions = {
        { when = "chamber.pressure_mmhg > 60", heart_per_min = -16, systolic_mmhg = -8, after_s = 4 },
        { when = "viscoelastic.pressure_mmhg > 60", heart_per_min = -16, systolic_mmhg = -8, after_s = 4 },
        { when = "iris.touch", heart_per_min = 8, systolic_mmhg = 10, after_s = 2 },
        { when = "iris.prolapse_mm > 0.5", heart_per_min = 12, systolic_mmhg = 14, diastolic_mmhg = 6, after_s = 6 },
        { when = "suprachoroidal.pressure_mmhg > 5", heart_per_min = 34, systolic_mmhg = 45, diastolic_mmhg = 20,
            saturation_percent = -2, after_s = 6 },
        { when = "globe.rotation_deg > 12", heart_per_min = 6, systolic_mmhg = 8, after_s = 3 },
    },
}
