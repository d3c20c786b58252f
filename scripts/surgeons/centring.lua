-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon brings the eye into the middle of the microscope's field and into focus: a part of looking. It
-- sees the picture only; whether it is focused too high or too low must be tried. Numbers are proposals.

local centring = {}

local well_centred = 0.1  -- share of the field's radius: nobody moves the microscope for less
local off_centre = 0.3    -- at which a person who operates moves it again
local beyond = 0.5        -- how far past where it gets sharp one turns the focus [mm]
local tries = 8           -- turns of the focus

-- The picture as it is now, once it is seen.
local function look(me)
    local now = me.time_s()
    me.wait_until(function(seen) return seen and seen.time_s >= now - 1e-9 end)
    return me.see()
end

-- Distance of the pupil from the middle, share of the field's radius; nothing where no pupil is seen.
local function offset(seen)
    local pupil = seen.landmarks.pupil
    if not pupil then return nil end
    local x, y = pupil.position[1] - seen.field.position[1], pupil.position[2] - seen.field.position[2]
    return math.sqrt(x * x + y * y) / seen.field.radius
end

-- Turns the focus until it is sharp: the other way as soon as it gets worse.
local function focus(me)
    local way = 1
    for _ = 1, tries do
        local before = look(me).field.out_of_focus_mm
        if before <= 0 then return end
        me.microscope.move_by({ 0, 0, way * (me.about(before) + beyond) })
        if look(me).field.out_of_focus_mm > before then way = -way end
    end
end

-- Both, where the pupil is farther off than a share of the field's radius, or not sharp.
local function bring(me, farthest)
    if not me.microscope then return end
    local seen = look(me)
    local off = offset(seen)
    if off and off > farthest then me.microscope.centre_on(seen.landmarks.pupil.position) end
    focus(me)
end

--- Before an operation: the eye into the middle, and sharp. Without a microscope nothing.
function centring.centre(me) bring(me, well_centred) end

--- In between: the same, if it has become necessary.
function centring.keep(me) bring(me, off_centre) end

return centring
