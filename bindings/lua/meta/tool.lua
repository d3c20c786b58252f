---@meta
-- SPDX-License-Identifier: GPL-3.0-or-later

---A rigid instrument of a scene, moved by the script.
---@class rhexis.Tool
local Tool = {}

---Its name.
---```lua
---assert(rhexis.scene.create():add_ball { name = "finger" }:name() == "finger")
---```
---@return string
function Tool:name() end

---@class rhexis.MoveOptions
---@field position? rhexis.Vec3 # of the tip [mm]; default where it is
---@field axis? rhexis.Vec3 # from the tip to the hand; default as it is
---@field roll? number # about the axis [degrees]; -360 to 360; default 0
---@field pedal? number # foot pedal, 0 to 3: 1 irrigates, 2 aspirates, 3 adds ultrasound; default as it is
---@field jaw? number # opening, 0 to 1; default as it is

---Where the tool is to be at the end of the next step, and what its pedal does. It gets there evenly over the step.
---```lua
---local scene = rhexis.scene.create()
---local rod = scene:add_rod { position = { 0, 0, 5 } }
---rod:move { position = { 0, 0, 4 }, axis = { 0, -1, 1 } }
---scene:step()
---assert(rod:position()[3] == 4)
---```
---@param options rhexis.MoveOptions
function Tool:move(options) end

---Shorthand for moving the tip alone.
---```lua
---local scene = rhexis.scene.create()
---local ball = scene:add_ball()
---ball:move_to { 0, 0, 0.1 }
---scene:step()
---```
---@param position rhexis.Vec3 # [mm]
function Tool:move_to(position) end

---Takes it out of the scene from the next step on; moving it brings it back.
---```lua
---local scene = rhexis.scene.create()
---local ball = scene:add_ball()
---ball:withdraw()
---scene:step()
---assert(not ball:present())
---```
function Tool:withdraw() end

---Where its tip is [mm].
---```lua
---assert(rhexis.scene.create():add_ball { position = { 1, 2, 3 } }:position()[2] == 2)
---```
---@return rhexis.Vec3
function Tool:position() end

---Direction from the tip to the hand, unit.
---```lua
---assert(rhexis.scene.create():add_rod():axis()[3] == 1)
---```
---@return rhexis.Vec3
function Tool:axis() end

---Is it in the scene?
---```lua
---assert(rhexis.scene.create():add_ball():present())
---```
---@return boolean
function Tool:present() end

---Force of the bodies on the tool, mean over the last step [uN].
---```lua
---local scene = rhexis.scene.create { gravity = { 0, 0, 0 } }
---scene:add_solid { mesh = rhexis.mesh.bar(), young_modulus = 3000, fixed = { high = { 0, 2, 2 } } }
---local ball = scene:add_ball { radius = 0.5, position = { 4, 1, 2.51 } }
---ball:move_to { 4, 1, 2.45 }
---scene:step()
---assert(ball:force()[3] > 0)
---```
---@return rhexis.Vec3
function Tool:force() end
