"use strict";
(() => {
  const byId = id => document.getElementById(id);
  const tools = byId("tools"), filter = byId("filter"), hits = byId("hits");
  const objects = [...document.querySelectorAll(".o")];
  const areas = [...document.querySelectorAll(".area")].map(area => ({ at: area, objects: [] }));
  const ACCESS = new Set(["ro", "wo", "rw", "rwr", "rww", "const"]);
  tools.hidden = byId("fold").hidden = false;

  // searchable text of an object or entry: its name without remarks, the name in the file, type, access and PDO
  const words = (at, anchor, name, remarks, cells) => {
    const own = remarks?.firstElementChild?.firstElementChild;
    const texts = [name?.data, own?.tagName === "CODE" ? own.textContent : "", ...cells];
    return { at, hidden: false, anchor: anchor.toLowerCase(), text: texts.join(" ").toLowerCase(), access: cells[1] };
  };
  const texts = cells => [...cells].map(cell => cell.textContent);
  const ofRow = row => {
    const cells = row.cells;
    return words(row, row.id, cells[1].firstChild, cells[1].firstElementChild, [cells[2], cells[3], cells[4]].map(cell => cell.textContent));
  };
  // only the first element of each kind: searching all rows of all objects takes half a second on a large page
  const ofObject = at => {
    const name = at.querySelector("h4").lastChild, remarks = at.querySelector(":scope>.m");
    if (at.tagName !== "DETAILS") return { rows: [], ...words(at, at.id, name, remarks, texts(at.querySelectorAll(":scope>dl>dd")).slice(0, 3)) };
    const rows = at.querySelector("tbody").rows, kind = at.firstElementChild.querySelectorAll(":scope>span");
    return { rows: [...rows].map(ofRow), ...words(at, at.id, name, remarks, texts(kind)) };
  };
  // build the index in idle time
  const index = [];
  const read = idle => {
    while (index.length < objects.length) {
      if (idle?.timeRemaining() < 2) return requestIdleCallback(read);
      const at = objects[index.length], object = ofObject(at);
      areas.find(area => area.at.contains(at)).objects.push(object);
      index.push(object);
    }
    return index;
  };

  // 0x6040, 6040h, 6040:1 and 6040sub1 are equivalent
  const term = word => {
    const place = /^(?:0x)?([0-9a-f]{1,4})h?(?:(?:sub|[:.])(0*)([0-9a-f]*))?$/.exec(word);
    const anchor = place && (place[2] === undefined ? place[1] : `${place[1]}sub${place[3] || (place[2] && "0")}`);
    const start = ACCESS.has(word) && new RegExp(`(^|[^a-z0-9])${word}`);
    return of => start ? of.access === word || start.test(of.text)
      : of.text.includes(word) || (anchor && of.anchor.startsWith(anchor)) || (word.startsWith("sub") && of.anchor.includes(word));
  };

  const show = (of, shown) => { if (of.hidden === shown) of.at.hidden = of.hidden = !shown; };
  const opened = new Set();
  let last = "";
  function apply() {
    const text = filter.value.toLowerCase().trim();
    if (text === last) return;
    last = text;
    const terms = text.split(/\s+/).filter(Boolean).map(term);
    let count = 0;
    for (const object of read()) {
      const isWhole = terms.every(matches => matches(object));
      const found = row => isWhole || terms.every(matches => matches(row) || matches(object));
      const rows = isWhole ? object.rows : object.rows.filter(found);
      const isShown = isWhole || rows.length > 0;
      show(object, isShown);
      if (!isShown) continue;
      count++;
      const kept = new Set(rows);
      for (const row of object.rows) show(row, kept.has(row));
      // open closed sections with matches and close them again when they no longer match; at most 100
      if (isWhole) { if (opened.delete(object)) object.at.open = false; }
      else if (!object.at.open && opened.size < 100) { opened.add(object); object.at.open = true; }
    }
    for (const area of areas) area.at.hidden = area.objects.every(object => object.hidden);
    hits.textContent = !terms.length ? "" : count ? `${count} / ${objects.length}` : hits.dataset.none;
  }
  // the objects are at the end of the page: scroll to the matches
  const section = byId("objects");
  const lead = () => { if (last && section.getBoundingClientRect().top > innerHeight / 2) section.scrollIntoView(); };
  const clear = () => { filter.value = ""; apply(); };

  // shows the target of a link even if it is in a closed section or filtered out
  const reveal = () => {
    let target;
    try { target = byId(decodeURIComponent(location.hash.slice(1))); } catch { return; }
    if (!target) return;
    if (target.closest("[hidden]")) clear();
    for (let at = target; at; at = at.parentElement) if (at.tagName === "DETAILS") at.open = true;
    // on a large page, elements above get their height when drawn: repeat until the target does not move
    let top, still = 0, frames = 30;
    const scroll = () => {
      still = target.getBoundingClientRect().top === top ? still + 1 : 0;
      target.scrollIntoView();
      top = target.getBoundingClientRect().top;
      if (still < 2 && frames--) requestAnimationFrame(scroll);
    };
    scroll();
  };
  let due;
  filter.addEventListener("input", () => { cancelAnimationFrame(due); due = requestAnimationFrame(() => { apply(); lead(); }); });
  filter.addEventListener("keydown", event => { if (event.key === "Escape") clear(); });
  addEventListener("keydown", event => {
    if (event.key !== "/" || event.ctrlKey || event.metaKey || event.altKey || document.activeElement === filter) return;
    event.preventDefault();
    filter.focus();
  });
  const toggle = open => objects.forEach(object => {
    if (object.tagName === "DETAILS" && (open || object.dataset.array !== undefined)) object.open = open;
  });
  byId("expand").addEventListener("click", () => toggle(true));
  byId("collapse").addEventListener("click", () => toggle(false));

  // one shared button: it follows the mouse or focus and offers to copy the name or SDO request of that entry
  const copy = byId("copy"), copies = byId("copies");
  const offer = event => {
    const link = event.target.closest("tr[id],.o")?.querySelector("a");
    if (!link || copies.matches(":popover-open")) return;
    if (link.nextElementSibling !== copy) link.after(copy);
    copy.hidden = false;
  };
  const forms = at => {
    const object = at.closest(".o"), isWhole = at.tagName === "DETAILS", [index, sub = "0"] = at.id.split("sub");
    const hex = sub.padStart(2, "0"), access = (at.cells ?? at.querySelectorAll("dd"))[at.cells ? 3 : 1]?.textContent;
    const { id, c } = object.dataset, own = at === object ? null : at.dataset;
    const found = [["CANopen", isWhole ? index : `${index}:${hex}`]];
    if (!isWhole && access !== "wo") found.push(["SDO", `${document.body.dataset.sdo}#40${index.slice(2)}${index.slice(0, 2)}${hex}00000000`]);
    if (id && (!own || own.id)) found.push(
      ["C", !own ? c : own.c ?? `${c.replace(/_+$/, "")}_${own.id}`],
      ["Rust", own ? id.replace(/INDEX$/, own.id) : id]);
    return found;
  };
  section.addEventListener("pointerover", offer);
  section.addEventListener("focusin", offer);
  copy.addEventListener("click", event => {
    event.preventDefault();
    copies.replaceChildren(...forms(copy.closest("tr[id],.o")).map(([kind, text]) => {
      const button = document.createElement("button"), code = document.createElement("code");
      code.textContent = text;
      button.append(`${kind} `, code);
      button.addEventListener("click", async () => {
        getSelection().selectAllChildren(code);
        await (navigator.clipboard?.writeText(text) ?? Promise.reject()).catch(() => document.execCommand("copy"));
        copies.hidePopover();
        copy.focus();
      });
      return button;
    }));
    copies.showPopover();
    const { left, bottom } = copy.getBoundingClientRect();
    copies.style.left = `${Math.max(8, Math.min(left, innerWidth - copies.offsetWidth - 8))}px`;
    copies.style.top = `${Math.min(bottom + 4, innerHeight - copies.offsetHeight - 8)}px`;
    copies.firstElementChild.focus();
  });
  addEventListener("hashchange", reveal);
  reveal();
  if (window.requestIdleCallback) requestIdleCallback(read);
})();
