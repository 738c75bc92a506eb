// app/page: colours, sizes, and what becomes of them on a phone and in the dark.
#include "app/page/page_parts.h"

namespace alhazen {

const std::string_view kPageStyle = R"css(:root {
  --back: #fdfdfc; --fore: #1c1c1a; --quiet: #5c5c56; --line: #d8d8d2; --head: #f1f1ed;
  --good: #17692f; --bad: #a31515;
}
@media (prefers-color-scheme: dark) {
  :root {
    --back: #161615; --fore: #e8e8e4; --quiet: #a3a39b; --line: #3a3a37; --head: #232321;
    --good: #6ecf88; --bad: #ff8f85;
  }
}
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; }
body {
  margin: 0; background: var(--back); color: var(--fore);
  font: 16px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "DejaVu Sans", sans-serif;
}
main { max-width: 90rem; margin: 0 auto; padding: 1rem clamp(0.75rem, 3vw, 2.5rem) 3rem; }
h1 { font-size: 1.5rem; line-height: 1.25; margin: 0.5rem 0; overflow-wrap: anywhere; }
h2 { font-size: 1.15rem; margin: 2rem 0 0.5rem; overflow-wrap: anywhere; }
h3 { font-size: 1rem; margin: 1.5rem 0 0.25rem; overflow-wrap: anywhere; }
p, ul, ol, dl { margin: 0.4rem 0; max-width: 45rem; overflow-wrap: anywhere; }
a { color: inherit; }
code { font: 0.9em ui-monospace, "DejaVu Sans Mono", monospace; overflow-wrap: anywhere; }
.quiet, figcaption span { color: var(--quiet); }
.good { color: var(--good); font-weight: 600; }
.bad { color: var(--bad); font-weight: 600; }
dt { font-weight: 600; }
dd { margin: 0 0 0.4rem 1.2rem; }
summary { cursor: pointer; margin-top: 1.5rem; }
.wide { overflow-x: auto; margin: 0.5rem 0; }
table { border-collapse: collapse; font-size: 0.9rem; }
th, td {
  padding: 0.3rem 0.7rem; border-bottom: 1px solid var(--line); text-align: left;
  vertical-align: top; white-space: nowrap;
}
th { background: var(--head); font-weight: 600; }
th[title] { text-decoration: underline dotted; cursor: help; }
.number { text-align: right; font-variant-numeric: tabular-nums; }
.pictures {
  display: grid; gap: 1rem; margin: 1rem 0;
  grid-template-columns: repeat(auto-fill, minmax(min(100%, 30rem), 1fr));
}
.three { grid-template-columns: repeat(auto-fill, minmax(min(100%, 20rem), 1fr)); }
figure { margin: 0; }
figure button {
  display: block; width: 100%; padding: 0; border: 1px solid var(--line); background: none;
  cursor: zoom-in;
}
figure button:focus-visible { outline: 3px solid var(--quiet); }
figure img { display: block; width: 100%; height: auto; }
figure img.small { image-rendering: pixelated; }
figcaption { font-size: 0.85rem; line-height: 1.4; padding-top: 0.3rem; }
figcaption strong::after { content: " \2014 "; font-weight: 400; }
.ramp { display: flex; max-width: 30rem; margin: 0.3rem 0 1.2rem; font-size: 0.85rem; gap: 0.6rem; }
.ramp div { flex: 1; border: 1px solid var(--line); }
dialog {
  border: 0; margin: 0; padding: 0; width: 100vw; height: 100vh; height: 100dvh;
  max-width: none; max-height: none; background: #111; color: #eee;
}
dialog[open] { display: flex; flex-direction: column; }
dialog p { margin: 0; padding: 0.4rem 0.8rem; max-width: none; font-size: 0.85rem; }
dialog div { flex: 1; overflow: auto; display: flex; cursor: pointer; }
dialog img { margin: auto; image-rendering: pixelated; flex: none; }
)css";

}  // namespace alhazen
