-- SPDX-License-Identifier: GPL-3.0-or-later
-- What is known of a measure whatever happens, from its name, unit and meaning: that it never falls, that it is never
-- negative, and what a scene must hold for it to be there.

local words = require "engine.words"

local measures = {}

-- "The lowest it has been so far" falls; a mean goes either way; "0: none so far" is a list of states.
local falling = { "[Ll]east", "[Ll]owest", "RMS", "^%d" }

--- Whether it never falls, as counts and sums do. info: { unit, meaning, bool }.
function measures.grows(name, info)
    local meaning = info.meaning or ""
    if name:find("^wounds%.main_") then return false end  -- another wound may take its place
    if info.bool or not (meaning:find("so far", 1, true) or meaning:find("^Times ")) then return false end
    for _, pattern in ipairs(falling) do
        if meaning:find(pattern) then return false end
    end
    return true
end

--- Whether it is never less than 0: times, counts, and what only grows, which begins at 0.
function measures.never_negative(name, info)
    if info.bool then return false end
    return info.unit == "s" or name:find("%.count$") ~= nil or (info.meaning or ""):find("^How many ") ~= nil
        or measures.grows(name, info)
end

-- Groups and measures that are not called as the tissue is that they come with.
local groups = { groove = "lens", grooves = "lens", groove_1 = "lens", groove_2 = "lens", reflex = "lens",
    fragments = "lens", crack = "lens", rhexis = "anterior_capsule", hydro = "hydrodissection", panel = "chamber",
    wound = "chamber", tamponade = "vitreous", suprachoroidal = "wounds" }
local of_instruments = { tip_depth_mm = "lens", inside_lens = "lens", in_contact = "lens", force_mN = "lens",
    tip_posterior_mm = "bag", capsule_gap_mm = "bag", capsule_touch = "bag", capsule_touches = "bag",
    endothelium_mm = "cornea", occlusion = "chamber", occluded_by_lens = "chamber", suction_mmhg = "chamber",
    hold_mN = "chamber" }

local function has_group(group, known)
    for _, name in ipairs(known) do
        if name:sub(1, #group + 1) == group .. "." then return true end
    end
    return false
end

--- Why a measure is not there, in brackets, if that can be told from its name; or nil. known: those that are there.
function measures.missing(name, known)
    local group, field = name:match("^([%w_]+)%.([%w_]+)$")
    if not group then return nil end
    local there = has_group(group, known)
    if not there and words.has(words.parts, group) then
        return (" (the exercise does not name '%s' among its tissues and instruments)"):format(group)
    end
    local tissue = not there and groups[group] or there and words.has(words.parts, group) and of_instruments[field]
    return tissue and (" (the tissue '%s' brings it, and the exercise does not name that)"):format(tissue) or nil
end

return measures
