---@meta
-- SPDX-License-Identifier: GPL-3.0-or-later

---The eye of a patient as a scene, with instruments to operate by hand.
---@class rhexis.eye
local eye = {}

---@class rhexis.EyeOptions
---@field age? number # of the patient [years]; 20 to 95; default 68
---@field nuclear_grade? number # LOCS III nuclear opalescence; 1 to 6; default 3
---@field cortical_opacity? number # 0 (cortex as clear as the nucleus lets it be) to 1 (a white cataract); default 0
---@field pupil_mm? number # diameter [mm]; 3 to 9; default 7.5
---@field side? "right"|"left" # default "right"
---@field tetrahedra? integer # wanted size of the lens mesh; 500 to 24000; default 3000
---@field tissues? string[] # what is simulated, by names below; default lens, bag, iris, cornea
---@field instruments? string[] # names below; default {"phaco"}
---@field step? number # length of a step [s]; 0.001 to 0.02; default 0.01
---@field threads? integer # that work on a step; the result does not depend on it; 1 to 64; default 1
---@field advance? "automatic"|"explicit"|"implicit" # way to advance the lens in time; default "automatic"
---@field seed? integer # 0 to 9e15; default 1
---@field settings? table<string, number> # such as {["phaco.power_limit"] = 0.6}; default none

---An eye whose lens lies free in its capsular bag. Origin at the centre of the lens equator, +z to the microscope, the
---surgeon at -y, +x to the surgeon's right. Instruments are withdrawn until the script moves them.
---
---Tissues: "lens", "bag", "capsule" (the posterior one), "iris", "cornea", "chamber"; or, in place of lens and bag,
---"anterior_capsule" (on a lens that is a smooth body), and in place of the chamber "viscoelastic". With capsule and
---chamber "vitreous": it comes forward through a hole in the capsule, and where zonules are lost; with the lens too
---"hydrodissection": its cortex adheres, and saline parts it; without the lens "cortex" and "retained_viscoelastic",
---which are aspirated. With a bag "zonules": they can break. With cornea "globe": it rolls under the shafts in its
---wounds, and with chamber "wounds": how they are cut, leak and are closed. In place of the lens "implant": a foldable
---lens that is held by the ends of its haptics; with an injector, which pushes it out, free.
---
---On the cornea "lids" with lashes; where no fluid flows "beads", for practice with forceps.
---
---Instruments: "cannula", "capsule_hook", "cutter", "cystotome", "drape", "forceps", "hook", "hydration_cannula",
---"ia_tip", "injector", "keratome", "lens_forceps", "needle_holder", "phaco", "probe", "ring", "saline_cannula",
---"side_port_blade", "spatula", "speculum", "sponge", "triamcinolone", and as the last one "microscope", which makes
---the picture what it shows and stands where its settings leave it.
---```lua
---local eye = rhexis.eye.create { age = 72, nuclear_grade = 4, tetrahedra = 500 }
---assert(eye:step(2))
---```
---@param options? rhexis.EyeOptions
---@return rhexis.Scene
function eye.create(options) end

rhexis.eye = eye
