"use strict";
(() => {
  const byId = id => document.getElementById(id);
  const filter = byId("filter"), hits = byId("hits"), all = byId("all"), table = byId("devices"), body = table.tBodies[0];
  const spoken = (at, ...of) => ({ at, text: of.map(part => part.textContent).join(" ").toLowerCase() });
  const devices = [...body.rows].map(row => spoken(row, row));
  let places;
  byId("tools").hidden = false;

  // devices are searched by the text of their row, objects by place and name: `0x6040`, `6040h` and `6040` are equivalent
  filter.addEventListener("input", () => {
    const terms = filter.value.toLowerCase().split(/\s+/).filter(Boolean).map(word => word.replace(/^([0-9a-f]{4})h/, "$1"));
    const found = of => terms.every(term => of.text.includes(term));
    const ofDevices = devices.filter(of => !(of.at.hidden = !found(of))).length;
    places ??= [...all.querySelectorAll("li")].map(item => spoken(item, item.children[0], item.children[1]));
    const ofPlaces = places.filter(of => !(of.at.hidden = !found(of))).length;
    all.open = terms.length > 0 && ofPlaces > 0;
    hits.textContent = !terms.length ? "" : ofDevices + ofPlaces ? `${ofDevices} + ${ofPlaces}` : hits.dataset.none;
  });

  for (const head of table.tHead.rows[0].cells) {
    const button = document.createElement("button");
    button.append(...head.childNodes);
    head.append(button);
    button.addEventListener("click", () => {
      const isUp = head.ariaSort !== "ascending", column = head.cellIndex;
      for (const other of table.tHead.rows[0].cells) other.ariaSort = null;
      head.ariaSort = isUp ? "ascending" : "descending";
      const key = row => row.cells[column]?.textContent ?? "";
      const sorted = [...body.rows].sort((a, b) => key(a).localeCompare(key(b), undefined, { numeric: true }));
      body.append(...(isUp ? sorted : sorted.reverse()));
    });
  }
})();
