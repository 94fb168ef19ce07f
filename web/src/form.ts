// Middle: an object as a table that is edited in place. Each field is the text that the file has; a select has the names of its values.

import { ask } from "./engine";
import { committing, disable, h, hex, iconButton, inBase, indexOf, indexText, numberIn, placeOf, prose, redraw } from "./dom";
import type { FieldChange, FieldForm, Finding, ObjectForm, PartForm } from "./protocol";
import type { OpenDocument, Store } from "./store";

const NAMES = "BOOLEAN INTEGER8 INTEGER16 INTEGER32 UNSIGNED8 UNSIGNED16 UNSIGNED32 REAL32 VISIBLE_STRING OCTET_STRING UNICODE_STRING TIME_OF_DAY TIME_DIFFERENCE - DOMAIN INTEGER24 REAL64 INTEGER40 INTEGER48 INTEGER56 INTEGER64 UNSIGNED24 - UNSIGNED40 UNSIGNED48 UNSIGNED56 UNSIGNED64 - - - - PDO_COMMUNICATION_PARAMETER PDO_MAPPING SDO_PARAMETER IDENTITY";

/** The data types of CiA 301 with their indexes as an EDS spells them. */
export const TYPES: [value: string, name: string][] = NAMES.split(" ").map((name, at): [string, string] => [`0x${hex(at + 1, 4)}`, name]).filter(([, name]) => name !== "-");

export const ACCESS: [value: string, name: string][] = [["ro", "ro: read only"], ["wo", "wo: write only"], ["rw", "rw: read, write"], ["rwr", "rwr: both, in TPDOs"], ["rww", "rww: both, in RPDOs"], ["const", "const: never changes"]];
const OBJECT_TYPES: [string, string][] = [["0x7", "VAR: one value"], ["0x8", "ARRAY: values of one type"], ["0x9", "RECORD: values of any types"], ["0x2", "DOMAIN: a block of data"]];
const FLAGS: [string, string][] = [["0", "none"], ["1", "not written"], ["2", "not read"], ["3", "neither"]];
const MAPPING: [string, string][] = [["0", "no"], ["1", "yes"]];
const XML_MAPPING: [string, string][] = ["no", "optional", "default", "TPDO", "RPDO"].map((word) => [word, word]);

export interface Column {
  field: string;
  label: string;
  /** For a screen reader, and where there is no head. */
  full: string;
  meaning: string;
  choices?: [string, string][];
}

export const COLUMNS: Column[] = [
  { field: "ParameterName", label: "Name", full: "Name", meaning: "The name of the object or entry, up to 241 characters." },
  { field: "DataType", label: "Type", full: "Data type", meaning: "The data type of CiA 301.", choices: TYPES },
  { field: "AccessType", label: "Access", full: "Access", meaning: "What SDO may do; `rwr` and `rww` also say which PDOs may carry the entry.", choices: ACCESS },
  { field: "DefaultValue", label: "Default", full: "Default value", meaning: "The value after power-on without stored parameters. `$NODEID+n` adds the node-ID." },
  { field: "ParameterValue", label: "Configured", full: "Configured value", meaning: "The value that this node is configured to have." },
  { field: "LowLimit", label: "Lowest", full: "Lowest value", meaning: "Smaller values are refused." },
  { field: "HighLimit", label: "Highest", full: "Highest value", meaning: "Greater values are refused." },
  { field: "PDOMapping", label: "PDO", full: "PDO mapping", meaning: "Whether PDOs may carry the entry.", choices: MAPPING },
  { field: "ObjFlags", label: "Flags", full: "Flags", meaning: "What configuration tools leave out: `not written` for entries that change when they are written, `not read` for entries that cannot be compared.", choices: FLAGS },
];

type Found = Map<string, Finding[]>;

/** The findings by their places, also as one of several places of a finding. */
export function foundBy(findings: Finding[]): Found {
  const found: Found = new Map();
  for (const finding of findings) {
    const places = new Set([finding.place, ...(finding.places ?? []).map(({ place }) => place)]);
    for (const place of places) if (place) found.set(place, [...(found.get(place) ?? []), finding]);
  }
  return found;
}

