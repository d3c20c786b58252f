-- SPDX-License-Identifier: GPL-3.0-or-later
-- Whose scores an attempt's is like: of the groups of virtual surgeons that did the same exercise in the same way
-- (rubrics/cohorts.json). Where they do not bear it nothing is said, and why.

local words = require "engine.words"

local standing = {}

local fewest_items = 3
local same_task = { language = true, mode = true, handedness = true, ["patient.side"] = true }

--- Whether an exercise in which `name` was set is another one than its cohort did.
function standing.is_another_task(name) return not same_task[name] and not name:find("^surgeon%.") end

local function scored_items(score)
    local ids = {}
    for _, item in ipairs(score.items) do
        if item.score then ids[#ids + 1] = item.id end
    end
    return ids
end

local function same(a, b) return table.concat(a, " ") == table.concat(b, " ") end

-- Why nothing can be said, or nil.
local function unfounded(score, completed, cohort, changed)
    if not cohort then return "no cohort" end
    if cohort.stale then return "another exercise" end
    if score.rubric ~= cohort.rubric then return "another rubric" end
    if changed then return "another task" end
    if not completed then return "not completed" end
    local items = scored_items(score)
    if #items < fewest_items then return "too few items" end
    if not same(items, cohort.items) then return "other items" end
    if #cohort.cuts < 2 then return "not told apart" end
    return nil
end

--- score: of Sheet:score. cohort: { rubric, items, seeds, groups, cuts = list of { from, groups, n }, ascending },
--- stale: the exercise is not what it was then. changed: it was set otherwise than it stands. Returns { like = groups,
--- n, seeds }, or { none = why }.
function standing.of(score, completed, cohort, changed)
    local why = unfounded(score, completed, cohort, changed)
    if why then return words.as_object({ none = why }) end
    local found = cohort.cuts[1]
    for _, cut in ipairs(cohort.cuts) do
        if score.scaled >= cut.from then found = cut end
    end
    return { like = found.groups, n = found.n, seeds = cohort.seeds }
end

return standing
