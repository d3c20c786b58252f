-- SPDX-License-Identifier: GPL-3.0-or-later
-- A ball of tissue lies on a plane; a rod pokes it from above. Prints force against depth, as a table.
local scene = rhexis.scene.create { step = 0.005, gravity = { 0, 0, 0 } }
scene:add_plane { point = { 0, 0, -2 }, friction = 0.5 }
local mesh = rhexis.mesh.ball { radius = 2, tetrahedra = 1000 }
local ball = scene:add_solid { mesh = mesh, young_modulus = 2000, damping_mass = 30 }
local rod = scene:add_rod { radius = 0.5, length = 8, position = { 0, 0, 2.5 } }
print("depth mm  force uN")
for step = 1, 60 do
    rod:move_to { 0, 0, 2.5 - 0.01 * step }
    assert(scene:step())
    if step % 10 == 0 then
        print(("%8.2f %9.1f"):format(0.01 * step, rod:force()[3]))
    end
end
print(("%d contacts, volume %.2f mm^3"):format(#scene:contacts(), ball:volume()))
