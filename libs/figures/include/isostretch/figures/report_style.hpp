#pragma once

namespace isostretch::figures::html {

/// The style of reports, for page(): narrow screens scroll wide tables by themselves, paper gets no shadows
/// and whole figures.
inline constexpr const char* report_style = R"(:root { color-scheme: light; }
body { font: 16px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", sans-serif; color: #222;
  background: #fff; max-width: 62rem; margin: 0 auto; padding: 1.5rem 1rem 3rem; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0 0 .6rem; overflow-wrap: anywhere; }
h2 { font-size: 1.15rem; margin: 2.2rem 0 .6rem; }
h3 { font-size: 1rem; margin: 0 0 .3rem; }
.verdict { padding: .6rem .9rem; border-left: 4px solid #3c7d50; background: #f1f7f2; margin: 0 0 1rem; }
.verdict.bad { border-color: #b8442e; background: #fbf1ee; }
.warnings { padding-left: 1.2rem; color: #8a2f1c; }
figure { margin: 1.4rem 0; }
img { display: block; width: 100%; height: auto; }
.frame-picture[hidden] { display: none; }
.player { display: flex; gap: .8rem; align-items: center; margin-top: .4rem; }
.player input { flex: 1; }
figcaption { color: #555; font-size: .9rem; margin-top: .4rem; }
.facts { display: grid; grid-template-columns: repeat(auto-fill, minmax(17rem, 1fr)); gap: 1.6rem 2.2rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-size: .9rem; font-variant-numeric: tabular-nums; }
th, td { text-align: left; vertical-align: top; padding: .22rem .8rem .22rem 0; border-bottom: 1px solid #e4e4e4; }
th { font-weight: 600; white-space: nowrap; border-bottom-color: #999; }
td { overflow-wrap: anywhere; }
th:last-child, td:last-child { padding-right: 0; }
.number { text-align: right; }
td.number { white-space: nowrap; }
.wide td { overflow-wrap: normal; }
footer { margin-top: 2.5rem; color: #666; font-size: .85rem; }
@media print {
  body { max-width: none; padding: 0; font-size: 10.5pt; }
  figure, tr, section { break-inside: avoid; }
  h2 { break-after: avoid; }
  .verdict { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)";

}  // namespace isostretch::figures::html
