-- SPDX-License-Identifier: GPL-3.0-or-later
-- What rhexis check finds in an exercise that loads and runs: steps that are never reached, conditions that never
-- change or can never hold, errors that can never be put right; and what its reader should know besides.

local measures = require "engine.measures"
local satisfy = require "engine.satisfy"
local texts = require "engine.texts"
local words = require "engine.words"

local review = {}

local Review = {}
Review.__index = Review

-- One line, whatever the texts hold.
function Review:fault(where, text, ...)
    table.insert(self.faults, where .. ": " .. text:format(...):gsub("%s+", " "))
end

-- What measures can be. limit_s: the longest that step.time_s can get.
function Review:bounds(limit_s)
    local all = self.exercise.time_limit_s
    local clocks = { time_s = { low = 0, high = all },
        ["step.time_s"] = { low = 0, high = math.min(limit_s or all, all) } }
    return function(name)
        if clocks[name] then return clocks[name] end
        local info = self.eye.info[name]
        return info and measures.never_negative(name, info) and { low = 0, high = math.huge } or nil
    end
end

-- What never falls: while one step runs, its clock too.
local function growing(eye, in_step)
    return function(name)
        local info = eye.info[name]
        return name == "time_s" or (in_step and name == "step.time_s") or (info ~= nil and measures.grows(name, info))
    end
end

-- Says what is wrong with one text, in brief; nil: nothing. alone: bounds without what came before it.
function Review:impossible(part, bounds, alone, after)
    if satisfy.never_changes(part, self.known) then return "never changes: it holds no measure", true end
    if not satisfy.can_hold(part, self.known, alone) then return "can never hold" end
    if not satisfy.can_hold(part, self.known, bounds) then
        return ("can never hold once %s has held: what it needs to be lower never falls"):format(after)
    end
    if satisfy.always_holds(part, self.known, alone) then return "always holds, from the first moment on", true end
    return nil
end

-- Looks at the texts of a condition, which must come true one after the other. way: { limit_s, in_step, bounds, after =
-- what has held before }. Returns whether it can ever hold, and the bounds from then on.
function Review:condition(parts, what, way)
    local alone, grows = self:bounds(way.limit_s), growing(self.eye, way.in_step)
    local bounds, after, possible = way.bounds or alone, way.after, true
    for _, part in ipairs(parts or {}) do
        if part.tree then
            local complaint, holds = self:impossible(part, bounds, alone, after)
            if complaint then self:fault(part.where, "%s: \"%s\" %s", what, part.text, complaint) end
            possible = possible and (not complaint or holds == true)
            bounds = satisfy.after(part, self.known, bounds, grows)
            after = way.after or after and "what stands before it" or ("\"%s\""):format(part.text)
        end
    end
    return possible, bounds
end

-- "recovered" that holds whenever "when" does: such an error is put right as it happens.
function Review:put_right_at_once(event, what)
    local when, recovered = event.when, event.recovered
    if not recovered or #when > 1 or #recovered > 1 or not when[1].tree or not recovered[1].tree then return end
    local left = { tree = { op = "and", when[1].tree, { op = "not", recovered[1].tree } } }
    if satisfy.can_hold(when[1], self.known, self:bounds())
        and not satisfy.can_hold(left, self.known, self:bounds()) then
        self:fault(recovered[1].where, "%srecovered: \"%s\" holds whenever 'when' does: it would be put right as it "
            .. "happens", what, recovered[1].text)
    end
end

-- Whether a step can end by itself, and whether its time limit can end it.
function Review:step(step)
    local what = ("step '%s': "):format(step.name)
    local enters = self:condition(step.enter_when, what .. "enter_when", {})
    local running = { limit_s = step.time_limit_s, in_step = true }
    self:condition(step.picture_when, what .. "picture_when", running)
    local done = self:condition(step.done, what .. "done", running)
    return { enters = enters, done = done and enters,
        late = (enters and step.time_limit_s ~= nil) or step.enter_limit_s ~= nil }
end

function Review:steps()
    local steps, reached = self.exercise.steps, { [1] = true }
    local blocked
    for i, step in ipairs(steps) do
        local way = self:step(step)
        if reached[i] then
            if way.done then reached[step.next_at or i + 1] = true end
            if way.late then reached[step.next_late_at or step.next_at or i + 1] = true end
            if not way.done and not way.late then blocked = step end
        elseif blocked then
            self:fault(step.where, "step '%s' is never reached: step '%s' before it never ends", step.name,
                blocked.name)
        else
            self:fault(step.where, "step '%s' is never reached: the steps before it lead past it", step.name)
        end
    end
end

function Review:event(event)
    local what = ("error_event '%s': "):format(event.name)
    local before = #self.faults
    local _, since = self:condition(event.when, what .. "when", {})
    self:condition(event.recovered, what .. "recovered", { bounds = since, after = "'when'" })
    self:condition(event.harm, what .. "harm", {})
    if #self.faults == before then self:put_right_at_once(event, what) end
    if event.recovered and event.deadline_s < self.exercise.step_s then
        self:fault(event.where, "%srecovery can never hold: deadline_s = %g leaves no time for it", what,
            event.deadline_s)
    end
end

function Review:untranslated()
    local lines = {}
    for _, language in ipairs(texts.own_languages(self.exercise)) do
        texts.each(self.exercise, function(owner, key)
            local text = owner[key]
            if text and not texts.has(language, self.exercise, text) then
                lines[#lines + 1] = ("no text in %s: \"%s\""):format(language, text)
            end
        end)
    end
    return lines
end

function Review:notes()
    local lines = {}
    for _, objective in ipairs(self.exercise.objectives) do lines[#lines + 1] = "objective: " .. objective end
    for _, name in ipairs(words.keys(self.exercise.levels)) do
        local meaning = self.exercise.levels[name].meaning
        lines[#lines + 1] = "level " .. name .. (meaning and ": " .. meaning or "")
    end
    for _, request in ipairs(self.exercise.requests) do
        lines[#lines + 1] = "request " .. request.title .. (request.meaning and ": " .. request.meaning or "")
    end
    return lines
end

--- exercise: as loaded; eye: of its scene. Returns { faults, notes, untranslated }, lists of lines.
function review.of(exercise, eye)
    local self = setmetatable({ exercise = exercise, eye = eye, faults = {} }, Review)
    function self.known(name)
        local goal = name:match("^goal%.(.+)$")
        return goal and exercise.goals[goal] or nil
    end
    self:steps()
    for _, event in ipairs(exercise.errors) do self:event(event) end
    self:condition(exercise.over, "over", {})
    return { faults = self.faults, notes = self:notes(), untranslated = self:untranslated() }
end

return review
