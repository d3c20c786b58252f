-- SPDX-License-Identifier: GPL-3.0-or-later
-- A bar of soft tissue, clamped at one end; a ball pushes the other end down by a millimetre in a second.
local scene = rhexis.scene.create { gravity = { 0, 0, 0 } }
local mesh = rhexis.mesh.bar { cells = { 8, 2, 2 }, cell = 1 }
local bar = scene:add_solid { mesh = mesh, young_modulus = 3000, damping_mass = 20, fixed = { high = { 0, 2, 2 } } }
local probe = scene:add_ball { radius = 0.6, position = { 7.5, 1, 2.7 } }
local tip = bar:select { low = { 8, 0, 0 } }
local start = bar:center(tip)[3]
for step = 1, 100 do
    probe:move_to { 7.5, 1, 2.7 - 0.01 * step }
    assert(scene:step())
end
print(("the tip went down by %.3f mm; the ball feels %.0f uN"):format(start - bar:center(tip)[3], probe:force()[3]))
local view = { eye = { 4, -60, 25 }, target = { 4, 1, 0 }, up = { 0, 0, 1 }, field = 8 }
rhexis.render.draw(scene, { camera = view }):write_png(arg[1] or "bar.png")
