-- SPDX-License-Identifier: GPL-3.0-or-later
-- The score of a report: the badge on top and the table of items with evidence and reasons.

local markup = require "report.markup"
local report_words = require "report.words"

local t, known = report_words.t, report_words.known

local scores = {}

local e, number = markup.escape, markup.number

-- Colour of a share of the points, 0 to 1.
local function class_of(share)
    if share >= 0.725 then return "good" end
    if share >= 0.2625 then return "fair" end
    return "bad"
end

--- Score and band, for the head of the page.
function scores.badge(osacss)
    if not osacss or not osacss.scaled then return '<div class="score"><b>–</b>' .. e(t("not scored")) .. "</div>" end
    local w = markup.writer()
    w('<div class="score"><span class="soft small">', e(osacss.rubric or "OSACSS"), "</span><b>",
        number(osacss.total, 1), '</b><span class="soft">', e(t("of %s", number(osacss.max, 0))), "</span><br>")
    w('<span class="band ', class_of(osacss.scaled), '">', e(osacss.band or t("not completed")),
        '</span><br><span class="soft small">', e(t("not clinically validated")), "</span></div>")
    return w:text()
end

-- Where thresholds come from: a tag, and the words behind it.
local function source_cell(w, source)
    source = tostring(source or "")
    local kind = source:find("^proposal") and "proposal" or source:find("proposal", 1, true) and "partly published"
        or source ~= "" and "published" or nil
    if kind then w('<span class="src">', e(t(kind)), "</span> ") end
    w(e((known(source):gsub("^" .. t("proposal") .. "%s*[;,]?%s*", ""))))
end

local function measures_table(w, measures)
    if #measures == 0 then return end
    w('<table class="measures"><tr><th>', e(t("Measure")), "</th><th>", e(t("Value")), "</th><th>", e(t("At")),
        "</th><th>", e(t("Points")), "</th><th>", e(t("What would have been better")), "</th><th>",
        e(t("Ground for the thresholds")), "</th></tr>")
    for _, measure in ipairs(measures) do
        w("<tr><td>", e(measure.name or measure.id), "</td><td>", number(measure.value, 2), " ",
            e(measure.unit == "1" and "" or measure.unit), "</td><td>", measure.time_s and markup.time(measure.time_s)
            or "", '</td><td>', number(measure.score, 1), "</td><td>", e(measure.better or ""), "</td><td>")
        source_cell(w, measure.threshold_source)
        w("</td></tr>")
    end
    w("</table>")
end

local function item_row(w, item, least)
    w('<tbody class="item"><tr><td class="id">', e(item.id), '</td><td><b>', e(item.name), "</b><ul>")
    if item.anchor then w('<li class="soft">', e(t("This level reads: ")), e(item.anchor), ".</li>") end
    for _, reason in ipairs(item.reasons or {}) do w("<li>", e(reason), "</li>") end
    w('</ul></td><td class="points">')
    if item.score then
        local share = (item.score - least) / (5 - least)
        w("<b>", number(item.score, 1), '</b> <span class="soft">', e(t("of 5")), '</span><div class="bar"><i class="',
            class_of(share), '" style="width:', number(20 * item.score, 1), '%"></i></div>')
    else
        w('<span class="soft">', e(t("N/A, not scored")), "</span>")
    end
    w("</td></tr>")
    if #(item.measures or {}) > 0 then
        w('<tr class="detail"><td></td><td colspan="2">')
        measures_table(w, item.measures)
        w("</td></tr>")
    end
    w("</tbody>")
end

--- The table of items.
function scores.section(w, osacss)
    if not osacss or not osacss.items then return end
    w("<section><h2>", e(t("Score, item by item")), "</h2><table><thead><tr><th>", e(t("Item")), "</th><th>",
        e(t("Why")), "</th><th>", e(t("Points")), "</th></tr></thead>")
    local least = type(osacss.least) == "number" and osacss.least or 1
    for _, item in ipairs(osacss.items) do item_row(w, item, least) end
    w("</table>")
    if osacss.band then
        w('<p class="small">', e(t("Band: ")), "<b>", e(osacss.band), "</b>", osacss.band_meaning and ", "
            .. e(osacss.band_meaning) or "", ". ", (osacss.rubric or "OSACSS") == "OSACSS"
            and e(t("The cuts are where the groups of Saleh et al. 2007 part.")) or "", "</p>")
    end
    w('<p class="soft small">', e(t("Each item has %s to 5 points.", number(least, 0))), " <b>",
        e(t("These scores have not been validated clinically.")), "</b> ",
        e(t("Thresholds marked “proposal” have no published ground; an item that this exercise does not show (N/A) is "
            .. "left out, and the scale shrinks to the others.")), "</p></section>")
end

return scores
