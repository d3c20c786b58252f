-- SPDX-License-Identifier: GPL-3.0-or-later
-- What rhexis check finds in an exercise that loads and runs: steps that are never reached, conditions that never
-- change or can never hold, errors that can never be put right; and what its reader should know besides.

local satisfy = require "engine.satisfy"
local texts = require "engine.texts"
local words = require "engine.words"

local review = {}

local Review = {}
Review.__index = Review

function Review:fault(where, text, ...) table.insert(self.faults, where .. ": " .. text:format(...)) end

-- limit_s: the longest that step.time_s can get.
function Review:bounds(limit_s)
    local all = self.exercise.time_limit_s
    return { time_s = { low = 0, high = all }, ["step.time_s"] = { low = 0, high = math.min(limit_s or all, all) } }
end

-- Looks at the texts of a condition. Returns whether it can ever hold.
function Review:condition(parts, what, limit_s)
    local possible = true
    for _, part in ipairs(parts or {}) do
        if part.tree then
            if satisfy.never_changes(part, self.known) then
                self:fault(part.where, "%s: \"%s\" never changes: it holds no measure", what, part.text)
            elseif not satisfy.can_hold(part, self.known, self:bounds(limit_s)) then
                self:fault(part.where, "%s: \"%s\" can never hold", what, part.text)
                possible = false
            end
            self:yes_no_compared(part.tree, part, what)
            self:number_as_condition(part.tree, part, what)
        end
    end
    return possible
end

local orders = { ["<"] = true, ["<="] = true, [">"] = true, [">="] = true }

-- "phaco.present > 1": a measure that is true or false has no order.
function Review:yes_no_compared(node, part, what)
    for _, inner in ipairs(node) do
        if orders[node.op] and inner.op == "name" and self.eye:is_yes_no(inner.name) then
            self:fault(part.where, "%s: %s is true or false and cannot be compared by %s", what, inner.name, node.op)
        end
        self:yes_no_compared(inner, part, what)
    end
end

local joins = { ["and"] = true, ["or"] = true, ["not"] = true }

-- "phaco.occlusion": a number holds whatever it is.
function Review:number_as_condition(node, part, what)
    if joins[node.op] then
        for _, inner in ipairs(node) do self:number_as_condition(inner, part, what) end
    elseif node.op == "name" and not self.eye:is_yes_no(node.name) then
        self:fault(part.where, "%s: %s is a number, which holds whatever it is: compare it, as in \"%s > 1\"", what,
            node.name, node.name)
    end
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
    local enters = self:condition(step.enter_when, what .. "enter_when")
    self:condition(step.picture_when, what .. "picture_when")
    local done = self:condition(step.done, what .. "done", step.time_limit_s)
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
    self:condition(event.when, what .. "when")
    self:condition(event.recovered, what .. "recovered")
    self:condition(event.harm, what .. "harm")
    self:put_right_at_once(event, what)
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
    self:condition(exercise.over, "over")
    return { faults = self.faults, notes = self:notes(), untranslated = self:untranslated() }
end

return review
