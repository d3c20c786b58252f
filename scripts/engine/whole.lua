-- SPDX-License-Identifier: GPL-3.0-or-later
-- The operation that an exercise is a part of, as far as it has come: steps, errors and scores of all parts so far, on
-- the operation's clock, and what the next part needs.

local scoring = require "scoring"
local words = require "engine.words"

local Whole = {}
Whole.__index = Whole

-- An item is watched in the parts whose exercises score it; of others, its measures would tell something else.
local function items_of(scoring_of_part)
    local items = {}
    for _, id in ipairs(scoring_of_part and scoring_of_part.items or {}) do items[id] = true end
    return items
end

--- given: { part, parts, scoring, reference, before } of operation.join; own: scoring of the part; eye: of the part.
function Whole.new(given, own, eye, dt)
    local before = given.before
    local self = setmetatable({ part = given.part, parts = given.parts, before = before, eye = eye,
        since_s = before.time_s or 0 }, Whole)
    if given.scoring then
        local score = { time_s = self.since_s, measures = before.score or {} }
        self.sheet = scoring.sheet(given.scoring, eye, given.reference, dt, score, items_of(own))
    end
    return self
end

function Whole:tick(time_s)
    if self.sheet then self.sheet:tick(time_s) end
end

-- A record of the part, on the operation's clock.
local function shifted(self, record)
    local copy = {}
    for key, value in pairs(record) do copy[key] = value end
    copy.part = self.part.id
    for _, key in ipairs({ "time_s", "start_s", "end_s" }) do
        if copy[key] then copy[key] = copy[key] + self.since_s end
    end
    return copy
end

local function all_of(self, name, own)
    local list = {}
    for i, record in ipairs(self.before[name] or {}) do list[i] = record end
    for _, record in ipairs(own) do list[#list + 1] = shifted(self, record) end
    return list
end

-- The last value of every measure that was ever defined.
local function facts_of(self)
    local facts = words.as_object({})
    for key, value in pairs(self.before.facts or {}) do facts[key] = value end
    for _, name in ipairs(self.eye.names) do
        local value = self.eye:value(name)
        if value ~= nil then facts[name] = value end
    end
    return facts
end

-- Ids of the parts that have begun.
local function begun(self)
    local ids = {}
    for i, id in ipairs(self.before.parts or {}) do ids[i] = id end
    ids[#ids + 1] = self.part.id
    return ids
end

-- Titles of the parts that have not, in case that the operation goes no further; nil: all have.
local function not_begun(self, ids)
    local titles = {}
    for _, part in ipairs(self.parts or {}) do
        if not words.has(ids, part.id) then titles[#titles + 1] = part.title end
    end
    return #titles > 0 and titles or nil
end

--- The operation so far, and in `carried` what the next part begins with. part: the result of the part itself. how: of
--- Sheet:score.
function Whole:result(part, time_s, how)
    local result = { steps = all_of(self, "steps", part.steps), events = all_of(self, "events", part.events) }
    result.completed = part.completed and self.before.completed ~= false
    if self.sheet then
        result.osacss = self.sheet:score(result.events, result.completed, how)
        result.measures = self.sheet:measures()
        result.advice = scoring.advice(result.osacss, result.events)
    end
    local ids = begun(self)
    result.not_begun = not_begun(self, ids)
    result.carried = { parts = ids, time_s = self.since_s + time_s, facts = facts_of(self), steps = result.steps,
        events = result.events, completed = result.completed,
        score = self.sheet and self.sheet:carried(time_s).measures }
    return result
end

return Whole
