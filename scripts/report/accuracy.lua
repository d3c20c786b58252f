-- SPDX-License-Identifier: GPL-3.0-or-later
-- How finely an attempt was simulated: what was chosen, what error that is expected to make, what it may be, and what
-- was measured.

local markup = require "report.markup"
local names = require "report.names"
local report_words = require "report.words"

local t = report_words.t

local accuracy = {}

local quantities_by_name = {
    balance = "force out of balance on the implant",
    depth = "depth of the chamber",
    force = "force on the instrument",
    overlap = "depth to which what touches overlaps",
    path = "way of the tear",
    pressure = "pressure in the chamber",
    tear = "length of the tear",
    volume = "volume taken out",
}

local meshes_by_name = {
    ["bag.triangles"] = "triangles of the bag",
    ["capsule.triangles"] = "triangles of the capsule",
    ["implant.triangles"] = "triangles of the implant",
    ["patient.tetrahedra"] = "tetrahedra",
}

local e, number = markup.escape, markup.number

local function percent(value)
    if value > 0 and value < 0.0005 then return "< " .. number(0.1, 1) .. " %" end
    return number(100 * value, value < 0.1 and 1 or 0) .. " %"
end

-- A share in per cent, a way in mm.
local function amount(quantity, value)
    if not value then return "–" end
    return quantity == "path" and number(value, 2) .. " mm" or percent(value)
end

local function sorted_keys(object)
    local keys = {}
    for key in pairs(object or {}) do keys[#keys + 1] = key end
    table.sort(keys)
    return keys
end

local function mesh_text(mesh)
    local parts = {}
    for _, name in ipairs(sorted_keys(mesh)) do
        parts[#parts + 1] = number(mesh[name], 0) .. " " .. t(meshes_by_name[name] or name)
    end
    return table.concat(parts, ", ")
end

local function chosen_text(model)
    local text = mesh_text(model.mesh)
    if text == "" then return "" end
    return model.by_hand and t("%s, as the exercise says", text) or text
end

local function rows(w, model, measured)
    local quantities = sorted_keys(model.budget)
    for i, quantity in ipairs(quantities) do
        local name = names.simulated[model.model] and t(names.simulated[model.model])
            or (tostring(model.model):gsub("_", " "))
        w("<tr><td>", i == 1 and e(name) or "", "</td><td>", i == 1 and e(chosen_text(model)) or "", "</td><td>",
            e(t(quantities_by_name[quantity] or quantity)), "</td><td>",
            e(amount(quantity, model.expected and model.expected[quantity])), "</td><td>",
            e(amount(quantity, model.budget[quantity])), "</td>")
        if measured then
            w("<td>", e(amount(quantity, measured.errors and measured.errors[quantity])), "</td>")
        end
        w("</tr>")
    end
end

local function measured_text(measured)
    local mesh = mesh_text(measured.mesh)
    local text = t("Measured against steps of %s ms%s over %s of %s s.", number(1000 * measured.step_s, 1),
        mesh == "" and "" or t(" and %s", mesh), number(measured.compared_s, 1), number(measured.of_s, 1))
    local differs = measured.differs
    if type(differs) ~= "table" then return text end
    return text .. " " .. t("After %s s a tear, crack or grip differs (%s).", number(differs.time_s, 2),
        tostring(differs.measure))
end

--- w: writes; report: with what make_report put into `accuracy`. Nothing where nobody chose.
function accuracy.section(w, report)
    local chosen = report.accuracy
    if type(chosen) ~= "table" or type(chosen.models) ~= "table" or #chosen.models == 0 then return end
    local measured = type(chosen.measured) == "table" and chosen.measured or nil
    w('<h3 class="after">', e(t("How finely it was simulated")), '</h3><div class="scroll"><table><tr><th>',
        e(t("Part")), "</th><th>", e(t("Mesh")), "</th><th>", e(t("Quantity")), "</th><th>",
        e(t("Expected error")), "</th><th>", e(t("Error that it may have")), "</th>",
        measured and "<th>" .. e(t("Measured error")) .. "</th>" or "", "</tr>")
    for _, model in ipairs(chosen.models) do rows(w, model, measured) end
    w('</table></div><p class="soft small">', e(t("Steps of %s ms. By the tables of the program that costs %s s of "
        .. "computing time per simulated second.", number(1000 * chosen.step_s, 0), number(chosen.cost, 2))),
        measured and " " .. e(measured_text(measured)) or "", "</p>")
end

return accuracy
