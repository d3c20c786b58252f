-- SPDX-License-Identifier: GPL-3.0-or-later
-- The needle's way under the capsule. The front of the lens is 1.84 mm over its middle where it goes in.

local full = { ["viscoelastic.fill"] = 1 }

-- Through the capsule to a height.
local function pierce(t, z)
    t.cystotome:enter({ speed = 20 })
    t.cystotome:move_to({ 0.89, -0.16, 2.4 }, { speed = 12 })
    t.cystotome:move_to({ 0.89, -0.16, z }, { speed = 2 })
end

return scenarios {
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
        function(t)
            pierce(t, 0.95)
            t.cystotome:move_by({ 0, 0.8, 0 }, { speed = 1.3 })
            t:expect("cystotome.tip_depth_mm > 0.7")
        end },
}
