---@meta
-- SPDX-License-Identifier: GPL-3.0-or-later

---The kernel, in scripts run by `rhexis lua FILE`. It is a global; `require "rhexis"` gives the same table.
---
---Units are the kernel's own everywhere: mm, g, s, so forces are uN, stresses Pa, energies nJ. Places are `{x, y, z}`.
---Nodes, elements and objects are numbered from 1. Options are tables of named fields: every field has a default, and a
---misspelt or impossible one is an error that says what is allowed.
---@class rhexis
---@field mesh rhexis.mesh # tetrahedral meshes to build, read, measure and write
---@field scene rhexis.scene # bodies and tools that a script puts together, steps and looks into
---@field render rhexis.render # pictures and videos of scenes
---@field eye rhexis.eye # the eye of a patient as a scene
rhexis = {}

---A place or a direction: three numbers.
---@alias rhexis.Vec3 number[]

---Which nodes or elements are meant: a function of the place that returns true for them; a box, its border included
---(a corner left out does not bound); or a list of numbers.
---@alias rhexis.Selection fun(x: number, y: number, z: number): boolean | rhexis.Box | integer[]

---@class rhexis.Box
---@field low? rhexis.Vec3 # smallest x, y, z [mm]
---@field high? rhexis.Vec3 # largest x, y, z [mm]
