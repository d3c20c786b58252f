-- SPDX-License-Identifier: GPL-3.0-or-later
-- The main incision, then the side port, then a leak test.
return exercise {
    title = "Two wounds and a leak test",
    objectives = {
        "A tunnel that shuts itself",
        "Main incision first, side port at a right angle",
        "Test before you go on",
    },

    patient = { age = 66, cataract = "NO2", pupil_mm = 7, tetrahedra = 500 },
    tissues = { "lens", "bag", "iris", "cornea", "chamber", "wounds" },
    instruments = { "keratome", "hydration_cannula", "sponge", "side_port_blade" },
    settings = { wounds = { uncut = 2 } },  -- neither is cut yet

    goals = {
        tunnel_mm = { 1.6, from = 1, to = 2.5, meaning = "least length of the tunnel" },
        leak_ul_s = { 0.3, from = 0.05, to = 2 },
    },

    steps = {
        step "main incision" {
            hint = "Along the slope of the cornea, then level.",
            done = "wounds.main_cut and not keratome.present",
            time_limit_s = 40,
        },
        step "side port" {
            hint = "About a quarter of the clock away.",
            done = "wounds.side_cut and not side_port_blade.present",
            time_limit_s = 30,
        },
        step "firm eye" {
            hint = "Saline through the main wound, until the eye is firm.",
            done = "chamber.pressure_mmhg > 16 and not hydration_cannula.present",
            time_limit_s = 30,
        },
        step "leak test" {
            hint = "Press on the lip with the sponge; look for fluid.",
            done = "wounds.checked and not sponge.present",
            time_limit_s = 20,
        },
    },

    errors = {
        error_event "Short tunnel" {
            when = "wounds.main_cut and wounds.main_tunnel_mm < goal.tunnel_mm",
            recovered = "wounds.leak_at_20_ul_s < goal.leak_ul_s and wounds.main_swelling > 0.3",
            deadline_s = 15,
            advice = "A short tunnel leaks: hydrate its sides until it is white.",
            items = { "T2", "T14" },
            evidence = { "wounds.main_width_mm", "wounds.main_planes" },
        },
        error_event "Side port before the main wound" {
            when = "wounds.side_cut",
            steps = { "main incision" },
            recovered = "wounds.main_cut",
            deadline_s = 30,
            severity = "minor",
            advice = "The order of this exercise is main incision, then side port. Cut the main incision now.",
            items = { "T2" },
        },
        error_event "Blade touches iris or lens" {
            when = "wounds.touches > 0",
            advice = "Keep the blade level and short; never over the lens.",
            items = { "G4", "G5" },
        },
    },
    scoring = osacss { "T2", "T14", "G4", "G5" },
    time_limit_s = 120,
}
