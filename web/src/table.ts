// Middle: all objects and entries in one table, edited in place. Only the rows in sight are in the page; the search on the left narrows it.

import { ask } from "./engine";
import { disable, h, hex, indexText, placeOf, redraw } from "./dom";
import { bases, cellsOf, columnKeys, COLUMNS, focusWanted, foundBy, headOf } from "./form";
import { searched } from "./objects";
import type { ObjectForm, ObjectRow } from "./protocol";
import type { Store } from "./store";

const ROW = 28;
/** Rows above and below those in sight. */
const AROUND = 30;
/** Browsers draw no element that is higher than so many rows. */
const MAX_ROWS = 500_000;

/** An entry, or an object itself without a `sub`. */
type Row = { object: ObjectRow; sub?: number; place: string };

export function tableView(store: Store): HTMLElement {
  // the words of access are explained by the help of their column
  const short = COLUMNS.map((column) => (column.field === "AccessType" ? { ...column, choices: column.choices!.map(([word]): [string, string] => [word, word]) } : column));
  const columns = () => short.filter(({ field }) => field !== "ParameterValue" || store.current!.outline.is_node);
  const bar = h("div", { class: "bar" });
  const [head, body] = [h("thead"), h("tbody")];
  const all = h("div", {}, h("table", { class: "entries all" }, head, body));
  const scroll = h("div", { class: "scroll", tabindex: -1 }, all);
  const view = h("div", { class: "dictionary" }, bar, scroll);
  let rows: Row[] = [];
  /** What the engine told about objects, for one text. */
  let forms = new Map<number, ObjectForm>();
  let known = "";
  /** The rows in the page with what is drawn in them. */
  let drawn = new Map<string, { state: string; element: HTMLElement }>();
  let found: ReturnType<typeof foundBy> = new Map();
  /** The object that is in sight. */
  let shown = "";
  let asked = 0;

  const inSight = (): [number, number] => {
    const first = Math.floor(scroll.scrollTop / ROW);
    return [Math.max(0, first - AROUND), Math.min(rows.length, MAX_ROWS, first + Math.ceil((scroll.clientHeight || 800) / ROW) + AROUND)];
  };

  const element = ({ object, sub, place }: Row): HTMLElement => {
    const current = store.current!;
    const form = forms.get(object.index);
    const part = form?.parts.find((part) => part.place === place);
    const remarks = [place, ...(part?.fields ?? []).map(({ name }) => `${place} / ${name}`)].flatMap((at) => found.get(at) ?? []);
    const state = JSON.stringify([part, remarks, store.base, current.state.is_read_only, current.id, sub === undefined && object.kind]);
    const former = drawn.get(place);
    if (former?.state === state) return former.element;
    const title = [...new Set(remarks.map(({ message }) => message))].join("\n");
    const mark = title !== "" && h("span", { class: `dot ${remarks[0]!.severity}`, title, role: "img", "aria-label": title });
    const name = sub === undefined ? h("button", { type: "button", class: "address", title: "Show the object", "data-key": `show-${place}`, onclick: () => store.select(object.index, "form") }, indexText(object.index)) : h("span", { class: "address" }, indexText(object.index));
    const cells = form && part ? cellsOf(store, current, form, part, found, columns(), ` of ${indexText(object.index)}`) : [h("td", { colspan: columns().length + 1, class: "name" }, object.subs.find((row) => row.sub === sub)?.name ?? object.name)];
    const kind = cells[columns().findIndex(({ field }) => field === "DataType")];
    if (kind && kind.childElementCount === 0) kind.append(h("span", { class: "type" }, object.kind));
    const row = h("tr", { "data-place": place, class: sub === undefined ? "object" : undefined }, h("th", { scope: "row" }, name), h("td", { class: "address sub" }, sub === undefined ? "" : hex(sub, 2), mark), ...cells);
    drawn.set(place, { state, element: row });
    return row;
  };

  const show = async (): Promise<void> => {
    const { current } = store;
    if (view.hidden || !current) return;
    const number = ++asked;
    const text = `${current.id}-${current.state.revision}`;
    const wanted = new Set(rows.slice(...inSight()).map(({ object }) => object.index));
    const missing = [...wanted].filter((index) => known !== text || !forms.has(index));
    const answers = await Promise.all(missing.map((index) => ask<ObjectForm>({ do: "form", document: current.id, index }).catch(() => undefined)));
    // what was scrolled to meanwhile asks itself
    if (number !== asked) return;
    if (known !== text) [known, forms] = [text, new Map()];
    for (const form of answers) if (form) forms.set(form.index, form);
    const [first, last] = inSight();
    const left = rows.slice(first, last);
    const active = document.activeElement as HTMLElement;
    // a field that leaves the page gives away its text before
    if (body.contains(active) && !left.some(({ place }) => place === active.closest("tr")?.dataset.place)) active.blur();
    body.dataset.shown = String(current.id);
    redraw(body, h("tr", { "data-key": "above", "aria-hidden": "true" }, h("td", { style: `height:${first * ROW}px` })), ...left.map(element));
    const elements = new Map([...body.children].map((row) => [(row as HTMLElement).dataset.place, row as HTMLElement]));
    drawn = new Map(left.map(({ place }) => [place, { state: drawn.get(place)!.state, element: elements.get(place)! }]));
    focusWanted(store, view);
  };

  // the rows that are drawn around those in sight are more than a page
  columnKeys(view, () => Math.min(AROUND, Math.max(1, Math.floor(scroll.clientHeight / ROW) - 2)));
  scroll.addEventListener("scroll", () => requestAnimationFrame(() => void show()));

  store.onLeave(() => {
    if (body.dataset.shown === String(store.current?.id)) return;
    disable(body);
    drawn.clear();
  });
  store.onDraw(() => {
    view.hidden = store.view !== "table";
    const { current } = store;
    if (view.hidden || !current) return;
    rows = searched(store).flatMap((object) => [undefined, ...object.subs.map(({ sub }) => sub)].map((sub) => ({ object, sub, place: placeOf(object.index, sub) })));
    found = foundBy(current.report.findings);
    const left = rows.length > MAX_ROWS && `, the first ${MAX_ROWS} are shown: search for others`;
    redraw(bar, h("span", { class: "count", role: "status" }, `${rows.length} row${rows.length === 1 ? "" : "s"}`, left), h("span", { class: "push" }), bases(store));
    redraw(head, h("tr", {}, h("th", { scope: "col" }, "Index"), h("th", { scope: "col", class: "sub" }, "Sub"), ...columns().map((column) => headOf(column, "all")), h("th", { scope: "col" }, "Unit")));
    all.style.height = `${head.clientHeight + Math.min(rows.length, MAX_ROWS) * ROW}px`;
    const object = `${current.id} ${store.index}`;
    const place = store.wanted?.split(" / ")[0] ?? (shown === object ? undefined : placeOf(store.index ?? 0));
    const at = rows.findIndex((row) => row.place === place);
    shown = object;
    if (at >= 0) scroll.scrollTop = Math.min(at * ROW, Math.max(scroll.scrollTop, (at + 3) * ROW - scroll.clientHeight));
    void show();
  });
  return view;
}
