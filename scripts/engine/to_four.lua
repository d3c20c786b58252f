-- SPDX-License-Identifier: GPL-3.0-or-later
-- How an item that earned less than four points would have earned four: which error it takes to leave out, and which
-- value of which measure. What is asked of each measure is as little as it takes.

local good = 4
local shown_as_good = 3.95  -- points are shown with one digit

local to_four = {}

-- The value nearest to `value` whose score on the curve is at least `score`; nil: there is none.
local function nearest(curve, value, score)
    local best
    local function offer(candidate)
        if not best or math.abs(candidate - value) < math.abs(best - value) then best = candidate end
    end
    for i, point in ipairs(curve) do
        if point[2] >= score - 1e-9 then offer(point[1]) end
        local before = curve[i - 1]
        if before and (before[2] - score) * (point[2] - score) < 0 then
            offer(before[1] + (point[1] - before[1]) * (score - before[2]) / (point[2] - before[2]))
        end
    end
    return best
end

-- Of one measure: the score that lifts the mean to four while the others stay, at most 5.
local function needed(measure, sum, weight)
    return math.min(5, (good * weight - sum) / measure.weight + measure.score)
end

-- Measures from the one that cost most, and what each would have to be, until the mean is four.
local function of_measures(measures, curves)
    local sum, weight, order = 0, 0, {}
    for i, measure in ipairs(measures) do
        sum, weight, order[i] = sum + measure.weight * measure.score, weight + measure.weight, measure
    end
    table.sort(order, function(a, b)
        local lost_a, lost_b = a.weight * (5 - a.score), b.weight * (5 - b.score)
        if lost_a ~= lost_b then return lost_a > lost_b end
        return a.id < b.id
    end)
    local list = {}
    for _, measure in ipairs(order) do
        if weight == 0 or sum / weight >= good - 1e-9 then break end
        local curve = curves[measure.id]
        local score = needed(measure, sum, weight)
        local wanted = curve and score > measure.score and nearest(curve, measure.value, score)
        if wanted then
            list[#list + 1] = { id = measure.id, name = measure.name, unit = measure.unit, value = measure.value,
                wanted = wanted }
            sum = sum + measure.weight * (score - measure.score)
        end
    end
    return list
end

-- Errors that leave less than four, each kind once.
local function of_errors(capped_by)
    local list, seen = {}, {}
    for _, by in ipairs(capped_by) do
        if by.cap < good and not seen[by.event] then
            seen[by.event] = true
            list[#list + 1] = { event = by.event, title = by.title, cap = by.cap, time_s = by.time_s }
        end
    end
    return list
end

--- item: as a score has it, with measures and capped_by; open: list of { measure = }, as the rubric declares them;
--- amount(measure, value): a value as it is told; t: makes a text one of the run's language. Nil: it has four, or was
--- not scored. Else { errors, measures }, each with a sentence; both empty: its work was not begun.
function to_four.of(item, open, amount, t)
    if not item.score or item.score >= shown_as_good then return nil end
    local declared, curves = {}, {}
    for _, one in ipairs(open) do declared[one.measure.id], curves[one.measure.id] = one.measure, one.measure.curve end
    local way = { errors = of_errors(item.capped_by), measures = of_measures(item.measures, curves) }
    for _, error in ipairs(way.errors) do
        error.text = t("Without \"%s\", or with it put right at once."):format(error.title)
    end
    for _, one in ipairs(way.measures) do
        local measure = declared[one.id]
        one.text = t("%s: %s instead of %s."):format(one.name, amount(measure, one.wanted), amount(measure, one.value))
    end
    return way
end

return to_four
