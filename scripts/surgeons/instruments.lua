-- SPDX-License-Identifier: GPL-3.0-or-later
-- How hands hold each instrument: the wound that its shaft goes through, by the name of its landmark, and how it is
-- turned about its shaft.

local vector = require "surgeons.vector"

local instruments = {}

local straight = { wound = "incision", orientation = vector.orientation, bend_mm = 0 }
-- Their shaft begins over their end.
local function bent(length, wound)
    return { wound = wound or "incision", orientation = vector.bent, bend_mm = length }
end

local held = {
    spatula = { wound = "side_port", orientation = vector.upright, bend_mm = 0 },
    cystotome = bent(1.0),
    forceps = bent(1.0),
    lens_forceps = bent(1.0),
    cannula = bent(0.6),
    saline_cannula = bent(0.6),
    triamcinolone = bent(0.6, "side_port"),
    hook = bent(0.5, "side_port"),
    -- They work from outside: about where a wound is, or is to be.
    keratome = { wound = "incision_site", orientation = vector.orientation, bend_mm = 0 },
    side_port_blade = { wound = "side_port_site", orientation = vector.orientation, bend_mm = 0 },
    hydration_cannula = { wound = "incision_site", orientation = vector.orientation, bend_mm = 0 },
    needle_holder = { wound = "incision_site", orientation = vector.orientation, bend_mm = 0 },
    sponge = { wound = "incision_site", orientation = vector.orientation, bend_mm = 0 },
    capsule_hook = bent(0.5, "side_port"),
    ring = bent(0.5),
    drape = bent(1.0, "hand_rest"),
    speculum = bent(1.0, "hand_rest"),
}

--- name: of an instrument of the scene.
function instruments.held(name) return held[name] or straight end

local out_mm = 0.5       -- from the wound, inwards: so near to it the shaft points as it did on the way in
local turned_mm = 1.5    -- beyond that it turns, until it goes through the wound

--- The way through a wound, outwards, as the tunnel through the cornea runs.
function instruments.way_out(wound)
    return vector.unit({ wound[1], wound[2], 0.5 * math.sqrt(wound[1] * wound[1] + wound[2] * wound[2]) })
end

--- Where a tip is taken up and put down: outside a wound.
function instruments.outside(wound)
    local across = math.sqrt(wound[1] ^ 2 + wound[2] ^ 2)
    return { wound[1] * (1 + 2 / across), wound[2] * (1 + 2 / across), wound[3] + 1.0 }
end

--- Direction of the shaft of an instrument with its tip at a place: through the wound; while the tip is outside or
--- close to the wound, as on the way in.
function instruments.shaft(hold, wound, tip)
    local entry = instruments.way_out(wound)
    local back = vector.sub(wound, { tip[1], tip[2], tip[3] + hold.bend_mm })
    local turned = math.max(0, math.min(1, (vector.dot(vector.sub(wound, tip), entry) - out_mm) / turned_mm))
    if turned == 0 then return entry end
    return vector.unit(vector.mix(entry, vector.unit(back), turned))
end

--- Orientation of an instrument with its tip at a place, rolled between the fingers: degrees from how hands hold it.
--- wound: where its shaft goes through; nil: there is none.
function instruments.orientation(hold, wound, tip, turned)
    local shaft = wound and instruments.shaft(hold, wound, tip) or vector.unit({ 0, -1, 0.5 })
    return vector.turned(hold.orientation(shaft), turned)
end

return instruments
