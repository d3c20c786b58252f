-- SPDX-License-Identifier: GPL-3.0-or-later
-- What a virtual surgeon does: hydrates, fills the eye until it feels firm, presses on the lip and looks. Where fluid
-- comes: more saline, then a stitch, and another test. It sees the picture only. [mm, s]

local wounding = require "surgeons.wounding"

local soft, hard = 15.5, 24.5  -- as the eye feels [mmHg]
local fill_s = 2.5
local most_tests = 5

return function(me)
    me.wait_until(function(seen) return seen and seen.landmarks.incision_site ~= nil end, 10)
    wounding.hydrate(me)
    wounding.fill(me, fill_s)
    for round = 1, most_tests do
        local felt, wet = wounding.test(me)
        local firm = felt >= soft and felt <= hard
        if not wet and firm then return end
        if me.notices(function() return wet end) then
            if round == 1 then wounding.hydrate(me, 0.25) else wounding.stitch(me, round == 2 and -0.3 or 0.3) end
        elseif wet then
            return  -- left as it is
        end
        if felt < soft then wounding.fill(me, fill_s) end
    end
end
