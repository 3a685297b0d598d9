"use strict";
const sections = [...document.querySelectorAll("section")];
// The last section that begins above the middle of the window; -1 before the first.
function current() {
  return sections.findLastIndex((section) => section.getBoundingClientRect().top < innerHeight / 3);
}
function go(element) {
  element.scrollIntoView();
  element.focus({ preventScroll: true });
}
document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const at = current();
  if (event.key === "j" && at + 1 < sections.length) go(sections[at + 1]);
  if (event.key === "k" && at > 0) go(sections[at - 1]);
  if (event.key === "t") go(document.getElementById("overview"));
  if (event.key === "s" && at >= 0) {
    const details = sections[at].querySelector("details");
    details.open = !details.open;
  }
});
