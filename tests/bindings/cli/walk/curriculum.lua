-- SPDX-License-Identifier: GPL-3.0-or-later
-- What happens depends on the order in which tables are walked: the power of the phaco follows one walk, the hand of
-- the surgeon another. Stock Lua would walk both in another order in every process.

local levels = {}
for _ = 1, 40 do
    local name = ""
    for _ = 1, 8 do name = name .. string.char(math.random(97, 122)) end
    levels[name] = math.random()
end

return exercise {
    title = "Walking tables",
    patient = { tetrahedra = 500 },
    tissues = { "lens", "bag" },
    instruments = { "phaco" },
    goals = { backwards = { 0, from = 0, to = 1, meaning = "1: the walk is taken from its end" } },
    steps = {
        step "walk" {
            script = function(eye, act)
                local values = {}
                for _, level in pairs(levels) do values[#values + 1] = level end
                for i = 1, #values do
                    act.set("phaco.power_limit", values[eye.goal.backwards > 0 and #values + 1 - i or i])
                    act.wait(0.01)
                end
            end,
        },
    },
}
