-- SPDX-License-Identifier: GPL-3.0-or-later
-- Runs every example of the stubs.
package.path = "scripts/dev/api/?.lua;" .. package.path
local stubs = require "stubs"

local faults = {}
for _, class in ipairs((stubs.read("bindings/lua/meta"))) do
    for _, fn in ipairs(class.functions) do
        local place = ("%s:%d"):format(fn.file, fn.line)
        local chunk, problem = load(table.concat(fn.example, "\n"), "=" .. place, "t")
        if chunk then
            local done, message = pcall(chunk)
            problem = not done and message
        end
        if problem then
            faults[#faults + 1] = ("%s (%s.%s): %s"):format(place, class.name, fn.name, problem)
        end
        collectgarbage()
    end
end
assert(#faults == 0, "\n" .. table.concat(faults, "\n"))
