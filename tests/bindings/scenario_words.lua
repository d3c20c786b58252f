-- SPDX-License-Identifier: GPL-3.0-or-later
-- bindings/lua/meta/scenario.lua declares the words that scripts/scenario offers, all of them and no others.
package.path = "scripts/?.lua;scripts/?/init.lua;" .. package.path
local Hand = require "scenario.hand"
local Microscope = require "scenario.microscope"
local Test = require "scenario.test"
local host = require "scenario.host"

local declared = { ScenarioTest = {}, Instrument = {}, Microscope = {} }
local globals = {}
for line in io.lines("bindings/lua/meta/scenario.lua") do
    local class, word = line:match("^function (%a+):([%w_]+)%(")
    if class then declared[class][word] = true end
    local global = line:match("^function ([%w_]+)%(")
    if global then globals[#globals + 1] = global end
end

local function same(class, words)
    local count = 0
    for _, word in ipairs(words) do
        assert(declared[class][word], ("the stubs lack %s:%s"):format(class, word))
        count = count + 1
    end
    for word in pairs(declared[class]) do
        count = count - 1
        assert(count >= 0, ("the stubs declare too much for %s, such as %s"):format(class, word))
    end
end
same("ScenarioTest", Test.public)
same("Instrument", Hand.public)
same("Microscope", Microscope.public)
assert(#globals == 3)
for _, name in ipairs(globals) do assert(rawget(host.environment(), name), "there is no word " .. name) end
