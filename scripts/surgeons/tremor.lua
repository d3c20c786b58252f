-- SPDX-License-Identifier: GPL-3.0-or-later
-- Physiological tremor: a sum of sine waves spread over 8 to 12 Hz in each direction of space, so that band and root
-- mean square are exact (8 to 12 Hz; Riviere 1997). Each wave is a rotating pair, advanced by one rotation.

local tremor = {}

local low_hz, high_hz, waves = 8, 12, 16

-- Library sines may differ in the last bit from machine to machine; after rounding they do not.
local function rounded(x) return math.floor(x * 2 ^ 40 + 0.5) / 2 ^ 40 end

local function wave(stream, amplitude, dt)
    local phase = 2 * math.pi * stream:uniform()
    local turn = 2 * math.pi * (low_hz + (high_hz - low_hz) * stream:uniform()) * dt
    return { c = amplitude * rounded(math.cos(phase)), s = amplitude * rounded(math.sin(phase)),
        turn_c = rounded(math.cos(turn)), turn_s = rounded(math.sin(turn)) }
end

local function advance(w)
    w.c, w.s = w.c * w.turn_c - w.s * w.turn_s, w.c * w.turn_s + w.s * w.turn_c
    return w.c
end

--- Returns a function that gives the displacement { x, y, z } [mm] of the next step. rms_mm: of its length; dt: [s].
function tremor.start(stream, rms_mm, dt)
    local amplitude = rms_mm * math.sqrt(2 / (3 * waves))
    local axes = { {}, {}, {} }
    for axis = 1, 3 do
        for i = 1, waves do axes[axis][i] = wave(stream, amplitude, dt) end
    end
    return function()
        local shift = { 0, 0, 0 }
        for axis = 1, 3 do
            local sum = 0
            for i = 1, waves do sum = sum + advance(axes[axis][i]) end
            shift[axis] = sum
        end
        return shift
    end
end

return tremor
