-- SPDX-License-Identifier: GPL-3.0-or-later
-- What a scenario makes of the score at its end.
local Test = require "scenario.test"
local support = require "support"

local case, equal = support.case, support.equal

local caps = { critical = { not_recovered = 1, open = 1, recovered = 3, near_miss = 4 }, minor = { recovered = 4 } }

local function failures_of(event, score)
    local test = setmetatable({ failures = {}, eye = { time_s = 2 }, at = "iris.lua:7" }, Test)
    event.id, event.title, event.items = "iris_touched", "Iris touched", { "G5" }
    test:judged({ events = { event },
        osacss = { caps = caps, items = { { id = "G4", score = 5 }, { id = "G5", score = score } } } })
    return test.failures
end

case("more points than an error leaves fail a scenario", function()
    local failures = failures_of({ severity = "critical", outcome = "recovered" }, 3.2)
    equal(#failures, 1)
    equal(failures[1].where, "iris.lua:7")
    equal(failures[1].message,
        'expected at most 3 points in G5 after error event "Iris touched", recovered, seen: 3.2')
    equal(#failures_of({ severity = "critical", outcome = "not_recovered" }, 1.1), 1)
    equal(#failures_of({ severity = "critical", outcome = "near_miss" }, 4.1), 1)
end)

case("no more than that, no score, and an error that is not limited do not", function()
    equal(#failures_of({ severity = "critical", outcome = "recovered" }, 3), 0)
    equal(#failures_of({ severity = "critical", outcome = "open" }, nil), 0)
    equal(#failures_of({ severity = "minor", outcome = "near_miss" }, 5), 0)
    local unscored = setmetatable({ failures = {}, eye = { time_s = 2 }, at = "iris.lua:7" }, Test)
    unscored:judged({ events = { { items = { "G5" } } } })
    equal(#unscored.failures, 0)
end)
