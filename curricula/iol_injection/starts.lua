-- SPDX-License-Identifier: GPL-3.0-or-later
-- The states in which this exercise begins: the implant lies folded in its injector. They are made when they are asked
-- for. torn: the bag's opening is the one that the expert tears.

return starts {
    begin = { folded = true },
    torn = { folded = true, opening = "capsulorhexis:round" },
}
