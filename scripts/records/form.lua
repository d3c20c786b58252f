-- SPDX-License-Identifier: GPL-3.0-or-later
-- The form with which a person rates a replay, without knowing whose it is. Works from a folder, without a network.
--
-- data: case = code of the recording, number, of = which of how many, title = of the exercise, or nil, parts = how many
-- recordings there are (of an operation more than one), videos = files beside the page, in order, or nil, items = ids
-- that the exercise judges, or nil where that is not known, language

local anchors = require "records.anchors"
local markup = require "report.markup"
local osacss = require "osacss"
local page = require "records.page"
local report_words = require "report.words"

local t = report_words.t

local form = {}

local e = markup.escape

local style = [[
body { max-width:76rem; }
.item { border-top:1px solid var(--line); padding:.7rem 0; display:grid; grid-template-columns:3rem 1fr; }
.item.open { background:#fff6ec; }
.choices { display:grid; grid-template-columns:repeat(5,1fr) 6.2rem; gap:.4rem; margin:.4rem 0; }
.choices b { white-space:nowrap; }
.choices label { border:1px solid var(--line); border-radius:8px; padding:.35rem .5rem; font-size:.84rem;
  cursor:pointer; }
.choices label:has(input:checked) { border-color:var(--accent); background:#e7f0f7; }
.choices b { font-size:1rem; margin-right:.3rem; }
input[type=text],textarea { width:100%; font:inherit; font-size:.9rem; padding:.3rem .5rem;
  border:1px solid var(--line);  border-radius:6px; }
button { font:inherit; font-weight:600; padding:.5rem 1.2rem; border:0; border-radius:8px; background:var(--accent);
  color:#fff; cursor:pointer; } button.quiet { background:#e4e9ee; color:var(--ink); }
video { max-width:48rem; }
h3 { margin-top:.8rem; }
summary { cursor:pointer; padding:.7rem 0; border-top:1px solid var(--line); }
.bar-below { position:sticky; bottom:0; display:flex; flex-wrap:wrap; gap:.5rem 1rem; align-items:center; }
@media (max-width:40rem) { .item,.choices { grid-template-columns:1fr; } }
]]

-- Reads the choices and saves them as a file; nothing leaves the computer.
local script = [[
const form = document.forms[0];
const items = [...document.querySelectorAll('.item[id]')];
const chosen = id => form.elements[id].value;
function tell() {
  const open = items.filter(item => !chosen(item.id));
  const said = open.length === 0 ? form.dataset.answered : open.length === 1 ? form.dataset.one : form.dataset.left;
  document.getElementById('left').textContent = said.replace('%d', open.length);
  return open;
}
form.addEventListener('change', event => { const item = event.target.closest('.item[id]');
  if (item) item.classList.remove('open'); tell(); });
document.getElementById('rest').addEventListener('click', () => { for (const item of tell())
  { form.elements[item.id].value = 'na'; item.classList.remove('open'); } tell(); });
document.getElementById('save').addEventListener('click', () => {
  const open = tell();
  items.forEach(item => item.classList.toggle('open', open.includes(item)));
  if (open.length) { open[0].scrollIntoView({ behavior: 'smooth', block: 'center' }); return; }
  const answers = { schema: 1, form: 'OSACSS', case: form.dataset.case, items: {},
    comment: form.elements.comment.value };
  for (const item of items) answers.items[item.id] = {
    score: chosen(item.id) === 'na' ? null : Number(chosen(item.id)),
    comment: form.elements[item.id + '.comment'].value };
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([JSON.stringify(answers, null, 2) + '\n'], { type: 'application/json' }));
  link.download = 'answers_' + form.dataset.case + '.json';
  link.click();
});
tell();
]]

local function choice(w, id, value, label, text, chosen)
    w('<label><input type="radio" name="', id, '" value="', value, '"', chosen and " checked" or "", "> <b>", label,
        "</b>", e(text or ""), "</label>")
end

local function item_rows(w, item, judged)
    local own = anchors[item.id] or {}
    w('<div class="item" id="', item.id, '"><b>', item.id, "</b><div><b>", e(t(item.name)), "</b>")
    w('<div class="choices">')
    for points = 1, 5 do choice(w, item.id, points, points, own[points] and t(own[points])) end
    choice(w, item.id, "na", e(t("N/A")), nil, not judged)
    w('</div><input type="text" name="', item.id, '.comment" placeholder="', e(t("Comment")), '" aria-label="',
        e(t("Comment on %s", item.id)), '"></div></div>')
end

-- Whether the exercise judges an item. Where nothing is known of that, and where it is judged by another rubric than
-- OSACSS, the rater may have something to say on each.
local function judged_by(data)
    local named, known = {}, {}
    for _, id in ipairs(data.items or {}) do named[id] = true end
    for _, item in ipairs(osacss.items) do known[item.id] = named[item.id] end
    return function(id) return next(known) == nil or known[id] == true end
end

-- What there is to watch, if it is here, and what to do then.
local function instructions(w, data)
    if data.title then w("<p><b>", e(data.title), "</b></p>") end
    w("<p>")
    if #(data.videos or {}) > 0 then
        w(e((data.parts or 1) > 1 and t("Watch all parts of the operation, one after the other.") or
            t("Watch the replay of this exercise to its end.")), " ")
    end
    w(e(t("Give each item of OSACSS 1 to 5 points. 2 and 4 lie between the descriptions. N/A: it was not to be seen, "
        .. "or is no part of what you watched.")), " ", e(t("Save, and send the file to who gave you this form.")),
        "</p>")
end

-- What is judged lies open; the rest is folded away, set to N/A.
local function all_items(w, data)
    local judged, folded = judged_by(data), {}
    w("<section>")
    for _, item in ipairs(osacss.items) do
        if judged(item.id) then item_rows(w, item, true) else folded[#folded + 1] = item end
    end
    if #folded > 0 then
        w("<details><summary>", e(t("Items that this exercise does not judge (%d, set to N/A): open them where you "
            .. "have something to say.", #folded)), "</summary>")
        for _, item in ipairs(folded) do item_rows(w, item, false) end
        w("</details>")
    end
    w('<div class="item"><span></span><textarea name="comment" rows="3" placeholder="', e(t("On the whole")),
        '" aria-label="', e(t("Comment on the whole")), '"></textarea></div></section>')
end

local function videos(w, data)
    for i, file in ipairs(data.videos or {}) do
        if #data.videos > 1 then w("<h3>", e(t("Part %d of %d", i, #data.videos)), "</h3>") end
        local link = ('<a href="%s">%s</a>'):format(e(file), e(file))
        w('<video controls preload="metadata" src="', e(file), '"></video><p class="soft small">',
            t("If the video does not play here, open %s, which lies beside this page, in any player.", link), "</p>")
    end
end

--- The whole page.
function form.html(data)
    report_words.use(data.language)
    local title = t("Rating %d of %d", data.number, data.of)
    return page.html(title, function(w)
        w("<header><h1>", e(title), "</h1>")
        instructions(w, data)
        videos(w, data)
        w('</header><form data-case="', e(data.case), '" data-left="', e(t("%d items left")), '" data-one="',
            e(t("1 item left")), '" data-answered="', e(t("All items answered")), '">')
        all_items(w, data)
        w('<section class="bar-below"><button type="button" id="save">', e(t("Save answers")), "</button>",
            '<button type="button" class="quiet" id="rest">', e(t("All that is open: N/A")),
            '</button><span id="left"></span></section></form><script>', script, "</script>")
    end, style)
end

return form
