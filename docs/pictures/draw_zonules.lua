-- SPDX-License-Identifier: GPL-3.0-or-later
-- A bag that lacks zonules over four clock hours: the lens lies aside; two hooks hold it, and a ring goes in.
--   rhexis lua docs/pictures/draw_zonules.lua [FOLDER]
local folder = arg[1] or "docs/pictures"
local size = { width = 480, height = 360 }

local function draw(eye, name)
    rhexis.render.draw(eye, size):write_png(folder .. "/" .. name .. ".png")
    print(name)
end

-- An instrument at the edge of the opening, turned from the middle of the gap [deg], its jaw so far open.
local function at_edge(eye, name, turn, jaw, steps)
    for _ = 1, steps do
        local now = eye:observation().zonules
        local x, y, angle = now.rim_x_mm, now.rim_y_mm, math.rad(turn)
        eye:tool(name):move { jaw = jaw, axis = { 0, -0.1, 1 }, position = {
            x * math.cos(angle) - y * math.sin(angle), x * math.sin(angle) + y * math.cos(angle), now.rim_z_mm + 0.1 } }
        assert(eye:step())
    end
end

local eye = rhexis.eye.create { age = 74, tetrahedra = 1000, pupil_mm = 8.5,
    instruments = { "phaco", "capsule_hook", "ring" },
    tissues = { "lens", "bag", "capsule", "iris", "cornea", "chamber", "vitreous", "zonules" },
    settings = { ["zonules.lost_from_deg"] = 30, ["zonules.lost_deg"] = 135, ["zonules.strength"] = 0.4,
        ["zonules.tension"] = 0.62 } }
for _ = 1, 200 do assert(eye:step()) end
draw(eye, "zonules_lost")
for _, turn in ipairs { -22, 22 } do
    at_edge(eye, "capsule_hook", turn, 1, 10)
    at_edge(eye, "capsule_hook", turn, 0, 2)
end
eye:tool("capsule_hook"):withdraw()
for _ = 1, 100 do assert(eye:step()) end
at_edge(eye, "ring", 0, 1, 120)
draw(eye, "zonules_held")
