"use strict";
(() => {
  const byId = id => document.getElementById(id);
  const tools = byId("tools"), filter = byId("filter"), hits = byId("hits");
  const objects = [...document.querySelectorAll(".o")];
  const ACCESS = new Set(["ro", "wo", "rw", "rwr", "rww", "const"]);
  tools.hidden = false;

  // shows what an address names, though it lies in something that is closed or filtered away
  const reveal = () => {
    const target = byId(decodeURIComponent(location.hash.slice(1)));
    if (!target) return;
    if (target.closest("[hidden]")) { filter.value = ""; apply(); }
    for (let at = target; at; at = at.parentElement) if (at.tagName === "DETAILS") at.open = true;
    target.scrollIntoView();
  };

  // what an object or entry is found by; the name without its remarks
  const words = (anchor, name, cells) => ({
    anchor: anchor.toLowerCase(),
    text: [anchor, anchor.replace("sub", ":"), name, ...cells].join(" ").toLowerCase(),
    access: cells[1] || "",
  });
  let index;
  const read = () => index ??= objects.map(object => {
    const heading = object.querySelector("h4").textContent;
    if (object.tagName !== "DETAILS") {
      const cells = [...object.querySelectorAll(":scope > dl > dd")].map(cell => cell.textContent);
      return { object, rows: [], ...words(object.id, heading, cells) };
    }
    const rows = [...object.querySelectorAll("tbody > tr")].map(row => ({
      row, ...words(row.id, row.cells[1].textContent, [...row.cells].slice(2, 5).map(cell => cell.textContent)),
    }));
    return { object, rows, ...words(object.id, heading, []) , kind: object.querySelector("summary span").textContent.toLowerCase() };
  });

  // 0x6040, 6040h, 6040:1 and 6040sub1 name the same
  const term = word => {
    const place = /^(?:0x)?([0-9a-f]{1,4})h?(?:(?:sub|[:.])0*([0-9a-f]*))?$/.exec(word);
    const anchor = place && (place[2] === undefined ? place[1] : `${place[1]}sub${place[2] || (/0$/.test(word) ? "0" : "")}`);
    const start = new RegExp(`(^|[^a-z0-9])${word.replace(/[^a-z0-9]/g, "\\$&")}`);
    return of => ACCESS.has(word)
      ? of.access === word || start.test(of.text)
      : (anchor && of.anchor.startsWith(anchor)) || of.text.includes(word) || (of.kind || "").includes(word);
  };

  const closed = new Set();
  function apply() {
    const terms = filter.value.toLowerCase().split(/\s+/).filter(Boolean).map(term);
    let count = 0;
    for (const entry of read()) {
      const { object, rows } = entry;
      const whole = terms.every(matches => matches(entry));
      const found = whole ? rows : rows.filter(row => terms.every(matches => matches(row) || matches(entry)));
      const shown = whole || found.length > 0;
      count += shown ? 1 : 0;
      object.hidden = !shown;
      if (!rows.length || !shown) continue;
      for (const row of rows) row.row.hidden = false;
      if (!whole) {
        const kept = new Set(found);
        for (const row of rows) row.row.hidden = !kept.has(row);
        if (!object.open) { closed.add(object); object.open = true; }
      } else if (closed.delete(object)) object.open = false;
    }
    for (const area of document.querySelectorAll(".area")) area.hidden = !area.querySelector(".o:not([hidden])");
    hits.textContent = !terms.length ? "" : count ? `${count} / ${objects.length}` : hits.dataset.none;
  }

  let due;
  filter.addEventListener("input", () => { cancelAnimationFrame(due); due = requestAnimationFrame(apply); });
  filter.addEventListener("keydown", event => { if (event.key === "Escape") { filter.value = ""; apply(); } });
  addEventListener("keydown", event => {
    if (event.key === "/" && !event.ctrlKey && !event.metaKey && !event.altKey && document.activeElement !== filter) { event.preventDefault(); filter.focus(); }
  });
  const toggle = open => objects.forEach(object => {
    if (object.tagName === "DETAILS" && (open || object.dataset.array !== undefined)) object.open = open;
  });
  byId("expand").addEventListener("click", () => toggle(true));
  byId("collapse").addEventListener("click", () => toggle(false));
  addEventListener("hashchange", reveal);
  reveal();
})();
