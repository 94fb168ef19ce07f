// Theme, sidebar, search and keys of the site. It runs before the page is drawn, so that no theme flashes.

const html = document.documentElement;
const kept = (key, value) => {
  try { return value === undefined ? localStorage.getItem(key) : localStorage.setItem(key, value); } catch { return null; }
};
const isDark = () => html.dataset.theme ? html.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
if (kept("theme")) html.dataset.theme = kept("theme");
const isWide = matchMedia("(min-width: 1000px)");
const byId = (id) => document.getElementById(id);

function showSidebar(isShown) {
  html.classList.toggle("with-sidebar", isShown);
  byId("menu").ariaExpanded = isShown;
  byId("sidebar").inert = !isShown;
}

// the headings of the page below its line in the sidebar; those of a rule are the same for each
function addHeadings() {
  const line = document.querySelector("site-contents").current;
  const headings = [...document.querySelectorAll("main h2[id]")];
  if (!line || headings.length < 2 || location.pathname.includes("/rules/")) return;
  const list = document.createElement("ul");
  list.ariaLabel = "On this page";
  for (const heading of headings) {
    const link = document.createElement("a");
    link.href = `#${heading.id}`;
    link.textContent = heading.textContent;
    const item = document.createElement("li");
    item.append(link);
    list.append(item);
  }
  line.parentElement.after(list);
}

// lines of a session and of a diff get colours here, code by highlight.js on the pages that have some
function colour() {
  for (const block of document.querySelectorAll("code.language-diff")) {
    block.replaceChildren(...block.textContent.split(/(?<=\n)/).map((text) => {
      const line = document.createElement(text.startsWith("-") ? "del" : text.startsWith("+") ? "ins" : "span");
      line.textContent = text;
      return line;
    }));
  }
  const code = document.querySelectorAll("code:is(.language-rust,.language-c,.language-toml,.language-yaml,.language-python,.language-json,.language-ini)");
  if (code.length === 0) return;
  const script = document.createElement("script");
  script.src = highlighter;
  script.onload = () => code.forEach((block) => hljs.highlightElement ? hljs.highlightElement(block) : hljs.highlightBlock(block));
  document.head.append(script);
}

let pagefind;
async function search() {
  const text = byId("search").value.trim(), results = byId("results");
  results.hidden = text === "";
  if (text === "") return;
  try {
    pagefind ??= await import(new URL(`${path_to_root}pagefind/pagefind.js`, location.href));
  } catch {
    results.textContent = "No search index: .ci/site.sh writes it, and a web server must serve this page.";
    return;
  }
  const found = await pagefind.search(text);
  const pages = await Promise.all(found.results.slice(0, 20).map((result) => result.data()));
  // a newer search may have been faster
  if (byId("search").value.trim() !== text) return;
  results.replaceChildren(...pages.map(({ url, meta, excerpt }) => {
    const link = document.createElement("a"), part = document.createElement("span");
    link.href = url;
    link.textContent = meta.title;
    part.innerHTML = excerpt; // Pagefind escapes the text
    link.append(part);
    return link;
  }));
  if (pages.length === 0) results.textContent = `No page contains ${text}.`;
}

function onKey(event) {
  const results = [...byId("results").children].filter((child) => child.href);
  const at = results.indexOf(document.activeElement);
  if (event.key === "Escape") {
    byId("search").value = "";
    byId("results").hidden = true;
    if (!isWide.matches) showSidebar(false);
    byId("content").focus();
  } else if (/^Arrow(Down|Up)$/.test(event.key) && (at >= 0 || document.activeElement === byId("search"))) {
    event.preventDefault();
    (results[event.key === "ArrowDown" ? at + 1 : at - 1] ?? byId("search")).focus();
  } else if (event.altKey || event.ctrlKey || event.metaKey || event.target.matches("input")) {
    return;
  } else if (event.key === "s" || event.key === "/") {
    event.preventDefault();
    byId("search").focus();
  } else if (event.key === "ArrowLeft" || event.key === "ArrowRight") {
    document.querySelector(event.key === "ArrowLeft" ? "[rel=prev]" : "[rel=next]")?.click();
  }
}

addEventListener("DOMContentLoaded", () => {
  showSidebar(isWide.matches && kept("sidebar") !== "hidden");
  byId("menu").onclick = () => {
    const isShown = !html.classList.contains("with-sidebar");
    showSidebar(isShown);
    if (isWide.matches) kept("sidebar", isShown ? "shown" : "hidden");
  };
  byId("theme").onclick = () => {
    html.dataset.theme = isDark() ? "light" : "dark";
    kept("theme", html.dataset.theme);
  };
  addHeadings();
  document.querySelector("site-contents [aria-current]")?.scrollIntoView({ block: "center" });
  colour();
  // what scrolls sideways must be reached by the keyboard
  for (const block of document.querySelectorAll("pre, .table-wrapper")) block.tabIndex = 0;
  byId("search").oninput = search;
  addEventListener("keydown", onKey);
  const asked = new URLSearchParams(location.search).get("search");
  if (asked) {
    byId("search").value = asked;
    search();
  }
});
