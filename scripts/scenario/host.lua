-- SPDX-License-Identifier: GPL-3.0-or-later
-- What bindings/lua/scenario_script.cpp calls: the border between the kernel and a file of scenarios or starts.

local Test = require "scenario.test"
local globals = require "engine.globals"
local language = require "scenario.language"
local words = require "engine.words"

local host = {}

--- The words that such a file finds besides the standard ones.
function host.environment()
    globals.refuse_unknown()
    return globals.of({ scenarios = language.scenarios, scenario = language.scenario, starts = language.starts })
end

host.begin_file = words.begin_file

--- Runs the file. kind: what it must return.
function host.read(kind, file)
    words.read(file, function(value)
        if type(value) ~= "table" or value.kind ~= kind then
            words.fail(words.where(nil, 1), ("the file must end with: return %s { ... }"):format(kind))
        end
        host.declared = value
    end)
end

--- What the file declares, without its functions.
function host.listing()
    local list = {}
    if host.declared.kind == "starts" then
        for name, start in pairs(host.declared.starts) do
            list[name] = { surgeon = start.surgeon, seed = start.seed, set = start.set, when = start.when,
                limit_s = start.limit_s, opening = start.opening,
                where = start.where, by_hand = start.play ~= nil }
        end
        return words.as_object(list)
    end
    for i, scenario in ipairs(host.declared.list) do
        list[i] = { name = scenario.name, line = scenario.line, seed = scenario.seed, set = scenario.set,
            start = scenario.start, silent_twin_of = scenario.silent_twin_of }
    end
    return { exercise = host.declared.exercise, list = list }
end

-- A start that is made by hand, as a scenario without expectations.
local function hand_of(name)
    local start = host.declared.starts[name]
    return { play = start.play, line = start.line, time_limit_s = start.limit_s, silent_twin_of = {} }
end

--- Begins scenario number `setup.number`, or the hand of start `setup.start`. Returns the row that step reads: the host
--- overwrites it.
function host.start(setup)
    host.test = Test.new(setup, setup.start and hand_of(setup.start) or host.declared.list[setup.number])
    host.test:begin()
    host.row = {}
    return host.row
end

function host.step(time_s, events)
    return host.test:step(time_s, host.row, events)
end

function host.judged(result) host.test:judged(result) end

function host.refused(why) host.test:refused(why) end

function host.outcome()
    return { at = host.test.at, failures = host.test.failures, covered = words.as_object(host.test.covered) }
end

return host
