-- SPDX-License-Identifier: GPL-3.0-or-later
-- What a surgeon must notice: trenches, folds of a capsule that is held, a hole in it, a burnt wound; by the mechanics.
--   rhexis lua docs/pictures/draw_signs.lua [FOLDER]
local folder = arg[1] or "docs/pictures"
local size = { width = 480, height = 360 }

local function open_eye(trench_mm)
    return rhexis.eye.create { tetrahedra = 1000, instruments = { "phaco" },
        tissues = { "lens", "bag", "capsule", "iris", "cornea", "chamber" },
        settings = { ["nucleus.segments"] = trench_mm > 0 and 4 or 0, ["nucleus.trench_mm"] = trench_mm,
            ["machine.bottle_cm"] = 95, ["machine.flow_ml_min"] = 32, ["machine.vacuum_mmhg"] = 120 } }
end

-- Evenly to a place [mm, mm/s] until it is reached or something is seen.
local function go(eye, place, speed, pedal, seen)
    local phaco = eye:tool("phaco")
    local from = phaco:present() and phaco:position() or { 0, -5, 3 }
    local way = math.sqrt((place[1] - from[1]) ^ 2 + (place[2] - from[2]) ^ 2 + (place[3] - from[3]) ^ 2)
    local steps = math.ceil(way / speed / 0.01)
    for i = 1, steps do
        local at = {}
        for k = 1, 3 do at[k] = from[k] + (place[k] - from[k]) * i / steps end
        phaco:move { position = at, pedal = pedal, axis = { 0, -1, 0.6 } }
        assert(eye:step())
        if seen and seen(eye:observation()) then return end
    end
end

local function stay(eye, steps, pedal, seen)
    for _ = 1, steps do
        eye:tool("phaco"):move { pedal = pedal }
        assert(eye:step())
        if seen and seen(eye:observation()) then return end
    end
end

local function draw(eye, name)
    rhexis.render.draw(eye, size):write_png(folder .. "/" .. name .. ".png")
    print(name)
end

local eye = open_eye(1.2)
go(eye, { 1.5, 0.5, 2.8 }, 8, 1)
draw(eye, "trenches")

eye = open_eye(1.6)
go(eye, { 0, -0.5, 2.8 }, 8, 1)
go(eye, { 0, 0.3, -4.5 }, 1.5, 3, function(now) return now.phaco.tip_posterior_mm < 0.3 end)
go(eye, { 0, 0.3, -4.5 }, 1.0, 1, function(now) return now.phaco.tip_posterior_mm < 0.05 end)
stay(eye, 300, 2, function(now) return now.capsule.captured end)
draw(eye, "folds")
stay(eye, 100, 3, function(now) return now.capsule.open end)
stay(eye, 20, 1)
go(eye, { 2.2, -1, 2.8 }, 6, 1)
draw(eye, "hole")

eye = open_eye(0)
go(eye, { 0, -1, 3 }, 8, 1)
eye:set("machine.infusion", 0)
stay(eye, 450, 3)
eye:set("machine.infusion", 1)
stay(eye, 100, 1)
draw(eye, "burn")
