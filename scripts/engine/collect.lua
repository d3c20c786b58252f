-- SPDX-License-Identifier: GPL-3.0-or-later
-- Ways to make one number of a quantity that changes during an attempt. Each collector has add(value, dt, time_s) and
-- result(), which gives the number (nil when nothing was ever added) and the time that it speaks of, if any. Where a
-- number is wanted, a condition is 1 when it holds and 0 when it does not.
--
-- All that a collector remembers is in its `state`, a table of numbers: one that begins with the state of another goes
-- on as that one would have. So a score reaches over the parts of an operation.

local collect = {}

local function number(x)
    if type(x) == "boolean" then return x and 1 or 0 end
    return x
end

local function extreme(better)
    return function()
        local state = {}
        return {
            state = state,
            add = function(given, _, time_s)
                local x = number(given)
                if state.value == nil or better(x, state.value) then state.value, state.at = x, time_s end
            end,
            result = function() return state.value, state.at end,
        }
    end
end

collect.max = extreme(function(a, b) return a > b end)
collect.min = extreme(function(a, b) return a < b end)

function collect.last()
    local state = {}
    return {
        state = state,
        add = function(x, _, time_s) state.value, state.at = number(x), time_s end,
        result = function() return state.value, state.at end,
    }
end

--- The first value: of a quantity when something else came to hold.
function collect.first()
    local state = {}
    return {
        state = state,
        add = function(x, _, time_s)
            if state.value == nil then state.value, state.at = number(x), time_s end
        end,
        result = function() return state.value, state.at end,
    }
end

--- The last value of a quantity that only grows and that each part of an operation counts from 0: parts add up.
function collect.total()
    local state = { before = 0 }
    return {
        state = state,
        add = function(x, _, time_s) state.value, state.at = number(x), time_s end,
        result = function() return state.value and state.before + state.value, state.at end,
        carry = function()
            return { before = state.before + (state.value or 0), value = state.value and 0, at = state.at }
        end,
    }
end

local function averaged(power, finish)
    return function()
        local state = { sum = 0, time = 0 }
        return {
            state = state,
            add = function(x, dt)
                state.sum, state.time = state.sum + number(x) ^ power * dt, state.time + dt
            end,
            result = function() return state.time > 0 and finish(state.sum / state.time) or nil end,
        }
    end
end

--- Mean over time.
collect.mean = averaged(1, function(mean) return mean end)

--- Root of the mean square over time.
collect.rms = averaged(2, math.sqrt)

--- Standard deviation over time.
function collect.deviation()
    local state = { mean = 0, square = 0, time = 0 }
    return {
        state = state,
        add = function(given, dt)
            local x = number(given)
            state.time = state.time + dt
            local off = x - state.mean
            state.mean = state.mean + off * dt / state.time
            state.square = state.square + off * (x - state.mean) * dt
        end,
        result = function() return state.time > 0 and math.sqrt(state.square / state.time) or nil end,
    }
end

-- Adds up the time in which a condition holds, in stretches of at least hold_s.
local function add_stretch(state, x, dt, hold_s)
    if not x then
        state.stretch = 0
        return
    end
    local before = state.stretch
    state.stretch = before + dt
    if state.stretch >= hold_s then state.total = state.total + (before < hold_s and state.stretch or dt) end
end

--- Time in which a condition holds [s].
function collect.time(options)
    local state = { total = 0, stretch = 0, any = 0 }
    return {
        state = state,
        add = function(x, dt)
            add_stretch(state, x, dt, options.hold_s or 0)
            state.any = 1
        end,
        result = function() return state.any > 0 and state.total or nil end,
    }
end

--- The longest time for which a condition held without a break [s].
function collect.longest()
    local state = { stretch = 0, longest = 0, any = 0 }
    return {
        state = state,
        add = function(x, dt, time_s)
            state.any, state.stretch = 1, x and state.stretch + dt or 0
            if state.stretch > state.longest then state.longest, state.at = state.stretch, time_s end
        end,
        result = function() return state.any > 0 and state.longest or nil, state.at end,
    }
end

--- Share of the time in which a condition holds [%].
function collect.share(options)
    local state = { total = 0, stretch = 0, time = 0 }
    return {
        state = state,
        add = function(x, dt)
            add_stretch(state, x, dt, options.hold_s or 0)
            state.time = state.time + dt
        end,
        result = function() return state.time > 0 and 100 * state.total / state.time or nil end,
    }
end

--- How often a condition comes true, after it has rested for quiet_s: a trembling touch is one touch.
function collect.count(options)
    local state = { count = 0, any = 0 }  -- calm: time since it held; nil: it never did
    return {
        state = state,
        add = function(x, dt, time_s)
            state.any = 1
            local calm = state.calm or math.huge
            if x and calm >= (options.quiet_s or 0) - 1e-9 and calm > 0 then
                state.count, state.at = state.count + 1, state.at or time_s
            end
            if x then state.calm = 0 elseif state.calm then state.calm = calm + dt end
        end,
        result = function() return state.any > 0 and state.count or nil, state.at end,
    }
end

return collect
