// app/page: the large view: the pictures of one row on the same spot, pixel on pixel.
#include "app/page/page_parts.h"

namespace alhazen {

const std::string_view kPageScript = R"js((() => {
  "use strict";
  const view = document.createElement("dialog");
  const label = document.createElement("p");
  const stage = document.createElement("div");
  const image = document.createElement("img");
  stage.append(image);
  view.append(label, stage);
  document.body.append(view);
  let row = [], at = 0, zoom = 1;

  function fitting(picture) {
    const room = Math.min(stage.clientWidth / picture.naturalWidth,
                          stage.clientHeight / picture.naturalHeight);
    return room >= 1 ? Math.floor(room) : room;
  }
  function show(index) {
    at = (index + row.length) % row.length;
    image.src = row[at].src;
    image.alt = row[at].alt;
    image.style.width = row[at].naturalWidth * zoom + "px";
    const size = zoom >= 1 ? zoom + "\u00d7" : Math.round(100 * zoom) + " %";
    label.textContent = (at + 1) + " of " + row.length + ": " + row[at].alt + "  (" + size +
      ")  \u2013  click, space or arrows: next; 1\u2013" + row.length +
      ": that one; + and \u2212: zoom; Esc or this line: close";
  }
  function enlarge(step) {
    const next = step > 0 ? (zoom >= 1 ? zoom + 1 : Math.min(1, zoom * 2))
                          : (zoom > 1 ? zoom - 1 : zoom / 2);
    zoom = Math.min(64, Math.max(1 / 16, next));
    show(at);
  }
  for (const button of document.querySelectorAll(".pictures button")) {
    button.addEventListener("click", () => {
      row = [...button.closest(".pictures").querySelectorAll("img")];
      view.showModal();
      const picture = button.querySelector("img");
      zoom = fitting(picture);
      show(row.indexOf(picture));
    });
  }
  stage.addEventListener("click", () => show(at + 1));
  label.addEventListener("click", () => view.close());
  view.addEventListener("keydown", (event) => {
    if (event.key === " " || event.key === "ArrowRight") show(at + 1);
    else if (event.key === "ArrowLeft") show(at - 1);
    else if (event.key === "+" || event.key === "=") enlarge(1);
    else if (event.key === "-") enlarge(-1);
    else if (event.key >= "1" && event.key <= String(Math.min(9, row.length))) {
      show(Number(event.key) - 1);
    } else return;
    event.preventDefault();
  });
})();
)js";

}  // namespace alhazen
