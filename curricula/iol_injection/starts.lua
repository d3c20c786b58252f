-- SPDX-License-Identifier: GPL-3.0-or-later
-- States of this exercise to start from. They are made when they are asked for. torn: the bag's opening is the one
-- that the expert tears. In the others the implant has been let out: before the capsule; in the bag upside down; in the
-- bag on its side, its front to the back, or nearly so; in the bag but for its trailing haptic, which the injector has
-- drawn out again because it left at once; in the bag, of a sticky material: with a haptic folded on the optic, tilted
-- by 7 degrees for 20 s, and with one that sticks as well on an optic that comes to lie flat within two seconds.

local implant_hand = require "implant_hand"

-- Let out with the mouth at a place, the injector turned so far [degrees]; then so long [s].
local function let_out(place, turned, set, then_s)
    return { set = set or implant_hand.thin, function(t)
        implant_hand.inject(t, place, turned)
        if then_s then t:wait(then_s) end
    end }
end

-- Let out as one should, but that the injector stays so long [s] before it leaves; then so long [s].
local function led_in(set, stays, then_s)
    return { set = set, function(t)
        implant_hand.inject_from_two(t, { 0, -0.2, 0.5 }, { 0, -1.7, 0.35 }, stays)
        t:wait(then_s)
    end }
end

return starts {
    torn = { opening = "capsulorhexis:round" },
    before_capsule = let_out({ 0, -1.2, 2.2 }, 0),
    upside_down = let_out({ 0, -0.8, 0.8 }, 180),
    trailing_out = led_in(nil, 0.1, 15),
    on_its_side = let_out({ 0, -1.0, 0.9 }, 70),
    nearly_over = let_out({ 0, -1.0, 0.9 }, 31),
    stuck = led_in(implant_hand.sticky(10), 0.6, 24),
    settles = led_in(implant_hand.sticky(50), 0.6, 6.5),
}
