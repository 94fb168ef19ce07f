// Middle: an object as a form. Each field is the text that the file has, with its meaning and what was found about it.

import { ask } from "./engine";
import { committing, disable, h, indexText, redraw } from "./dom";
import type { FieldForm, Finding, ObjectForm, PartForm } from "./protocol";
import type { Store } from "./store";

/** What a field means (CiA 306-1, in short). */
const MEANINGS: Record<string, [label: string, meaning: string]> = {
  ParameterName: ["Name", "The name of the object or entry, up to 241 characters."],
  ObjectType: ["Object type", "0x7 VAR: one value. 0x8 ARRAY: values of one type. 0x9 RECORD: values of any types. 0x2 DOMAIN: a block of data."],
  DataType: ["Data type", "The index of the data type: 0x0001 BOOLEAN, 0x0005 UNSIGNED8, 0x0006 UNSIGNED16, 0x0007 UNSIGNED32, 0x0003 INTEGER16, 0x0004 INTEGER32, 0x0008 REAL32, 0x0009 VISIBLE_STRING."],
  AccessType: ["Access", "ro: read only. wo: write only. rw: both. rwr: both, in a TPDO. rww: both, in an RPDO. const: read only, never changes."],
  DefaultValue: ["Default value", "The value after power-on without stored parameters. $NODEID+n adds the node-ID."],
  ParameterValue: ["Configured value", "The value that this node is configured to have."],
  LowLimit: ["Lowest value", "Smaller values are refused."],
  HighLimit: ["Highest value", "Greater values are refused."],
  PDOMapping: ["PDO mapping", "1: PDOs may carry the entry. 0: they may not."],
  ObjFlags: ["Flags", "Bit 0: configuration tools do not write the entry. Bit 1: they do not read it."],
};

const CHOICES: Record<string, string[]> = {
  AccessType: ["ro", "wo", "rw", "rwr", "rww", "const"],
  PDOMapping: ["0", "1"],
  ObjectType: ["0x7", "0x8", "0x9", "0x2"],
  DataType: ["0x0001", "0x0002", "0x0003", "0x0004", "0x0005", "0x0006", "0x0007", "0x0008", "0x0009", "0x000A", "0x000F", "0x0011", "0x0015", "0x001B"],
};

function placeOfField(part: PartForm, field: FieldForm): string {
  return `${part.place} / ${field.name}`;
}

/** What was found at a place, also as one of several places of a finding. */
function foundAt(findings: Finding[], place: string): Finding[] {
  return findings.filter((finding) => finding.place === place || finding.places?.some((other) => other.place === place));
}

function remarks(findings: Finding[], id: string): HTMLElement | false {
  if (findings.length === 0) return false;
  return h("div", { id }, ...findings.map((finding) => h("p", { class: `remark ${finding.severity}` }, finding.message)));
}

function fieldRow(store: Store, part: PartForm, field: FieldForm): HTMLElement {
  const document = store.current!;
  const place = placeOfField(part, field);
  const [label, meaning] = MEANINGS[field.name] ?? [field.name, ""];
  const id = `field-${place.replace(/\W+/g, "-")}`;
  const found = foundAt(document.report.findings, place);
  const set = (value: string) => {
    const change = value === "" ? ({ change: "remove", at: place } as const) : ({ change: "set", at: place, value } as const);
    return store.change({ do: "change", document: document.id, changes: [change] });
  };
  const input = h("input", {
    id,
    value: field.text ?? "",
    placeholder: field.text == null ? "not stated" : "",
    readonly: document.state.is_read_only,
    list: CHOICES[field.name] ? `choices-${field.name}` : undefined,
    spellcheck: "false",
    autocomplete: "off",
    "aria-describedby": found.length > 0 ? `${id}-found ${id}-means` : `${id}-means`,
    "aria-invalid": found.some((finding) => finding.severity === "error") ? "true" : undefined,
    "data-key": place,
    ...committing(field.text ?? "", set),
  });
  const isValue = field.name === "DefaultValue" || field.name === "ParameterValue";
  return h(
    "div",
    { class: "field" },
    h("label", { for: id }, label),
    h("div", {}, input, isValue && field.text != null && part.words && h("span", { class: "words" }, part.words), remarks(found, `${id}-found`), h("p", { class: "meaning", id: `${id}-means` }, meaning)),
  );
}

function partSection(store: Store, form: ObjectForm, part: PartForm): HTMLElement {
  const document = store.current!;
  const title = part.sub == null ? "" : `sub-index ${part.sub.toString(16).toUpperCase().padStart(2, "0")} · ${part.name}`;
  const remove = () => void store.change({ do: "patch", document: document.id, patch: patchOf({ at: address(form, part), remove: true }) });
  return h(
    "section",
    { class: part.sub == null ? "part" : "part sub", "aria-label": title || `${indexText(form.index)} ${form.name}` },
    title && h("h3", {}, title, part.data_type ? h("span", { class: "type" }, part.data_type) : null),
    remarks(foundAt(document.report.findings, part.place), `part-${part.place}`),
    ...part.fields.map((field) => fieldRow(store, part, field)),
    !document.state.is_read_only && h("button", { class: "quiet", onclick: remove }, part.sub == null ? "Remove the object" : "Remove this sub-index"),
  );
}

const address = (form: ObjectForm, part: PartForm): string =>
  form.index.toString(16).toUpperCase() + (part.sub == null ? "" : `:${part.sub.toString(16).toUpperCase()}`);

/** A patch of one change (docs/guides/patches.md). */
export function patchOf(change: Record<string, string | boolean | Record<string, string | number>>): string {
  const value = (value: unknown): string =>
    typeof value === "object" && value !== null
      ? `{ ${Object.entries(value).map(([key, inner]) => `${key} = ${JSON.stringify(inner)}`).join(", ")} }`
      : JSON.stringify(value);
  const lines = Object.entries(change).map(([key, inner]) => `${key} = ${value(inner)}`);
  return `format = "objdict-patch/1"\n\n[[change]]\n${lines.join("\n")}\n`;
}

export function formView(store: Store): HTMLElement {
  const view = h("div", { class: "form scroll", tabindex: -1 });
  let asked = 0;
  // asked for between two drawings, it would have the page laid out once more
  let top = 0;
  view.addEventListener("scroll", () => (top = view.scrollTop));
  const choices = Object.entries(CHOICES).map(([name, values]) => h("datalist", { id: `choices-${name}` }, ...values.map((value) => h("option", { value }))));
  const wanted = () => `${store.current?.id}-${store.index}`;
  const leave = () => view.dataset.shown !== wanted() && disable(view);
  store.onLeave(leave);
  store.onDraw(async () => {
    const { current, index } = store;
    view.hidden = store.view !== "form";
    if (view.hidden || !current || index === undefined) return;
    const number = ++asked;
    const shown = wanted();
    const same = view.dataset.shown === shown;
    const form = await ask<ObjectForm>({ do: "form", document: current.id, index }).catch(() => undefined);
    if (number !== asked) return;
    if (!form) {
      view.replaceChildren(h("p", { class: "nothing" }, `There is no object ${indexText(index)}.`));
      return;
    }
    view.dataset.shown = shown;
    redraw(view, h("h2", {}, h("span", { class: "address" }, indexText(form.index)), ` ${form.name} `, h("span", { class: "type" }, form.kind)), ...form.parts.map((part) => partSection(store, form, part)), ...choices);
    if (!same && top > 0) view.scrollTop = 0;
    leave();
  });
  return view;
}
