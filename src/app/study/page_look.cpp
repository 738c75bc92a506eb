#include "app/study/page_look.h"

namespace alhazen {
namespace {

// The colours of Okabe and Ito, which every kind of colour sight tells apart, darker on light paper
// and lighter on dark; shapes differ too. s0 to s11 are the knobs in the order of knob.def.
constexpr std::string_view kStyle = R"css(:root {
  --c0: #0072b2; --c1: #d55e00; --c2: #a06a00; --c3: #00795a; --c4: #a8427f; --c5: #2b86b8;
  --c6: #55554f; --c7: #7a5230; --c8: #8a1c1c; --c9: #1c1c1a; --c10: #1c1c1a; --c11: #1c1c1a;
  --front: #f2c230; --shade: #efefe9;
}
@media (prefers-color-scheme: dark) {
  :root {
    --c0: #56b4e9; --c1: #ff8a4c; --c2: #e6b422; --c3: #2fc79a; --c4: #e08fc4; --c5: #9fd4f5;
    --c6: #b9b9b0; --c7: #cfa37a; --c8: #ff8080; --c9: #f0f0ea; --c10: #f0f0ea; --c11: #f0f0ea;
    --front: #7d6412; --shade: #1f1f1d;
  }
}
.lead { font-size: 1.05rem; max-width: 52rem; padding-left: 1.2rem; }
.lead li { margin: 0.35rem 0; max-width: 52rem; }
.chart svg { display: block; width: 100%; height: auto; overflow: visible; }
.chart text { fill: var(--fore); font: 12px system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; }
.chart .tick { fill: var(--quiet); font-variant-numeric: tabular-nums; }
.chart .axis { fill: var(--fore); font-size: 12.5px; }
.chart .note { fill: var(--quiet); font-size: 11px; }
.chart .raised { font-size: 8.5px; }
.chart .label { font-size: 11px; paint-order: stroke; stroke: var(--back); stroke-width: 3px;
  stroke-linejoin: round; fill: var(--c); }
.grid { stroke: var(--line); stroke-width: 1; }
.grid.thin { opacity: 0.45; }
.floor { fill: var(--shade); }
.mark { stroke: var(--quiet); stroke-width: 1; stroke-dasharray: 2 3; }
.guide { stroke: var(--quiet); stroke-width: 1; stroke-dasharray: 6 4; opacity: 0.7; }
.front { fill: none; stroke: var(--front); stroke-width: 9; stroke-linecap: round;
  stroke-linejoin: round; opacity: 0.55; }
.line { fill: none; stroke: var(--c); stroke-width: 1.6; }
.dashed { stroke-dasharray: 3 3; }
.spread { stroke: var(--c); stroke-width: 1.2; opacity: 0.7; }
.faint { fill: var(--quiet); opacity: 0.45; }
.touch { fill: transparent; }
.own { fill: none; stroke: var(--fore); stroke-width: 1.8; }
circle[class^="s"], path[class^="s"] { fill: var(--c); }
.hollow { fill: var(--back) !important; stroke: var(--c); stroke-width: 1.6; }
path.stroke { fill: none !important; stroke: var(--c); stroke-width: 2.4; stroke-linecap: round; }
.s0 { --c: var(--c0); } .s1 { --c: var(--c1); } .s2 { --c: var(--c2); } .s3 { --c: var(--c3); }
.s4 { --c: var(--c4); } .s5 { --c: var(--c5); } .s6 { --c: var(--c6); } .s7 { --c: var(--c7); }
.s8 { --c: var(--c8); } .s9 { --c: var(--c9); } .s10 { --c: var(--c10); }
.s11 { --c: var(--c11); }
.chart a { cursor: pointer; outline: none; }
.chart a:hover .touch, .chart a:focus-visible .touch, .chart a.shown .touch {
  fill: var(--fore); opacity: 0.16; }
.narrow { display: none; }
@media (max-width: 640px) { .wide-chart { display: none; } .narrow { display: block; } }
.legend { display: flex; flex-wrap: wrap; gap: 0.2rem 1.1rem; list-style: none; padding: 0;
  margin: 0.3rem 0 0; max-width: none; font-size: 0.88rem; }
.legend li { display: flex; align-items: center; gap: 0.35rem; }
.key { width: 16px; height: 16px; flex: none; overflow: visible; }
.swatch { width: 22px; height: 9px; border-radius: 5px; background: var(--front); opacity: 0.8; }
.ring { width: 13px; height: 13px; border-radius: 50%; border: 1.8px solid var(--fore); }
.knobs { display: grid; gap: 1.2rem 2rem; margin: 1rem 0;
  grid-template-columns: repeat(auto-fill, minmax(min(100%, 22rem), 1fr)); }
.knobs h3 { margin: 0.3rem 0 0; }
.knobs p { margin: 0 0 0.3rem; font-size: 0.85rem; color: var(--quiet); min-height: 2.5em; }
.points { display: grid; gap: 1rem 1.2rem; margin: 1rem 0;
  grid-template-columns: repeat(auto-fill, minmax(min(100%, 15.5rem), 1fr)); }
.points figure { scroll-margin-top: 1rem; }
.points figure:target { outline: 2px solid var(--quiet); outline-offset: 4px; }
.pair { display: grid; grid-template-columns: 1fr 1fr; gap: 4px; }
.pair img { width: 100%; height: auto; image-rendering: pixelated; display: block; }
.points figcaption, #card figcaption { font-size: 0.82rem; }
figcaption b { display: block; }
#card { position: fixed; z-index: 5; width: 22rem; padding: 0.6rem; border-radius: 6px;
  background: var(--back); border: 1px solid var(--line); box-shadow: 0 4px 18px rgb(0 0 0 / 25%); }
