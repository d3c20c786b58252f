-- SPDX-License-Identifier: GPL-3.0-or-later
-- This attempt beside the trainee's earlier ones and beside a reference cohort, where the report has them:
--
--   history: list, oldest first, of { date, score, max, passed, items = { id = score } }
--   cohort:  { group, mean, sd, items = { id = mean score }, max }: mean and sd of the total, max of this report if
--            missing

local markup = require "report.markup"
local t = require("report.words").t

local history = {}

local e, number = markup.escape, markup.number
local wide, tall, left, right, top, bottom = 620, 240, 46, 16, 28, 44
local now_colour, passed_colour, other_colour, cohort_colour = "#c2570c", "#1e7d4f", "#6d7a86", "#1f5f8b"

local function is_number(x) return type(x) == "number" and x == x end

local function percent(score, max)
    return is_number(score) and is_number(max) and max > 0 and 100 * score / max or nil
end

local function earlier_of(report)
    local list = {}
    for _, attempt in ipairs(type(report.history) == "table" and report.history or {}) do
        if type(attempt) == "table" and percent(attempt.score, attempt.max) then list[#list + 1] = attempt end
    end
    return list
end

local function cohort_band(w, cohort, max, y_of)
    local mean = percent(cohort.mean, max)
    if not mean then return end
    local sd = percent(cohort.sd, max) or 0
    local high, low = y_of(math.min(100, mean + sd)), y_of(math.max(0, mean - sd))
    w(('<rect x="%d" y="%.1f" width="%d" height="%.1f" fill="%s" opacity="0.12"/>'):format(left, high,
        wide - left - right, low - high, cohort_colour))
    w(('<line x1="%d" x2="%d" y1="%.1f" y2="%.1f" stroke="%s" stroke-dasharray="6 4"/>'):format(left, wide - right,
        y_of(mean), y_of(mean), cohort_colour))
end

local function axis(w, y_of)
    for value = 20, 100, 20 do
        w(('<line x1="%d" x2="%d" y1="%.1f" y2="%.1f" stroke="#d6dde4"/>'):format(left, wide - right, y_of(value),
            y_of(value)))
        w(('<text class="soft" x="%d" y="%.1f" text-anchor="end">%d %%</text>'):format(left - 6, y_of(value) + 4,
            value))
    end
end

local function dot(w, x, y, attempt)
    local colour = attempt.now and now_colour or attempt.passed and passed_colour or other_colour
    local fill = (attempt.now or attempt.passed) and colour or "#fff"
    w(('<circle cx="%.1f" cy="%.1f" r="%d" fill="%s" stroke="%s" stroke-width="2"><title>%s</title></circle>'):format(
        x, y, attempt.now and 7 or 5, fill, colour, e(t("%s: %s of %s points", tostring(attempt.date or t("now")),
            number(attempt.score, 1), number(attempt.max, 0)) .. (attempt.passed and t(", passed") or ""))))
end

-- The first, the last and some of the dates between, so that they do not run into each other.
local function date_labels(w, attempts, x_of)
    local every = math.max(1, math.ceil(#attempts / 6))
    for i, attempt in ipairs(attempts) do
        local last = i == #attempts
        if last or ((i - 1) % every == 0 and #attempts - i >= every) then
            w(('<text class="%s" x="%.1f" y="%d" text-anchor="%s">%s</text>'):format(last and "strong" or "soft",
                x_of(i), tall - 22, last and #attempts > 1 and "end" or i == 1 and #attempts > 1 and "start"
                or "middle", e(last and t("now") or tostring(attempt.date or i):sub(1, 10))))
        end
    end
end

local function legend(w, cohort)
    local x = left
    local function entry(mark, text)
        w(mark:format(x + 6, tall - 6))
        w(('<text class="soft" x="%d" y="%d">%s</text>'):format(math.floor(x + 16), tall - 2, e(text)))
        x = x + 30 + 6.6 * utf8.len(text)
    end
    local circle = '<circle cx="%%.1f" cy="%%d" r="4" fill="%s" stroke="%s" stroke-width="2"/>'
    entry(circle:format(now_colour, now_colour), t("this attempt"))
    entry(circle:format(passed_colour, passed_colour), t("passed"))
    entry(circle:format("#fff", other_colour), t("not passed"))
    if cohort then
        entry(('<circle cx="%%.1f" cy="%%d" r="5" fill="%s" opacity="0.35"/>'):format(cohort_colour),
            t("cohort, mean and SD") .. (cohort.group and ": " .. tostring(cohort.group) or ""))
    end
end

local function curve(w, attempts, cohort, max)
    local function x_of(i)
        return left + 14 + (wide - left - right - 28) * (#attempts > 1 and (i - 1) / (#attempts - 1) or 0.5)
    end
    local function y_of(value) return tall - bottom - (tall - top - bottom) * value / 100 end
    w(('<svg viewBox="0 0 %d %d" role="img" aria-label="%s">'):format(wide, tall, e(t("Scores of all attempts"))))
    axis(w, y_of)
    if cohort then cohort_band(w, cohort, max, y_of) end
    local path = markup.writer()
    for i, attempt in ipairs(attempts) do
        path(i == 1 and "M" or "L", ("%.1f %.1f"):format(x_of(i), y_of(percent(attempt.score, attempt.max))))
    end
    w(('<path d="%s" fill="none" stroke="#8795a1" stroke-width="1.5"/>'):format(path:text()))
    for i, attempt in ipairs(attempts) do dot(w, x_of(i), y_of(percent(attempt.score, attempt.max)), attempt) end
    date_labels(w, attempts, x_of)
    legend(w, cohort)
    w("</svg>")
end

-- Scores of one item on a line from 1 to 5.
local function strip(w, now, earlier, cohort)
    local function x_of(score) return 8 + 184 * (math.max(1, math.min(5, score)) - 1) / 4 end
    w('<svg class="strip" viewBox="0 0 200 20" role="img" aria-label="', e(t("1 to 5 points")), '">',
        '<line x1="8" x2="192" y1="10" y2="10" stroke="#d6dde4" stroke-width="2"/>')
    for score = 1, 5 do
        w(('<line x1="%.1f" x2="%.1f" y1="6" y2="14" stroke="#d6dde4"/>'):format(x_of(score), x_of(score)))
    end
    for _, score in ipairs(earlier) do
        w(('<circle cx="%.1f" cy="10" r="3.5" fill="%s" opacity="0.45"/>'):format(x_of(score), other_colour))
    end
    if cohort then
        w(('<line x1="%.1f" x2="%.1f" y1="1" y2="19" stroke="%s" stroke-width="3"/>'):format(x_of(cohort), x_of(cohort),
            cohort_colour))
    end
    w(('<circle cx="%.1f" cy="10" r="5.5" fill="%s"/></svg>'):format(x_of(now), now_colour))
end

local function item_row(w, item, attempts, cohort)
    local scores = {}
    for _, attempt in ipairs(attempts) do
        local score = type(attempt.items) == "table" and attempt.items[item.id]
        if is_number(score) then scores[#scores + 1] = score end
    end
    local of_cohort = cohort and type(cohort.items) == "table" and cohort.items[item.id]
    if not is_number(of_cohort) then of_cohort = nil end
    local last = scores[#scores]
    local change = last and item.score - last
    w('<tr><td class="id">', e(item.id), "</td><td>", e(item.name), "</td><td>", number(item.score, 1), "</td><td>",
        number(last, 1), change and math.abs(change) >= 0.05 and (' <span class="%s">%s%s</span>'):format(
            change > 0 and "tg" or "tb", change > 0 and "+" or "", number(change, 1)) or "", "</td><td>",
        number(of_cohort, 1), "</td><td>")
    strip(w, item.score, scores, of_cohort)
    w("</td></tr>")
end

-- "Attempt 3. The best so far, with 70 % of its points."
local function own_course(now, earlier)
    local best = 0
    for _, attempt in ipairs(earlier) do best = math.max(best, percent(attempt.score, attempt.max)) end
    local mine = percent(now.score, now.max)
    local place = mine > best + 0.05 and t("The best so far, with %s %% of its points.", number(mine, 0))
        or mine >= best - 0.05 and t("As good as the best so far, with %s %% of its points.", number(mine, 0))
        or t("The best so far had %s %% of its points, this one %s %%.", number(best, 0), number(mine, 0))
    return t("Attempt %d.", #earlier + 1) .. " " .. place .. " "
end

local function cohort_course(cohort, max)
    local mean, sd = percent(cohort.mean, max), percent(cohort.sd, max)
    if not mean then return "" end
    local share = number(mean, 0) .. " %" .. (sd and " ± " .. number(sd, 0) or "")
    if not cohort.group then return t("The cohort has %s.", share) end
    return t("The cohort (%s) has %s.", tostring(cohort.group), share)
end

local function sentence(w, now, earlier, cohort, max)
    local own = #earlier > 0 and own_course(now, earlier) or ""
    w("<p>", e(own), e(cohort and cohort_course(cohort, max) or ""), "</p>")
end

--- The section; none without history or cohort, or where this attempt was not scored.
function history.section(w, report)
    local osacss = report.osacss
    if type(osacss) ~= "table" or not percent(osacss.total, osacss.max) then return end
    local earlier = earlier_of(report)
    local cohort = type(report.cohort) == "table" and report.cohort or nil
    if #earlier == 0 and not cohort then return end
    local max = cohort and is_number(cohort.max) and cohort.max or osacss.max
    local attempts = table.move(earlier, 1, #earlier, 1, {})
    local now = { score = osacss.total, max = osacss.max, now = true }
    attempts[#attempts + 1] = now
    w("<section><h2>", e(cohort and t("Compared with earlier attempts and with others")
        or t("Compared with earlier attempts")), "</h2>")
    sentence(w, now, earlier, cohort, max)
    w('<div class="curve">')
    curve(w, attempts, cohort, max)
    w('</div><table class="compare"><thead><tr><th>', e(t("Item")), "</th><th></th><th>", e(t("Now")), "</th><th>",
        e(t("Last time")), "</th><th>", e(t("Cohort")), "</th><th>",
        e(t("1 to 5 points: orange now, grey before, blue cohort")), "</th></tr></thead><tbody>")
    for _, item in ipairs(osacss.items or {}) do
        if is_number(item.score) then item_row(w, item, earlier, cohort) end
    end
    w('</tbody></table><p class="soft small">', e(t("Shares of the points that could be earned. Exercises and rubrics "
        .. "change: only attempts at the same version compare exactly.")), " ",
        e(t("These scores have not been validated clinically.")), "</p></section>")
end

return history
