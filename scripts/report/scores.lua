-- SPDX-License-Identifier: GPL-3.0-or-later
-- The score of a report: the badge on top and the table of items with evidence and reasons.

local markup = require "report.markup"
local quantity = require "report.quantity"
local reasons = require "report.reasons"
local report_words = require "report.words"

local t, known = report_words.t, report_words.known

local scores = {}

local e, number = markup.escape, markup.number

-- Colour of a share of the points, 0 to 1: from 4 points on, from 2 on.
local function class_of(share)
    if share >= 0.75 then return "good" end
    if share >= 0.25 then return "fair" end
    return "bad"
end

local function scored_of(score)
    local scored = 0
    for _, item in ipairs(score.items or {}) do scored = scored + (item.score and 1 or 0) end
    return scored
end

-- "It rests on 4 of 20 items."
local function ground(score)
    return t("rests on %d of %d items", scored_of(score), reasons.items_of(score))
end

-- Why it is not said whose scores these are like.
local no_standing = {
    ["no cohort"] = "no comparison: virtual surgeons have not done it for one",
    ["another exercise"] = "no comparison: the exercise has changed since virtual surgeons did it",
    ["another rubric"] = "no comparison: judged by another rubric",
    ["another task"] = "no comparison: not the exercise as virtual surgeons did it",
    ["not completed"] = "no comparison: not completed",
    ["too few items"] = "no comparison: too few items",
    ["other items"] = "no comparison: other items than virtual surgeons were scored on",
    ["not told apart"] = "no comparison: this exercise does not tell beginners from experts",
}

