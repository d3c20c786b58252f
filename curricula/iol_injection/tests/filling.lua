-- SPDX-License-Identifier: GPL-3.0-or-later
-- An implant that comes out into a chamber with too little viscoelastic, and into a full one.

local implant_hand = require "implant_hand"

local function chamber(fill) return implant_hand.thin_with { ["viscoelastic.fill"] = fill } end

-- The mouth under the rim, and the plunger until a little of the implant is out.
local function begin(t)
    implant_hand.bring(t, { 0, -1.0, 1.0 })
    implant_hand.push(t, function() return t:value("implant.delivered") > 0.05 end)
end

return scenarios {
    patient = { age = 68, pupil_mm = 8 },

    scenario "injected without viscoelastic, and left so" {
        recover_within_s = 3,
        set = chamber(0.5),
        function(t)
            begin(t)
            t:expect_event("Injected without viscoelastic", { recovered = false, within = 4 })
        end },

    scenario "injected without viscoelastic, then filled" {
        set = chamber(0.6),
        function(t)
            begin(t)
            t:wait(0.5)
            t:expect_event("Injected without viscoelastic")
            t.cannula:enter({ speed = 20 })
            t.cannula:move_to({ 0, -1.5, 3 }, { speed = 12 })
            t.cannula:jaw(0.7)
            t:wait_until("viscoelastic.fill > 0.95", 15)
            t:expect_event("Injected without viscoelastic", { recovered = true })
        end },

    scenario "injected into a chamber that is nearly full" {
        set = chamber(0.8),
        silent_twin_of = "Injected without viscoelastic",
        near = "implant.delivered > 0.02 and viscoelastic.fill < 0.8",
        function(t)
            begin(t)
            t:wait(0.5)
        end },
}
