-- SPDX-License-Identifier: GPL-3.0-or-later
-- Heart rate, blood pressure and saturation of the patient, as the theatre's monitor shows them: scripted values that
-- reactions move (theatre/vitals.lua, and the exercise's own). Nothing is judged by them.

local condition = require "engine.condition"
local fields = require "engine.fields"
local standard = require "theatre.vitals"
local words = require "engine.words"

local vitals = {}

local constants = { "heart_per_min", "systolic_mmhg", "diastolic_mmhg", "saturation_percent" }

-- Fields of the exercise's word `vitals`, and of each of its reactions.
local rules = {
    heart_per_min = { kind = "number", from = 20, to = 220 },
    systolic_mmhg = { kind = "number", from = 50, to = 260 },
    diastolic_mmhg = { kind = "number", from = 20, to = 160 },
    saturation_percent = { kind = "number", from = 50, to = 100 },
    reactions = { kind = "table", default = {} },
}
local reaction_rules = {
    when = { kind = "condition", required = true },
    after_s = { kind = "number", default = 3, from = 0.1, to = 120 },
    heart_per_min = { kind = "number", default = 0, from = -150, to = 150 },
    systolic_mmhg = { kind = "number", default = 0, from = -150, to = 150 },
    diastolic_mmhg = { kind = "number", default = 0, from = -100, to = 100 },
    saturation_percent = { kind = "number", default = 0, from = -50, to = 50 },
}

--- Checks what an exercise gives, and returns it.
function vitals.read(given)
    local own = fields.read(given, rules, "vitals")
    for i, reaction in ipairs(own.reactions) do
        own.reactions[i] = fields.read(reaction, reaction_rules, ("vitals: reaction %d"):format(i))
    end
    return own
end

local Vitals = {}
Vitals.__index = Vitals

local function add(self, reaction, parts, what)
    for _, part in ipairs(parts) do
        for _, name in ipairs(part.names or {}) do
            if not self.eye:resolve(name) then return end  -- the scene has not what it reacts to
        end
    end
    table.insert(self.reactions, { of = reaction, test = condition.bind(parts, self.eye, what), share = 0 })
end

--- own: the exercise's field, checked, or nil.
function vitals.new(own, eye)
    local self = setmetatable({ eye = eye, own = own or {}, reactions = {}, beat = 0 }, Vitals)
    for _, reaction in ipairs(standard.reactions) do
        add(self, reaction, condition.read(reaction.when, "theatre/vitals.lua", "when"), "in 'vitals'")
    end
    for _, reaction in ipairs(self.own.reactions or {}) do
        words.try(add, self, reaction, reaction.when, "in 'vitals'")
    end
    return self
end

--- One step of time.
function Vitals:tick(time_s)
    local dt = time_s - (self.time_s or time_s)
    self.time_s = time_s
    for _, one in ipairs(self.reactions) do
        local towards = one.test.test() and 1 or 0
        one.test.reset()
        one.share = one.share + (towards - one.share) * (1 - math.exp(-dt / (one.of.after_s or 3)))
    end
    self.beat = (self.beat + dt * self:value("heart_per_min") / 60) % 1
end

--- A constant as it is now.
function Vitals:value(name)
    local value = self.own[name] or standard[name]
    for _, one in ipairs(self.reactions) do value = value + one.share * (one.of[name] or 0) end
    local rule = rules[name]
    return math.max(rule.from, math.min(rule.to, value))
end

--- All of them, and how far the heart is through its beat, 0 to 1.
function Vitals:now()
    local now = { beat = self.beat }
    for _, name in ipairs(constants) do now[name] = self:value(name) end
    return now
end

return vitals
