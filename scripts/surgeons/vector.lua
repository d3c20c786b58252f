-- SPDX-License-Identifier: GPL-3.0-or-later
-- Places and directions as { x, y, z } [mm], orientations as { w, x, y, z }.

local vector = {}

function vector.add(a, b) return { a[1] + b[1], a[2] + b[2], a[3] + b[3] } end

function vector.sub(a, b) return { a[1] - b[1], a[2] - b[2], a[3] - b[3] } end

function vector.scale(a, s) return { a[1] * s, a[2] * s, a[3] * s } end

function vector.dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end

function vector.norm(a) return math.sqrt(vector.dot(a, a)) end

function vector.distance(a, b) return vector.norm(vector.sub(a, b)) end

function vector.cross(a, b)
    return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end

function vector.unit(a) return vector.scale(a, 1 / vector.norm(a)) end

--- From a to b, share 0 to 1.
function vector.mix(a, b, share) return vector.add(a, vector.scale(vector.sub(b, a), share)) end

-- Quaternion of a rotation given by its columns; its trace must exceed -1 clearly, which holds for directions() below
-- unless the shaft points straight down into the eye.
local function quaternion(x, y, z)
    local trace = x[1] + y[2] + z[3]
    if trace > -0.9 then
        local s = 2 * math.sqrt(1 + trace)
        return { 0.25 * s, (y[3] - z[2]) / s, (z[1] - x[3]) / s, (x[2] - y[1]) / s }
    end
    local s = 2 * math.sqrt(1 + x[1] - y[2] - z[3])
    return { (y[3] - z[2]) / s, 0.25 * s, (y[1] + x[2]) / s, (z[1] + x[3]) / s }
end

--- Orientation of an instrument whose shaft points along `shaft` (from the tip to the hand) and whose own x axis points
--- to the surgeon's right; away from the surgeon if the shaft itself lies across.
function vector.orientation(shaft)
    local z = vector.unit(shaft)
    local across = math.abs(z[1]) < 0.999 and { 1, 0, 0 } or { 0, 1, 0 }
    local x = vector.unit(vector.sub(across, vector.scale(z, vector.dot(z, across))))
    return quaternion(x, vector.cross(z, x), z)
end

--- The same for an instrument that comes from the side: its own y axis points up as far as the shaft lets it.
function vector.upright(shaft)
    local z = vector.unit(shaft)
    local y = vector.unit(vector.sub({ 0, 0, 1 }, vector.scale(z, z[3])))
    return quaternion(vector.cross(y, z), y, z)
end

--- The same for an instrument whose end is bent down from its shaft, as kernel/tools/rhexis_tools.cpp has them: its own
--- x axis lies across, its z axis points up as far as the shaft lets it.
function vector.bent(shaft)
    local out = vector.unit(shaft)
    local x = vector.unit(vector.cross({ 0, 0, 1 }, out))
    local along = vector.scale(out, -1)
    local up = vector.cross(x, along)
    local y = vector.unit(vector.add(along, vector.scale(up, 0.1)))  -- the shaft rises by a tenth towards the hand
    return quaternion(x, y, vector.cross(x, y))
end

--- An orientation turned about its own z axis, anticlockwise as seen from where that points [degrees].
function vector.turned(q, angle)
    if angle == 0 then return q end
    local c, s = math.cos(math.rad(angle) / 2), math.sin(math.rad(angle) / 2)
    return { q[1] * c - q[4] * s, q[2] * c + q[3] * s, q[3] * c - q[2] * s, q[4] * c + q[1] * s }
end

return vector