export const remark = ({ severity, message }: Finding): HTMLElement => h("p", { class: `remark ${severity}` }, ...prose(message));

/** A select that has the value of the file, whatever it is, and has it again if another one is refused. */
function choice(text: string, options: [string, string][], set: (value: string) => Promise<boolean>, attributes: Parameters<typeof h>[1] = {}): HTMLSelectElement {
  // `0x1` is 1
  const value = options.find(([known]) => numberIn(known) === numberIn(text))?.[0] ?? text;
  const all: [string, string][] = [["", "–"], ...options];
  if (!all.some(([known]) => known === value)) all.push([value, value]);
  const give = ({ currentTarget }: Event) => {
    const select = currentTarget as HTMLSelectElement;
    void set(select.value).then((isDone) => isDone || (select.value = value));
  };
  return h("select", { onchange: give, ...attributes }, ...all.map(([each, name]) => h("option", { value: each, selected: each === value }, name)));
}

/** A field of the file as an element; `attributes` are those of the element that takes input. */
export function fieldOf(store: Store, document: OpenDocument, place: string, field: FieldForm, found: Found, label: string, choices?: [string, string][]): HTMLElement {
  const at = `${place} / ${field.name}`;
  const own = found.get(at) ?? [];
  const set = (value: string) => store.change({ do: "change", document: document.id, changes: [value === "" ? { change: "remove", at } : { change: "set", at, value }] });
  const attributes = {
    "aria-label": label,
    "aria-invalid": own.some(({ severity }) => severity === "error") ? "true" : undefined,
    title: own.length > 0 ? own.map(({ message }) => message).join("\n") : undefined,
    class: [field.text == null ? "implied" : "", own[0]?.severity ?? ""].join(" ").trim(),
    "data-key": at,
  };
  const value = (choices === MAPPING && /^xd/i.test(document.state.format) ? field.text : field.value) ?? field.text ?? "";
  if (choices) return choice(value, choices === MAPPING && /^xd/i.test(document.state.format) ? XML_MAPPING : choices, set, { ...attributes, disabled: document.state.is_read_only });
  const shown = inBase(field.text ?? "", store.base);
  return h("input", { ...attributes, value: shown, placeholder: field.value ?? "", readonly: document.state.is_read_only, spellcheck: "false", autocomplete: "off", ...committing(shown, set) });
}

/** The cells of an object or entry in these columns, and one for its unit; `of` is added to their labels. */
export function cellsOf(store: Store, document: OpenDocument, form: ObjectForm, part: PartForm, found: Found, columns: Column[], of = ""): HTMLTableCellElement[] {
  const { sub, place } = part;
  const suffix = `${of}${sub == null ? "" : `, sub-index ${hex(sub, 2)}`}`;
  const cells = columns.map(({ field: name, full, choices }) => {
    const field = part.fields.find((field) => field.name === name);
    return h("td", { class: `${name} ${choices ? "choice" : name === "ParameterName" ? "name" : "value"}` }, field && fieldOf(store, document, place, field, found, full + suffix, choices));
  });
  const unit = part.unit ?? "";
  const at = addressOf(form.index, sub);
  const set = (value: string) => store.change({ do: "patch", document: document.id, patch: patchOf(value ? { at, set: { unit: value } } : { at, unset: ["unit"] }) });
  const field = (sub != null || !form.has_subs) && h("input", { value: unit, "aria-label": `Unit${suffix}`, "data-key": `${place} / Unit`, readonly: document.state.is_read_only, ...committing(unit, set) });
  return [...cells, h("td", { class: "unit" }, field)];
}

/** The head of a column with its help; each table has a name, because ids are unique in the page. */
export const headOf = ({ field, label, meaning }: Column, table: string): HTMLElement =>
  h("th", { scope: "col", class: field }, h("button", { type: "button", class: "quiet help-button", popovertarget: `help-${table}-${field}` }, label), h("div", { popover: "auto", id: `help-${table}-${field}` }, ...prose(meaning)));

