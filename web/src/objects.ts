// Left: the objects and PDOs of the device, with a search. Only the rows that are in sight are in the page.

import { addressIn, finds, h, indexOf, indexText, placeOf, redraw, shortType } from "./dom";
import type { ObjectRow, PdoRow } from "./protocol";
import type { Store } from "./store";

const ROW = 30;
/** Rows above and below those in sight. */
const AROUND = 12;

const AREAS: [number, string][] = [
  [0x1000, "Communication"],
  [0x2000, "Manufacturer"],
  [0x6000, "Device profile"],
  [0xa000, "Interface profile"],
];

type Row =
  | { kind: "area"; title: string; count: number }
  | { kind: "pdo"; pdo: PdoRow; position: number }
  | { kind: "object"; object: ObjectRow };

/** Whether each word is in the object, or is its address; a type is found as `UNSIGNED32` and as `u32`. */
function matches(object: ObjectRow, words: string[]): boolean {
  const types = [object.data_type, ...object.subs.map((sub) => sub.data_type)].filter((type) => type !== undefined && type !== null);
  const short = new Set(types.map(shortType));
  const text = `${indexText(object.index)} 0x${indexText(object.index)} ${object.name} ${object.kind} ${types.join(" ")} ${object.subs.map((sub) => sub.name).join(" ")}`.toLowerCase();
  return words.every((word) => {
    const { index, sub } = addressIn(word) ?? {};
    const isHere = index === object.index && (object.subs.some((row) => row.sub === sub) || (sub === 0 && object.subs.length === 0));
    return sub === undefined ? short.has(word) || (!/^[uif](8|16|24|32|64)$/.test(word) && text.includes(word)) : isHere;
  });
}

/** The objects that the search finds. */
export function searched(store: Store): ObjectRow[] {
  const { objects } = store.current!.outline;
  const words = store.search.toLowerCase().split(/\s+/).filter(Boolean);
  return words.length > 0 ? objects.filter((object) => matches(object, words)) : objects;
}

function rowsOf(store: Store): Row[] {
  const outline = store.current?.outline;
  if (!outline) return [];
  const rows: Row[] = [];
  const pdos = outline.pdos
    .map((pdo, position) => ({ kind: "pdo" as const, pdo, position }))
    .filter(({ pdo }) => finds(store.search, `${pdo.kind} ${pdo.number} pdo`));
  if (pdos.length > 0) rows.push({ kind: "area", title: "PDOs", count: pdos.length }, ...pdos);
  let area = "";
  let head: { kind: "area"; title: string; count: number } | undefined;
  for (const object of searched(store)) {
    const title = AREAS.filter(([first]) => object.index >= first).at(-1)?.[1] ?? "Data types";
    if (title !== area) rows.push((head = { kind: "area", title: (area = title), count: 0 }));
    head!.count++;
    rows.push({ kind: "object", object });
  }
  return rows;
}

/** The worst severity of the findings about each object. */
function severities(store: Store): Map<number, string> {
  const worst = new Map<number, string>();
  const order = ["note", "warning", "error"];
  for (const finding of store.current?.report.findings ?? []) {
    for (const place of [finding, ...(finding.places ?? [])]) {
      const index = indexOf(place.place);
      if (index === undefined) continue;
      const known = worst.get(index);
      if (known === undefined || order.indexOf(finding.severity) > order.indexOf(known)) worst.set(index, finding.severity);
    }
  }
  return worst;
}

