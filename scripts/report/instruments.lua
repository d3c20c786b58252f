-- SPDX-License-Identifier: GPL-3.0-or-later
-- What instruments are called on a page.

local t = require("report.words").t

local instruments = {}

-- As kernel/tools/instruments.cpp names them; what a reader calls them where that is another word.
local called = { cannula = "cannula", capsule_hook = "capsule hook", cutter = "cutter", cystotome = "needle",
    drape = "drape", forceps = "forceps", hook = "hook", hydration_cannula = "hydration cannula",
    ia_tip = "irrigation and aspiration tip", injector = "injector", keratome = "keratome",
    lens_forceps = "lens forceps", needle_holder = "needle holder", phaco = "phaco", probe = "probe", ring = "ring",
    saline_cannula = "saline cannula", side_port_blade = "side port blade", spatula = "second instrument",
    speculum = "speculum", sponge = "sponge", triamcinolone = "triamcinolone" }

local outside = { drape = true, speculum = true }

function instruments.known(name) return called[name] ~= nil end

--- Whether an instrument ever works inside of the eye.
function instruments.inside(name) return called[name] ~= nil and not outside[name] end

function instruments.name(name) return called[name] and t(called[name]) or (name:gsub("_", " ")) end

return instruments
