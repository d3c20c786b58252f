-- SPDX-License-Identifier: GPL-3.0-or-later
-- States of this exercise to start from. They are made when they are asked for. torn: the bag's opening is the one that
-- the expert tears. In the others the implant has been let out: before the capsule; in the bag upside down; in the bag
-- on its side; in the bag but for its trailing haptic, which the injector has drawn out again because it left at once;
-- some time ago, with haptics that stick to the optic, and with such as come off it.

local implant_hand = require "implant_hand"

-- Let out with the mouth at a place, the injector turned so far [degrees]; then so long [s].
local function let_out(place, turned, set, then_s)
    return { set = set or implant_hand.thin, function(t)
        implant_hand.inject(t, place, turned)
        if then_s then t:wait(then_s) end
    end }
end

return starts {
    torn = { opening = "capsulorhexis:round" },
    before_capsule = let_out({ 0, -1.2, 2.2 }, 0),
    upside_down = let_out({ 0, -0.8, 0.8 }, 180),
    trailing_out = { function(t)
        implant_hand.inject_from_two(t, { 0, -0.2, 0.5 }, { 0, -1.7, 0.35 }, 0.1)
        t:wait(15)
    end },
    on_its_side = let_out({ 0, -1.0, 0.9 }, 70),
    stuck = let_out({ 0, -1.2, 2.2 }, 0, implant_hand.tacky(50), 15),
    came_off = let_out({ 0, -0.8, 0.8 }, 180, implant_hand.tacky(0), 5),
}
