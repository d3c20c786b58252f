-- SPDX-License-Identifier: GPL-3.0-or-later
-- Simulator against raters, and raters among themselves: a table, and a chart after Bland and Altman for each item.
--
-- data: as bindings/records/comparison.hpp tells

local markup = require "report.markup"
local page = require "records.page"
local reasons = require "report.reasons"
local report_words = require "report.words"

local t = report_words.t

local agreement = {}

local e, number = markup.escape, markup.number
local wide, tall, left, right, top, bottom = 500, 250, 44, 116, 12, 36

local function dashed(w, y, colour, text, dash)
    w(('<line x1="%d" x2="%d" y1="%.1f" y2="%.1f" stroke="%s" stroke-dasharray="%s"/>'):format(left, wide - right, y, y,
        colour, dash))
    w(('<text x="%d" y="%.1f" style="fill:%s">%s</text>'):format(wide - right + 5, y + 4, colour, text))
end

-- Points that lie on each other are drawn larger.
local function dots(w, points, x_of, y_of)
    local count, order = {}, {}
    for _, point in ipairs(points) do
        local key = ("%.3f %.3f"):format(point[1], point[2])
        if not count[key] then order[#order + 1] = { key, point } end
        count[key] = (count[key] or 0) + 1
    end
    for _, one in ipairs(order) do
        local key, point = one[1], one[2]
        w(('<circle cx="%.1f" cy="%.1f" r="%.1f" fill="#c2570c" opacity="0.7"><title>%s</title></circle>'):format(
            x_of(point[1]), y_of(point[2]), 3.5 * math.sqrt(count[key]),
            e(t("%d of mean %s, difference %s", count[key], number(point[1], 2), number(point[2], 2)))))
    end
end

local function chart(w, row)
    local limits = row.simulator.limits
    local least, most = row.item == "total" and 20 or 1, row.item == "total" and 100 or 5
    local reach = math.max(math.abs(limits.low), math.abs(limits.high), (most - least) / 8)
    for _, point in ipairs(row.simulator.points) do reach = math.max(reach, math.abs(point[2])) end
    reach = 1.1 * reach
    local function x_of(value) return left + (wide - left - right) * (value - least) / (most - least) end
    local function y_of(value) return top + (tall - top - bottom) * (reach - value) / (2 * reach) end
    w(('<svg viewBox="0 0 %d %d" role="img" aria-label="%s">'):format(wide, tall,
        e(t("Differences against means"))))
    for _, value in ipairs(page.ticks(-reach, reach)) do
        w(('<text class="soft" x="%d" y="%.1f" text-anchor="end">%s</text>'):format(left - 6, y_of(value) + 4,
            number(value, 2)))
    end
    for _, value in ipairs(page.ticks(least, most)) do
        w(('<line x1="%.1f" x2="%.1f" y1="%d" y2="%d" stroke="#eef1f4"/>'):format(x_of(value), x_of(value), top,
            tall - bottom))
        w(('<text class="soft" x="%.1f" y="%d" text-anchor="middle">%s</text>'):format(x_of(value), tall - bottom + 15,
            number(value, 2)))
    end
    local free = true  -- beside the line at 0
    for _, value in ipairs { limits.bias, limits.high, limits.low } do
        free = free and math.abs(y_of(0) - y_of(value)) > 14
    end
    dashed(w, y_of(0), "#8795a1", free and "0" or "", "1 3")
    dashed(w, y_of(limits.bias), "#1f5f8b", e(t("bias %s", number(limits.bias, 2))), "none")
    dashed(w, y_of(limits.high), "#b3261e", e(t("+1.96 SD %s", number(limits.high, 2))), "6 4")
    dashed(w, y_of(limits.low), "#b3261e", e(t("−1.96 SD %s", number(limits.low, 2))), "6 4")
    dots(w, row.simulator.points, x_of, y_of)
    w(('<text class="soft" x="%d" y="%d">%s</text></svg>'):format(left, tall - 4,
        e(t("mean of simulator and raters [points]"))))
end

local function correlation(icc, which)
    return icc.why and '<span class="soft small">' .. e(t(icc.why)) .. "</span>" or number(icc[which], 2)
end

local function range(limits) return e(t("%s to %s", number(limits.low, 2), number(limits.high, 2))) end

-- In the language of the page: what is stored is in that of a run.
local function name_of(row)
    if row.item == "total" then return t("Mean points per item × 20") end
    return reasons.item_name(nil, { id = row.item, name = row.name })
end

local function title_of(item) return item == "total" and t("total") or item end

-- A table of its own section; write(row) writes one of `rows`.
local function table_section(w, title, width, columns, rows, write)
    w("<section><h2>", e(title), "</h2>")
    page.wide_table(w, width, function()
        w("<thead><tr>")
        for _, column in ipairs(columns) do w("<th>", e(column), "</th>") end
        w("</tr></thead><tbody>")
        for _, row in ipairs(rows) do write(row) end
        w("</tbody>")
    end)
    w("</section>")
end

local function table_row(w, row)
    local own, raters = row.simulator, row.raters
    w('<tr><td class="id">', e(title_of(row.item)), "</td><td>", e(name_of(row)), "</td><td>",
        correlation(raters.icc, "single"), "</td><td>", raters.icc.average and number(raters.icc.average, 2) or "",
        "</td><td>", raters.icc.n or "", "</td><td>", correlation(own.icc, "single"), "</td><td>")
    if own.limits.why then
        w('</td><td><span class="soft small">', e(t(own.limits.why)), "</span></td><td>")
    else
        w(number(own.limits.bias, 2), "</td><td class=\"limits\">", range(own.limits), "</td><td>", own.limits.n)
    end
    w("</td></tr>")
end

local function pairs_section(w, row)
    if #row.raters.pairs == 0 then return end
    local columns = { t("Raters"), t("Bias, points"), t("95 % limits, points"), "n" }
    table_section(w, t("Raters among themselves, total"), 24, columns, row.raters.pairs, function(pair)
        local limits = pair.limits
        w("<tr><td>", e(pair.a), " − ", e(pair.b), "</td><td>", limits.bias and number(limits.bias, 2) or "",
            "</td><td>", limits.why and e(t(limits.why)) or range(limits), "</td><td>", limits.n or "", "</td></tr>")
    end)
end

local function items_section(w, rows)
    local columns = { t("Item"), "", t("Raters: ICC(2,1)"), "ICC(2,k)", "n", t("Simulator and raters: ICC(2,1)"),
        t("Bias, points"), t("95 % limits, points"), "n" }
    table_section(w, t("By item"), 44, columns, rows, function(row) table_row(w, row) end)
end

-- The total, for each exercise on its own: raters may agree on one and not on another.
local function exercises_section(w, exercises)
    if #exercises < 2 then return end
    local columns = { t("Exercise"), t("Attempts"), t("Raters: ICC(2,1)"), t("Simulator and raters: ICC(2,1)"),
        t("Bias, points"), t("95 % limits, points") }
    table_section(w, t("By exercise"), 36, columns, exercises, function(one)
        local own, raters = one.total.simulator, one.total.raters
        w("<tr><td>", e(one.title), "</td><td>", one.attempts, "</td><td>", correlation(raters.icc, "single"),
            "</td><td>", correlation(own.icc, "single"), "</td><td>",
            own.limits.why and "" or number(own.limits.bias, 2), '</td><td class="limits">',
            own.limits.why and '<span class="soft small">' .. e(t(own.limits.why)) .. "</span>" or range(own.limits),
            "</td></tr>")
    end)
end

-- "3 rated attempts, 2 raters: R1, R2."
local function who(data)
    local n = #data.raters
    return report_words.count(data.attempts, "%d rated attempt", "%d rated attempts", data.attempts) .. ", "
        .. report_words.count(n, "%d rater: %s.", "%d raters: %s.", n, table.concat(data.raters, ", "))
end

--- The whole page.
function agreement.html(data)
    report_words.use(data.language)
    local title = t("Agreement of simulator and raters")
    return page.html(title, function(w)
        local few = table.concat(data.left_out or {}, ", ")
        w("<header><h1>", e(title), "</h1><p><b>", e(who(data)), "</b>", few ~= "" and " "
            .. e(t("Left out of the correlation among raters, because of too few ratings: %s.", few)) or "",
            '</p><p class="soft small">', e(t("ICC(2,1), ICC(2,k): two-way random "
            .. "effects, absolute agreement (Shrout and Fleiss 1979). Bias: simulator minus mean of the raters, with "
            .. "limits that hold 95 % of the differences if they are normal (Bland and Altman 1986). The scores of the "
            .. "simulator are not clinically validated.")), " ",
            e(t("Points: 1 to 5 of an item, 20 to 100 of the total.")), "</p></header>")
        exercises_section(w, data.exercises or {})
        items_section(w, data.rows)
        pairs_section(w, data.rows[#data.rows])
        w("<section><h2>", e(t("Simulator minus raters")), '</h2><div class="charts">')
        for i = 0, #data.rows - 1 do
            local row = data.rows[i > 0 and i or #data.rows]  -- the total first
            if not row.simulator.limits.why then
                w("<figure><figcaption><b>", e(title_of(row.item)), "</b> ", e(name_of(row)), "</figcaption>")
                chart(w, row)
                w("</figure>")
            end
        end
        w("</div></section>")
    end, "td.limits { white-space:nowrap; }")
end

return agreement
