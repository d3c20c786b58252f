---@meta
-- SPDX-License-Identifier: GPL-3.0-or-later

---A thin sheet of a scene. Selections choose nodes by where they are at rest; a tear adds nodes at the end of the list.
---@class rhexis.Membrane
local Membrane = {}

---The name it was given.
---```lua
---local scene = rhexis.scene.create()
---assert(scene:add_membrane { sheet = rhexis.mesh.sheet { triangles = 50 } }:name() == "membrane")
---```
---@return string
function Membrane:name() end

---Number of nodes now.
---```lua
---local scene = rhexis.scene.create()
---local mesh = rhexis.mesh.sheet { triangles = 50 }
---assert(scene:add_membrane { sheet = mesh }:node_count() == mesh:info().nodes)
---```
---@return integer
function Membrane:node_count() end

---Number of triangles now.
---```lua
---local scene = rhexis.scene.create()
---local mesh = rhexis.mesh.sheet { triangles = 50 }
---assert(scene:add_membrane { sheet = mesh }:triangle_count() == mesh:info().triangles)
---```
---@return integer
function Membrane:triangle_count() end

---Where a node is now [mm].
---```lua
---local scene = rhexis.scene.create()
---assert(scene:add_membrane { sheet = rhexis.mesh.sheet() }:position(1)[3] == 0)
---```
---@param number integer # 1 to node_count()
---@return rhexis.Vec3
function Membrane:position(number) end

---Where a node is at rest [mm].
---```lua
---local scene = rhexis.scene.create()
---assert(scene:add_membrane { sheet = rhexis.mesh.sheet() }:rest_position(1)[1] == 0)
---```
---@param number integer # 1 to node_count()
---@return rhexis.Vec3
function Membrane:rest_position(number) end

---Mean place of some nodes now [mm].
---```lua
---local scene = rhexis.scene.create()
---local sheet = scene:add_membrane { sheet = rhexis.mesh.sheet { size = 4 } }
---assert(math.abs(sheet:center(function(x) return x < 1e-9 end)[2] - 2) < 1e-6)
---```
---@param selection rhexis.Selection
---@return rhexis.Vec3
function Membrane:center(selection) end

---Numbers of the nodes that a selection means, ascending.
---```lua
---local scene = rhexis.scene.create()
---assert(#scene:add_membrane { sheet = rhexis.mesh.sheet() }:select { high = { 0, 10, 0 } } > 10)
---```
---@param selection rhexis.Selection
---@return integer[]
function Membrane:select(selection) end

---Spreads a constant force evenly over some nodes, on top of earlier ones [uN].
---```lua
---local scene = rhexis.scene.create()
---local sheet = scene:add_membrane { sheet = rhexis.mesh.sheet(), fixed = function(x) return x < 1e-9 end }
---sheet:load(function(x) return x > 9.99 end, { 1000, 0, 0 })
---scene:step(3)
---```
---@param selection rhexis.Selection
---@param force rhexis.Vec3
function Membrane:load(selection, force) end

---Takes all its loads away.
---```lua
---local scene = rhexis.scene.create()
---scene:add_membrane { sheet = rhexis.mesh.sheet { triangles = 50 } }:clear_loads()
---```
function Membrane:clear_loads() end

---Moves fixed nodes by a way [mm]; the sheet follows in the next step.
---```lua
---local scene = rhexis.scene.create()
---local sheet = scene:add_membrane { sheet = rhexis.mesh.sheet(), fixed = function(x) return x < 1e-9 end }
---sheet:move(function(x) return x < 1e-9 end, { -0.1, 0, 0 })
---```
---@param selection rhexis.Selection
---@param way rhexis.Vec3
function Membrane:move(selection, way) end

---The force that the sheet's stretch puts on some nodes: what holds them there feels it [uN].
---```lua
---local scene = rhexis.scene.create()
---local sheet = scene:add_membrane { sheet = rhexis.mesh.sheet() }
---assert(math.abs(sheet:force(function(x) return x < 1e-9 end)[1]) < 1e-6)
---```
---@param selection rhexis.Selection
---@return rhexis.Vec3
function Membrane:force(selection) end

---Elastic energy [nJ].
---```lua
---local scene = rhexis.scene.create()
---assert(scene:add_membrane { sheet = rhexis.mesh.sheet() }:energy() < 1e-9)
---```
---@return number
function Membrane:energy() end

---Makes a slit of two edges through a place of the sheet at rest, along a direction and against it. Both its ends can
---tear on. A place outside the sheet or on its edge, and a direction that leads out of it, are errors.
---```lua
---local scene = rhexis.scene.create()
---local sheet = scene:add_membrane { sheet = rhexis.mesh.sheet() }
---sheet:puncture({ 5, 5, 0 }, { 1, 0, 0 })
---assert(#sheet:tips() == 2)
---```
---@param place rhexis.Vec3
---@param direction rhexis.Vec3
function Membrane:puncture(place, direction) end

---@class rhexis.TearTip
---@field rest rhexis.Vec3 # where it is at rest [mm]
---@field position rhexis.Vec3 # where it is now [mm]
---@field direction rhexis.Vec3 # the way the tear came, at rest, of length 1

---The ends of its tears.
---```lua
---local scene = rhexis.scene.create()
---assert(#scene:add_membrane { sheet = rhexis.mesh.sheet() }:tips() == 0)
---```
---@return rhexis.TearTip[]
function Membrane:tips() end

---@class rhexis.Torn
---@field area number # length times thickness of all tears [mm^2]
---@field energy number # that they took [nJ]

---What was torn so far.
---```lua
---local scene = rhexis.scene.create()
---assert(scene:add_membrane { sheet = rhexis.mesh.sheet() }:torn().area == 0)
---```
---@return rhexis.Torn
function Membrane:torn() end
