#include <gable/engine/drawing/page_style.h>

namespace gable {

const char* const kPageStyle = R"css(
:root { --ink: #2c2e34; --faint: #6e727a; --line: #dcdee2; --paper: #ffffff; --wash: #f5f5f3;
        --accent: #35586e; --warn: #9e4c40; }
* { box-sizing: border-box; }
body { margin: 0; background: var(--wash); color: var(--ink);
       font: 15px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, sans-serif; }
main { max-width: 1440px; margin: 0 auto; padding: 24px; }
h1 { font-size: 24px; font-weight: 600; margin: 0 0 16px; }
h2 { font-size: 17px; font-weight: 600; margin: 32px 0 12px; }
section, figure { background: var(--paper); border: 1px solid var(--line); border-radius: 6px; }
.summary { display: flex; flex-wrap: wrap; gap: 24px 48px; padding: 20px; align-items: flex-start; }
.summary dl { display: grid; grid-template-columns: auto auto; gap: 2px 20px; margin: 0; }
.summary dt { color: var(--faint); }
.summary dd { margin: 0; text-align: right; font-variant-numeric: tabular-nums; }
.summary dt.head { grid-column: 1 / 3; color: var(--ink); font-weight: 600; }
.histogram { flex: 1 1 420px; max-width: 720px; min-width: 300px; font-size: 12px; }
.histogram text { fill: var(--faint); }
.histogram .bar { fill: var(--accent); }
.histogram .grid { stroke: var(--line); }
.histogram .axis { stroke: var(--faint); }
.histogram .median { stroke: var(--warn); stroke-dasharray: 4 3; }
.table { overflow: auto; max-height: 480px; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { padding: 5px 12px; text-align: left; white-space: nowrap; border-bottom: 1px solid var(--line); }
th { position: sticky; top: 0; background: var(--paper); padding: 0; }
th button { all: unset; cursor: pointer; padding: 8px 12px; font-weight: 600; display: block; }
th button:hover, th button:focus-visible { color: var(--accent); text-decoration: underline; }
th[aria-sort=ascending] button::after { content: " \2191"; }
th[aria-sort=descending] button::after { content: " \2193"; }
.number { text-align: right; }
td.reason { white-space: normal; min-width: 16em; }
a { color: var(--accent); }
.extrusion { color: var(--warn); }
.houses { display: grid; gap: 16px; grid-template-columns: repeat(auto-fill, minmax(min(100%, 640px), 1fr)); }
figure { margin: 0; padding: 8px; scroll-margin-top: 12px; }
figure:target { border-color: var(--accent); box-shadow: 0 0 0 2px var(--accent); }
figure img { display: block; width: 100%; height: auto; }
figcaption { padding: 4px 8px 2px; overflow-wrap: anywhere; }
figcaption .figures { color: var(--faint); }
.note { color: var(--faint); margin: 0 0 12px; max-width: 70em; }
@media print {
  body { background: none; font-size: 11px; }
  main { padding: 0; max-width: none; }
  .table { max-height: none; overflow: visible; }
  .table td, .table th, .table th button { padding: 2px 6px; }
  th { position: static; }
  .houses { display: block; }
  figure, tr { break-inside: avoid; }
  figure { margin-bottom: 8px; }
}
)css";

}  // namespace gable
