-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon puts an implant into the bag. All groups follow this plan; what they make of it depends on
-- their hands, eyes and attention (scripts/surgeons/groups.lua). The plan sees the picture only: no measure, no event,
-- no score.

local implanting = require "surgeons.implanting"

local unfolds_s = 8   -- before one judges where the haptics are
local settles_s = 20  -- that one watches the implant come to rest in its bag
local attempts = 2    -- at a haptic that lies before the bag

return function(me)
    local eye = implanting.look_around(me)
    if implanting.is_shallow(me.see()) then implanting.fill(me, eye) end
    if not me.see().landmarks.optic then  -- an attempt may begin with the implant in the eye
        implanting.inject(me, eye)
        me.wait(unfolds_s)
    end
    for _ = 1, attempts do
        for _, which in ipairs { "leading", "trailing" } do
            if implanting.lies_before(me.see(), which) then
                implanting.tuck_in(me, eye, which)
                me.wait(unfolds_s)
            end
        end
    end
    me.wait(settles_s - unfolds_s)
end
