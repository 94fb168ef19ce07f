// New devices, and objects that are added to an open one.

import { ask } from "./engine";
import { Dialog } from "./dialog";
import { finds, h, hex, numberIn, placeOf } from "./dom";
import { ACCESS, TYPES } from "./form";
import type { Feature, NewDevice, NewObject, Opened, ProfileObject, ProfileRow } from "./protocol";
import { textBytes, type OpenDocument, type Store } from "./store";

/** A feature as a field; what is left empty is as the profile has it. */
function featureField({ word, kind, names, range, meaning }: Feature): HTMLElement {
  const label = meaning.replace(/ \[default: .*\]$/, "");
  const usual = /\[default: (.*)\]$/.exec(meaning)?.[1] ?? "as the profile has it";
  const attributes = { "data-feature": word, "data-kind": kind };
  if (kind === "number") return h("label", {}, `${label} `, h("input", { ...attributes, type: "number", min: range?.[0], max: range?.[1], placeholder: usual }));
  const options = kind === "flag" ? [["true", "yes"], ["false", "no"]] : names.map((name) => [name, name]);
  if (kind === "names") return h("label", {}, `${label} `, h("select", { ...attributes, multiple: true, size: Math.min(6, names.length) }, ...options.map(([value, text]) => h("option", { value }, text!))));
  return h("label", {}, `${label} `, h("select", attributes, h("option", { value: "" }, `default: ${usual}`), ...options.map(([value, text]) => h("option", { value }, text!))));
}

function featuresIn(parent: HTMLElement): NewDevice["features"] {
  const features: NewDevice["features"] = {};
  for (const field of parent.querySelectorAll<HTMLInputElement | HTMLSelectElement>("[data-feature]")) {
    const word = field.dataset.feature!;
    const names = field instanceof HTMLSelectElement && field.multiple ? [...field.selectedOptions].map((option) => option.value) : [];
    if (names.length > 0) features[word] = names;
    else if (field.value !== "") features[word] = { number: Number(field.value), flag: field.value === "true" }[field.dataset.kind!] ?? field.value;
  }
  return features;
}

const profileOption = ({ number, title }: ProfileRow): HTMLElement => h("option", { value: number }, `CiA ${number}: ${title}`);

/** A text from the clipboard: a log, a description or a network. */
export function pasteDialog(store: Store): Dialog {
  const text = h("textarea", { rows: 10, required: true, spellcheck: "false", id: "paste-text", placeholder: "(1436509052.249713) can0 185#3702" });
  const name = h("input", { value: "pasted.log", required: true, autocomplete: "off" });
  const make = async () => {
    await store.load(name.value, textBytes(text.value));
    text.value = "";
  };
  const fields = [
    h("p", { class: "meaning" }, "Frames as candump or another tool of the bus prints them, or the text of a description or a network."),
    h("label", { class: "above" }, "Text ", text),
    h("label", {}, "Name ", name),
  ];
  return new Dialog(store, "paste", { title: "Paste a text", form: { fields, label: "Open", make } });
}

export function newDialog(store: Store): Dialog {
  const profile = h("select", { id: "new-profile", onchange: () => offer() });
  const own = h("div", {});
  const general = h("details", {});
  let profiles: ProfileRow[] = [];
  const offer = () => {
    const features = profiles.find((row) => row.number === Number(profile.value))?.features ?? [];
    const fields = (isGeneral: boolean) => features.filter((feature) => feature.is_general === isGeneral).map(featureField);
    own.replaceChildren(...fields(false));
    general.replaceChildren(h("summary", {}, "Communication"), ...fields(true));
  };
  const text = (value: string) => h("input", { value, required: true, autocomplete: "off" });
  const [name, vendor, vendorId, product, code] = [text("device.eds"), text(""), text("0x0"), text(""), text("0x0")];
  const make = async () => {
    const today = new Date();
    const opened = await ask<Opened>({
      do: "new",
      name: name.value,
      profile: Number(profile.value),
      vendor: vendor.value,
      vendor_id: numberIn(vendorId.value) || 0,
      product: product.value,
      product_code: numberIn(code.value) || 0,
      date: [today.getFullYear(), today.getMonth() + 1, today.getDate()],
      features: featuresIn(features),
    });
    await store.take(opened);
  };
  const prepare = () => (profiles.length > 0 ? undefined : load());
  const load = async () => {
    profiles = await ask<ProfileRow[]>({ do: "profiles" });
    profile.replaceChildren(...profiles.map(profileOption));
    offer();
  };
  const features = h("fieldset", {}, h("legend", {}, "Features"), own, general);
  const fields = [
    h("label", {}, "Device profile ", profile),
    h("label", {}, "Vendor ", vendor),
    h("label", {}, "Vendor-ID, as CiA assigned it ", vendorId),
    h("label", {}, "Product ", product),
    h("label", {}, "Product code ", code),
    h("label", {}, "File name ", name),
    features,
  ];
  return new Dialog(store, "new", { title: "New device", form: { fields, label: "Create", make }, prepare });
}

/** The size and the start value of the entries of an object of the vendor. */
const KINDS: [value: string, label: string][] = [["VAR", "VAR: one value"], ["ARRAY", "ARRAY: values of one type"], ["RECORD", "RECORD: values of any types"]];

