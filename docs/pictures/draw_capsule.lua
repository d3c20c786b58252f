-- SPDX-License-Identifier: GPL-3.0-or-later
-- A capsulorhexis under way, by the mechanics: a needle pierces the anterior capsule and drags a flap open; and the same
-- with the capsule stained.
--   rhexis lua docs/pictures/draw_capsule.lua [FOLDER]
local folder = arg[1] or "docs/pictures"
local size = { width = 360, height = 270 }

local function open_eye(stain)
    return rhexis.eye.create { tissues = { "anterior_capsule", "viscoelastic", "iris", "cornea" },
        instruments = { "cystotome", "forceps" }, settings = { ["capsule.trypan_blue"] = stain } }
end

-- Evenly through places [mm] at a speed [mm/s].
local function lead(eye, tool, places, speed, jaw)
    for _, place in ipairs(places) do
        local from = tool:present() and tool:position() or { place[1], place[2], place[3] }
        local way = math.sqrt((place[1] - from[1]) ^ 2 + (place[2] - from[2]) ^ 2 + (place[3] - from[3]) ^ 2)
        local steps = math.max(1, math.ceil(way / speed / 0.01))
        for i = 1, steps do
            local at = {}
            for k = 1, 3 do at[k] = from[k] + (place[k] - from[k]) * i / steps end
            tool:move { position = at, axis = { 0, 0, 1 }, jaw = jaw }
            assert(eye:step())
        end
    end
end

-- Of the capsule's front, at 68 years [mm].
local function front(x, y, above)
    return { x, y, 1.88 * math.sqrt(1 - (x * x + y * y) / 4.82 ^ 2) + above }
end

local function arc(radius, from, to, above)
    local places = {}
    for i = 0, 12 do
        local angle = math.rad(from + (to - from) * i / 12)
        places[#places + 1] = front(radius * math.cos(angle), radius * math.sin(angle), above)
    end
    return places
end

for name, stain in pairs { capsule_flap = 0, capsule_blue = 1 } do
    local eye = open_eye(stain)
    local needle = eye:tool("cystotome")
    lead(eye, needle, { front(0.6, 0.2, 0.4), front(0.6, 0.2, -0.35) }, 1.5)
    lead(eye, needle, { front(2.0, 0.2, -0.35) }, 1.5)
    lead(eye, needle, arc(1.9, 6, 100, -0.2), 1.5)
    rhexis.render.draw(eye, size):write_png(folder .. "/" .. name .. ".png")
    print(name)
end
