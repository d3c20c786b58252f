-- SPDX-License-Identifier: GPL-3.0-or-later
-- The view through a microscope that stands beside the pupil and is not focused, and one that is centred and sharp.
--   rhexis lua docs/pictures/draw_microscope.lua [FOLDER]
local folder = arg[1] or "docs/pictures"

local function draw(name, x, y, focus)
    local eye = rhexis.eye.create { tissues = { "anterior_capsule", "viscoelastic", "iris", "cornea" },
        instruments = { "cystotome", "microscope" },
        settings = { ["microscope.x_mm"] = x, ["microscope.y_mm"] = y, ["microscope.focus_mm"] = focus } }
    eye:tool("cystotome"):move { position = { 0.9, -0.2, 2.4 } }
    assert(eye:step())
    rhexis.render.draw(eye, { width = 480, height = 360 }):write_png(folder .. "/" .. name .. ".png")
end

draw("microscope_off", 3, 2, 5)
draw("microscope_centred", 0, 0, 0)
