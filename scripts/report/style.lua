-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a report looks, on screen and on paper.

return [[
:root { --ink:#1d2630; --soft:#52606d; --line:#d6dde4; --paper:#fff; --back:#f2f5f8; --accent:#1f5f8b;
  --good:#1e7d4f; --fair:#a86500; --bad:#b3261e; }
* { box-sizing:border-box; }
html { font:16px/1.5 system-ui,"Segoe UI","Liberation Sans",Arial,sans-serif; color:var(--ink);
  background:var(--back); }
body { margin:0 auto; max-width:66rem; padding:1.5rem; }
header,section { background:var(--paper); border:1px solid var(--line); border-radius:10px; padding:1.25rem 1.5rem;
  margin-bottom:1.25rem; }
h1 { font-size:1.7rem; line-height:1.2; margin:0 0 .25rem; }
h2 { font-size:1.2rem; margin:0 0 .75rem; }
h3 { font-size:1rem; margin:0; }
p { margin:.35rem 0; max-width:46rem; }
.soft { color:var(--soft); }
.small { font-size:.86rem; }
.head { display:grid; grid-template-columns:1fr auto; gap:1.5rem; align-items:center; }
.score { text-align:center; min-width:11rem; max-width:14rem; }
.score b { display:block; font-size:2.6rem; line-height:1.1; font-variant-numeric:tabular-nums; }
.band { display:inline-block; padding:.15rem .7rem; border-radius:1rem; color:#fff; font-weight:600; font-size:.9rem; }
.good { background:var(--good); } .fair { background:var(--fair); } .bad { background:var(--bad); }
.none { background:var(--soft); }
.tg { color:var(--good); } .tf { color:var(--fair); } .tb { color:var(--bad); }
.facts { display:flex; flex-wrap:wrap; gap:.3rem 1.5rem; margin:.75rem 0 0; padding:0; list-style:none; }
.facts b { font-weight:600; }
ol.advice { margin:.5rem 0 0; padding-left:1.3rem; } ol.advice li { margin:.3rem 0; max-width:46rem; }
table { border-collapse:collapse; width:100%; font-variant-numeric:tabular-nums; }
th,td { text-align:left; vertical-align:top; padding:.5rem .6rem; border-bottom:1px solid var(--line); }
th { font-size:.82rem; color:var(--soft); font-weight:600; }
tr:last-child td { border-bottom:0; }
tbody.item:not(:last-child) tr:last-child > td { border-bottom:1px solid var(--line); }
.measures tr:last-child > td { border-bottom:0 !important; }
td.id { white-space:nowrap; font-weight:600; }
td.points { white-space:nowrap; width:8.5rem; }
.bar { height:.5rem; border-radius:9px; background:#e4e9ee; overflow:hidden; margin-top:.3rem; }
.bar i { display:block; height:100%; }
td ul { margin:0; padding-left:1.1rem; } td li { margin:.15rem 0; }
.measures { margin-top:.5rem; font-size:.82rem; color:var(--soft); }
.measures { table-layout:fixed; } .measures td,.measures th { padding:.15rem .5rem .15rem 0; border:0; }
.measures th:nth-child(2) { width:5.9rem; } .measures th:nth-child(3) { width:5.6rem; }
.measures th:nth-child(4) { width:3.6rem; } .measures th:nth-child(5) { width:24%; }
.measures th:nth-child(6) { width:26%; }
tr:has(+ .detail) > td { border-bottom:0; } .detail > td { padding-top:0; }
.src { border:1px solid var(--line); border-radius:5px; padding:0 .3rem; font-size:.74rem; white-space:nowrap; }
.curve { max-width:44rem; } .compare td { padding:.25rem .5rem; } .compare td:nth-child(n+3) { white-space:nowrap; }
.strip { width:12rem; min-width:8rem; } svg .strong { font-weight:600; }
.event { border-left:5px solid var(--bad); padding:.2rem 0 .2rem 1rem; margin:.9rem 0; }
.event ul { margin:.3rem 0; padding-left:1.1rem; }
.event.minor { border-color:var(--fair); }
.tag { font-size:.8rem; font-weight:600; padding:.05rem .5rem; border-radius:6px; color:#fff; vertical-align:.1em; }
figure { margin:0; break-inside:avoid; }
figure img { width:100%; border-radius:8px; display:block; background:#000; }
video { width:100%; max-width:40rem; border-radius:8px; display:block; background:#000; }
figcaption { font-size:.86rem; margin-top:.35rem; }
.pictures { display:grid; grid-template-columns:repeat(auto-fill,minmax(17rem,1fr)); gap:1.1rem; }
.charts { display:grid; grid-template-columns:repeat(auto-fit,minmax(min(26rem,100%),1fr)); gap:1.25rem; }
svg { width:100%; height:auto; display:block; }
svg text { font:12px system-ui,"Liberation Sans",Arial,sans-serif; fill:var(--ink); }
svg .soft { fill:var(--soft); } svg .halo { paint-order:stroke; stroke:#fff; stroke-width:3px; }
.legend { display:flex; flex-wrap:wrap; gap:0 1rem; margin:.1rem 0 0 2.4rem; font-size:.8rem; }
.legend i { display:inline-block; width:1rem; height:.28rem; border-radius:2px; margin-right:.35rem;
  vertical-align:middle; }
.legend i.dot { width:.7rem; height:.7rem; border-radius:50%; border:2px solid; }
.scroll { overflow-x:auto; } .timeline svg { min-width:40rem; } .quantity b { font-weight:600; white-space:nowrap; }
.unit { white-space:nowrap; } h3.after { margin-top:1rem; }
footer { color:var(--soft); font-size:.82rem; padding:0 .5rem 1rem; }
code { font-family:ui-monospace,"Liberation Mono",monospace; font-size:.8rem; overflow-wrap:anywhere; }
@media (max-width:40rem) { .head { grid-template-columns:1fr; } .charts { grid-template-columns:1fr; }
  body { padding:.6rem; } header,section { padding:1rem .8rem; } th,td { padding:.4rem .3rem; }
  .measures { min-width:46rem; } .compare { min-width:32rem; } .items,.items thead,.items tbody.item,
  .items > tbody > tr,.items > tbody > tr > td { display:block; } .items > thead { display:none; }
  .items > tbody > tr > td { border:0 !important;
  padding:.2rem 0; } .items > tbody.item { border-bottom:1px solid var(--line);
  padding:.5rem 0; } td.points { width:auto; } h1 { font-size:1.4rem; overflow-wrap:anywhere; } }
@page { size:A4; margin:14mm 13mm 16mm; }
@media print { h2,h3,h2 + p.small { break-after:avoid; } .charts figure,.curve,.background,svg { break-inside:avoid; }
  thead { display:table-header-group; } tr:not(.detail) { break-inside:avoid; }
  tr:has(+ .detail),.measures tr:nth-child(-n+2) { break-after:avoid; }
  .measures tr:nth-last-child(2) { break-after:avoid; }
  .video { display:none; } html { background:#fff; font-size:9.5pt; } body { max-width:none; padding:0; }
  header,section { border:0; padding:.4rem 0; } .event,figure { break-inside:avoid; }
  .scroll { overflow:visible; } .timeline svg { min-width:0; }
  * { -webkit-print-color-adjust:exact; print-color-adjust:exact; } p,li { orphans:3; widows:3; }
  .charts svg text { font-size:17px; } .charts figure.way svg text { font-size:12px; }
  .charts { grid-template-columns:1fr 1fr; } .pictures { grid-template-columns:repeat(3,1fr); } }
]]
