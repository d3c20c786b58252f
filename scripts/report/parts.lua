-- SPDX-License-Identifier: GPL-3.0-or-later
-- Parts of an operation in a series: each has its own scene, so that nothing goes on from one to the next.

local parts = {}

local instant = 1e-6  -- [s]

-- The sample with which what begins at that time begins: the last of its time, since the part before ends there too.
local function first_sample(times, time)
    local found
    for i = 1, #times do
        if times[i] > time + instant then return found or i end
        if times[i] > time - instant then found = i end
    end
    return found
end

--- Adds to a chart's context: part_starts, times at which a part begins but the first; starts, set of their samples.
function parts.mark(context, list)
    context.part_starts, context.starts = {}, {}
    local time = 0
    for i, part in ipairs(type(list) == "table" and list or {}) do
        if i > 1 then
            context.part_starts[i - 1] = time
            local sample = first_sample(context.times, time)
            if sample then context.starts[sample] = true end
        end
        time = time + (type(part.duration_s) == "number" and part.duration_s or 0)
    end
end

local function is_told(lines, i)
    for _, line in ipairs(lines) do
        if type(line.values[i]) == "number" then return true end
    end
    return false
end

--- From the beginning of the first part that has something of the lines to the end of the last one.
function parts.range(context, lines)
    if #context.part_starts == 0 then return context.first, context.last end
    local begun, ended
    for i = 1, #context.times do
        if is_told(lines, i) then begun, ended = begun or context.times[i], context.times[i] end
    end
    if not begun then return context.first, context.last end
    local first, last = context.first, context.last
    for _, time in ipairs(context.part_starts) do
        if time <= begun + instant then first = time end
        if time > ended and time < last then last = time end
    end
    return first, math.max(last, first + instant)
end

return parts
