---@meta
-- SPDX-License-Identifier: GPL-3.0-or-later

---Tetrahedral meshes and triangle sheets to build, read, measure and write.
---@class rhexis.mesh
local mesh = {}

---@class rhexis.BarOptions
---@field cells? rhexis.Vec3 # cubes along x, y and z; each 1 to 200, 200000 in all; default {8, 2, 2}
---@field cell? number # edge of a cube [mm]; 0.001 to 1000; default 1
---@field origin? rhexis.Vec3 # the corner with the smallest coordinates [mm]; default {0, 0, 0}

---A block of cubes, each cut into 5 tetrahedra, mirrored from cube to cube so that their diagonals meet.
---```lua
---local bar = rhexis.mesh.bar { cells = { 8, 2, 2 }, cell = 0.5 }
---assert(bar:info().tetrahedra == 8 * 2 * 2 * 5)
---```
---@param options? rhexis.BarOptions
---@return rhexis.Mesh
function mesh.bar(options) end

---@class rhexis.BallOptions
---@field radius? number # [mm]; 0.001 to 1000; default 2
---@field tetrahedra? integer # wanted number of elements, met within about 3 %; 300 to 100000; default 1000

---A ball about the origin.
---```lua
---local ball = rhexis.mesh.ball { radius = 2, tetrahedra = 500 }
---assert(math.abs(ball:info().volume / (4 / 3 * math.pi * 8) - 1) < 0.1)
---```
---@param options? rhexis.BallOptions
---@return rhexis.Mesh
function mesh.ball(options) end

---@class rhexis.LensOptions
---@field age? number # of the patient, from which the three sizes follow [years]; 20 to 95; default 68
---@field radius? number # of the equator [mm]; 1 to 10; default from age
---@field anterior? number # equatorial plane to anterior pole (+z) [mm]; 0.3 to 10; default from age
---@field posterior? number # equatorial plane to posterior pole (-z) [mm]; 0.3 to 10; default from age
---@field tetrahedra? integer # wanted number of elements, met within about 3 %; 300 to 100000; default 3000

---A lens: two half-ellipsoids that share the equator, which lies in the plane z = 0.
---```lua
---local lens = rhexis.mesh.lens { age = 75, tetrahedra = 1000 }
---print(("%.0f mm^3"):format(lens:info().volume))
---```
---@param options? rhexis.LensOptions
---@return rhexis.Mesh
function mesh.lens(options) end

---Reads a tetrahedral mesh by the ending of its name: `.vtk` (legacy form, ASCII or BINARY, unstructured grid) or
---`.msh` (Gmsh 1, 2, 4.0 and 4.1, text or binary). Lengths are taken as mm. Nodes of no element are left out, which a
---line on stderr tells. A broken file or an inverted element is an error with its line and its number in the file.
---```lua
---local path = os.tmpname() .. ".vtk"
---rhexis.mesh.bar():write(path)
---assert(rhexis.mesh.read(path):info().nodes == rhexis.mesh.bar():info().nodes)
---os.remove(path)
---```
---@param path string
---@return rhexis.Mesh
function mesh.read(path) end

---@class rhexis.SheetOptions
---@field shape? "square"|"round" # a square with a corner at the origin, or a disc about it; default "square"
---@field size? number # side or diameter [mm]; 0.001 to 1000; default 10
---@field triangles? integer # wanted number of them, met within a row; 8 to 100000; default 1500
---@field jitter? number # moves inner nodes at random by up to this share of an edge; 0 to 0.3; default 0
---@field seed? integer # chooses that movement; 0 to 1000000000; default 1

---A flat sheet of triangles in the plane z = 0, its front towards +z.
---```lua
---local sheet = rhexis.mesh.sheet { size = 4, triangles = 200 }
---assert(math.abs(sheet:info().area - 16) < 1e-9)
---```
---@param options? rhexis.SheetOptions
---@return rhexis.Sheet
function mesh.sheet(options) end

