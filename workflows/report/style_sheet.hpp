#pragma once

namespace mesobridge::workflows {

/// The look of a report. --c0 ... --c6 stand for the palette of the plots, in the light as it is.
inline constexpr char const* style_sheet = R"css(
:root { color-scheme: light dark;
        --paper: #fff; --ink: #1f2328; --soft: #59636e; --line: #d8dee4; --wash: #f6f8fa; --accent: #005a8d;
        --axis: #444; --grid: #e4e4e4; --level: #888;
        --c0: #0072b2; --c1: #d55e00; --c2: #009e73; --c3: #cc79a7; --c4: #e69f00; --c5: #56b4e9; --c6: #000;
        --good: #d9f2e6; --good-ink: #00593f; --bad: #fbe3d6; --bad-ink: #8a3500; --note: #e7eaee; --note-ink: #40474f; }
@media screen and (prefers-color-scheme: dark) {
  :root { --paper: #14181d; --ink: #e3e8ed; --soft: #a3adb8; --line: #343b44; --wash: #1d232a; --accent: #7cc4f0;
          --axis: #a3adb8; --grid: #2c333b; --level: #7d8792;
          --c0: #4aa8e0; --c1: #f28c46; --c2: #2fc49a; --c3: #e09cc2; --c4: #f0b83a; --c5: #8fd0f7; --c6: #f4f4f4;
          --good: #123d2e; --good-ink: #8ce3c0; --bad: #4c2412; --bad-ink: #ffb899; --note: #2b323a; --note-ink: #c3cbd4; } }
* { box-sizing: border-box; }
body { margin: 0; color: var(--ink); background: var(--paper);
       font: 16px/1.55 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif; }
main { max-width: 1120px; margin: 0 auto; padding: 40px 24px 64px; }
h1 { font-size: 30px; line-height: 1.2; margin: 0 0 8px; letter-spacing: -0.01em; overflow-wrap: anywhere; }
h2 { font-size: 21px; margin: 48px 0 12px; padding-top: 16px; border-top: 1px solid var(--line); }
p, li { max-width: 84ch; }
a { color: var(--accent); overflow-wrap: anywhere; }
.lead { font-size: 18px; color: var(--soft); margin: 0 0 24px; }
nav ul { display: flex; flex-wrap: wrap; gap: 4px 18px; list-style: none; font-size: 14px; margin: 24px 0 0; padding: 0; }
nav a { text-decoration: none; }
nav a:hover, nav a:focus { text-decoration: underline; }
figure { margin: 24px 0; }
.drawings { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 440px), 1fr)); gap: 16px; }
.drawings > div { min-width: 0; }
.drawings svg { display: block; width: 100%; height: auto; }
.drawings svg text { fill: var(--ink); }
figcaption, caption { font-size: 14px; color: var(--soft); text-align: left; margin-top: 8px; }
caption { caption-side: bottom; padding-top: 8px; }
.scroll { overflow-x: auto; margin: 20px 0; }
table { border-collapse: collapse; width: 100%; font-size: 13.5px; font-variant-numeric: tabular-nums; }
th { text-align: right; vertical-align: bottom; font-weight: 600; border-bottom: 2px solid var(--line); padding: 6px 7px; }
td { text-align: right; border-bottom: 1px solid var(--line); padding: 6px 7px; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; white-space: normal; }
tbody tr:hover { background: var(--wash); }
.verdicts td, .verdicts th { text-align: left; white-space: normal; vertical-align: top; }
.pill { display: inline-block; min-width: 62px; text-align: center; border-radius: 10px; padding: 1px 10px; font-size: 13px;
        font-weight: 600; white-space: nowrap; }
.passed { background: var(--good); color: var(--good-ink); }
.failed, .warnings { background: var(--bad); color: var(--bad-ink); }
.noted { background: var(--note); color: var(--note-ink); }
.warnings { border-radius: 6px; padding: 10px 16px; margin: 16px 0; }
.warnings ul { margin: 0; padding-left: 18px; }
code, pre { font: 13px/1.5 ui-monospace, SFMono-Regular, Menlo, Consolas, monospace; background: var(--wash); border-radius: 4px; }
code { padding: 1px 4px; overflow-wrap: anywhere; }
pre { padding: 12px 16px; overflow-x: auto; border: 1px solid var(--line); }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 4px 20px; font-size: 14px; }
dt { color: var(--soft); }
dd { margin: 0; overflow-wrap: anywhere; }
.sources { font-size: 14px; }
@media (max-width: 640px) {
  main { padding: 24px 14px 40px; }
  h1 { font-size: 25px; }
  th, td { padding: 5px 6px; }
  dl { grid-template-columns: 1fr; }
  .verdicts thead { display: none; }
  .verdicts tr { display: block; border-bottom: 1px solid var(--line); padding: 8px 0; }
  .verdicts td { display: block; border: 0; padding: 1px 0; }
  .verdicts td:first-child { font-weight: 600; }
  .verdicts td:nth-child(2)::before { content: "Found: "; color: var(--soft); }
  .verdicts td:nth-child(3)::before { content: "Expected: "; color: var(--soft); }
  .verdicts td:nth-child(4):not(:empty)::before { content: "Deviation: "; color: var(--soft); } }
@media print {
  @page { margin: 16mm 14mm; }
  body { font-size: 10.5pt; }
  main { max-width: none; padding: 0; }
  nav { display: none; }
  h2 { margin-top: 24px; }
  h2, caption { break-after: avoid; }
  figure, table, tr, .drawings > div { break-inside: avoid; }
  thead { display: table-header-group; }
  .drawings { grid-template-columns: 1fr 1fr; }
  .scroll { overflow: visible; }
  table { font-size: 7.5pt; }
  th, td { padding: 3px 4px; white-space: normal; }
  .verdicts { font-size: 8.5pt; }
  .pill { min-width: 0; font-size: 8pt; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  pre { white-space: pre-wrap; } }
)css";

} // namespace mesobridge::workflows
