-- SPDX-License-Identifier: GPL-3.0-or-later
-- The state in which this exercise begins: the implant lies folded in its injector. It is made when it is asked for.

return starts {
    begin = { folded = true },
}
