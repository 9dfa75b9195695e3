"use strict";
const all = () => document.querySelectorAll("details");
// a link to a case opens it
const reveal = () => {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (target && target.tagName === "DETAILS") { target.open = true; target.scrollIntoView(); }
};
addEventListener("hashchange", reveal);
reveal();
const button = document.getElementById("open");
button.addEventListener("click", () => {
  const open = button.textContent === "Open all";
  all().forEach((d) => { d.open = open; });
  button.textContent = open ? "Close all" : "Open all";
});
// paper shows everything
addEventListener("beforeprint", () => all().forEach((d) => { d.open = true; }));
document.getElementById("theme").addEventListener("click", () => {
  const root = document.documentElement;
  const dark = root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
  root.dataset.theme = dark ? "light" : "dark";
});
// the value under the pointer
const note = document.getElementById("note");
addEventListener("pointerover", (e) => {
  const title = e.target.parentElement?.classList.contains("notes") ? e.target.querySelector("title") : null;
  note.hidden = !title;
  if (!title) return;
  note.textContent = title.textContent;
  note.style.left = `${Math.min(e.clientX + 14, innerWidth - note.offsetWidth - 8)}px`;
  note.style.top = `${e.clientY + 18}px`;
});
