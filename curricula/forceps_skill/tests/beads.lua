-- SPDX-License-Identifier: GPL-3.0-or-later
-- Beads carried and dropped, jaws in the wound, iris and cornea.

local beads = { { 2.2, 0 }, { -2.2, 0 }, { 0, 2.2 } }

local function go_in(t)
    t.forceps:enter()
    t.forceps:move_to({ 0, -2, 3.5 }, { speed = 20 })
end

-- Over a bead, down, closed on it, and up.
local function take(t, bead)
    t.forceps:move_to({ bead[1], bead[2], 3.6 }, { speed = 8 })
    t.forceps:jaw(0.6)
    t.forceps:move_to({ bead[1], bead[2], 0 }, { speed = 6, stop = "beads.nearest_mm < 0.1" })
    t.forceps:jaw(0)
    t:wait(0.05)
    t:expect("beads.held")
    t.forceps:move_by({ 0, 0, 0.8 }, { speed = 8 })
end

local function to_tray(t)
    local tip = t.forceps:tip()
    t.forceps:move_to({ 0, 0, tip[3] - 0.4 }, { speed = 8 })
    t.forceps:jaw(0.6)
    t.forceps:move_by({ 0, 0, 0.8 }, { speed = 8 })
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "all beads in the tray" {
        function(t)
            go_in(t)
            for _, bead in ipairs(beads) do
                take(t, bead)
                to_tray(t)
                t.forceps:jaw(0)
            end
            t:wait_until("beads.placed == 3", 2)
            t.forceps:move_to({ 0, -2, 3.5 }, { speed = 20 })
            t.forceps:withdraw()
            t:expect("beads.drops == 0 and beads.grasps == 3")
            t:expect_no_event("Bead dropped")
            t:expect_no_event("Jaws open in the wound")
        end },

    scenario "a bead carried nearly as fast as the grip bears" {
        silent_twin_of = "Bead dropped",
        near = "beads.held and forceps.speed_mm_s > 11",
        function(t)
            go_in(t)
            take(t, beads[1])
            t.forceps:move_to({ 0, 0, 3.5 }, { speed = 11.5 })
            t:expect("beads.held")
            to_tray(t)
        end },

    scenario "jaws nearly closed in the wound" {
        silent_twin_of = "Jaws open in the wound",
        near = "beads.jaw > 0.22 and beads.wound_mm < goal.wound_mm",
        function(t)
            t.forceps:enter()
            t.forceps:jaw(0.23)
            t:wait(0.5)
        end },

    scenario "bead let go beside the tray, and taken again" {
        function(t)
            go_in(t)
            take(t, beads[1])
            t.forceps:jaw(0.6)
            t:wait(0.05)
            t:expect_event("Bead dropped")
            t:wait(0.9)
            t.forceps:move_by({ 0, 0, -1.2 }, { speed = 6, stop = "beads.nearest_mm < 0.1" })
            t.forceps:jaw(0)
            t:expect_event("Bead dropped", { recovered = true, within = 1 })
        end },

    scenario "bead jerked out of the jaws, and left" {
        function(t)
            go_in(t)
            take(t, beads[1])
            t.forceps:move_to({ 1.2, -1, 3.5 }, { speed = 30 })
            t:expect("not beads.held and beads.drops == 1")
            t:expect_event("Bead dropped", { recovered = false, within = 7 })
        end },

    scenario "jaws opened in the wound, and closed" {
        function(t)
            t.forceps:enter()
            t.forceps:jaw(0.6)
            t:wait(0.1)
            t:expect_event("Jaws open in the wound")
            t.forceps:jaw(0)
            t:expect_event("Jaws open in the wound", { recovered = true, within = 0.5 })
        end },

    scenario "jaws opened in the wound, and left open" {
        function(t)
            t.forceps:enter()
            t.forceps:jaw(0.6)
            t:expect_event("Jaws open in the wound", { recovered = false, within = 2 })
        end },

    scenario "iris touched, put right" {
        function(t)
            go_in(t)
            t.forceps:move_to({ 3.4, 0, 3 }, { speed = 8 })
            t.forceps:move_to({ 5, 0, 0.5 }, { speed = 4, stop = "iris.gap_mm < -0.05" })
            t:expect_event("Iris touched")
            t.forceps:move_to({ 1.5, 0, 3.4 }, { speed = 8 })
            t:expect_event("Iris touched", { recovered = true })
        end },

    scenario "iris touched, and the tip stays" {
        function(t)
            go_in(t)
            t.forceps:move_to({ 3.4, 0, 3 }, { speed = 8 })
            t.forceps:move_to({ 5, 0, 0.5 }, { speed = 4, stop = "iris.gap_mm < -0.05" })
            t:expect_event("Iris touched", { recovered = false, within = 2 })
        end },

    scenario "turns back before the iris" {
        silent_twin_of = "Iris touched",
        near = "iris.gap_mm < 0.2",
        function(t)
            go_in(t)
            t.forceps:move_to({ 3.2, 0, 3.2 }, { speed = 8 })
            t.forceps:move_to({ 5, 0, 0.5 }, { speed = 3, stop = "iris.gap_mm < 0.2" })
            t.forceps:move_to({ 1.5, 0, 3.4 }, { speed = 8 })
        end },

    scenario "cornea touched, put right" {
        function(t)
            go_in(t)
            t.forceps:move_to({ 0, 0, 3 }, { speed = 8 })
            t.forceps:move_to({ 0, 0, 8 }, { speed = 4, stop = "forceps.endothelium_mm < 0.05" })
            t:expect_event("Cornea touched")
            t.forceps:move_to({ 0, 0, 3 }, { speed = 8 })
            t:expect_event("Cornea touched", { recovered = true })
        end },

    scenario "cornea touched, and the tip stays" {
        function(t)
            go_in(t)
            t.forceps:move_to({ 0, 0, 3 }, { speed = 8 })
            t.forceps:move_to({ 0, 0, 8 }, { speed = 4, stop = "forceps.endothelium_mm < 0.05" })
            t:expect_event("Cornea touched", { recovered = false, within = 2 })
        end },

    scenario "turns back before the cornea" {
        silent_twin_of = "Cornea touched",
        near = "forceps.endothelium_mm < 0.25 and forceps.tip_y_mm > -2.5",
        function(t)
            go_in(t)
            t.forceps:move_to({ 0, 0, 3 }, { speed = 8 })
            t.forceps:move_to({ 0, 0, 8 }, { speed = 4, stop = "forceps.endothelium_mm < 0.25" })
            t.forceps:move_to({ 0, 0, 3 }, { speed = 8 })
        end },
}
