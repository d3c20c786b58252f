---@meta
-- SPDX-License-Identifier: GPL-3.0-or-later

---Bodies, tools and planes that a script puts together, steps and looks into.
---@class rhexis.scene
local scene = {}

---@class rhexis.SceneOptions
---@field step? number # length of a step [s]; 0.00001 to 0.1; default 0.01
---@field gravity? rhexis.Vec3 # [mm/s^2]; default {0, 0, -9810}
---@field threads? integer # that work on a step; the result does not depend on it; 1 to 64; default 1
---@field instruction_set? "best"|"baseline"|"avx2"|"avx512" # same bits, other speed; default "best"
---@field tolerance? number # force left over in an implicit step, as a share of all; 1e-14 to 0.01; default 0.0001

---An empty scene.
---```lua
---local scene = rhexis.scene.create { step = 0.005, gravity = { 0, 0, 0 } }
---assert(scene:time() == 0)
---```
---@param options? rhexis.SceneOptions
---@return rhexis.Scene
function scene.create(options) end

---A small world: bodies, tools and planes. Made by rhexis.scene.create, or by rhexis.eye.create around a patient.
---@class rhexis.Scene
local Scene = {}

---@class rhexis.SolidOptions
---@field mesh rhexis.Mesh # of the body; must be given
---@field name? string # default "solid"
---@field origin? rhexis.Vec3 # added to every node of the mesh [mm]; default {0, 0, 0}
---@field young_modulus? number # Young's modulus [Pa]; above 0 up to 1e9; default 1000
---@field poisson_ratio? number # Poisson's ratio; 0 to 0.499; default 0.45
---@field density? number # [g/mm^3]; above 0 up to 0.1; default 0.00105
---@field fixed? rhexis.Selection # nodes that never move, at least one; default none
---@field advance? "automatic"|"explicit"|"implicit" # way to advance it in time; default "automatic"
---@field formulation? "linear"|"nodal_pressure"|"edge_smoothed" # see below; default "edge_smoothed"
---@field damping_mass? number # Rayleigh damping by mass [1/s]; 0 to 10000; default 0
---@field damping_stiffness? number # Rayleigh damping by stiffness [s]; 0 to 10; default 0
---@field buoyancy_density? number # density of the fluid around it [g/mm^3]; 0 to 0.1; default 0
---@field ablation_energy? number # ultrasound energy to emulsify it [mJ/mm^3]; 0 (never) to 1e6; default 0
---@field extinction? rhexis.Vec3 # Beer-Lambert attenuation for red, green, blue [1/mm]; default {0.05, 0.1, 0.2}
---@field velocity? rhexis.Vec3 # of every free node at the start [mm/s]; default {0, 0, 0}
---@field fine? boolean # split every element into 8 for contact, sculpting and picture; default true

