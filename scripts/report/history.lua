-- SPDX-License-Identifier: GPL-3.0-or-later
-- This attempt beside the trainee's earlier ones and beside a reference cohort, where the report has them:
--
--   history: list, oldest first, of { date, score, max, passed, completed, items = { id = score } }
--   cohort:  { group, n, mean, sd, items = { id = mean score }, max }: mean and sd of the total, max of this report if
--            missing
--   pass:    share of the scale from which an attempt passes
--
-- All are shown as shares of the scale, as learning curves are: 0 % where every item has its least points, 100 % where
-- each has its most.

local markup = require "report.markup"
local reasons = require "report.reasons"
local report_words = require "report.words"

local t, known = report_words.t, report_words.known

local history = {}

local e, number = markup.escape, markup.number
local wide, tall, left, right, top, bottom = 620, 240, 46, 16, 28, 44
local now_colour, passed_colour, other_colour, cohort_colour = "#c2570c", "#1e7d4f", "#6d7a86", "#1f5f8b"

local function is_number(x) return type(x) == "number" and x == x end

local most = 5  -- points of an item

local function least_of(report) return is_number(report.osacss.least) and report.osacss.least or 1 end

-- Share of the scale: the total less the least that its items can have, of what they can have beyond that.
local function percent(score, max, least)
    if not is_number(score) or not is_number(max) or max <= 0 then return nil end
    local items = max / most
    return math.max(0, math.min(100, 100 * (score - least * items) / ((most - least) * items)))
end

-- The same of a spread, which has no least.
local function spread(sd, max, least)
    return is_number(sd) and is_number(max) and max > 0 and 100 * sd / ((most - least) * max / most) or nil
end

-- Attempts as the chart has them: { share, passed, completed, date, items, now }.
local function earlier_of(report)
    local list, least = {}, least_of(report)
    for _, attempt in ipairs(type(report.history) == "table" and report.history or {}) do
        local share = type(attempt) == "table" and percent(attempt.score, attempt.max, least)
        if share then
            list[#list + 1] = { share = share, passed = attempt.passed == true, completed = attempt.completed ~= false,
                date = attempt.date, items = type(attempt.items) == "table" and attempt.items or {} }
        end
    end
    return list
end

-- The cohort as the chart has it: { mean, sd, n, group, items }; nil where there is none.
local function cohort_of(report)
    local cohort = type(report.cohort) == "table" and report.cohort or nil
    if not cohort then return nil end
    local max, least = is_number(cohort.max) and cohort.max or report.osacss.max, least_of(report)
    local mean = percent(cohort.mean, max, least)
    return mean and { mean = mean, sd = spread(cohort.sd, max, least), n = is_number(cohort.n) and cohort.n or nil,
        group = cohort.group, items = type(cohort.items) == "table" and cohort.items or {} } or nil
end

local function cohort_band(w, cohort, y_of)
    local sd = cohort.sd or 0
    local high, low = y_of(math.min(100, cohort.mean + sd)), y_of(math.max(0, cohort.mean - sd))
    w(('<rect x="%d" y="%.1f" width="%d" height="%.1f" fill="%s" opacity="0.12"/>'):format(left, high,
        wide - left - right, low - high, cohort_colour))
    w(('<line x1="%d" x2="%d" y1="%.1f" y2="%.1f" stroke="%s" stroke-dasharray="6 4"/>'):format(left, wide - right,
        y_of(cohort.mean), y_of(cohort.mean), cohort_colour))
end

local function pass_line(w, pass, y_of)
    if not is_number(pass) then return end
    local y = y_of(100 * math.max(0, math.min(1, pass)))
    w(('<line x1="%d" x2="%d" y1="%.1f" y2="%.1f" stroke="%s" stroke-width="1.5" stroke-dasharray="2 3"/>'):format(left,
        wide - right, y, y, passed_colour))
    w(('<text class="soft halo" x="%d" y="%.1f">%s</text>'):format(left + 4, y - 4, e(t("pass mark"))))
end

local function axis(w, y_of)
    for value = 0, 100, 20 do
        w(('<line x1="%d" x2="%d" y1="%.1f" y2="%.1f" stroke="#d6dde4"/>'):format(left, wide - right, y_of(value),
            y_of(value)))
        w(('<text class="soft" x="%d" y="%.1f" text-anchor="end">%d %%</text>'):format(left - 6, y_of(value) + 4,
            value))
    end
end

-- "2026-01-02: 34 % of the scale, not completed"
local function dot_text(attempt)
    local text = t("%s: %s %% of the scale", tostring(attempt.date or t("now")), number(attempt.share, 0))
    if not attempt.completed then return text .. t(", not completed") end
    return text .. (attempt.passed and t(", passed") or "")
