-- SPDX-License-Identifier: GPL-3.0-or-later
-- What happened when: the time line, and errors with what was measured at them.

local markup = require "report.markup"
local quantity = require "report.quantity"
local report_words = require "report.words"
local time_line = require "report.time_line"

local t, known = report_words.t, report_words.known

local events = {}

local e, time = markup.escape, markup.time

local outcomes = { recovered = { "put right", "good" }, near_miss = { "near miss", "good" },
    not_recovered = { "not put right in time", "bad" }, open = { "not put right", "bad" } }

local function consequences_html(consequences)
    local parts, names = {}, {}
    for _, text in ipairs(consequences and consequences.texts or {}) do parts[#parts + 1] = e(known(text)) end
    for name in pairs(consequences and consequences.settings or {}) do names[#names + 1] = name end
    table.sort(names)
    for _, name in ipairs(names) do
        local meaning, value = quantity.parts(name, consequences.settings[name])
        parts[#parts + 1] = ('<span title="%s">%s</span>'):format(e(name), e(t("%s set to %s", meaning, value)))
    end
    return table.concat(parts, " ")
end

local function occurrence(w, event)
    local outcome = outcomes[event.outcome] or outcomes[event.recovered and "recovered" or "not_recovered"]
    w("<li>", e(t("at %s", time(event.time_s))), ' <span class="tag ', outcome[2], '">', e(t(outcome[1])),
        event.recovery_s and e(t(" after %s", time(event.recovery_s))) or "", "</span>",
        event.given and (' <span class="tag">' .. e(t("given at the start")) .. "</span>") or "")
    local followed = consequences_html(event.consequences)
    if followed ~= "" then
        w('<br><span class="soft small">', e(t("What the exercise let follow: ")), followed, "</span>")
    end
    local evidence = quantity.all(event.evidence, quantity.measure)
    if evidence ~= "" then w('<br><span class="soft small">', e(t("Measured then: ")), evidence, "</span>") end
    w("</li>")
end

-- All occurrences of one error.
local function event_card(w, same)
    local first = same[1]
    w('<div class="event ', first.severity == "minor" and "minor" or "", '"><h3>', e(known(first.title or first.id)),
        "</h3>")
    if first.cue then w("<p><b>", e(t("What shows it:")), "</b> ", e(known(first.cue)), "</p>") end
    if first.advice then w("<p><b>", e(t("What to do:")), "</b> ", e(known(first.advice)), "</p>") end
    w("<ul>")
    for _, event in ipairs(same) do occurrence(w, event) end
    w("</ul></div>")
end

local function event_cards(w, made)
    local order, by_id = {}, {}
    for _, event in ipairs(made) do
        if not by_id[event.id] then
            by_id[event.id] = {}
            order[#order + 1] = event.id
        end
        table.insert(by_id[event.id], event)
    end
    for _, id in ipairs(order) do event_card(w, by_id[id]) end
end

--- The section.
function events.section(w, report)
    local steps, made = report.steps or {}, report.events or {}
    w("<section><h2>", e(t("What happened when")), "</h2>")
    if #steps > 0 and (report.duration_s or 0) > 0 then
        w('<div class="scroll timeline">', time_line.svg(steps, made, report.requests or {}, report.duration_s),
            "</div>")
        w('<p class="soft small">', e(t("Green: step completed. Grey: not completed.")), "</p>")
    end
    event_cards(w, made)
    w("</section>")
end

return events
