"use strict";
// The button "theme" of a page: light or dark, whatever the system says.
const theme = document.getElementById("theme");
const systemDark = matchMedia("(prefers-color-scheme: dark)");

function isDark() {
  const chosen = document.documentElement.dataset.theme;
  return chosen ? chosen === "dark" : systemDark.matches;
}
function themeChanged() {
  theme.textContent = isDark() ? "Light" : "Dark";
  document.dispatchEvent(new Event("themechange"));
}
theme.addEventListener("click", () => {
  document.documentElement.dataset.theme = isDark() ? "light" : "dark";
  themeChanged();
});
systemDark.addEventListener("change", themeChanged);
themeChanged();
