-- SPDX-License-Identifier: GPL-3.0-or-later
-- A chamber with too little viscoelastic when the capsule is opened, and one with too much.

local function chamber(fill) return { ["viscoelastic.fill"] = fill } end
-- A thin agent: what is too much leaves beside the cannula within seconds, not half a minute.
local thin = { ["viscoelastic.fill"] = 1, ["viscoelastic.leak"] = 0.04 }

-- Through the capsule, 0.9 mm from its middle, and a little on. lift: of the lens in a chamber that is not full.
local function pierce(t)
    t.cystotome:enter({ speed = 20 })
    local lift = t:value("lens.lift_mm")
    t.cystotome:move_to({ 0.89, -0.16, 2.4 + lift }, { speed = 12 })
    t.cystotome:move_to({ 0.89, -0.16, 1.45 + lift }, { speed = 2 })
    t.cystotome:move_by({ 0, 0.5, 0 }, { speed = 1.3 })
    t:expect("rhexis.opened")
end

local function bring_cannula(t)
    t.cannula:enter({ speed = 20 })
    t.cannula:move_to({ 0, -1.5, 3 }, { speed = 12 })
end

-- Pressed until a condition holds.
local function inject(t, condition)
    t.cannula:jaw(0.7)
    t:wait_until(condition, 15)
    t.cannula:jaw(0)
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "opened in a shallow chamber, then filled" {
        set = chamber(0.6),
        function(t)
            pierce(t)
            t:expect_event("Underfilled")
            t.cystotome:move_by({ 0, 0, 0.8 }, { speed = 8 })
            t.cystotome:withdraw({ speed = 20 })
            bring_cannula(t)
            inject(t, "viscoelastic.fill > 0.95")
            t:expect_event("Underfilled", { recovered = true })
        end },

    scenario "opened in a shallow chamber, and left so" {
        recover_within_s = 3,
        set = chamber(0.6),
        function(t)
            pierce(t)
            t:expect_event("Underfilled", { recovered = false, within = 4 })
        end },

    scenario "opened in a chamber that is nearly full" {
        set = chamber(0.8),
        silent_twin_of = "Underfilled",
        near = "rhexis.opened and cystotome.in_contact and viscoelastic.fill < 0.8",
        function(t)
            pierce(t)
            t:wait(1)
        end },

    scenario "pressed too long, and let out along the cannula" {
        set = thin,
        function(t)
            bring_cannula(t)
            inject(t, "viscoelastic.pressure_mmhg > 62")
            t:expect_event("Overfilled")
            t:expect_event("Overfilled", { recovered = true, within = 6 })
        end },

    scenario "pressed too long, and the wound closed over it" {
        recover_within_s = 3,
        set = chamber(1),
        function(t)
            bring_cannula(t)
            inject(t, "viscoelastic.pressure_mmhg > 62")
            t.cannula:withdraw({ speed = 20 })
            t:expect_event("Overfilled", { recovered = false, within = 4 })
        end },

    scenario "pressed a little too long" {
        set = chamber(1),
        silent_twin_of = "Overfilled",
        near = "viscoelastic.pressure_mmhg > 55",
        function(t)
            bring_cannula(t)
            inject(t, "viscoelastic.pressure_mmhg > 55")
            t:wait(1)
        end },
}
