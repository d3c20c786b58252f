-- SPDX-License-Identifier: GPL-3.0-or-later
-- A square sheet with fibres at 45 degrees is pulled left and right until a puncture in its middle tears
-- (the experiment of [Dequidt2013] fig. 4, with the criterion of docs/tearing.md). Strength 4 times as large across the
-- fibres: a tear of the sheet in uniaxial tension runs at 58.0, 53.4, 59.0, 68.2, 78.8 degrees for fibres at 15 to 75.
--   rhexis lua docs/examples/torn_sheet.lua [FOLDER]
-- Prints how the fibres bend deformation and path, and how the way the tear came matters. With a folder: pictures.
local folder = arg[1]
local side = 10

-- Angle of a direction from the pull [deg], 0 to 180.
local function angle(direction) return math.deg(math.atan(direction[2], direction[1])) % 180 end

local camera = { eye = { 5, 5, 200 }, target = { 5, 5, 0 }, up = { 0, 1, 0 }, field = 13 }

local function draw(scene, name)
    if not folder then return end
    local picture = rhexis.render.draw(scene, { width = 480, height = 400, camera = camera })
    picture:write_png(("%s/%s.png"):format(folder, name))
end

-- stiffer: Young's modulus along the fibres over that across. tougher: strength across the fibres over that along them.
-- turn: sharpest turn of the tear [deg].
local function sheet(fibre_deg, stiffer, tougher, turn)
    local scene = rhexis.scene.create { gravity = { 0, 0, 0 } }
    local membrane = scene:add_membrane {
        sheet = rhexis.mesh.sheet { shape = "square", size = side, triangles = 1500 },
        along = 1e6, across = 1e6 / stiffer, poisson_ratio = 0.3,
        fibre = { math.cos(math.rad(fibre_deg)), math.sin(math.rad(fibre_deg)), 0 },
        toughness_along = 2e3, toughness_across = 2e3 * tougher ^ 2, sharpest_turn = turn, tear_radius = 1.0,
        damping_mass = 200, fixed = function(x) return x < 1e-9 or x > side - 1e-9 end,
    }
    return scene, membrane
end

local function left(x) return x < 1e-9 end
local function right(x) return x > side - 1e-9 end

local function length_of(tips)
    local a, b = tips[1].rest, tips[2].rest
    return math.sqrt((a[1] - b[1]) ^ 2 + (a[2] - b[2]) ^ 2)
end

-- Pulls left and right until the tear is so long, or a tip has left the sheet. Returns the last two tips that were
-- seen, and how far the sheet was stretched [%].
local function pull(scene, membrane, long, name)
    local tips, stretch = membrane:tips(), 0
    draw(scene, name .. "_0")
    for step = 1, 1500 do
        membrane:move(left, { -0.002, 0, 0 })
        membrane:move(right, { 0.002, 0, 0 })
        stretch = 100 * 0.004 * step / side
        assert(scene:step(3))
        local now = membrane:tips()
        if #now < 2 then break end
        tips = now
        if length_of(tips) > long then break end
    end
    draw(scene, name .. "_1")
    return tips, stretch
end

local function path_angle(tips)
    local a, b = tips[1].rest, tips[2].rest
    return angle({ a[1] - b[1], a[2] - b[2] })
end

-- How far the middle of the upper edge has moved along the pull: fibres at an angle make the sheet shear.
local function shear(membrane)
    local top = membrane:select(function(x, y) return y > side - 1e-9 and math.abs(x - side / 2) < 0.3 end)
    return membrane:center(top)[1] - side / 2
end

local cases = {
    { "isotropic", 45, 1, 1, 90, { 0, 1, 0 } },
    { "fibres_15", 15, 1, 4, 90, { 0, 1, 0 } },
    { "fibres_30", 30, 1, 4, 90, { 0, 1, 0 } },
    { "fibres_45", 45, 1, 4, 90, { 0, 1, 0 } },
    { "fibres_60", 60, 1, 4, 90, { 0, 1, 0 } },
    { "fibres_75", 75, 1, 4, 90, { 0, 1, 0 } },
    { "stiff_fibres_45", 45, 4, 4, 90, { 0, 1, 0 } },
    { "straight_on", 45, 1, 4, 10, { 0, 1, 0 } },
}
print("name              fibres  stiffer  tougher  turn   tear   at stretch  upper edge")
for _, case in ipairs(cases) do
    local name, fibre, stiffer, tougher, turn, slit = table.unpack(case)
    local scene, membrane = sheet(fibre, stiffer, tougher, turn)
    membrane:puncture({ side / 2, side / 2, 0 }, slit)
    local tips, stretch = pull(scene, membrane, 5, name)
    print(("%-16s  %3d deg  %5d  %7d  %4d  %5.1f deg  %5.1f %%  %+7.3f mm"):format(name, fibre, stiffer, tougher, turn,
        path_angle(tips), stretch, shear(membrane)))
end
