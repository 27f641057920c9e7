#pragma once

namespace brouwer {

/// The style sheet of a report: system fonts, colours for light and dark screens, figures on white.
inline constexpr char const* report_style = R"css(
:root { color-scheme: light dark; --ink: #1c1c1c; --quiet: #5c5c5c; --paper: #ffffff; --line: #dcdcdc;
        --tint: #f5f6f8; --good: #00704e; --bad: #b23c00; --blue: #00588c; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e8e8e8; --quiet: #a4a4a4; --paper: #17181a; --line: #3a3c40; --tint: #212327;
          --good: #4fd0a4; --bad: #ff9a62; --blue: #7cc4f2; } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 76rem; padding: 2rem 1.25rem 4rem; background: var(--paper); color: var(--ink);
       font: 16px/1.5 system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif; }
h1 { font-size: 1.7rem; line-height: 1.25; margin: 0 0 .5rem; }
h2 { font-size: 1.2rem; margin: 2.5rem 0 .75rem; padding-bottom: .25rem; border-bottom: 1px solid var(--line); }
.title, cite, .legend, figcaption { color: var(--quiet); }
.title { margin: 0; letter-spacing: .03em; }
.summary { font-weight: 600; }
.pass.summary, .pass .mark { color: var(--good); }
.fail.summary, .fail .mark { color: var(--bad); }
.mark { font-weight: 700; text-transform: uppercase; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .9rem; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .75rem .3rem 0; text-align: left; vertical-align: top; }
thead th { border-bottom: 2px solid var(--line); white-space: nowrap; }
tbody tr + tr td { border-top: 1px solid var(--line); }
td.number, th.number { text-align: right; white-space: nowrap; }
tr.cell th { padding-top: .9rem; font-style: italic; font-weight: 600; }
.legend { font-size: .85rem; padding-left: 1.1rem; }
.verdicts { list-style: none; padding: 0; }
.verdicts li { margin: .5rem 0; }
.verdict { padding: .1rem .5rem; border-radius: .6rem; background: var(--tint); color: var(--blue); font-size: .85rem;
           font-weight: 600; white-space: nowrap; }
.verdict.drift, .verdict.superlinear, .verdict.persistent-slopes { color: var(--bad); }
.verdict.random-walk, .verdict.bounded, .verdict.exact { color: var(--good); }
figure { margin: 1.5rem 0; }
figure svg { display: block; width: 100%; height: auto; background: #ffffff; border: 1px solid var(--line);
             border-radius: .4rem; color: #000000; }
figcaption { font-size: .9rem; margin-top: .4rem; }
dl { display: grid; grid-template-columns: max-content auto; gap: .2rem 1.25rem; }
dt { color: var(--quiet); }
dd { margin: 0; }
details { margin: .5rem 0; }
summary { cursor: pointer; }
pre { overflow-x: auto; padding: .75rem 1rem; background: var(--tint); border-radius: .4rem; font-size: .85rem; }
@media print { body { max-width: none; padding: 0; } figure, tr { break-inside: avoid; } }
)css";

}  // namespace brouwer
