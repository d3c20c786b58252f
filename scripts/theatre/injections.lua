-- SPDX-License-Identifier: GPL-3.0-or-later
-- What an instructor may let happen from the theatre's monitor: causes, never outcomes. What follows is simulated.
--
--   needs       measure that the scene must have; none: any scene
--   settings    of the machine and the patient, that go to `to` within over_s, one after the other, and back to what
--               they were when it is ended
--   head        where the patient's head goes: list of { time_s, x, y, z } [mm]. Hands and microscope stay, the eye
--               goes; it stays at the last place until it is ended, and then comes back in one second
--   microscope  by how much it is pushed aside [mm], once, where there is one

return {
    {
        id = "choroidal_bleed",
        title = "Bleeding behind the choroid",
        needs = "suprachoroidal.pressure_mmhg",
        settings = { { "suprachoroidal.pressure_mmhg", to = 30, over_s = 8 } },
    },
    {
        id = "empty_bottle",
        title = "The bottle runs empty",
        needs = "chamber.infusion_ml_min",
        settings = { { "machine.bottle_cm", to = 0, over_s = 15 }, { "machine.infusion", to = 0, over_s = 0 } },
    },
    {
        id = "blocked_line",
        title = "The infusion line is kinked",
        needs = "chamber.infusion_ml_min",
        settings = { { "machine.infusion", to = 0, over_s = 0 } },
    },
    {
        id = "cough",
        title = "The patient coughs",
        head = { { 0, 0, 0, 0 }, { 0.08, 0.3, 0.9, 0.6 }, { 0.2, -0.2, -0.7, -0.3 }, { 0.34, 0.2, 0.6, 0.3 },
            { 0.5, -0.1, -0.4, -0.1 }, { 0.8, 0.05, 0.15, 0 }, { 1.2, 0, 0, 0 } },
    },
    {
        id = "patient_moves",
        title = "The patient moves the head",
        head = { { 0, 0, 0, 0 }, { 0.7, 1.6, -0.9, 0.3 } },
    },
    {
        id = "lost_reflex",
        title = "The microscope is pushed: the red reflex is lost",
        microscope = { 2.6, 1.8, 0 },
    },
}
