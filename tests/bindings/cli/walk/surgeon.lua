-- SPDX-License-Identifier: GPL-3.0-or-later
-- Cuts from place to place of a table, as pairs walks it. [mm]
local places = {
    anterior = { 0.0, 0.5, 1.3 }, inferior = { 0.2, -0.8, 1.4 }, nasal = { 0.7, 0.0, 1.5 },
    superior = { -0.1, 1.0, 1.4 }, temporal = { -0.8, 0.1, 1.5 },
}

return function(me)
    me.take_up({ 0, -0.5, 2.2 })
    me.pedal(3)
    for _, place in pairs(places) do me.go(place, 20) end
end