-- "b", "b and c"
local function listed(groups)
    if #groups < 2 then return groups[1] end
    return table.concat(groups, ", ", 1, #groups - 1) .. t(" and ") .. groups[#groups]
end

-- Whose scores these are like. Who begins in the middle has not shown a whole attempt.
local function standing_of(report)
    if report.begun_at then return t("no comparison: begun in the middle"), "none" end
    if report.aids then return t("no comparison: with aids"), "none" end
    if report.input then return t("no comparison: no cohort of people with this device"), "none" end
    local standing = report.osacss.standing
    if not standing or not standing.like then
        return t(no_standing[standing and standing.none] or no_standing["no cohort"]), "none"
    end
    return t(#standing.like > 1 and "like virtual surgeons of groups %s" or "like virtual surgeons of group %s",
        listed(standing.like)), class_of(report.osacss.scaled)
end

--- Score, and whose it is like, for the head of the page.
function scores.badge(report)
    local score = report.osacss
    if not score or not score.scaled then return '<div class="score"><b>–</b>' .. e(t("not scored")) .. "</div>" end
    local standing, class = standing_of(report)
    local w = markup.writer()
    w('<div class="score"><span class="soft small">', e(score.rubric or "OSACSS"), "</span><b>",
        number(score.total, 1), '</b><span class="soft">', e(t("of %s", number(score.max, 0))), "</span><br>")
    w('<span class="band ', class, '">', e(standing), '</span><br><span class="soft small">')
    if score.items then w(e(ground(score)), "<br>") end
    w(e(t("not clinically validated")), "</span></div>")
    return w:text()
end

-- Where thresholds come from: a tag, and the words behind it.
local function source_cell(w, source)
    source = tostring(source or "")
    local kind = source:find("^proposal") and "proposal" or source:find("proposal", 1, true) and "partly published"
        or source ~= "" and "published" or nil
    if kind then w('<span class="src">', e(t(kind)), "</span> ") end
    w(e((quantity.rewritten(known(source)):gsub("^" .. t("proposal") .. "%s*[;,]?%s*", ""))))
end

local function measures_table(w, rubric, item)
    w('<div class="scroll"><table class="measures"><tr><th>', e(t("Measure")), "</th><th>", e(t("Value")),
        "</th><th>", e(t("At")), "</th><th>", e(t("Points")), "</th><th>", e(t("What would have been better")),
        "</th><th>", e(t("Ground for the thresholds")), "</th></tr>")
    for _, measure in ipairs(item.measures) do
        w("<tr><td>", e(reasons.measure_name(rubric, item, measure)), "</td><td>", e(reasons.measure_value(measure)),
            "</td><td>", measure.time_s and markup.time(measure.time_s) or "", '</td><td>', number(measure.score, 1),
            "</td><td>", e(measure.better and known(measure.better) or ""), "</td><td>")
        source_cell(w, measure.threshold_source)
        w("</td></tr>")
    end
    w("</table></div>")
end

local function item_row(w, score, item, least)
    w('<tbody class="item"><tr><td class="id">', e(item.id), '</td><td><b>', e(reasons.item_name(score.rubric, item)),
        "</b><ul>")
    if item.anchor then w('<li class="soft">', e(t("This level reads: ")), e(known(item.anchor)), ".</li>") end
    for _, reason in ipairs(reasons.of(score.rubric, item)) do w("<li>", e(reason), "</li>") end
    local way = item.to_four
    if way and #way.errors + #way.measures > 0 then
        w("<li><b>", e(t("For 4 points: ")), "</b>", e(table.concat(reasons.to_four(score.rubric, item), " ")),
            "</li>")
    end
    for _, measure in ipairs(item.given or {}) do
        w('<li class="soft">', e(t("%s: given at the start, not judged.", reasons.measure_name(score.rubric, item,
            measure))), "</li>")
    end
    for _, measure in ipairs(item.hidden or {}) do
        local why = measure.why == "pace" and "%s: not judged, for simulated time ran slower than the clock."
            or "%s: not judged, for what it was operated with does not show it."
        w('<li class="soft">', e(t(why, reasons.measure_name(score.rubric, item, measure))), "</li>")
    end
    w('</ul></td><td class="points">')
    if item.score then
        local share = (item.score - least) / (5 - least)
        w("<b>", number(item.score, 1), '</b> <span class="soft">', e(t("of 5")), '</span><div class="bar"><i class="',
            class_of(share), ('" style="width:%.1f%%"></i></div>'):format(20 * item.score))
    else
        w('<span class="soft">', e(t("N/A, not scored")), "</span>")
    end
    w("</td></tr>")
    if #(item.measures or {}) > 0 then
        w('<tr class="detail"><td></td><td colspan="2">')
        measures_table(w, score.rubric, item)
        w("</td></tr>")
    end
    w("</tbody>")
end

-- What a comparison rests on.
local function standing_told(w, report)
    local score, standing = report.osacss, report.osacss.standing
    if report.begun_at or report.aids or report.input or not standing or not standing.like then return end
    w('<p class="small">', e(t("Comparison: this exercise was completed %d times by virtual surgeons of group %s; the "
        .. "score falls nearer to theirs than to those of the others.", standing.n, listed(standing.like))), " ",
        e(t("Group a stands for fewer than 50 operations, d for over 500; what they are is a model, not people.")), " ",
        e(t("It ")), e(ground(score)), ".</p>")
end

--- The table of items.
function scores.section(w, report)
    local score = report.osacss
    if not score or not score.items then return end
    w("<section><h2>", e(t("Score, item by item")), '</h2><div class="scroll"><table class="items"><thead><tr><th>',
        e(t("Item")), "</th><th>", e(t("Why")), "</th><th>", e(t("Points")), "</th></tr></thead>")
    local least = type(score.least) == "number" and score.least or 1
    for _, item in ipairs(score.items) do item_row(w, score, item, least) end
    w("</table></div>")
    standing_told(w, report)
    w('<p class="soft small">', e(t("Each item has %s to 5 points.", number(least, 0))), " <b>",
        e(t("These scores have not been validated clinically.")), "</b> ",
        e(t("Thresholds marked “proposal” have no published ground; an item that this exercise does not show (N/A) is "
            .. "left out, and the scale shrinks to the others.")), "</p></section>")
end

return scores
