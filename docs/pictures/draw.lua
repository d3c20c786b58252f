-- SPDX-License-Identifier: GPL-3.0-or-later
-- The pictures of this folder: one groove, early, half way and late, sculpted by the mechanics of the default patient.
--   rhexis lua docs/pictures/draw.lua [FOLDER]
local folder = arg[1] or "docs/pictures"
local size = { width = 800, height = 600 }
local eye = rhexis.eye.create { advance = "explicit", seed = 1 }
local phaco = eye:tool("phaco")

-- One stroke away from the surgeon, at a height and a little to one side; `share` of it at the end.
local function stroke(height, side, share)
    local steps = math.floor(110 * share)
    for step = 0, steps do
        phaco:move { position = { side, -1.9 + 3.7 * step / 110, height }, axis = { 0, -1, 0.75 }, pedal = 3 }
        assert(eye:step())
    end
end

local function back(height)
    phaco:move { position = { 0, -1.9, height + 0.4 }, axis = { 0, -1, 0.75 }, pedal = 1 }
    assert(eye:step(10))
end

local function deepen(from, to)
    for pass = from, to do
        local height = 2.15 - 0.26 * pass
        for _, side in ipairs { -0.3, 0.3, 0 } do
            stroke(height, side, 1)
            back(height)
        end
    end
end

local function draw(name)
    rhexis.render.draw(eye, size):write_png(folder .. "/" .. name .. ".png")
    print(("%s: %.1f mg emulsified"):format(name, 1000 * eye:removed_mass()))
end

deepen(1, 2)
stroke(2.15 - 0.26 * 3, 0, 0.6)
draw("groove_early")
back(2.15)
deepen(3, 7)
stroke(2.15 - 0.26 * 8, 0, 0.55)
draw("groove_half_way")
back(2.15)
deepen(8, 13)
stroke(2.15 - 0.26 * 13, 0, 0.25)
draw("groove_late")
