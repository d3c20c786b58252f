-- SPDX-License-Identifier: GPL-3.0-or-later
-- What an exact hand does for a bag that lacks zonules, for starts and scenarios of the exercises that share it. It
-- knows the measures, which no surgeon does.

local zonule_hand = {}

--- The edge of the opening before the middle of the gap, and a place by it: so far towards the middle of the opening
--- and so high over it [mm].
function zonule_hand.by_rim(t, inwards, over)
    local x, y, z = t:value("zonules.rim_x_mm"), t:value("zonules.rim_y_mm"), t:value("zonules.rim_z_mm")
    local share = 1 - inwards / math.sqrt(x * x + y * y)
    return { share * x, share * y, z + over }
end

--- A hook round the edge of the opening over the gap.
function zonule_hand.set_hook(t)
    t.capsule_hook:enter({ speed = 20 })
    t.capsule_hook:jaw(1)
    t.capsule_hook:move_to(zonule_hand.by_rim(t, 0.3, 1.0), { speed = 15 })
    t.capsule_hook:move_to(zonule_hand.by_rim(t, 0.1, 0.3), { speed = 5 })
    t.capsule_hook:jaw(0)
    t:wait(0.1)
    t.capsule_hook:withdraw({ speed = 20 })
end

--- A tension ring under the edge of the opening.
function zonule_hand.feed_ring(t)
    t.ring:enter({ speed = 20 })
    t.ring:move_to(zonule_hand.by_rim(t, 0.3, 1.0), { speed = 15 })
    t.ring:move_to(zonule_hand.by_rim(t, 0.1, 0.3), { speed = 5 })
    t.ring:jaw(1)
    t:wait(2.2)
    t.ring:withdraw({ speed = 20 })
end

--- Viscoelastic over the gap; through: the wound, where it is not the main one.
function zonule_hand.cover(t, through)
    t.cannula:enter({ speed = 25, through = through })
    t.cannula:move_to(zonule_hand.by_rim(t, -0.9, -0.2), { speed = 15 })
    t.cannula:jaw(1)
    t:wait_until("tamponade.gap_cover > 0.95", 4)
    t.cannula:jaw(0)
    t.cannula:withdraw({ speed = 25 })
end

return zonule_hand
