-- SPDX-License-Identifier: GPL-3.0-or-later
-- A cartridge without its coating: the implant rubs on its wall until a hand cannot push it. The hand is a weak one: a
-- lens that is crushed by 30 N takes long to simulate.

local implant_hand = require "implant_hand"

local function rubbing(friction)
    return { ["cartridge.tucked"] = 1, ["cartridge.nozzle_mm"] = 2.6, ["cartridge.friction"] = friction,
        ["injector.push_n"] = 3 }
end
local dry, worn, coated = rubbing(0.6), rubbing(0.2), rubbing(0.1)

local function push_until(t, test)
    implant_hand.bring(t, { 0, -1.0, 1.0 })
    implant_hand.push(t, test)
end

local function push_until_it_jams(t)
    push_until(t, function() return t:value("injector.jammed") end)
    t:expect_event("Implant jammed")
end

return scenarios {
    patient = { age = 68, pupil_mm = 8 },

    scenario "implant jammed, and the plunger drawn back" {
        set = dry,
        function(t)
            push_until_it_jams(t)
            t.injector:jaw(0)
            t:wait(1)
            t:expect("injector.force_mN < 1000")
            t:expect_event("Implant jammed", { recovered = true, within = 4 })
        end },

    scenario "implant jammed, and pushed on" {
        set = dry,
        function(t)
            push_until_it_jams(t)
            t.injector:jaw(1)
            t:expect_event("Implant jammed", { recovered = false, within = 6 })
        end },

    scenario "the plunger is felt to bind, and drawn back" {
        set = worn,
        silent_twin_of = "Implant jammed",
        near = "injector.force_mN > 1500",
        function(t)
            push_until(t, function() return t:value("injector.force_mN") > 1500 end)
            t.injector:jaw(0)
            t:wait(1)
        end },

    scenario "pushed as hard through a coated cartridge" {
        set = coated,
        function(t)
            push_until(t, function() return t:value("implant.delivered") > 0.1 end)
            t:expect("injector.force_mN > 50 and injector.force_mN < 1000")
            t:expect_no_event("Implant jammed")
        end },
}
