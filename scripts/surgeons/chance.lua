-- SPDX-License-Identifier: GPL-3.0-or-later
-- Streams of chance for virtual surgeons, one per purpose, so that a plan that draws numbers changes nothing else.
-- SplitMix64 (Steele, Lea & Flood 2014); integers of Lua wrap at 64 bits.

local chance = {}

local Stream = {}
Stream.__index = Stream

-- FNV-1a of a text.
local function hash_of(text)
    local hash = -3750763034362895579
    for i = 1, #text do hash = (hash ~ text:byte(i)) * 1099511628211 end
    return hash
end

--- seed: an integer; purpose: a text.
function chance.stream(seed, purpose) return setmetatable({ state = seed ~ hash_of(purpose) }, Stream) end

function Stream:next()
    self.state = self.state + 0x9E3779B97F4A7C15
    local z = self.state
    z = (z ~ (z >> 30)) * 0xBF58476D1CE4E5B9
    z = (z ~ (z >> 27)) * 0x94D049BB133111EB
    return z ~ (z >> 31)
end

--- In [0, 1).
function Stream:uniform() return (self:next() >> 11) * (1.0 / (1 << 53)) end

--- In [low, high).
function Stream:between(low, high) return low + (high - low) * self:uniform() end

--- Standard normal deviate, polar method.
function Stream:normal()
    if self.spare then
        local value = self.spare
        self.spare = nil
        return value
    end
    local x, y, square
    repeat
        x, y = 2 * self:uniform() - 1, 2 * self:uniform() - 1
        square = x * x + y * y
    until square > 0 and square < 1
    local scale = math.sqrt(-2 * math.log(square) / square)
    self.spare = y * scale
    return x * scale
end

return chance
