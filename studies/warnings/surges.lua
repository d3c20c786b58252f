-- SPDX-License-Identifier: GPL-3.0-or-later
-- A piece on the tip with much vacuum, let go of with the pedal down or up, under bottles of all heights: how often is
-- warned before the chamber empties, and how often for nothing?

local chance = require "surgeons.chance"
local quarter_hand = require "quarter_hand"

local function occlude(t, stream)
    quarter_hand.come_in(t, nil, 6)
    quarter_hand.press_on_piece(t)
    t:wait(stream:between(1, 4))
end

local list = {}
local function add(name, settings, hand) list[#list + 1] = scenario(name) { set = settings, hand } end

for seed = 1, 48 do
    local stream = chance.stream(seed, "warnings: surges")
    local settings = { ["machine.vacuum_mmhg"] = stream:between(150, 500),
        ["machine.bottle_cm"] = stream:between(45, 110), ["machine.tubing_mm3_mmhg"] = stream:between(0.2, 0.8),
        ["machine.flow_ml_min"] = stream:between(20, 40) }
    local set = seed % 2 == 1 and "tuning" or "held out"
    local lets_go = seed % 4 < 2
    add(("%s, %s %d"):format(set, lets_go and "let go" or "torn away", seed), settings, function(t)
        occlude(t, stream)
        if lets_go then
            t.phaco:pedal(1)
            t:wait(stream:between(0.8, 2))
        end
        t.phaco:move_to({ 1.2, -0.6, 3 }, { speed = stream:between(10, 30) })
        t:wait(1.5)
    end)
end

return scenarios "surge" (list)
