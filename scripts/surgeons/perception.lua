-- SPDX-License-Identifier: GPL-3.0-or-later
-- What a person makes of the picture: late by the reaction time, and with errors of place, size and brightness that
-- drift slowly, as misjudgements do. What has not been seen yet is kept here and cannot be reached from a plan.

local perception = {}

local drift_s = 2.0  -- correlation time of a misjudgement [s]; proposal
local worse_per_mm = 1.0  -- growth of errors of place with the distance out of focus, share per mm; proposal

-- A first-order random drift of unit spread.
local function drift(stream, dt)
    local keep = math.max(0, 1 - dt / drift_s)
    local fresh = math.sqrt(1 - keep * keep)
    local value = stream:normal()
    return function()
        value = keep * value + fresh * stream:normal()
        return value
    end
end

-- blur: how many times as large the error is as in a sharp picture.
local function place_error(stream, person, dt)
    local x, y, z = drift(stream, dt), drift(stream, dt), drift(stream, dt)
    return function(place, blur)
        return { place[1] + blur * person.lateral_error_mm * x(), place[2] + blur * person.lateral_error_mm * y(),
            place[3] + blur * person.depth_error_mm * z() }
    end
end

-- Sizes are misjudged in proportion to what they are. What is felt is not seen: the finger has an error of its own.
-- What is counted is told exactly.
local felt, counted = { hardness = true }, { stitches = true }

local function size_error(stream, share, dt)
    local off = drift(stream, dt)
    return function(size) return size * math.exp(share * off()) end
end

-- How high the microscope is focused is not seen, only that the picture is not sharp.
local function field_of(raw)
    if not raw then return nil end
    return { position = { raw.position[1], raw.position[2] }, radius = raw.radius,
        out_of_focus_mm = raw.out_of_focus_mm }
end

-- What comes and goes, or is there in some exercises only, has a stream of chance of its own, so that it changes
-- nothing for the rest.
local own_stream = { "^groove_%d", "^side_port$", "^capsulorhexis$", "^spatula$", "^fragment_%d", "^bridge$",
    "^capsule_folds$", "^capsule_hole$", "^iris_caught$", "^viscoelastic$", "^tear_tip$", "^flap$",
    "^wound_gape$", "^wound_fluid$", "_site$", "^stroma_white$", "^side_port_white$", "^side_port_fluid$",
    "^descemet_flap$", "^stitches$", "^hardness$", "^held$", "^rim$", "^pupil_peak$", "^iris_prolapse$",
    "^limbus$", "^vitreous", "^cutter$", "^triamcinolone$", "^haptic_%a+_middle$", "^haptic_%a+_elbow$",
    "^bag_edge$", "^zonule_gap$", "^ring$", "^capsule_hook", "^fluid_wave$", "^cortical_spoke$", "^pupil_edge$",
    "^cortex_", "^optic", "^saline_cannula$", "^ia_tip$", "^lash_%d", "^drip$", "^hand_rest$",
    "^drape$", "^speculum$", "^bead_%d", "^tray$" }

-- What lies so near to another thing that one look takes in both is misjudged as that is.
local one_look = { margin = "tear_tip" }

local function has_own_stream(name)
    for _, pattern in ipairs(own_stream) do
        if name:find(pattern) then return true end
    end
    return false
end

-- Everything in the picture shares one misjudgement of place per kind, so that errors between an instrument and what
-- lies beside it are those of one look.
local function judgement(stream, person, dt, stream_of)
    local places, sizes, bright = {}, {}, drift(stream, dt)
    local function place_of(name, place, blur)
        name = one_look[name] or name
        if not places[name] then
            local source = has_own_stream(name) and stream_of("perception of " .. name) or stream
            places[name] = place_error(source, person, dt)
        end
        return places[name](place, blur)
    end
    local function size_of(name, size)
        if size == 0 or counted[name] then return size end
        if not sizes[name] then
            local share = felt[name] and person.palpation_error or person.size_error
            sizes[name] = size_error(stream_of("size of " .. name), share, dt)
        end
        return sizes[name](size)
    end
    return function(raw)
        local factor = math.exp(person.brightness_error * bright())
        local blur = raw.field and 1 + worse_per_mm * raw.field.out_of_focus_mm or 1
        local view = { time_s = raw.time_s, pedal = raw.pedal, power = raw.power,
            vacuum_mmhg = raw.vacuum_mmhg, flow_ml_min = raw.flow_ml_min, field = field_of(raw.field), tools = {},
            landmarks = {},
            tip_brightness = raw.tip_brightness * factor, reflex_brightness = raw.reflex_brightness * factor }
        for name, tool in pairs(raw.tools) do
            view.tools[name] = { present = tool.present, position = place_of(name, tool.position, blur) }
        end
        for name, mark in pairs(raw.landmarks) do
            view.landmarks[name] = { position = place_of(name, mark.position, blur),
                size = size_of(name, mark.size) }
        end
        return view
    end
end

--- Returns a function that takes the picture of now and gives what the person sees now: the picture of reaction_s ago
--- with this person's errors, or nil before there is one. stream_of: gives the stream of another purpose.
function perception.start(stream, person, dt, stream_of)
    local judge = judgement(stream, person, dt, stream_of)
    local queue, first = {}, 1
    local seen
    return function(raw)
        queue[#queue + 1] = raw
        while queue[first] and queue[first].time_s <= raw.time_s - person.reaction_s + 1e-9 do
            seen = judge(queue[first])
            queue[first] = false
            first = first + 1
        end
        if first > 512 then
            queue = table.move(queue, first, #queue, 1, {})
            first = 1
        end
        return seen
    end
end

return perception
