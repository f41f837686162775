#include "reports/stylesheet.hpp"

namespace wavecurve::reports {

namespace {

// Contrast of every text colour against its ground is at least 4.5 : 1, light and dark.
constexpr std::string_view sheet = R"(:root {
  color-scheme: light dark;
  --ground: #ffffff; --raised: #f6f7f8; --text: #1c2228; --muted: #4f5963; --line: #d3d8dd;
  --link: #0b4f8a; --focus: #b3541e;
  --good: #14532d; --good-ground: #e6f2ea; --partial: #694200; --partial-ground: #faf0da;
  --bad: #851b1b; --bad-ground: #fae8e6; --open: #36424f; --open-ground: #ebeef2;
}
@media screen and (prefers-color-scheme: dark) {
  :root {
    --ground: #15191d; --raised: #1d2227; --text: #e3e7ea; --muted: #a9b3bc; --line: #39424a;
    --link: #8ec1f0; --focus: #f0a36b;
    --good: #a5dcb8; --good-ground: #173524; --partial: #f0cf8e; --partial-ground: #3a2c0e;
    --bad: #f3b3ad; --bad-ground: #45191a; --open: #c3ced9; --open-ground: #2b333c;
  }
}
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; }
body {
  margin: 0 auto; padding: 2rem 1.5rem 4rem; max-width: 68rem;
  background: var(--ground); color: var(--text);
  font: 1rem/1.55 system-ui, "Segoe UI", "Helvetica Neue", Arial, sans-serif;
  overflow-wrap: anywhere;
}
h1, h2, h3 { font-family: Charter, "Bitstream Charter", Georgia, serif; line-height: 1.25; }
h1 { font-size: 1.9rem; margin: 0 0 .5rem; }
h2 { font-size: 1.45rem; margin: 2.5rem 0 .75rem; }
h3 { font-size: 1.2rem; margin: 0 0 .15rem; }
p { max-width: 46rem; margin: .75rem 0; }
a { color: var(--link); text-underline-offset: .15em; }
a:focus-visible, .scroll:focus-visible, section:focus-visible {
  outline: 3px solid var(--focus); outline-offset: 2px;
}
code { font: .9em ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; }
sub, sup { font-size: .75em; line-height: 0; }
.skip { position: absolute; left: -999rem; padding: .5rem 1rem; background: var(--ground); }
.skip:focus { left: 1rem; top: 1rem; z-index: 1; }
header { border-bottom: 1px solid var(--line); padding-bottom: 1rem; }
.publication { margin: 0; }
.dated, .where, .files { color: var(--muted); font-size: .875rem; }
.dated { margin: .25rem 0 .75rem; }
nav a { display: inline-block; margin-right: 1.25rem; padding: .15rem 0; }
.verdict {
  display: inline-block; padding: .05rem .5rem; border: 1px solid currentColor;
  border-radius: .25rem; font-size: .875rem; white-space: nowrap;
}
.good { color: var(--good); background: var(--good-ground); }
.partial { color: var(--partial); background: var(--partial-ground); }
.bad { color: var(--bad); background: var(--bad-ground); }
.open { color: var(--open); background: var(--open-ground); }
.counts { display: flex; flex-wrap: wrap; gap: .4rem 1.25rem; list-style: none; padding: 0; }
.counts strong { font-size: 1.25rem; font-variant-numeric: tabular-nums; margin-right: .15rem; }
table { border-collapse: collapse; font-size: .9rem; line-height: 1.4; }
caption { text-align: left; color: var(--muted); font-size: .875rem; padding: 0 0 .4rem; }
th, td { padding: .35rem .75rem; text-align: left; vertical-align: top; }
thead th { border-bottom: 2px solid var(--line); font-weight: 600; }
tbody th { font-weight: 400; }
tbody tr { border-bottom: 1px solid var(--line); }
.number { text-align: right; font-variant-numeric: tabular-nums; }
td.number, tbody .number { white-space: nowrap; }
.scroll th:first-child, .scroll td:first-child { padding-left: 0; }
.scroll thead th { vertical-align: bottom; min-width: 4rem; max-width: 12rem; }
.summary { width: 100%; }
.summary th, .summary td { padding-left: 0; padding-right: 1rem; }
.summary th:first-child, .summary td { width: 27%; }
.summary td:last-child { width: auto; }
.summary .where { display: block; }
.clamp {
  display: -webkit-box; -webkit-box-orient: vertical; -webkit-line-clamp: 4; overflow: hidden;
}
.claim { border-top: 1px solid var(--line); padding-top: 1.5rem; margin-top: 2rem; }
.claim > .where { margin: 0 0 .75rem; }
dl { margin: 1rem 0; }
dl > div { display: grid; grid-template-columns: 8rem 1fr; gap: .25rem 1rem; padding: .35rem 0; }
.claim > dl { background: var(--raised); border: 1px solid var(--line); padding: .5rem 1rem; }
.meanings > div { grid-template-columns: 14rem 1fr; }
dt { color: var(--muted); }
dd { margin: 0; }
figure { margin: 1.5rem 0 .75rem; }
figure svg {
  display: block; max-width: 100%; height: auto; background: #ffffff; color: #000000;
  border: 1px solid var(--line);
}
figcaption { margin-top: .5rem; max-width: 46rem; }
.scroll { overflow-x: auto; margin: 1rem 0 1.5rem; max-width: 100%; }
.scroll table { overflow-wrap: normal; min-width: min(100%, 34rem); }
.long { max-height: 40rem; overflow-y: auto; border-bottom: 1px solid var(--line); }
.long thead th { position: sticky; top: 0; background: var(--ground); }
.back { font-size: .875rem; }
mark {
  color: var(--bad); background: var(--bad-ground); font-weight: 700;
  text-decoration: underline; text-underline-offset: .2em;
}
.print code {
  display: inline-block; width: max-content; max-width: 15rem; overflow-wrap: anywhere;
}
.sentences { padding-left: 1.25rem; max-width: 60rem; }
fieldset { border: 0; margin: 1rem 0; padding: 0; }
legend { color: var(--muted); font-size: .875rem; padding: 0; }
@media (max-width: 40rem) {
  body { padding: 1.25rem 1rem 3rem; }
  h1 { font-size: 1.5rem; }
  dl > div, .meanings > div { grid-template-columns: 1fr; }
  .summary thead { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
  .summary, .summary caption, .summary tbody, .summary tr, .summary th, .summary td {
    display: block; width: auto;
  }
  .summary tbody th:first-child, .summary tbody td { width: auto; }
  .summary tr { padding: .6rem 0; }
  .summary th, .summary td { padding: .15rem 0; }
  .summary td { display: grid; grid-template-columns: 5.5rem 1fr; }
  .summary td::before { content: attr(data-label); color: var(--muted); font-size: .875rem; }
}
@media print {
  @page { margin: 18mm 16mm; }
  :root { color-scheme: light; }
  body { max-width: none; padding: 0; font-size: 10pt; }
  .skip, nav, .back { display: none; }
  a { color: inherit; text-decoration: none; }
  h1 { font-size: 18pt; }
  h2 { font-size: 14pt; }
  h3 { font-size: 12pt; }
  h2, h3, caption, .claim > .where { break-after: avoid; }
  figcaption { break-before: avoid; }
  .summary, caption, .dated, .where, .files, .verdict { font-size: 8.5pt; }
  figure, .counts, .claim > dl, tr { break-inside: avoid; }
  figure svg { max-width: 150mm; }
  .scroll { overflow: visible; }
  .long { max-height: none; border-bottom: 0; }
  .long thead th { position: static; }
  .scroll table { font-size: 8pt; overflow-wrap: anywhere; }
  .scroll th, .scroll td { padding: .2rem .4rem; }
  .scroll thead th { min-width: 0; }
  .clamp { -webkit-line-clamp: none; display: block; }
  .scroll .checked { font-size: 7pt; overflow-wrap: break-word; }
  .checked .verdict { font-size: 7pt; padding: 0 .25rem; }
  .print code { max-width: 28mm; }
  input { display: none; }
  .verdict { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)";

}  // namespace

std::string_view stylesheet() { return sheet; }

}  // namespace wavecurve::reports
