-- SPDX-License-Identifier: GPL-3.0-or-later
local Eye = require "engine.eye"
local condition = require "engine.condition"
local expression = require "engine.expression"
local support = require "support"

local case, equal, fails = support.case, support.equal, support.fails

local function value_of(text, values)
    local schema = { { name = "a.x_mm", unit = "mm" }, { name = "a.y_mm", unit = "mm" },
        { name = "b.on", unit = "bool" } }
    local eye = Eye.new(schema, { limit = 4 })
    eye:look(12.5, { values[1] or 0 / 0, values[2] or 0 / 0, values[3] or 0 / 0 }, 2.5)
    local parsed = expression.parse(text, "here:1")
    return expression.bind(parsed, function(name) return eye:resolve(name) end)()
end

case("texts compute as they read", function()
    equal(value_of("2 + 3 * 4 - 10 / 5", {}), 12)
    equal(value_of("-(2 + 3) * 2", {}), -10)
    equal(value_of("max(1, a.x_mm, 2) - min(3, 4) + abs(0 - 2)", { 7 }), 6)
    equal(value_of("sqrt(a.x_mm) + 1", { 16 }), 5)
    equal(value_of("sqrt(a.x_mm)", { -1 }), nil)
    equal(value_of("a.x_mm < 0.3 and not b.on", { 0.2, nil, 0 }), true)
    equal(value_of("a.x_mm < 0.3 and b.on or a.y_mm >= 2", { 0.4, 2 }), true)
    equal(value_of("1.5e1 == 15 and .5 ~= 1 and true", {}), true)
end)

case("times and goals can be used in texts", function()
    equal(value_of("time_s > 12 and step.time_s < 3", {}), true)
    equal(value_of("a.x_mm >= goal.limit", { 4 }), true)
end)

case("an undefined measure makes a sum undefined and a comparison false", function()
    equal(value_of("a.x_mm < 1", {}), false)
    equal(value_of("a.x_mm >= 1", {}), false)
    equal(value_of("a.x_mm + 1", {}), nil)
    equal(value_of("1 / 0", {}), nil)
    equal(value_of("not b.on", {}), true)
end)

case("mistakes of form name the place and what is missing", function()
    fails(function() expression.parse("a.x_mm <", "file.lua:3") end, "file.lua:3:", "missing at its end")
    fails(function() expression.parse("a.x_mm = 3", "file.lua:3") end, "write == to compare")
    fails(function() expression.parse("(1 + 2", "file.lua:3") end, "')' is missing")
    fails(function() expression.parse("1 2", "file.lua:3") end, "'and' or 'or' is missing near '2'")
    fails(function() expression.parse("", "file.lua:3") end, "missing")
    fails(function() expression.parse("a.x_mm < and b.on", "file.lua:3") end, "near 'and'")
end)

case("what is written as in other languages is told how it is written here", function()
    local function says(text, ...)
        local advice = { ... }
        fails(function() expression.parse(text, "file.lua:3") end, "file.lua:3:", table.unpack(advice))
    end
    says("a.on && b.on", "'&' does not belong", "write and")
    says("a.on || b.on", "'|' does not belong", "write or")
    says("!a.on", "write not")
    says("a.on AND b.on", "near 'AND'", "write and in small letters")
    says("(a.on OR b.on)", "near 'OR'", "write or in small letters")
    says("NOT a.on", "write not in small letters")
    says("a.x_mm > 1,5", "write a decimal point, 1.5")
    says("a.x_mm > 1 mm", "near 'mm'", "numbers stand without a unit")
    says("a.x_mm > 5 %", "numbers stand without a unit")
    says("a.x_mm => 1", "write >=")
    says("a.x_mm ≥ 1", "'≥' does not belong", "write >=")
    says("a.x_mm > 1e999", "1e999 is too large a number")
end)

case("functions take as many numbers as they can use", function()
    fails(function() expression.parse("min(a.x_mm) > 1", "file.lua:3") end, "file.lua:3: min takes two numbers or more")
    fails(function() expression.parse("abs(1, 2) > 1", "file.lua:3") end, "file.lua:3: abs takes one number")
end)

case("a condition has an end, and no more brackets than a person reads", function()
    local function nested(n) return ("("):rep(n) .. "a.on" .. (")"):rep(n) end
    fails(function() expression.parse(nested(150), "file.lua:3") end, "file.lua:3:", "nested more than 100 deep")
    fails(function() expression.parse(("not "):rep(150) .. "a.on", "file.lua:3") end, "nested more than 100 deep")
    fails(function() expression.parse(("-"):rep(150) .. "1 < 2", "file.lua:3") end, "nested more than 100 deep")
    fails(function() expression.parse(("not "):rep(1e5) .. "a.on", "file.lua:3") end, "longer than 4000 characters")
    expression.parse(nested(90) .. (" and a.on"):rep(300), "file.lua:3")
end)

case("unknown names bring near ones", function()
    fails(function() value_of("a.x_m < 1", {}) end, "unknown measure 'a.x_m'", "did you mean a.x_mm")
    fails(function() value_of("goal.limt < 1", {}) end, "did you mean goal.limit")
end)

case("a list of conditions must come true in order", function()
    local eye = Eye.new({ { name = "a.x_mm", unit = "mm" } }, {})
    local bound = condition.bind(condition.read({ "a.x_mm > 1", "a.x_mm < 0" }, "here:1", "when"), eye, "in a test")
    local function at(x)
        eye:look(0, { x }, 0)
        return bound.test()
    end
    equal(at(-1), false, "second before first")
    equal(at(2), false, "first")
    equal(at(0.5), false, "between")
    equal(at(-1), true, "second")
    bound.reset()
    equal(at(-1), false, "after reset")
end)

case("functions see undefined measures as nil and yes/no as booleans", function()
    local eye = Eye.new({ { name = "a.x_mm", unit = "mm" }, { name = "a.on", unit = "bool" } }, { limit = 4 })
    eye:look(1, { 0 / 0, 1 }, 0)
    equal(eye.view.a.x_mm, nil)
    equal(eye.view.a.on, true)
    equal(eye.view.goal.limit, 4)
    equal(eye.view.time_s, 1)
    fails(function() return eye.view.a.x_cm end, "test_expression.lua:", "unknown measure 'a.x_cm'", "x_mm")
    fails(function() return eye.view.phaco end, "unknown group of measures 'phaco'")
    fails(function() eye.view.a.x_mm = 3 end, "only be read")
end)
