-- SPDX-License-Identifier: GPL-3.0-or-later
-- A cataract lens lies free in its bag; a blunt probe pushes it sideways from the front. How far does the lens go?
local eye = rhexis.eye.create { age = 68, nuclear_grade = 3, tetrahedra = 1000, instruments = { "probe" } }
local lens, probe = eye:solid("lens"), eye:tool("probe")
assert(eye:step(20))
local start = lens:center()
for step = 1, 60 do
    probe:move { position = { -1 + 0.02 * step, 0, 2.4 - 0.015 * step }, axis = { 0, -1, 1 } }
    assert(eye:step())
end
local now, force = lens:center(), probe:force()
print(("the lens moved %.3f mm sideways and %.3f mm down"):format(now[1] - start[1], start[3] - now[3]))
print(("the probe feels %.0f, %.0f, %.0f uN"):format(force[1], force[2], force[3]))
