-- SPDX-License-Identifier: GPL-3.0-or-later
-- A square sheet with fibres at 45 degrees is pulled left and right until a puncture in its middle tears
-- (the experiment of [Dequidt2013] fig. 4, with the criterion of docs/tearing.md).
--   rhexis lua docs/examples/torn_sheet.lua [FOLDER]
-- Prints how the fibres bend deformation and path, and how the way the tear came matters. With a folder: pictures.
local folder = arg[1]
local side = 10
local picture_size = { width = 480, height = 480 }

-- Angle of a direction from the pull [deg], 0 to 180.
local function angle(direction) return math.deg(math.atan(direction[2], direction[1])) % 180 end

local function draw(scene, name)
    if folder then
        rhexis.render.picture(scene, { width = picture_size.width, height = picture_size.height,
            camera = { eye = { 5, 5, 200 }, target = { 5, 5, 0 }, up = { 0, 1, 0 }, field_mm = 14 } })
            :write(("%s/%s.png"):format(folder, name))
    end
end

-- ratio: strength across the fibres over that along them. turn: sharpest turn of the tear [deg].
local function sheet(fibre_deg, stiffer, ratio, turn)
    local scene = rhexis.scene.create { gravity = { 0, 0, 0 } }
    local fibre = { math.cos(math.rad(fibre_deg)), math.sin(math.rad(fibre_deg)), 0 }
    local membrane = scene:add_membrane {
        sheet = rhexis.mesh.sheet { shape = "square", size = side, triangles = 1500 },
        along = 1e6, across = 1e6 / stiffer, poisson_ratio = 0.3, fibre = fibre,
        toughness_along = 1e5, toughness_across = 1e5 * ratio ^ 2, sharpest_turn = turn, tear_radius = 1.0,
        damping_mass = 200, fixed = function(x) return x < 1e-9 or x > side - 1e-9 end,
    }
    return scene, membrane
end

local function left(x) return x < 1e-9 end
local function right(x) return x > side - 1e-9 end

-- Pulls until the tear has gone so far, or leaves the sheet. Returns where its tips are.
local function pull(scene, membrane, far, name)
    for step = 1, 400 do
        membrane:move(left, { -0.01, 0, 0 })
        membrane:move(right, { 0.01, 0, 0 })
        assert(scene:step(4))
        local tips = membrane:tips()
        if name and step % 40 == 0 then draw(scene, ("%s_%03d"):format(name, step)) end
        if #tips < 2 then return tips, step end
        local a, b = tips[1].rest, tips[2].rest
        local length = math.sqrt((a[1] - b[1]) ^ 2 + (a[2] - b[2]) ^ 2)
        if length > far then return tips, step end
    end
    return membrane:tips(), 400
end

local function path_angle(tips)
    local a, b = tips[1].rest, tips[2].rest
    return angle({ a[1] - b[1], a[2] - b[2] })
end

print("pull at 0 degrees; angle of the tear from it")
for _, case in ipairs { { 45, 1, 1, "isotropic" }, { 45, 1, 4, "fibres_45" }, { 15, 1, 4 }, { 30, 1, 4 }, { 60, 1, 4 }, { 75, 1, 4 } } do
    local fibre, stiffer, ratio, name = table.unpack(case)
    local scene, membrane = sheet(fibre, stiffer, ratio, 90)
    membrane:puncture({ 5, 5, 0 }, { 0, 1, 0 })
    local tips, steps = pull(scene, membrane, 4, name)
    print(("fibres at %2d, strength ratio %d: %5.1f degrees after %d steps, %.3f mm^2 torn"):format(fibre, ratio,
        #tips == 2 and path_angle(tips) or 0 / 0, steps, membrane:torn().area))
    if name then draw(scene, name .. "_end") end
end
