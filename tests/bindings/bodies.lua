-- SPDX-License-Identifier: GPL-3.0-or-later
-- Bodies and sheets of a scene of one's own, against closed forms.

-- Gravity acts on a sheet as on a block; a held one pulls at its edge with its weight.
do
    local scene = rhexis.scene.create { step = 0.01 }
    local sheet = scene:add_membrane { sheet = rhexis.mesh.sheet { size = 10, triangles = 200 } }
    assert(scene:step(50))
    local fallen, expected = -sheet:position(1)[3], 0.5 * 9810 * 0.5 ^ 2
    assert(math.abs(fallen / expected - 1) < 0.03, ("a free sheet fell %g mm of %g"):format(fallen, expected))

    local held = rhexis.scene.create { step = 0.01 }
    local function edge(x) return x < 1e-9 or x > 10 - 1e-9 end
    local cloth = held:add_membrane { sheet = rhexis.mesh.sheet { size = 10, triangles = 400 }, along = 1e4,
        thickness = 0.1, density = 0.1, damping_mass = 20, fixed = edge }
    assert(held:step(300))
    local weight, carried = 10 * 10 * 0.1 * 0.1 * 9810, -cloth:force(edge)[3]
    local own = carried / weight  -- what hangs on the free nodes; the held ones carry themselves
    assert(own > 0.9 and own < 1.02, ("the edge carries %g of %g uN"):format(carried, weight))

    local floating = rhexis.scene.create { step = 0.01 }
    local light = floating:add_membrane { sheet = rhexis.mesh.sheet { size = 2, triangles = 50 },
        buoyancy_density = 0.00105 }
    assert(floating:step(20))
    assert(math.abs(light:position(1)[3]) < 1e-9, "what floats falls")
end

-- A cantilever under a load at its tip, after Timoshenko: shear counts.
local function cantilever(poisson_ratio, across, options)
    local length, height, young_modulus, force = 16, 2, 3000, 0.4
    local scene = rhexis.scene.create { gravity = { 0, 0, 0 }, step = 0.1, tolerance = 1e-9 }
    options.mesh = options.mesh or
        rhexis.mesh.bar { cells = { length / height * across, across, across }, cell = height / across }
    options.young_modulus, options.poisson_ratio, options.damping_mass = young_modulus, poisson_ratio, 5
    options.fixed, options.fine = { high = { 1e-6, height, height } }, false
    local bar = scene:add_solid(options)
    local tip = bar:select { low = { length - 1e-6, -1, -1 } }
    local start = bar:center(tip)
    bar:load(tip, { 0, 0, -force })
    assert(scene:step(60))
    local second, area = height ^ 4 / 12, height * height
    local shear = young_modulus / (2 * (1 + poisson_ratio))
    local expected = force * length ^ 3 / (3 * young_modulus * second) + force * length / (5 / 6 * shear * area)
    return (start[3] - bar:center(tip)[3]) / expected
end
for _, across in ipairs { 2, 4 } do
    for _, poisson_ratio in ipairs { 0.3, 0.45, 0.49 } do
        local ratio = cantilever(poisson_ratio, across, {})
        assert(math.abs(ratio - 1) < 0.1, ("nu %g, %d across: %g of Timoshenko"):format(poisson_ratio, across, ratio))
    end
end
local linear = cantilever(0.49, 2, { formulation = "linear", advance = "implicit" })
assert(linear < 0.7, ("a mesh that locks does not: %g"):format(linear))
do
    local mesh = rhexis.mesh.read("tests/data/meshes/cantilever.msh")  -- 16 x 2 x 2, no lattice
    for _, poisson_ratio in ipairs { 0.3, 0.45, 0.49 } do
        local ratio = cantilever(poisson_ratio, 2, { mesh = mesh })
        assert(math.abs(ratio - 1) < 0.1, ("nu %g, Gmsh: %g of Timoshenko"):format(poisson_ratio, ratio))
    end
end

-- Each pair of formulation and advance works, or is refused in one line.
local refused = { ["nodal_pressure implicit"] = true, ["edge_smoothed explicit"] = true }
for _, formulation in ipairs { "linear", "nodal_pressure", "edge_smoothed" } do
    for _, advance in ipairs { "automatic", "explicit", "implicit" } do
        local scene = rhexis.scene.create()
        local ok, message = pcall(scene.add_solid, scene, { mesh = rhexis.mesh.bar(), young_modulus = 3000,
            formulation = formulation, advance = advance, fixed = { high = { 0, 2, 2 } } })
        local pair = formulation .. " " .. advance
        assert(ok == not refused[pair], pair .. ": " .. tostring(message))
        if ok then assert(scene:step(3), pair) else assert(message:find("formulation.*goes with advance"), message) end
    end
end

