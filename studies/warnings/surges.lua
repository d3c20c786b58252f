-- SPDX-License-Identifier: GPL-3.0-or-later
-- A piece on the tip with much vacuum, let go of with the pedal down or up, under bottles of all heights: how often is
-- warned before the chamber empties, and how often for nothing?

local chance = require "surgeons.chance"

-- Numbers between two others, the same for the same seed.
local function draws(seed)
    local stream = chance.stream(seed, "warnings: surges")
    return function(from, to) return from + (to - from) * stream:uniform() end
end

local function occlude(t, draw)
    t.phaco:enter()
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, 0, 3 }, { speed = 6 })
    t:wait(1.5)
    t.phaco:move_to({ 0.8, 0.8, 0.2 }, { speed = 4 })
    t.phaco:pedal(3)
    t.phaco:move_to({ 1.4, 1.4, -0.1 }, { speed = 1.5, motion = "even" })
    t.phaco:pedal(2)
    t.phaco:move_to({ 1.9, 1.9, -0.4 }, { speed = 1, motion = "even" })
    t:wait(draw(1, 4))
end

local list = {}
local function add(name, settings, hand) list[#list + 1] = scenario(name) { set = settings, hand } end

for seed = 1, 48 do
    local draw = draws(seed)
    local settings = { ["machine.vacuum_mmhg"] = draw(150, 500), ["machine.bottle_cm"] = draw(45, 110),
        ["machine.tubing_mm3_mmhg"] = draw(0.2, 0.8), ["machine.flow_ml_min"] = draw(20, 40) }
    local set = seed % 2 == 1 and "tuning" or "held out"
    local lets_go = seed % 4 < 2
    add(("%s, %s %d"):format(set, lets_go and "let go" or "torn away", seed), settings, function(t)
        occlude(t, draw)
        if lets_go then
            t.phaco:pedal(1)
            t:wait(draw(0.8, 2))
        end
        t.phaco:move_to({ 1.2, -0.6, 3 }, { speed = draw(10, 30) })
        t:wait(1.5)
    end)
end

return scenarios "surge" (list)
