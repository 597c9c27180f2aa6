#pragma once

namespace nearwall::pipeline {

/// The style sheet of report.html. Colours of limits and shares are the same everywhere on the page.
inline constexpr const char* kReportStyle = R"css(
:root { --ink: #1b2430; --soft: #5c6878; --line: #dfe5ec; --paper: #fff; --ground: #f4f6f9; --accent: #1f5fbf;
  --good: #1e7f4f; --good-soft: #e2f4ea; --bad: #b3261e; --bad-soft: #fbe6e4; }
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; }
body { margin: 0; background: var(--ground); color: var(--ink);
  font: 16px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", "Liberation Sans", Arial, sans-serif; }
main { max-width: 1120px; margin: 0 auto; padding: 32px 24px 56px; }
header { display: flex; flex-wrap: wrap; align-items: center; gap: 8px 18px; margin-bottom: 4px; }
h1 { font-size: 30px; line-height: 1.2; margin: 0; letter-spacing: -0.01em; overflow-wrap: anywhere; }
h2 { font-size: 19px; margin: 0 0 14px; }
h3 { font-size: 14px; margin: 0 0 6px; font-weight: 600; }
p { margin: 0 0 10px; }
a { color: var(--accent); }
.subtitle { color: var(--soft); margin: 0 0 22px; overflow-wrap: anywhere; }
.badge { font-size: 14px; font-weight: 600; padding: 3px 12px; border-radius: 999px; white-space: nowrap; }
.badge.good { color: var(--good); background: var(--good-soft); }
.badge.bad { color: var(--bad); background: var(--bad-soft); }
.cards { display: grid; grid-template-columns: repeat(auto-fit, minmax(150px, 1fr)); gap: 12px; margin-bottom: 20px; }
.card { background: var(--paper); border: 1px solid var(--line); border-radius: 10px; padding: 12px 16px; }
.card b { display: block; font-size: 23px; line-height: 1.25; font-weight: 650; font-variant-numeric: tabular-nums; }
.card span { color: var(--soft); font-size: 13.5px; }
section { background: var(--paper); border: 1px solid var(--line); border-radius: 10px; padding: 20px 22px; margin: 0 0 20px; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-size: 14.5px; font-variant-numeric: tabular-nums; }
th { text-align: right; font-weight: 600; color: var(--soft); font-size: 13px; padding: 4px 10px 7px; vertical-align: bottom;
  border-bottom: 1px solid var(--line); }
td { text-align: right; padding: 8px 10px; border-bottom: 1px solid var(--line); vertical-align: middle; }
tr:last-child td { border-bottom: 0; }
th:first-child, td:first-child { text-align: left; padding-left: 0; }
th:last-child, td:last-child { padding-right: 0; }
td.left, th.left { text-align: left; }
td small { color: var(--soft); font-size: 12.5px; }
tr.short td:first-child { color: var(--bad); font-weight: 600; }
.stack { display: flex; height: 20px; min-width: 220px; border-radius: 4px; overflow: hidden; background: var(--line); }
.stack span { font-size: 11.5px; line-height: 20px; color: #fff; text-align: center; white-space: nowrap; overflow: hidden; }
.full { background: #1f5fbf; } .all { background: #5b93de; } .some { background: #a9772b; } .none { background: #8b95a3; }
.limit-1 { background: #6b4fa0; } .limit-2 { background: #1f7a8c; } .limit-3 { background: #b3541e; } .limit-4 { background: #6d7b8d; }
.limit-5 { background: #b3261e; } .limit-6 { background: #4d7c2a; } .limit-7 { background: #8c2f6b; } .limit-8 { background: #1f5fbf; }
.legend { display: flex; flex-wrap: wrap; gap: 4px 18px; margin: 12px 0 0; color: var(--soft); font-size: 13.5px; }
.legend i { display: inline-block; width: 11px; height: 11px; border-radius: 3px; margin-right: 6px; vertical-align: -1px; }
.charts { display: grid; grid-template-columns: repeat(auto-fill, minmax(290px, 1fr)); gap: 22px 28px; }
.chart { width: 100%; height: auto; display: block; overflow: visible; }
.bar { fill: #8db3e6; } .axis { stroke: #b8c2ce; stroke-width: 1; } .median { stroke: var(--ink); stroke-width: 1; stroke-dasharray: 3 2; }
.label { font-size: 11.5px; fill: var(--soft); } .label.strong { fill: var(--ink); }
.empty { color: var(--soft); }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(320px, 1fr)); gap: 18px; }
figure { margin: 0; } figure img { width: 100%; height: auto; display: block; border: 1px solid var(--line); border-radius: 8px; }
figcaption { color: var(--soft); font-size: 13.5px; margin-top: 6px; }
.columns { display: grid; grid-template-columns: repeat(auto-fit, minmax(300px, 1fr)); gap: 20px 40px; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 4px 18px; margin: 0; font-size: 14.5px; }
dt { color: var(--soft); } dd { margin: 0; overflow-wrap: anywhere; font-variant-numeric: tabular-nums; }
.time { background: #8db3e6; height: 9px; border-radius: 3px; min-width: 1px; }
pre { margin: 0; font: 13px/1.55 ui-monospace, "SFMono-Regular", Menlo, Consolas, "Liberation Mono", monospace; white-space: pre-wrap;
  overflow-wrap: anywhere; }
ul { margin: 0; padding-left: 20px; }
footer { color: var(--soft); font-size: 13px; }
@media (max-width: 640px) { main { padding: 20px 12px 40px; } section { padding: 16px 14px; } h1 { font-size: 24px; } }
@media print { body { background: #fff; font-size: 12px; } main { max-width: none; padding: 0; }
  section, .card { break-inside: avoid; border-color: #ccc; } .stack, .bar, .time, .badge, .legend i { print-color-adjust: exact;
  -webkit-print-color-adjust: exact; } .scroll { overflow: visible; } }
)css";

}  // namespace nearwall::pipeline