/** A new object as JSON of the model: of an ARRAY or RECORD with so many entries, the first sub-index has their number. */
function objectOf(name: string, kind: string, entry: Pick<NewObject, "data_type" | "access" | "pdo_mapping">, count: number): NewObject {
  const zero = ["UNSIGNED8", "UNSIGNED16", "UNSIGNED24", "UNSIGNED32"].includes(entry.data_type!) ? { unsigned: 0 } : undefined;
  const of = (name: string): NewObject => ({ name, object_type: "VAR", ...entry, default: zero });
  if (kind === "VAR") return of(name);
  const highest: NewObject = { name: "Highest sub-index supported", object_type: "VAR", data_type: "UNSIGNED8", access: "const", pdo_mapping: "no", default: { unsigned: count } };
  const subs = Array.from({ length: count }, (_, at): [string, NewObject] => [`0x${hex(at + 1, 2)}`, of(`${name} ${at + 1}`)]);
  return { name, object_type: kind, sub_number: count + 1, subs: { "0x00": highest, ...Object.fromEntries(subs) } };
}

export function addDialog(store: Store): Dialog<OpenDocument> {
  const profile = h("select", { "aria-label": "Document" });
  const filter = h("input", { type: "search", placeholder: "Index or name", "aria-label": "Search objects of the document" });
  const list = h("ul", { class: "candidates" });
  let objects: ProfileObject[] = [];
  const show = () => {
    const shown = objects.filter((object) => finds(filter.value, `${hex(object.index, 4)}h ${object.name}`));
    list.replaceChildren(
      ...shown.slice(0, 200).map((object) =>
        h("li", {}, h("button", { type: "button", class: "mappable", disabled: object.has, onclick: () => void add(object.index) }, h("span", { class: "address" }, `${hex(object.index, 4)}h`), h("span", { class: "name" }, object.name), h("span", { class: "type" }, object.has ? "already there" : object.kind))),
      ),
    );
  };
  const load = async ({ id }: OpenDocument) => {
    objects = await ask<ProfileObject[]>({ do: "profile-objects", document: id, profile: Number(profile.value) });
    show();
  };
  const select = (of: OpenDocument, index: number) => {
    if (store.current !== of) return;
    store.wanted = `${placeOf(index, kind.value !== "VAR" ? 1 : undefined)} / ParameterName`;
    store.select(index);
  };
  const add = (index: number) =>
    dialog.run(async () => {
      const of = dialog.subject;
      await store.edit({ do: "add-objects", document: of.id, profile: Number(profile.value), indexes: [index] });
      select(of, index);
    });
  filter.addEventListener("input", show);
  profile.addEventListener("change", () => void load(dialog.subject));

  const index = h("input", { placeholder: "0x2000", required: true, pattern: "(0x)?[0-9A-Fa-f]{4}h?", autocomplete: "off" });
  const name = h("input", { required: true, autocomplete: "off" });
  const kind = h("select", { id: "own-kind", onchange: () => (count.disabled = kind.value === "VAR") }, ...KINDS.map(([value, label]) => h("option", { value }, label)));
  const count = h("input", { type: "number", min: 1, max: 254, value: 3, disabled: true });
  const type = h("select", {}, ...TYPES.map(([, label]) => h("option", { value: label, selected: label === "UNSIGNED16" }, label)));
  const access = h("select", {}, ...ACCESS.map(([word, label]) => h("option", { value: word, selected: word === "rw" }, label)));
  const mapping = h("input", { type: "checkbox" });
  const make = async (of: OpenDocument) => {
    const digits = index.value.replace(/^0x|h$/gi, "").toUpperCase();
    const object = objectOf(name.value, kind.value, { data_type: type.value, access: access.value, pdo_mapping: mapping.checked ? "optional" : "no" }, Number(count.value));
    await store.edit({ do: "insert", document: of.id, objects: [[parseInt(digits, 16), object]] });
    select(of, parseInt(digits, 16));
  };
  const prepare = async (of: OpenDocument) => {
    if (profile.options.length === 0) {
      const profiles = await ask<ProfileRow[]>({ do: "profiles" });
      profile.replaceChildren(...profiles.map(profileOption));
    }
    const used = new Set(of.outline.objects.map((object) => object.index));
    let free = 0x2000;
    while (used.has(free)) free++;
    index.value = `0x${hex(free, 4)}`;
    const own = String(of.outline.profile ?? 301);
    if ([...profile.options].some((option) => option.value === own)) profile.value = own;
    await load(of);
  };
  const fields = [
    h("h3", {}, "Your own"),
    h("label", {}, "Index ", index),
    h("label", {}, "Name ", name),
    h("label", {}, "Object type ", kind),
    h("label", {}, "Number of entries ", count),
    h("label", {}, "Data type ", type),
    h("label", {}, "Access ", access),
    h("label", { class: "choice" }, mapping, " PDOs may carry it"),
  ];
  const choices = [h("section", {}, h("h3", {}, "From a document of CiA"), profile, filter, list)];
  const dialog = new Dialog<OpenDocument>(store, "add", { title: "Add an object", choices, form: { fields, label: "Add", make }, prepare });
  return dialog;
}
