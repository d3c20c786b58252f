-- SPDX-License-Identifier: GPL-3.0-or-later
-- Ways to make one number of a quantity that changes during an attempt. Each collector has add(value, dt, time_s) and
-- result(), which gives the number (nil when nothing was ever added) and the time that it speaks of, if any. Where a
-- number is wanted, a condition is 1 when it holds and 0 when it does not.

local collect = {}

local function number(x)
    if type(x) == "boolean" then return x and 1 or 0 end
    return x
end

local function extreme(better)
    return function()
        local value, at
        return {
            add = function(given, _, time_s)
                local x = number(given)
                if value == nil or better(x, value) then value, at = x, time_s end
            end,
            result = function() return value, at end,
        }
    end
end

collect.max = extreme(function(a, b) return a > b end)
collect.min = extreme(function(a, b) return a < b end)

function collect.last()
    local value, at
    return {
        add = function(x, _, time_s) value, at = number(x), time_s end,
        result = function() return value, at end,
    }
end

--- Mean over time.
function collect.mean()
    local sum, time = 0, 0
    return {
        add = function(x, dt) sum, time = sum + number(x) * dt, time + dt end,
        result = function() return time > 0 and sum / time or nil end,
    }
end

--- Root of the mean square over time.
function collect.rms()
    local sum, time = 0, 0
    return {
        add = function(x, dt) sum, time = sum + number(x) ^ 2 * dt, time + dt end,
        result = function() return time > 0 and math.sqrt(sum / time) or nil end,
    }
end

-- Adds up the time in which a condition holds, in stretches of at least hold_s.
local function stretches(hold_s)
    local total, stretch = 0, 0
    return function(x, dt)
        if not x then
            stretch = 0
            return total
        end
        local before = stretch
        stretch = stretch + dt
        if stretch >= hold_s then total = total + (before < hold_s and stretch or dt) end
        return total
    end
end

--- Time in which a condition holds [s].
function collect.time(options)
    local add, total, any = stretches(options.hold_s or 0), 0, false
    return {
        add = function(x, dt) total, any = add(x, dt), true end,
        result = function() return any and total or nil end,
    }
end

--- Share of the time in which a condition holds [%].
function collect.share(options)
    local add, total, time = stretches(options.hold_s or 0), 0, 0
    return {
        add = function(x, dt) total, time = add(x, dt), time + dt end,
        result = function() return time > 0 and 100 * total / time or nil end,
    }
end

--- How often a condition comes true, after it has rested for quiet_s: a trembling touch is one touch.
function collect.count(options)
    local count, calm, any, at = 0, math.huge, false, nil
    return {
        add = function(x, dt, time_s)
            any = true
            if x and calm >= (options.quiet_s or 0) - 1e-9 and calm > 0 then
                count, at = count + 1, at or time_s
            end
            calm = x and 0 or calm + dt
        end,
        result = function() return any and count or nil, at end,
    }
end

return collect