/** The switch between hexadecimal and decimal numbers. */
export const bases = (store: Store): HTMLElement =>
  h("span", { class: "group", role: "group", "aria-label": "Numbers" }, ...(["text", "hex", "dec"] as const).map((base) => h("button", { type: "button", "aria-pressed": String(store.base === base), title: { text: "Numbers as the file has them", hex: "Numbers in hexadecimal", dec: "Numbers in decimal" }[base], "data-key": `base-${base}`, onclick: () => ((store.base = base), store.draw()) }, base === "text" ? "as in the file" : base)));

/** Up and down lead to the same field of the next row, the page keys farther; in a select, with Ctrl. */
export function columnKeys(view: HTMLElement, page: () => number): void {
  view.addEventListener("keydown", (event) => {
    const by = { ArrowUp: -1, ArrowDown: 1, PageUp: -page(), PageDown: page() }[event.key];
    const target = event.target as HTMLElement;
    const name = target.dataset.key?.split(" / ")[1];
    if (!by || event.altKey || !name || !(event.ctrlKey || target instanceof HTMLInputElement)) return;
    const column = [...view.querySelectorAll<HTMLElement>(`.entries [data-key$="/ ${name}"]`)];
    const next = column[Math.max(0, Math.min(column.length - 1, column.indexOf(target) + by))]!;
    event.preventDefault();
    next.focus();
    if (next instanceof HTMLInputElement) next.select();
  });
}

/** A patch of changes (docs/reference/patch.md). */
export function patchOf(...changes: Record<string, string | boolean | string[] | Record<string, string | number>>[]): string {
  const value = (value: unknown): string =>
    typeof value === "object" && value !== null && !Array.isArray(value)
      ? `{ ${Object.entries(value).map(([key, inner]) => `${key} = ${JSON.stringify(inner)}`).join(", ")} }`
      : JSON.stringify(value);
  const tables = changes.map((change) => `\n[[change]]\n${Object.entries(change).map(([key, inner]) => `${key} = ${value(inner)}\n`).join("")}`);
  return `format = "objdict-patch/1"\n${tables.join("")}`;
}

const addressOf = (index: number, sub?: number | null): string => (sub == null ? hex(index, 4) : `${hex(index, 4)}:${hex(sub, 1)}`);

/** The changes that add entries like these, behind the last one. */
export function entriesLike(form: ObjectForm, rows: PartForm[], isNumbered: boolean): FieldChange[] {
  const subs = form.parts.filter(({ sub }) => sub != null);
  const first = (subs.at(-1)?.sub ?? 0) + 1;
  const changes = rows.map((row, at): FieldChange => {
    const fields = row.fields.map(({ name, text, value }): [string, string] => [name, text ?? value ?? ""]).filter(([, value]) => value !== "");
    const named = fields.map(([name, value]): [string, string] => [name, name === "ParameterName" && isNumbered ? `${value.replace(/ ?\d+$/, "")} ${first + at}` : value]);
    return { change: "add", at: placeOf(form.index, first + at), fields: named };
  });
  return [...changes, ...counts(form, subs.length + rows.length, first + rows.length - 1)];
}

/** The changes of the number of entries and of the highest sub-index. */
function counts(form: ObjectForm, count: number, highest: number): FieldChange[] {
  const zero = form.parts.find(({ sub }) => sub === 0);
  const changes: FieldChange[] = [{ change: "set", at: `${placeOf(form.index)} / SubNumber`, value: String(count) }];
  if (zero && numberIn(zero.fields.find(({ name }) => name === "DefaultValue")?.text ?? "") !== highest) changes.push({ change: "set", at: `${zero.place} / DefaultValue`, value: String(highest) });
  return changes;
}

