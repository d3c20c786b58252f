-- SPDX-License-Identifier: GPL-3.0-or-later
-- States of this exercise to start from. They are made when they are asked for.

return starts {
    half_way = { surgeon = "d", seed = 101, when = "groove.depth_share > 0.3 and not phaco.in_contact", limit_s = 120 },
}