-- What a ball that rests in a block feels does not depend on how long the steps are, nor on how they are made.
local function force_at_rest(step, friction, advance)
    local scene = rhexis.scene.create { gravity = { 0, 0, 0 }, step = step, tolerance = 1e-10 }
    scene:add_solid { mesh = rhexis.mesh.bar { cells = { 6, 6, 3 }, cell = 1 }, young_modulus = 3000,
        damping_mass = 20, fixed = { high = { 6, 6, 0.01 } }, formulation = "linear", advance = advance }
    local ball = scene:add_ball { radius = 1, position = { 3, 3, 4.1 }, friction = friction }
    local steps = math.floor(0.5 / step + 0.5)
    for i = 1, steps do
        ball:move_to { 3, 3, 4.1 - 0.6 * i / steps }
        assert(scene:step())
    end
    assert(scene:step(2 * steps))
    return ball:force()[3]
end
for _, friction in ipairs { 0, 0.3 } do
    local hard = force_at_rest(0.01, friction, "explicit")
    for _, step in ipairs { 0.02, 0.01, 0.005, 0.002 } do
        for _, advance in ipairs { "implicit", "automatic" } do
            local ratio = force_at_rest(step, friction, advance) / hard
            assert(math.abs(ratio - 1) < 0.02, ("%s, %g s, friction %g: %g of the force of hard contact"):format(
                advance, step, friction, ratio))
        end
    end
end

-- A selection that is given means something.
do
    local scene = rhexis.scene.create()
    local nowhere = { high = { -5, -5, -5 } }
    for _, add in ipairs { { scene.add_solid, { mesh = rhexis.mesh.bar(), fixed = nowhere } },
        { scene.add_membrane, { sheet = rhexis.mesh.sheet(), fixed = nowhere } } } do
        local ok, message = pcall(add[1], scene, add[2])
        assert(not ok and message:find("fixed: no node was selected"), tostring(message))
    end
end

-- A block that lies on a plane weighs the same a kilometre from the origin; beyond what was tried it is refused.
local function weight_at(far, formulation, advance)
    local scene = rhexis.scene.create { tolerance = 1e-8 }
    scene:add_plane { point = { far, 0, far }, friction = 0.3 }
    local block = scene:add_solid { mesh = rhexis.mesh.bar { cells = { 4, 2, 2 }, cell = 1 }, young_modulus = 3000,
        origin = { far, 0, far }, damping_mass = 20, formulation = formulation, advance = advance }
    assert(scene:step(100))
    local sum = 0
    for _, contact in ipairs(scene:contacts()) do sum = sum + contact.force[3] end
    return sum, block:center()[3] - far
end
for _, way in ipairs { { "edge_smoothed", "implicit" }, { "linear", "explicit" }, { "nodal_pressure", "explicit" } } do
    local near, low = weight_at(0, way[1], way[2])
    for _, far in ipairs { 9e3, 1e6 } do
        local weight, height = weight_at(far, way[1], way[2])
        assert(math.abs(weight / near - 1) < 1e-4 and math.abs(height - low) < 1e-4,
            ("%s at %g mm: %g uN instead of %g, %g mm instead of %g"):format(way[1], far, weight, near, height, low))
    end
end
do
    local ok, message = pcall(function()
        local scene = rhexis.scene.create()
        scene:add_solid { mesh = rhexis.mesh.bar(), origin = { 2e7, 0, 0 } }
        assert(scene:step())
    end)
    assert(not ok and tostring(message):find("-1e7 to 1e7 mm", 1, true), tostring(message))
end

-- Contacts say what they are of.
do
    local step = 0.01
    local scene = rhexis.scene.create { gravity = { 0, 0, 0 }, step = step, tolerance = 1e-8 }
    scene:add_solid { mesh = rhexis.mesh.bar { cells = { 6, 6, 3 }, cell = 1 }, young_modulus = 3000,
        damping_mass = 20, fixed = { high = { 6, 6, 0.01 } } }
    local ball = scene:add_ball { radius = 1, position = { 3, 3, 4.1 }, friction = 0 }
    local steps = math.floor(0.5 / step + 0.5)
    for i = 1, steps do
        ball:move_to { 3, 3, 4.1 - 0.6 * i / steps }
        assert(scene:step())
    end
    assert(#scene:contacts() > 0)
    for _, contact in ipairs(scene:contacts()) do
        assert(contact.solid == 1 and contact.membrane == nil and contact.partner == "tool")
    end
end
do
    local scene = rhexis.scene.create()
    scene:add_plane { point = { 0, 0, -0.5 } }
    scene:add_membrane { sheet = rhexis.mesh.sheet { size = 4, triangles = 100 }, density = 0.01 }
    local found
    for _ = 1, 60 do
        assert(scene:step())
        found = found or scene:contacts()[1]
    end
    assert(found and found.membrane == 1 and found.solid == nil and found.partner == "plane", "no contact of a sheet")
end