---Reads the triangles of a mesh file, as mesh.read reads its tetrahedra. A sheet that is not sound (an edge with three
---triangles, a flipped triangle, parts that only touch) is an error with the number of what is wrong.
---```lua
---local ok, message = pcall(rhexis.mesh.read_sheet, "nowhere.vtk")
---assert(not ok and message:find("nowhere.vtk"))
---```
---@param path string
---@return rhexis.Sheet
function mesh.read_sheet(path) end

---A triangle mesh at rest.
---@class rhexis.Sheet
local Sheet = {}

---@class rhexis.SheetInfo
---@field nodes integer # number of nodes
---@field triangles integer # number of triangles
---@field area number # [mm^2]
---@field mean_edge number # mean length of their edges [mm]
---@field smallest_angle number # [degrees]

---Size and quality.
---```lua
---assert(rhexis.mesh.sheet():info().smallest_angle > 25)
---```
---@return rhexis.SheetInfo
function Sheet:info() end

---Where a node is at rest [mm].
---```lua
---assert(rhexis.mesh.sheet():node(1)[1] == 0)
---```
---@param number integer # 1 to the number of nodes
---@return rhexis.Vec3
function Sheet:node(number) end

---Numbers of the nodes that a selection means, ascending.
---```lua
---assert(#rhexis.mesh.sheet():select(function(x) return x == 0 end) > 10)
---```
---@param selection rhexis.Selection
---@return integer[]
function Sheet:select(selection) end

---Frees it now.
---```lua
---rhexis.mesh.sheet():close()
---```
function Sheet:close() end

---A tetrahedral mesh at rest.
---@class rhexis.Mesh
local Mesh = {}

---Writes the mesh by the ending of the name: `.vtk` or `.msh`. Coordinates survive exactly.
---```lua
---local path = os.tmpname() .. ".msh"
---rhexis.mesh.ball { tetrahedra = 300 }:write(path)
---os.remove(path)
---```
---@param path string
function Mesh:write(path) end

---@class rhexis.MeshInfo
---@field nodes integer # number of nodes
---@field tetrahedra integer # number of elements
---@field volume number # [mm^3]
---@field min_ratio number # worst shape: 3 x inscribed / circumscribed radius, 1 for a regular tetrahedron
---@field mean_ratio number # mean shape
---@field min_height number # shortest height of an element [mm]; the explicit step limit is proportional to it
---@field worst integer # number of the element with min_ratio

---Counts, volume and quality.
---```lua
---local info = rhexis.mesh.bar():info()
---assert(info.tetrahedra == 160 and math.abs(info.volume - 32) < 1e-12)
---```
---@return rhexis.MeshInfo
function Mesh:info() end

---The place of a node [mm].
---```lua
---local p = rhexis.mesh.bar():node(1)
---assert(p[1] == 0 and p[2] == 0 and p[3] == 0)
---```
---@param number integer # 1 to the number of nodes
---@return rhexis.Vec3
function Mesh:node(number) end

---The four node numbers of an element.
---```lua
---assert(#rhexis.mesh.bar():tetrahedron(1) == 4)
---```
---@param number integer # 1 to the number of elements
---@return integer[]
function Mesh:tetrahedron(number) end

---Numbers of the nodes that a selection means, ascending.
---```lua
---local bar = rhexis.mesh.bar()
---assert(#bar:select(function(x) return x == 0 end) == 9)
---assert(#bar:select { high = { 0, 2, 2 } } == 9)
---```
---@param selection rhexis.Selection
---@return integer[]
function Mesh:select(selection) end

---Frees the mesh now instead of when the script has lost it. Solids made from it keep their own copy.
---```lua
---local bar = rhexis.mesh.bar()
---bar:close()
---assert(not pcall(bar.info, bar))
---```
function Mesh:close() end

rhexis.mesh = mesh
