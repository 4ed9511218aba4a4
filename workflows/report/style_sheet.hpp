#pragma once

namespace mesobridge::workflows {

/// The look of a report.
inline constexpr char const* style_sheet = R"css(
:root { --ink: #1f2328; --soft: #59636e; --line: #d8dee4; --wash: #f6f8fa; --accent: #0072b2; }
* { box-sizing: border-box; }
body { margin: 0; color: var(--ink); background: #fff;
       font: 16px/1.55 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif; }
main { max-width: 980px; margin: 0 auto; padding: 40px 24px 64px; }
h1 { font-size: 30px; line-height: 1.2; margin: 0 0 8px; letter-spacing: -0.01em; }
h2 { font-size: 21px; margin: 48px 0 12px; padding-top: 16px; border-top: 1px solid var(--line); }
.lead { font-size: 18px; color: var(--soft); margin: 0 0 24px; }
nav { display: flex; flex-wrap: wrap; font-size: 14px; margin: 24px 0 0; color: var(--soft); }
nav a { color: var(--accent); text-decoration: none; margin-right: 16px; white-space: nowrap; }
nav a:hover { text-decoration: underline; }
figure { margin: 24px 0; }
.drawings { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 420px), 1fr)); gap: 12px; }
.drawings > div { min-width: 0; }
.drawings svg { display: block; width: 100%; height: auto; }
figcaption, caption { font-size: 14px; color: var(--soft); text-align: left; margin-top: 8px; }
caption { caption-side: bottom; padding-top: 8px; }
.scroll { overflow-x: auto; margin: 20px 0; }
table { border-collapse: collapse; width: 100%; font-size: 14px; font-variant-numeric: tabular-nums; }
th { text-align: right; font-weight: 600; border-bottom: 2px solid var(--line); padding: 6px 10px; }
td { text-align: right; border-bottom: 1px solid var(--line); padding: 6px 10px; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; white-space: normal; }
tbody tr:hover { background: var(--wash); }
.verdicts td, .verdicts th { text-align: left; white-space: normal; vertical-align: top; }
.pill { display: inline-block; min-width: 62px; text-align: center; border-radius: 10px; padding: 1px 10px; font-size: 13px;
        font-weight: 600; }
.passed { background: #d9f2e6; color: #00593f; }
.failed { background: #fbe3d6; color: #8a3500; }
.noted { background: #e7eaee; color: #40474f; }
code, pre { font: 13px/1.5 ui-monospace, SFMono-Regular, Menlo, Consolas, monospace; background: var(--wash); border-radius: 4px; }
code { padding: 1px 4px; }
pre { padding: 12px 16px; overflow-x: auto; border: 1px solid var(--line); }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 4px 20px; font-size: 14px; }
dt { color: var(--soft); }
dd { margin: 0; overflow-wrap: anywhere; }
@media print { main { max-width: none; padding: 0; } h2, figure, tr { break-inside: avoid; } nav { display: none; } }
)css";

} // namespace mesobridge::workflows