export function objectsPanel(store: Store): HTMLElement {
  const search = h("input", {
    type: "search",
    placeholder: "Name, 6040:0, u32 …",
    "aria-label": "Search objects",
    "data-key": "search",
    title: "Ctrl+K; Enter shows the first match",
    onkeydown: (event: KeyboardEvent) => {
      const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
      // who types fast is ahead of what is drawn
      rows = rowsOf(store);
      if (by) move(by);
      const first = event.key === "Enter" ? (rows.find(isSelected) ?? rows.find(({ kind }) => kind !== "area")) : undefined;
      if (first) enter(first);
      if (by || first) event.preventDefault();
    },
    oninput: () => {
      store.search = search.value;
      store.draw();
    },
  });
  const list = h("div", { role: "listbox", "aria-label": "Objects and PDOs", class: "rows", tabindex: 0 });
  const scroll = h("div", { class: "scroll" }, list);
  let rows: Row[] = [];
  let marks = new Map<number, string>();

  const isSelected = (row: Row): boolean =>
    row.kind === "object"
      ? ["form", "table", "text"].includes(store.view) && row.object.index === store.index
      : row.kind === "pdo" && store.view === "pdo" && row.position === store.pdo;

  const choose = (row: Row): void => {
    if (row.kind === "object") {
      const sub = store.search.split(/\s+/).map((word) => addressIn(word)?.sub).find((sub) => sub !== undefined);
      // the keyboard stays in the list where it is
      if (sub !== undefined && document.activeElement !== list) store.wanted = placeOf(row.object.index, row.object.subs.length > 0 ? sub : undefined);
      store.select(row.object.index, store.view === "text" ? "text" : undefined);
    }
    else if (row.kind === "pdo") store.selectPdo(row.position);
  };

  /** Chooses a row, and has the keyboard in its view. */
  const enter = (row: Row): void => {
    choose(row);
    if (row.kind === "object") store.wanted ??= placeOf(row.object.index, row.object.subs.length > 0 ? (row.object.subs[1]?.sub ?? 0) : undefined);
    if (row.kind === "pdo") store.wanted = "PDO";
  };

  const element = (row: Row, number: number): HTMLElement => {
    const top = `top:${number * ROW}px`;
    if (row.kind === "area") return h("div", { class: "area", style: top, role: "presentation" }, row.title, h("span", { class: "count" }, String(row.count)));
    const attributes = { role: "option", style: top, id: `row-${number}`, "aria-selected": String(isSelected(row)), onclick: () => choose(row) };
    if (row.kind === "pdo") {
      const { pdo } = row;
      const bits = pdo.mapped.reduce((sum, mapped) => sum + mapped.bits, 0);
      const note = pdo.is_valid === false ? "not valid" : `${bits} bits`;
      return h("div", { ...attributes, class: "row" }, h("span", { class: "address" }, pdo.kind), h("span", { class: "name" }, `${pdo.number}`), h("span", { class: bits > 64 ? "type remark error" : "type" }, note));
    }
    const { object } = row;
    const mark = marks.get(object.index);
    return h(
      "div",
      { ...attributes, class: "row", "data-index": object.index },
      h("span", { class: "address" }, indexText(object.index)),
      h("span", { class: "name", title: object.name }, object.name),
      mark && h("span", { class: `dot ${mark}`, title: mark, role: "img", "aria-label": mark }),
      h("span", { class: "type", title: object.data_type ?? object.kind }, object.kind === "VAR" && object.data_type ? shortType(object.data_type) : object.kind),
    );
  };

  const show = (): void => {
    const first = Math.max(0, Math.floor(scroll.scrollTop / ROW) - AROUND);
    const last = Math.min(rows.length, Math.ceil((scroll.scrollTop + (scroll.clientHeight || 800)) / ROW) + AROUND);
    list.style.height = `${rows.length * ROW}px`;
    redraw(list, ...rows.slice(first, last).map((row, at) => element(row, first + at)));
    const selected = rows.findIndex(isSelected);
    if (selected >= first && selected < last) list.setAttribute("aria-activedescendant", `row-${selected}`);
    else list.removeAttribute("aria-activedescendant");
  };
  scroll.addEventListener("scroll", () => requestAnimationFrame(show));

  const move = (by: number): void => {
    let at = rows.findIndex(isSelected);
    do at += by;
    while (rows[at]?.kind === "area");
    const row = rows[at];
    if (!row) return;
    if (at * ROW < scroll.scrollTop) scroll.scrollTop = at * ROW;
    if ((at + 1) * ROW > scroll.scrollTop + scroll.clientHeight) scroll.scrollTop = (at + 1) * ROW - scroll.clientHeight;
    choose(row);
  };
  list.addEventListener("keydown", (event) => {
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!by) return;
    event.preventDefault();
    move(by);
  });
  addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.key !== "k" || panel.hidden || document.querySelector("dialog[open]")) return;
    event.preventDefault();
    search.focus();
    search.select();
  });

  store.onDraw(() => {
    if (search.value !== store.search) search.value = store.search;
    rows = rowsOf(store);
    marks = severities(store);
    show();
  });
  const panel = h("nav", { "aria-label": "Object dictionary", class: "panel objects" }, h("div", { class: "bar" }, search), scroll);
  store.onDraw(() => (panel.hidden = store.current?.state.kind !== "device"));
  return panel;
}