export function formView(store: Store): HTMLElement {
  const view = h("div", { class: "form scroll", tabindex: -1 });
  let asked = 0;
  // asked for between two drawings, it would have the page laid out once more
  let top = 0;
  view.addEventListener("scroll", () => (top = view.scrollTop));
  /** The chosen sub-indexes, and the one that was chosen last. */
  let chosen = new Set<number>();
  let last: number | undefined;
  const wanted = () => `${store.current?.id}-${store.index}`;
  /** What is drawn: a table of many entries is not drawn again for nothing. */
  let drawn = "";
  const leave = () => {
    if (view.dataset.shown === wanted()) return;
    disable(view);
    drawn = "";
  };
  store.onLeave(leave);

  columnKeys(view, () => 10);

  const choose = (form: ObjectForm, sub: number, event: MouseEvent) => {
    const between = (each: number) => last !== undefined && each >= Math.min(last, sub) && each <= Math.max(last, sub);
    if (event.shiftKey && last !== undefined) chosen = new Set(form.parts.map((part) => part.sub ?? -1).filter((each) => each >= 0 && between(each)));
    else if (!chosen.delete(sub)) chosen.add(sub);
    last = sub;
    store.draw();
  };

  const row = (form: ObjectForm, part: PartForm, found: Found, columns: Column[]): HTMLElement[] => {
    const { sub } = part;
    const head = sub == null ? h("th", { scope: "row", class: "address" }, indexText(form.index)) : h("th", { scope: "row" }, h("button", { class: "address", type: "button", "aria-label": `Choose sub-index ${hex(sub, 2)}`, "aria-pressed": String(chosen.has(sub)), "data-key": `choose-${sub}`, onclick: (event: MouseEvent) => choose(form, sub, event) }, hex(sub, 2)));
    const hasValue = sub != null || !form.has_subs;
    const remarks = [part.place, ...part.fields.map(({ name }) => `${part.place} / ${name}`)].flatMap((place) => found.get(place) ?? []);
    const notes = [hasValue && part.words && h("span", { class: "words" }, part.words), ...new Set(remarks)].filter(Boolean);
    const below = notes.length > 0 && h("tr", { class: "below" }, h("td", {}), h("td", { colspan: columns.length + 1 }, ...notes.map((note) => (note instanceof Node ? note : remark(note as Finding)))));
    return [h("tr", { "data-place": part.place, class: sub != null && chosen.has(sub) ? "chosen" : undefined }, head, ...cellsOf(store, store.current!, form, part, found, columns)), ...(below ? [below] : [])];
  };

  const actions = (form: ObjectForm): HTMLElement | false => {
    const document = store.current!;
    if (document.state.is_read_only) return false;
    const subs = form.parts.filter((part) => part.sub != null);
    const rows = subs.filter(({ sub }) => chosen.has(sub!));
    const change = (changes: FieldChange[]) => void store.change({ do: "change", document: document.id, changes });
    const patch = (...changes: Parameters<typeof patchOf>) => store.change({ do: "patch", document: document.id, patch: patchOf(...changes) });
    const count = h("input", { type: "number", min: 1, max: 254, value: 1, "aria-label": "How many sub-indexes to add", "data-key": "add-count", class: "count" });
    const model = rows.at(-1) ?? subs.at(-1);
    const add = () => model && change(entriesLike(form, Array.from({ length: Math.max(1, Number(view.querySelector<HTMLInputElement>("[data-key=add-count]")!.value)) }, () => model), true));
    const remove = () => {
      const left = subs.filter((part) => !rows.includes(part));
      chosen.clear();
      change([...rows.map(({ place }): FieldChange => ({ change: "remove", at: place })), ...counts(form, left.length, left.at(-1)?.sub ?? 0)]);
    };
    /** The chosen entries trade places with the one before or behind them. */
    const move = async (by: -1 | 1) => {
      const order = by < 0 ? rows : rows.toReversed();
      const moved = new Set<number>();
      const swaps = order.flatMap(({ sub }) => {
        const other = subs[subs.findIndex((part) => part.sub === sub) + by]?.sub;
        if (other == null || other === 0) return [];
        moved.add(other);
        const [from, to, spare] = [sub!, other, 0xfe].map((each) => addressOf(form.index, each)) as [string, string, string];
        return [{ at: from, rename: spare }, { at: to, rename: from }, { at: spare, rename: to }];
      });
      if (moved.size === rows.length && (await patch(...swaps))) [chosen, last] = [moved, undefined];
      store.draw();
    };
    const others = store.documents.filter((other) => other !== document && other.state.kind === "device" && !other.state.is_read_only);
    const copy = ({ currentTarget }: Event) => void store.change({ do: "copy", document: Number((currentTarget as HTMLSelectElement).value), from: document.id, indexes: [form.index] });
    const target = h("select", { "aria-label": "Copy the object to another file", class: "copy-to", onchange: copy }, h("option", { value: "" }, "Copy to …"), ...others.map(({ id, state }) => h("option", { value: id }, state.name)));
    const canMove = rows.length > 0 && !chosen.has(0);
    return h(
      "div",
      { class: "bar row-actions" },
      ...(form.has_subs
        ? [
            h("button", { type: "button", onclick: add, "data-key": "add-subs" }, "Add sub-indexes"),
            count,
            h("button", { type: "button", disabled: rows.length === 0, onclick: () => change(entriesLike(form, rows, false)), "data-key": "copy-subs" }, "Copy"),
            iconButton("up", "Move up", () => void move(-1), { disabled: !canMove, "data-key": "move-up" }),
            iconButton("down", "Move down", () => void move(1), { disabled: !canMove, "data-key": "move-down" }),
            h("button", { type: "button", disabled: !canMove, onclick: remove, "data-key": "remove-subs" }, "Remove"),
            h("span", { class: "meaning" }, rows.length > 0 ? `${rows.length} chosen` : "Choose entries by their numbers, ranges with Shift."),
          ]
        : []),
      h("span", { class: "push" }),
      others.length > 0 && target,
      h("button", { type: "button", class: "quiet", onclick: () => void patch({ at: addressOf(form.index), remove: true }) }, "Remove the object"),
    );
  };

  store.onDraw(async () => {
    const { current, index } = store;
    view.hidden = store.view !== "form";
    if (view.hidden || !current || index === undefined) return;
    const number = ++asked;
    const shown = wanted();
    const same = view.dataset.shown === shown;
    if (!same) [chosen, last] = [new Set(), undefined];
    const form = await ask<ObjectForm>({ do: "form", document: current.id, index }).catch(() => undefined);
    if (number !== asked) return;
    if (!form) return redraw(view, h("p", { class: "nothing" }, `There is no object ${indexText(index)}.`));
    view.dataset.shown = shown;
    const found = foundBy(current.report.findings.filter((finding) => [finding, ...(finding.places ?? [])].some(({ place }) => indexOf(place) === index)));
    const state = JSON.stringify([form, [...found], [...chosen], store.base, current.state.is_read_only, store.documents.map(({ id, state }) => [id, state.name])]);
    if (same && state === drawn) return focusWanted(store, view);
    drawn = state;
    const named = new Set(form.parts.flatMap((part) => part.fields.map(({ name }) => name)));
    const columns = COLUMNS.filter(({ field }) => named.has(field) && (field !== "ObjFlags" || form.parts.some((part) => part.fields.some(({ name, text }) => name === field && text != null))));
    const kind = form.parts[0]!.fields.find(({ name }) => name === "ObjectType");
    redraw(
      view,
      h("div", { class: "title" }, h("h2", {}, `${form.name} `, h("span", { class: "address" }, indexText(form.index))), kind ? fieldOf(store, current, form.parts[0]!.place, kind, found, "Object type", OBJECT_TYPES) : "", bases(store)),
      h("div", { class: "wide" }, h("table", { class: "entries" }, h("thead", {}, h("tr", {}, h("th", { scope: "col" }, form.has_subs ? "Sub" : "Index"), ...columns.map((column) => headOf(column, "object")), h("th", { scope: "col" }, "Unit"))), h("tbody", {}, ...form.parts.flatMap((part) => row(form, part, found, columns))))),
      ...[actions(form) || []].flat(),
    );
    if (!same && top > 0) view.scrollTop = 0;
    leave();
    focusWanted(store, view);
  });
  return view;
}

/** Gives the focus to the field that was asked for. */
export function focusWanted(store: Store, view: HTMLElement): void {
  const place = store.wanted;
  if (!place) return;
  const part = view.querySelector<HTMLElement>(`[data-place="${CSS.escape(place.split(" / ")[0]!)}"]`);
  const field = view.querySelector<HTMLElement>(`[data-key="${CSS.escape(place)}"]`) ?? part?.querySelector<HTMLElement>("input, select");
  if (!field && !part) return;
  store.wanted = undefined;
  (field ?? part)!.scrollIntoView({ block: "center", inline: "nearest" });
  field?.focus({ preventScroll: true });
  if (field instanceof HTMLInputElement) field.select();
}
