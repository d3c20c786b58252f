-- SPDX-License-Identifier: GPL-3.0-or-later
-- Tips that go down to the posterior capsule, by suction, ultrasound or touch, each at its own speed and place, and
-- tips that turn back in time: how often is warned before it tears, and how often for nothing?

local chance = require "surgeons.chance"

local coarse = { patient = { tetrahedra = 1000 } }

-- Down the hole in the middle, to so far from the capsule.
local function go_down(t, stream, gap)
    t.phaco:enter({ speed = 20 })
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, 0, 3 }, { speed = 20 })
    t.phaco:move_to({ 0, 0, -5 }, { speed = stream:between(2, 5), motion = "even",
        stop = ("phaco.tip_posterior_mm < %.3f"):format(gap) })
end

local list = {}
local function add(name, hand) list[#list + 1] = scenario(name) { start = "hole", set = coarse, hand } end

for seed = 1, 32 do
    local stream = chance.stream(seed, "warnings: ruptures")
    local way = seed % 3
    add(("%s, torn %d"):format(seed <= 16 and "tuning" or "held out", seed), function(t)
        go_down(t, stream, 1.5)
        t.phaco:pedal(3)
        t.phaco:move_to({ 0, 0, -5 }, { speed = stream:between(0.8, 1.6), motion = "even",
            stop = "phaco.tip_posterior_mm < 0.3" })
        if way == 0 then  -- ultrasound, straight on
            t.phaco:move_by({ stream:between(-0.3, 0.3), stream:between(-0.3, 0.3), -1.6 },
                { speed = stream:between(0.4, 1.5), motion = "even",
                stop = "capsule.open" })
        elseif way == 1 then  -- suction, and drawn back with the capsule in the tip
            t:set { ["machine.vacuum_mmhg"] = stream:between(150, 350) }
            t.phaco:pedal(2)
            t.phaco:move_by({ 0, 0, -0.3 }, { speed = stream:between(0.3, 1), motion = "even" })
            t:wait(stream:between(0.5, 1.5))
            t.phaco:move_by({ stream:between(-1, 1), stream:between(-1, 1), 1.5 },
                { speed = stream:between(1, 4), motion = "even",
                stop = "capsule.open" })
        else  -- pushed through
            t.phaco:pedal(2)
            t.phaco:move_by({ 0, 0, -2.5 }, { speed = stream:between(0.6, 2), motion = "even", stop = "capsule.open" })
        end
        t:wait(0.5)
    end)
end
for seed = 33, 48 do
    local stream = chance.stream(seed, "warnings: ruptures")
    add(("%s, kept %d"):format(seed <= 40 and "tuning" or "held out", seed), function(t)
        go_down(t, stream, 1.5)
        for _ = 1, 3 do  -- strokes close to it
            t.phaco:pedal(3)
            t.phaco:move_to({ stream:between(-0.5, 0.5), stream:between(-0.5, 0.5), -5 },
                { speed = stream:between(0.6, 1.4), motion = "even",
                stop = ("phaco.tip_posterior_mm < %.3f"):format(stream:between(0.25, 0.6)) })
            t.phaco:pedal(2)
            t.phaco:move_by({ 0, 0, stream:between(0.8, 1.6) }, { speed = stream:between(2, 4) })
            t:wait(stream:between(0.1, 0.5))
        end
        t.phaco:pedal(1)
    end)
end

return scenarios "phaco_sculpt" (list)
