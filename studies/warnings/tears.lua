-- SPDX-License-Identifier: GPL-3.0-or-later
-- Capsulorhexes by hands that stream the tear outwards, and by hands that lead it round, each otherwise: how often is
-- warned before the edge is lost, and how often for nothing? scripts/dev/warnings.py counts.

local chance = require "surgeons.chance"
local rhexis_hand = require "rhexis_hand"

-- Holds near the end of the tear and leads it, again and again. outwards: of each pull's goal from the circle [mm].
local function lead(t, stream, outwards, pulls)
    for _ = 1, pulls do
        local radius, angle, lift = rhexis_hand.tear_end(t)
        if t:value("rhexis.run_out") or t:value("rhexis.closed") or not radius then return end
        rhexis_hand.take_hold(t, stream:between(0.25, 0.5), stream:between(0.15, 0.4))
        local goal = math.max(0.8, math.min(4.6, radius + outwards(radius)))
        local to = rhexis_hand.place(goal, angle + stream:between(25, 45), stream:between(0.1, 0.5), lift)
        t.forceps:move_to(to, { speed = stream:between(1, 4), motion = "even", stop = "rhexis.run_out" })
        t:wait(stream:between(0, 0.4))
        rhexis_hand.open_jaws(t)
    end
end

local list = {}
local function add(name, settings, start, hand)
    list[#list + 1] = scenario(name) { start = start, set = settings, hand }
end

for seed = 1, 32 do
    local set = seed <= 16 and "tuning" or "held out"
    local stream = chance.stream(seed, "warnings: tears")
    -- the chamber shallow or the capsule brittle, and a hand that pulls away from the middle
    add(("%s, outwards %d"):format(set, seed), { ["viscoelastic.fill"] = stream:between(0.3, 0.7),
        ["vitreous.pressure_mmhg"] = 20, ["capsule.toughness"] = stream:between(0.2, 0.6) }, "brittle", function(t)
        t.forceps:enter({ speed = 20 })
        lead(t, stream, function() return stream:between(0.6, 2) end, 7)
        t:wait(0.5)
    end)
end
for seed = 33, 48 do
    local set = seed <= 40 and "tuning" or "held out"
    local stream = chance.stream(seed, "warnings: tears")
    -- round, with a hand that errs now this way, now that way, in a deep chamber
    add(("%s, round %d"):format(set, seed), { ["viscoelastic.fill"] = 1 }, "flap", function(t)
        t.forceps:enter({ speed = 20 })
        lead(t, stream, function(radius) return 2.3 - radius + stream:between(-0.6, 0.5) end, 7)
        t:wait(0.5)
    end)
end

return scenarios "capsulorhexis" (list)
