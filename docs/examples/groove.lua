-- SPDX-License-Identifier: GPL-3.0-or-later
-- Sculpting by hand: the phaco tip passes over the lens five times, deeper each time.
local eye = rhexis.eye.create { tetrahedra = 1000, advance = "explicit" }
local lens, phaco = eye:solid("lens"), eye:tool("phaco")
local before = lens:mass()
for pass = 1, 5 do
    for step = 0, 100 do
        local tip = { 0, -1.6 + 0.03 * step, 2.0 - 0.35 * pass }
        phaco:move { position = tip, axis = { 0, -1, 0.7 }, pedal = 3 }
        assert(eye:step())
    end
    phaco:move { position = { 0, -1.6, 2.4 }, pedal = 1 }
    assert(eye:step(5))
    print(("pass %d: %.2f mg emulsified"):format(pass, 1000 * eye:removed_mass()))
end
assert(math.abs(before - lens:mass() - eye:removed_mass() - eye:crumb_mass()) < 1e-12)
phaco:withdraw()
assert(eye:step(20))
rhexis.render.draw(eye):write_png(arg[1] or "groove.png")
