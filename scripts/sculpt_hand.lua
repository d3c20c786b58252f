-- SPDX-License-Identifier: GPL-3.0-or-later
-- What an exact hand does with the phaco tip on a nucleus, for starts and scenarios of sculpting.

local sculpt_hand = {}

sculpt_hand.half_length = 2.2  -- of a stroke [mm]
sculpt_hand.over = 2.4         -- in front of the lens [mm]

--- One stroke through the middle with ultrasound. turn: degrees from straight away to the surgeon's right. height: of
--- its floor [mm]. speed: over the lens [mm/s]; down to it 0.4 of that.
function sculpt_hand.stroke(t, turn, height, speed)
    local half, over = sculpt_hand.half_length, sculpt_hand.over
    local x, y = half * math.sin(math.rad(turn)), half * math.cos(math.rad(turn))
    t.phaco:move_to({ -x, -y, over }, { speed = speed })
    t.phaco:pedal(3)
    t.phaco:move_to({ -x, -y, height }, { speed = 0.4 * speed })
    t.phaco:move_to({ x, y, height }, { speed = 2.5, motion = "even" })
    t.phaco:pedal(1)
    t.phaco:move_to({ x, y, over }, { speed = speed })
end

return sculpt_hand
