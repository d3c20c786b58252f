-- SPDX-License-Identifier: GPL-3.0-or-later
-- What a script gets of what `rhexis bench implicit_lens_3000_balanced` says: the same lens under the same moving load,
-- in a scene of its own.
--
--   rhexis lua tests/bench/script_speed.lua
local folder = "tests/data/meshes/lens_3000"

local function read_nodes(path)
    local nodes = {}
    for number in assert(io.open(path)):read("a"):gmatch("%d+") do
        nodes[#nodes + 1] = tonumber(number) + 1
    end
    return nodes
end

local scene = rhexis.scene.create { step = 0.01 }
local lens = scene:add_solid {
    mesh = rhexis.mesh.read(folder .. ".vtk"), young_modulus = 5000, poisson_ratio = 0.45, damping_mass = 0.1,
    damping_stiffness = 0.01, formulation = "linear", advance = "implicit", fine = false,
    fixed = read_nodes(folder .. ".fixed.txt"),
}
local poked = read_nodes(folder .. ".poke.txt")
local steps, warm_up = 400, 100
local began
for step = 1, warm_up + steps do
    lens:clear_loads()
    lens:load(poked, { 0, 0, -2500 * (1 - math.cos(2 * math.pi * 0.01 * step / 0.5)) })
    assert(scene:step())
    if step == warm_up then
        began = os.clock()
    end
end
print(("%.0f steps a second"):format(steps / (os.clock() - began)))