end

-- Below a dot, within the drawing.
local function not_completed_label(w, x, y)
    local anchor = x > wide - right - 60 and "end" or x < left + 60 and "start" or "middle"
    local shift = anchor == "end" and 8 or anchor == "start" and -8 or 0
    w(('<text class="soft halo" x="%.1f" y="%.1f" text-anchor="%s">%s</text>'):format(x + shift, y + 20, anchor,
        e(t("not completed"))))
end

-- What was not completed, or did not pass, is hollow. labelled: there is room to say so.
local function dot(w, x, y, attempt, labelled)
    local colour = attempt.now and now_colour or attempt.passed and passed_colour or other_colour
    local filled = attempt.completed and (attempt.now or attempt.passed)
    w(('<circle cx="%.1f" cy="%.1f" r="%d" fill="%s" stroke="%s" stroke-width="2"><title>%s</title></circle>'):format(
        x, y, attempt.now and 7 or 5, filled and colour or "#fff", colour, e(dot_text(attempt))))
    if labelled and not attempt.completed then not_completed_label(w, x, y) end
end

-- Numbers of the attempts, not so many that they run into each other.
local function attempt_numbers(w, attempts, x_of)
    local every = math.max(1, math.ceil(#attempts / 20))
    for i = 1, #attempts do
        if i == #attempts or ((i - 1) % every == 0 and #attempts - i >= every) then
            w(('<text class="%s" x="%.1f" y="%d" text-anchor="middle">%d</text>'):format(
                i == #attempts and "strong" or "soft", x_of(i), tall - bottom + 16, i))
        end
    end
    w(('<text class="soft" x="%d" y="%d" text-anchor="end">%s</text>'):format(wide - right, tall - 6, e(t("attempt"))))
end

-- Below the drawing, as text that wraps.
local function legend(w, attempts, cohort)
    w('<p class="legend">')
    local function entry(fill, edge, text)
        w(('<span><i class="dot" style="background:%s;border-color:%s"></i>%s</span>'):format(fill, edge, e(text)))
    end
    local now, passed, failed
    for _, attempt in ipairs(attempts) do
        now = now or attempt.now and attempt
        passed = passed or not attempt.now and attempt.passed
        failed = failed or not attempt.now and not attempt.passed
    end
    entry(now.completed and now_colour or "#fff", now_colour, t("this attempt"))
    if passed then entry(passed_colour, passed_colour, t("passed")) end
    if failed then entry("#fff", other_colour, t("not passed")) end
    if cohort then
        entry("#d2dfe8", "#d2dfe8", cohort.group
            and t("%s: %s", t("cohort, mean and SD"), tostring(known(cohort.group))) or t("cohort, mean and SD"))
    end
    w("</p>")
end

local function curve(w, attempts, cohort, pass)
    local function x_of(i)
        return left + 14 + (wide - left - right - 28) * (#attempts > 1 and (i - 1) / (#attempts - 1) or 0.5)
    end
    local function y_of(value) return tall - bottom - (tall - top - bottom) * value / 100 end
    w(('<svg viewBox="0 0 %d %d" role="img" aria-label="%s">'):format(wide, tall, e(t("Scores of all attempts"))))
    axis(w, y_of)
    if cohort then cohort_band(w, cohort, y_of) end
    pass_line(w, pass, y_of)
    local path = markup.writer()
    for i, attempt in ipairs(attempts) do
        path(i == 1 and "M" or "L", ("%.1f %.1f"):format(x_of(i), y_of(attempt.share)))
    end
    w(('<path d="%s" fill="none" stroke="#8795a1" stroke-width="1.5"/>'):format(path:text()))
    for i, attempt in ipairs(attempts) do dot(w, x_of(i), y_of(attempt.share), attempt, #attempts <= 6) end
    attempt_numbers(w, attempts, x_of)
    w("</svg>")
    legend(w, attempts, cohort)
end

-- Scores of one item on a line from the least to the most points.
local function strip(w, least, now, earlier, cohort)
    local function x_of(score) return 8 + 184 * (math.max(least, math.min(most, score)) - least) / (most - least) end
    w('<svg class="strip" viewBox="0 0 200 20" role="img" aria-label="', e(t("%s to 5 points", number(least, 0))), '">',
        '<line x1="8" x2="192" y1="10" y2="10" stroke="#d6dde4" stroke-width="2"/>')
    for score = math.ceil(least), most do
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

local function change_html(now, last)
    local change = last and now - last
    if not change or math.abs(change) < 0.05 then return "" end
    return (' <span class="%s">%s%s</span>'):format(change > 0 and "tg" or "tb", change > 0 and "+" or "",
        number(change, 1))
end

local function item_row(w, report, item, earlier, cohort)
    local scores = {}
    for _, attempt in ipairs(earlier) do
        local score = attempt.items[item.id]
        if is_number(score) then scores[#scores + 1] = score end
    end
    local of_cohort = cohort and is_number(cohort.items[item.id]) and cohort.items[item.id] or nil
    local last = scores[#scores]
    w('<tr><td class="id">', e(item.id), "</td><td>", e(reasons.item_name(report.osacss.rubric, item)), "</td><td>",
        number(item.score, 1), "</td>")
    if #earlier > 0 then w("<td>", number(last, 1), change_html(item.score, last), "</td>") end
    if cohort then w("<td>", number(of_cohort, 1), "</td>") end
    w("<td>")
    strip(w, least_of(report), item.score, scores, of_cohort)
    w("</td></tr>")
end

local function items_table(w, report, earlier, cohort)
    local function head(text) w("<th>", e(text), "</th>") end
    w('<div class="scroll"><table class="compare"><thead><tr>')
    head(t("Item"))
    head("")
    head(t("Now"))
    if #earlier > 0 then head(t("Last time")) end
    if cohort then head(t("Cohort")) end
    local legend_text = t("%s to 5 points: orange now", number(least_of(report), 0))
    if #earlier > 0 then legend_text = legend_text .. t(", grey before") end
    if cohort then legend_text = legend_text .. t(", blue cohort") end
    head(legend_text)
    w("</tr></thead><tbody>")
    for _, item in ipairs(report.osacss.items or {}) do
        if is_number(item.score) then item_row(w, report, item, earlier, cohort) end
    end
    w("</tbody></table></div>")
end

-- "Attempt 3. The best so far, with 70 % of the scale."
local function own_course(now, earlier)
    local start, mine = t("Attempt %d.", #earlier + 1) .. " ", now.share
    if not now.completed then
        return start .. t("%s %% of the scale for what was done: not completed, and not compared.", number(mine, 0))
            .. " "
    end
    local best
    for _, attempt in ipairs(earlier) do
        if attempt.completed then best = math.max(best or 0, attempt.share) end
    end
    local place = not best and t("The first that was completed, with %s %% of the scale.", number(mine, 0))
        or mine > best + 0.05 and t("The best so far, with %s %% of the scale.", number(mine, 0))
        or mine >= best - 0.05 and t("As good as the best so far, with %s %% of the scale.", number(mine, 0))
        or t("The best so far had %s %% of the scale, this one %s %%.", number(best, 0), number(mine, 0))
    return start .. place .. " "
end

-- "The cohort (2026, 12 trainees) has 64 % ± 9 of the scale."
local function cohort_course(cohort)
    local share = number(cohort.mean, 0) .. " %" .. (cohort.sd and " ± " .. number(cohort.sd, 0) or "")
    local who = {}
    if cohort.group then who[1] = tostring(known(cohort.group)) end
    if cohort.n then
        who[#who + 1] = report_words.count(cohort.n, "%d trainee", "%d trainees", math.floor(cohort.n))
    end
    if #who == 0 then return t("The cohort has %s of the scale.", share) end
    return t("The cohort (%s) has %s of the scale.", table.concat(who, ", "), share)
end

--- The section; none without history or cohort, or where this attempt was not scored.
function history.section(w, report)
    local score = report.osacss
    if type(score) ~= "table" or not percent(score.total, score.max, least_of(report)) then return end
    local earlier, cohort = earlier_of(report), cohort_of(report)
    if #earlier == 0 and not cohort then return end
    local now = { share = percent(score.total, score.max, least_of(report)), now = true,
        completed = report.completed ~= false }
    local attempts = table.move(earlier, 1, #earlier, 1, {})
    attempts[#attempts + 1] = now
    w("<section><h2>", e(cohort and #earlier > 0 and t("Compared with earlier attempts and with others")
        or cohort and t("Compared with others") or t("Compared with earlier attempts")), "</h2><p>",
        e(#earlier > 0 and own_course(now, earlier) or t("This attempt has %s %% of the scale.", number(now.share, 0))
            .. " "), e(cohort and cohort_course(cohort) or ""), '</p><div class="curve">')
    curve(w, attempts, cohort, report.pass)
    w("</div>")
    items_table(w, report, earlier, cohort)
    w('<p class="soft small">', e(t("Shares of the scale: 0 % if every item has its least points, 100 % if every "
        .. "one has its most.")), " ", e(t("Exercises and rubrics change: only attempts at the same version compare "
        .. "exactly.")), " ", e(t("These scores have not been validated clinically.")), "</p></section>")
end

return history