#card[hidden] { display: none; }
@media (max-width: 640px) {
  #card { left: 0 !important; right: 0; bottom: 0; top: auto !important; width: auto;
    border-radius: 10px 10px 0 0; }
}
tr.below td { color: var(--quiet); }
td.lead-cell { white-space: normal; min-width: 14rem; }
)css";

// The pictures of the point under the pointer, beside it. Without scripts a click goes to them.
constexpr std::string_view kScript = R"js((() => {
  "use strict";
  const card = document.createElement("aside");
  card.id = "card";
  card.hidden = true;
  document.body.append(card);
  let pinned = null;

  function place(link) {
    const box = link.getBoundingClientRect(), own = card.getBoundingClientRect();
    const right = box.right + 14 + own.width < innerWidth;
    card.style.left = Math.max(8, right ? box.right + 14 : box.left - own.width - 14) + "px";
    card.style.top = Math.max(8, Math.min(innerHeight - own.height - 8,
                                          box.top + box.height / 2 - own.height / 2)) + "px";
  }
  function show(link) {
    const figure = document.getElementById(link.dataset.point);
    if (!figure) return;
    hide();
    card.replaceChildren(...[...figure.cloneNode(true).childNodes]);
    card.hidden = false;
    link.classList.add("shown");
    place(link);
  }
  function hide() {
    card.hidden = true;
    for (const link of document.querySelectorAll(".chart a.shown")) link.classList.remove("shown");
  }
  for (const link of document.querySelectorAll(".chart a[data-point]")) {
    const title = link.querySelector("title");
    link.setAttribute("aria-label", title.textContent);
    title.remove();
    link.addEventListener("pointerenter", () => { if (!pinned) show(link); });
    link.addEventListener("pointerleave", () => { if (!pinned) hide(); });
    link.addEventListener("focus", () => { if (!pinned) show(link); });
    link.addEventListener("blur", () => { if (!pinned) hide(); });
    link.addEventListener("click", (event) => {
      event.preventDefault();
      event.stopPropagation();
      pinned = pinned === link ? null : link;
      if (pinned) show(link); else hide();
    });
  }
  const close = () => { pinned = null; hide(); };
  document.addEventListener("click", close);
  document.addEventListener("keydown", (event) => { if (event.key === "Escape") close(); });
})();
)js";

}  // namespace

PageExtras study_page_extras() {
  return {kStyle, kScript};
}

}  // namespace alhazen
