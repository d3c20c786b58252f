-- SPDX-License-Identifier: GPL-3.0-or-later
-- An implant that comes out into a chamber with too little viscoelastic, and into a full one.

-- The mouth under the rim, and the plunger until a little of the implant is out.
local function begin(t)
    t.injector:enter({ speed = 20 })
    t.injector:move_to({ 0, 0.2, 1.1 }, { speed = 8 })
    t.injector:jaw(0.55)
    t:wait_until("implant.delivered > 0.03", 8)
end

return scenarios {
    scenario "injected without viscoelastic, and left so" {
        set = { ["viscoelastic.fill"] = 0.5 },
        function(t)
            begin(t)
            t:expect_event("Injected without viscoelastic", { recovered = false, within = 32 })
        end },

    scenario "injected without viscoelastic, then filled" {
        set = { ["viscoelastic.fill"] = 0.6 },
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
        set = { ["viscoelastic.fill"] = 0.8 },
        silent_twin_of = "Injected without viscoelastic",
        function(t)
            begin(t)
            t:wait(0.5)
            t:expect("viscoelastic.fill < 0.85")
        end },
}
