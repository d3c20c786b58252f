-- SPDX-License-Identifier: GPL-3.0-or-later
-- What to do better next time, of a score and of the errors of an attempt.

-- Points that putting a measure right would bring back to its item.
local function lost_points(item)
    local lost, weight = {}, 0
    for _, measure in ipairs(item.measures) do weight = weight + measure.weight end
    for _, measure in ipairs(item.measures) do
        if measure.better and weight > 0 then
            lost[#lost + 1] = { text = measure.better, points = (5 - measure.score) * measure.weight / weight }
        end
    end
    return lost
end

--- Up to five sentences: errors by their severity, what was not put right first, then what cost most points.
return function(score, events)
    local advice, seen = {}, {}
    local function add(text)
        if not seen[text] and #advice < 5 then advice[#advice + 1] = text end
        seen[text] = true
    end
    for _, severity in ipairs({ "critical", "minor" }) do
        for _, outcome in ipairs({ "not_recovered", "open", "recovered" }) do
            for _, event in ipairs(events) do
                local met = event.given and event.recovered and not event.harmed
                if event.severity == severity and event.outcome == outcome and not met then add(event.advice) end
            end
        end
    end
    local lost = {}
    for _, item in ipairs(score.items) do
        for _, entry in ipairs(lost_points(item)) do lost[#lost + 1] = entry end
    end
    table.sort(lost, function(a, b)
        if a.points ~= b.points then return a.points > b.points end
        return a.text < b.text
    end)
    for _, entry in ipairs(lost) do
        if entry.points > 0.2 then add(entry.text) end
    end
    return advice
end
