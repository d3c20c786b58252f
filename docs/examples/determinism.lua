-- SPDX-License-Identifier: GPL-3.0-or-later
-- The same scene with one and two threads, by every instruction set: one hash.
local function simulate(threads, instruction_set)
    local scene = rhexis.scene.create { threads = threads, instruction_set = instruction_set }
    scene:add_plane { point = { 0, 0, -2.2 } }
    scene:add_solid { mesh = rhexis.mesh.ball { tetrahedra = 600 }, young_modulus = 2000, damping_mass = 5 }
    assert(scene:step(40))
    return scene:state_hash()
end
local hash = simulate(1, "best")
assert(simulate(2, "best") == hash)
assert(simulate(1, "baseline") == hash)
print("40 steps, one hash: " .. hash)