---Adds a deformable body. Its nodes lie within 1e7 mm of the origin along every axis. It meets tools and planes. Two
---bodies, or a body and a sheet, pass through each other, which a line on stderr tells. How its elements are made is
---`formulation`: edge-smoothed ones, which step implicitly, are within 10 % of Timoshenko's beam with 2 cells across.
---Linear ones, which step either way, lock where they bend (up to 42 % too stiff at a Poisson's ratio of 0.49); those
---with their pressure at the nodes, which step explicitly and are the default with advance "explicit", less.
---```lua
---local scene = rhexis.scene.create()
---local bar = scene:add_solid { mesh = rhexis.mesh.bar(), young_modulus = 3000, fixed = { high = { 0, 2, 2 } } }
---assert(scene:step(5))
---assert(bar:center()[3] < 1)
---```
---@param options rhexis.SolidOptions
---@return rhexis.Solid
function Scene:add_solid(options) end

---@class rhexis.MembraneOptions
---@field sheet rhexis.Sheet # must be given
---@field name? string # default "membrane"
---@field along? number # Young's modulus along the fibres [Pa]; above 0 up to 1e12; default 1e6
---@field across? number # and across them [Pa]; above 0 up to 1e12; default as along
---@field poisson_ratio? number # across, pulled along; -1 to 10, its square below along / across; default 0.45
---@field shear_modulus? number # [Pa]; 0 (so that one over E blends those of along and across) to 1e12; default 0
---@field fibres? "straight"|"circles" # all one way, or in circles about the z axis; default "straight"
---@field fibre? rhexis.Vec3 # the way of straight ones, not at a right angle to the sheet; default {1, 0, 0}
---@field thickness? number # [mm]; 0.00001 to 10; default 0.015
---@field toughness_along? number # energy per area of a tear along the fibres [mJ/m^2]; 0.001 to 1e12; default 1e6
---@field toughness_across? number # and of one across them [mJ/m^2]; 0.001 to 1e12; default as along
---@field tear_radius? number # about the tip of a tear, of what decides on its way [mm]; 0.0001 to 100; default 0.4
---@field sharpest_turn? number # of a tear from the way it came [degrees]; 0 to 180; default 90
---@field existing_edges? boolean # tear along edges of the mesh only; default false
---@field density? number # [g/mm^3]; 1e-7 to 1; default 0.00105
---@field buoyancy_density? number # density of the fluid around it [g/mm^3]; 0 to 1; default 0
---@field damping_mass? number # Rayleigh damping by mass [1/s]; 0 to 1e6; default 0
---@field damping_stiffness? number # Rayleigh damping by stiffness [s]; 0 to 10; default 0
---@field fixed? rhexis.Selection # nodes that only Membrane:move moves, at least one; default none

---Adds a thin sheet that has weight, stretches, wrinkles and, once it is punctured, tears where there is the energy for
---it. It meets tools and planes; bodies and other sheets pass through it, which a line on stderr tells.
---```lua
---local scene = rhexis.scene.create()
---local sheet = scene:add_membrane { sheet = rhexis.mesh.sheet { size = 2, triangles = 100 }, across = 3e5,
---    fibre = { 1, 1, 0 }, fixed = function(x) return x < 1e-9 or x > 2 - 1e-9 end }
---sheet:move(function(x) return x > 2 - 1e-9 end, { 0.1, 0, 0 })
---assert(scene:step(5))
---assert(sheet:force(function(x) return x < 1e-9 end)[1] > 0)
---```
---@param options rhexis.MembraneOptions
---@return rhexis.Membrane
function Scene:add_membrane(options) end

---@class rhexis.BallToolOptions
---@field radius? number # [mm]; 0.001 to 100; default 0.5
---@field position? rhexis.Vec3 # of its centre [mm]; default {0, 0, 0}
---@field axis? rhexis.Vec3 # from the tip to the hand; default {0, 0, 1}
---@field roll? number # about the axis [degrees]; -360 to 360; default 0
---@field friction? number # Coulomb coefficient; 0 to 2; default 0.2
---@field name? string # default "ball"

---Adds a rigid ball that the script moves.
---```lua
---local scene = rhexis.scene.create()
---local ball = scene:add_ball { radius = 0.4, position = { 0, 0, 3 } }
---assert(ball:position()[3] == 3)
---```
---@param options? rhexis.BallToolOptions
---@return rhexis.Tool
function Scene:add_ball(options) end

---@class rhexis.RodToolOptions
---@field radius? number # of its round end, the tip [mm]; 0.001 to 100; default 0.5
---@field shaft_radius? number # at the other end [mm]; 0.001 to 100; default radius
---@field length? number # from the centre of one end to that of the other [mm]; 0.001 to 1000; default 10
---@field position? rhexis.Vec3 # centre of the tip's ball [mm]; default {0, 0, 0}
---@field axis? rhexis.Vec3 # from the tip to the hand; default {0, 0, 1}
---@field roll? number # about the axis [degrees]; -360 to 360; default 0
---@field friction? number # Coulomb coefficient; 0 to 2; default 0.2
---@field name? string # default "rod"

---Adds a rigid rod with round ends that the script moves.
---```lua
---local scene = rhexis.scene.create()
---local rod = scene:add_rod { radius = 0.3, length = 8, position = { 0, 0, 2 }, axis = { 0, -1, 1 } }
---assert(rod:axis()[2] < 0)
---```
---@param options? rhexis.RodToolOptions
---@return rhexis.Tool
function Scene:add_rod(options) end

---@class rhexis.PhacoToolOptions
---@field position? rhexis.Vec3 # of the tip [mm]; default {0, 0, 0}
---@field axis? rhexis.Vec3 # from the tip to the hand; default {0, 0, 1}
---@field roll? number # about the axis [degrees]; -360 to 360; default 0
---@field friction? number # Coulomb coefficient; 0 to 2; default the handpiece's
---@field name? string # default "phaco"

---Adds a phacoemulsification handpiece; its pedal is moved with Tool:move.
---```lua
---local scene = rhexis.scene.create()
---local phaco = scene:add_phaco { position = { 0, 0, 10 }, axis = { 0, -1, 1 } }
---phaco:move { pedal = 3 }
---assert(scene:step())
---```
---@param options? rhexis.PhacoToolOptions
---@return rhexis.Tool
function Scene:add_phaco(options) end

---@class rhexis.PlaneOptions
---@field point? rhexis.Vec3 # on the plane [mm]; default {0, 0, 0}
---@field normal? rhexis.Vec3 # into the free side, any length; default {0, 0, 1}
---@field friction? number # Coulomb coefficient; 0 to 2; default 0.3

---Adds a fixed plane that bodies rest on.
---```lua
---local scene = rhexis.scene.create()
---scene:add_plane { point = { 0, 0, -2 } }
---```
---@param options? rhexis.PlaneOptions
function Scene:add_plane(options) end

---Steps the scene. A step that cannot be solved, after smaller steps and the safer way were tried, moves nothing.
---```lua
---local scene = rhexis.scene.create { step = 0.01 }
---assert(scene:step(3))
---assert(scene:step_count() == 3)
---```
---@param count? integer # number of steps, 0 to 1e8; default 1
---@return true? done # nil if a step failed; the rest was then not tried
---@return string? why # which step failed, and how
function Scene:step(count) end

---Everything that moves, to come back to. Going on from it gives the same hashes as going through.
---```lua
---local scene = rhexis.scene.create()
---scene:add_solid { mesh = rhexis.mesh.bar(), fixed = { high = { 0, 2, 2 } } }
---local before = scene:snapshot()
---scene:step(2)
---local once = scene:state_hash()
---scene:restore(before)
---scene:step(2)
---assert(scene:state_hash() == once)
---```
---@return rhexis.Snapshot
function Scene:snapshot() end

---Goes back to a snapshot of this scene. Bodies must not have been added since.
---```lua
---local scene = rhexis.scene.create()
---local start = scene:snapshot()
---scene:step(4)
---scene:restore(start)
---assert(scene:time() == 0)
---```
---@param snapshot rhexis.Snapshot
function Scene:restore(snapshot) end

---In the scene of an eye: sets a parameter from the next step on, such as "phaco.power_limit".
---```lua
---local eye = rhexis.eye.create { tetrahedra = 500 }
---eye:set("phaco.power_limit", 0.6)
---```
---@param name string
---@param value number
function Scene:set(name, value) end

---Simulated time [s].
---```lua
---local scene = rhexis.scene.create { step = 0.01 }
---scene:step(5)
---assert(math.abs(scene:time() - 0.05) < 1e-12)
---```
---@return number
function Scene:time() end

---Number of steps since the start.
---```lua
---assert(rhexis.scene.create():step_count() == 0)
---```
---@return integer
function Scene:step_count() end

---16 hexadecimal digits that name the state: equal for the same script on any x86-64 machine and any thread count.
---```lua
---local one, two = rhexis.scene.create(), rhexis.scene.create()
---assert(one:state_hash() == two:state_hash())
---```
---@return string
function Scene:state_hash() end

---@class rhexis.Contact
---@field solid? integer # number of the body that touches; nil: a sheet does
---@field membrane? integer # number of the sheet that touches; nil: a body does
---@field partner "tool"|"bag"|"plane"|"dome"|"support"|"tube"|"layer"|"sheet"|"jaws" # what it touches
---@field partner_index integer # which one, from 1
---@field point rhexis.Vec3 # [mm]
---@field normal rhexis.Vec3 # unit, from the partner into the body
---@field gap number # [mm]; negative: penetration
---@field force rhexis.Vec3 # on the body or sheet, mean over the step [uN]
---@field sliding boolean # friction is at its limit

---Who touches what, as of the last step.
---```lua
---local scene = rhexis.scene.create()
---scene:add_plane()
---scene:add_solid { mesh = rhexis.mesh.bar(), young_modulus = 3000, damping_mass = 20 }
---scene:step(5)
---assert(#scene:contacts() > 0 and scene:contacts()[1].partner == "plane")
---```
---@return rhexis.Contact[]
function Scene:contacts() end

---@class rhexis.Energy
---@field kinetic number # [nJ]
---@field elastic number # [nJ]

---Energy of all bodies at the end of the last step.
---```lua
---local scene = rhexis.scene.create()
---scene:add_solid { mesh = rhexis.mesh.bar(), fixed = { high = { 0, 2, 2 } } }
---scene:step()
---assert(scene:energy().kinetic > 0)
---```
---@return rhexis.Energy
function Scene:energy() end

---@class rhexis.Report
---@field rollbacks integer # tries thrown away before the result
---@field notes string[] # one line per fallback
---@field solids rhexis.SolidReport[] # one per body
---@field membranes rhexis.MembraneReport[] # one per membrane

---@class rhexis.MembraneReport
---@field substeps integer
---@field newton_iterations integer
---@field linear_iterations integer
---@field force number # norm of the forces that do not balance at the end [uN]
---@field tears integer # that had the energy to go on

---@class rhexis.SolidReport
---@field advance "explicit"|"implicit" # the way that was taken
---@field substeps integer
---@field newton_iterations integer
---@field solver_iterations integer
---@field residual number # relative, left by the implicit solve
---@field stable_step number # explicit stability limit now [s]; 0 if unknown
---@field kinetic_energy number # [nJ]
---@field elastic_energy number # [nJ]
---@field inverted integer # elements with negative volume

---How the last step went.
---```lua
---local scene = rhexis.scene.create()
---scene:add_solid { mesh = rhexis.mesh.bar(), fixed = { high = { 0, 2, 2 } }, advance = "explicit" }
---scene:step()
---assert(scene:report().solids[1].advance == "explicit")
---```
---@return rhexis.Report
function Scene:report() end

---Mass emulsified so far [g].
---```lua
---assert(rhexis.scene.create():removed_mass() == 0)
---```
---@return number
function Scene:removed_mass() end

---Mass of the crumbs that have come loose from bodies and drift about [g].
---```lua
---assert(rhexis.scene.create():crumb_mass() == 0)
---```
---@return number
function Scene:crumb_mass() end

---A body by its name or number.
---```lua
---local eye = rhexis.eye.create { tetrahedra = 500 }
---print(eye:solid("lens"):tetrahedron_count())
---```
---@param name string|integer
---@return rhexis.Solid
function Scene:solid(name) end

---A membrane by its name or number.
---```lua
---local scene = rhexis.scene.create()
---scene:add_membrane { sheet = rhexis.mesh.sheet { triangles = 50 }, name = "sheet" }
---assert(scene:membrane("sheet"):triangle_count() == scene:membrane(1):triangle_count())
---```
---@param name string|integer
---@return rhexis.Membrane
function Scene:membrane(name) end

---A tool by its name or number.
---```lua
---local eye = rhexis.eye.create { tetrahedra = 500, instruments = { "phaco" } }
---assert(eye:tool("phaco"):name() == "phaco")
---```
---@param name string|integer
---@return rhexis.Tool
function Scene:tool(name) end

---In the scene of an eye: its measures now, by group, as a curriculum sees them. A measure without a value is nil.
---```lua
---local eye = rhexis.eye.create { tetrahedra = 500 }
---eye:step()
---assert(type(eye:observation().lens) == "table")
---```
---@return table<string, table<string, number|boolean>>
function Scene:observation() end

---@class rhexis.Measure
---@field name string # "group.name_unit"
---@field unit string
---@field meaning string # one plain sentence

---In the scene of an eye: what each measure of observation means.
---```lua
---local eye = rhexis.eye.create { tetrahedra = 500 }
---assert(#eye:measures() > 0)
---```
---@return rhexis.Measure[]
function Scene:measures() end

---@class rhexis.Anatomy
---@field cornea_apex_z number # front of the cornea on the axis [mm]
---@field cornea_radius number # front radius of curvature [mm]
---@field limbus_radius number # half of white-to-white [mm]
---@field limbus_z number # [mm]
---@field iris_z number # plane of the pupil's edge [mm]
---@field pupil_radius number # [mm]
---@field anterior_chamber_depth number # front of the cornea to front of the lens [mm]
---@field incision rhexis.Vec3 # centre of the main wound at its inner lip [mm]
---@field incision_width number # [mm]
---@field side_port rhexis.Vec3 # centre of the second, narrow wound at its inner lip [mm]
---@field side_port_width number # [mm]; 0: it is not cut, because no instrument needs it

---In the scene of an eye: sizes and places of what surrounds the lens.
---```lua
---local eye = rhexis.eye.create { tetrahedra = 500, pupil_mm = 7 }
---assert(math.abs(eye:anatomy().pupil_radius - 3.5) < 1e-9)
---```
---@return rhexis.Anatomy
function Scene:anatomy() end

---Frees the scene now. Its solids, tools and views then raise an error.
---```lua
---local scene = rhexis.scene.create()
---scene:close()
---assert(not pcall(scene.step, scene))
---```
function Scene:close() end

---A deformable body of a scene.
---@class rhexis.Solid
local Solid = {}

---The name it was given; "lens" in an eye.
---```lua
---local scene = rhexis.scene.create()
---assert(scene:add_solid { mesh = rhexis.mesh.bar(), name = "bar" }:name() == "bar")
---```
---@return string
function Solid:name() end

---Number of nodes.
---```lua
---local scene = rhexis.scene.create()
---assert(scene:add_solid { mesh = rhexis.mesh.bar() }:node_count() == 81)
---```
---@return integer
function Solid:node_count() end

---Number of elements that are still there.
---```lua
---local scene = rhexis.scene.create()
---assert(scene:add_solid { mesh = rhexis.mesh.bar() }:tetrahedron_count() == 160)
---```
---@return integer
function Solid:tetrahedron_count() end

---Where a node is now [mm].
---```lua
---local scene = rhexis.scene.create()
---local bar = scene:add_solid { mesh = rhexis.mesh.bar(), origin = { 0, 0, 5 } }
---assert(bar:position(1)[3] == 5)
---```
---@param node integer # 1 to node_count()
---@return rhexis.Vec3
function Solid:position(node) end

---How fast a node moves [mm/s].
---```lua
---local scene = rhexis.scene.create()
---local bar = scene:add_solid { mesh = rhexis.mesh.bar(), velocity = { 1, 0, 0 } }
---assert(bar:velocity(1)[1] == 1)
---```
---@param node integer # 1 to node_count()
---@return rhexis.Vec3
function Solid:velocity(node) end

---A copy of all node places [mm].
---```lua
---local scene = rhexis.scene.create()
---local bar = scene:add_solid { mesh = rhexis.mesh.bar() }
---assert(#bar:positions() == bar:node_count())
---```
---@return rhexis.Vec3[]
function Solid:positions() end

---Mean place of some nodes, or of all [mm].
---```lua
---local scene = rhexis.scene.create()
---local bar = scene:add_solid { mesh = rhexis.mesh.bar() }
---local tip = bar:select(function(x) return x == 8 end)
---assert(bar:center(tip)[1] == 8)
---```
---@param nodes? rhexis.Selection # by where the nodes are now; default all
---@return rhexis.Vec3
function Solid:center(nodes) end

---Numbers of the nodes that a selection means where the body is at rest, ascending.
---```lua
---local scene = rhexis.scene.create()
---local bar = scene:add_solid { mesh = rhexis.mesh.bar() }
---assert(#bar:select { low = { 8, 0, 0 } } == 9)
---```
---@param selection rhexis.Selection
---@return integer[]
function Solid:select(selection) end

---What is left of it [g].
---```lua
---local scene = rhexis.scene.create()
---local bar = scene:add_solid { mesh = rhexis.mesh.bar(), density = 0.001 }
---assert(math.abs(bar:mass() - 0.032) < 1e-12)
---```
---@return number
function Solid:mass() end

---Volume now of the elements that are still there [mm^3].
---```lua
---local scene = rhexis.scene.create()
---assert(math.abs(scene:add_solid { mesh = rhexis.mesh.bar() }:volume() - 32) < 1e-12)
---```
---@return number
function Solid:volume() end

---Share of an element that is left, 1 down to 0.
---```lua
---local scene = rhexis.scene.create()
---assert(scene:add_solid { mesh = rhexis.mesh.bar() }:fraction(1) == 1)
---```
---@param tetrahedron integer
---@return number
function Solid:fraction(tetrahedron) end

---Spreads a force over nodes, from the next step until clear_loads. Not for the tissue of an eye.
---```lua
---local scene = rhexis.scene.create { gravity = { 0, 0, 0 } }
---local bar = scene:add_solid { mesh = rhexis.mesh.bar(), fixed = { high = { 0, 2, 2 } } }
---bar:load({ low = { 8, 0, 0 } }, { 0, 0, -100 })
---scene:step(5)
---assert(bar:center()[3] < 1)
---```
---@param nodes rhexis.Selection # where the body is at rest
---@param force rhexis.Vec3 # their sum [uN]
function Solid:load(nodes, force) end

---Takes all loads off this body.
---```lua
---local scene = rhexis.scene.create()
---scene:add_solid { mesh = rhexis.mesh.bar() }:clear_loads()
---```
function Solid:clear_loads() end

---Takes elements out of the body, chosen by where their centres are now. Not for the tissue of an eye.
---```lua
---local scene = rhexis.scene.create()
---local bar = scene:add_solid { mesh = rhexis.mesh.bar() }
---assert(bar:remove(function(x) return x > 7 end) == 20)
---assert(bar:tetrahedron_count() == 140)
---```
---@param tetrahedra rhexis.Selection
---@return integer removed
function Solid:remove(tetrahedra) end

---A live view of the node places: `view[i]` is where node i is now, `#view` their number. It raises "mesh changed" once
---elements of the scene were removed.
---```lua
---local scene = rhexis.scene.create()
---local bar = scene:add_solid { mesh = rhexis.mesh.bar() }
---local view = bar:view()
---assert(#view == 81 and view[1][1] == 0)
---bar:remove { 1 }
---assert(not pcall(function() return view[1] end))
---```
---@return rhexis.View
function Solid:view() end

---Node places as they are now; see Solid:view.
---@class rhexis.View
local View = {}

---A moment of a scene; see Scene:snapshot.
---@class rhexis.Snapshot
local Snapshot = {}

---Frees it now.
---```lua
---rhexis.scene.create():snapshot():close()
---```
function Snapshot:close() end

rhexis.scene = scene
