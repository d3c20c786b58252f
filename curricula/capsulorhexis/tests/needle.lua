-- SPDX-License-Identifier: GPL-3.0-or-later
-- The needle's way through the capsule and under it. The front of the lens is 1.84 mm over its middle where it goes in.

local full = { ["viscoelastic.fill"] = 1 }

-- Through the capsule to a height.
local function pierce(t, z)
    t.cystotome:enter({ speed = 20 })
    t.cystotome:move_to({ 0.89, -0.16, 2.4 }, { speed = 12 })
    t.cystotome:move_to({ 0.89, -0.16, z }, { speed = 2 })
end

local function zonules(share) return { ["viscoelastic.fill"] = 1, ["zonules.strength"] = share } end

-- Slowly down, until it is through.
local function puncture(t)
    t.cystotome:enter({ speed = 20 })
    t.cystotome:move_to({ 0.89, -0.16, 2.2 }, { speed = 12 })
    t.cystotome:move_to({ 0.89, -0.16, 1.2 }, { speed = 2, motion = "even", stop = "rhexis.opened" })
    t:expect("rhexis.opened")
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "wrinkles at the puncture, and weak zonules declared" {
        set = zonules(0.1),
        function(t)
            puncture(t)
            t:expect_event("Wrinkles at the puncture")
            t.cystotome:move_by({ 0, 0, 0.8 }, { speed = 8 })
            t:request("Weak zonules declared")
            t:expect_event("Wrinkles at the puncture", { recovered = true, within = 0.2 })
        end },

    scenario "wrinkles at the puncture, and nothing said" {
        recover_within_s = 3,
        set = zonules(0.1),
        function(t)
            puncture(t)
            t:expect_event("Wrinkles at the puncture", { recovered = false, within = 4 })
        end },

    scenario "zonules a third as stiff: a few wrinkles at the puncture" {
        set = zonules(0.3),
        silent_twin_of = "Wrinkles at the puncture",
        near = "not rhexis.opened and cystotome.wrinkled_share > 0.06",
        function(t)
            puncture(t)
            t:wait(0.5)
        end },

    scenario "needle deep in the cortex, and lifted" {
        set = full,
        function(t)
            pierce(t, 0.2)
            t:wait(0.4)
            t:expect_event("Needle too deep")
            t.cystotome:move_to({ 0.89, -0.16, 1.45 }, { speed = 3 })
            t:expect_event("Needle too deep", { recovered = true })
        end },

    scenario "needle deep in the cortex, and led on there" {
        set = full,
        function(t)
            pierce(t, 0.4)
            t.cystotome:move_to({ 0.89, 1.8, 0.3 }, { speed = 1 })
            t:expect_event("Needle too deep", { recovered = false, within = 2 })
        end },

    scenario "needle rather deep" {
        set = full,
        silent_twin_of = "Needle too deep",
        near = "cystotome.tip_depth_mm > 0.84",
        function(t)
            pierce(t, 0.95)
            t.cystotome:move_by({ 0, 0.8, 0 }, { speed = 1.3 })
        end },
}
