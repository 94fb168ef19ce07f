// A node of a description: its node-ID, bit rate, modules and values, as a DCF or XDC of its own.

import { ask } from "./engine";
import { Dialog } from "./dialog";
import { finds, h, hex } from "./dom";
import { BIT_RATES } from "./output";
import type { Modules, Opened, Setting } from "./protocol";
import type { OpenDocument, Store } from "./store";

export function configureDialog(store: Store): Dialog<OpenDocument> {
  const name = h("input", { id: "configure-name", required: true, autocomplete: "off" });
  const nodeId = h("input", { id: "configure-node-id", type: "number", min: 1, max: 127, required: true });
  const bitRate = h("select", { id: "configure-bit-rate" }, ...BIT_RATES.map((rate) => h("option", { value: rate }, `${rate} kbit/s`)));
  const nodeName = h("input", { id: "configure-node-name", autocomplete: "off" });
  const settings = h("textarea", { id: "configure-settings", rows: 4, spellcheck: "false", placeholder: "1017=1000\n1800:5=100" });
  const filter = h("input", { type: "search", placeholder: "Name or address", "aria-label": "Search entries to set", oninput: () => offer() });
  const entries = h("ul", { class: "candidates", "aria-label": "Entries to set" });
  let offered: Setting[] = [];
  const addressOf = ({ index, sub }: Setting) => `${hex(index, 4)}${sub === 0 ? "" : `:${hex(sub, 1)}`}`;
  const offer = () => {
    const shown = offered.filter((entry) => finds(filter.value, `${addressOf(entry)} ${entry.name} ${entry.data_type ?? ""}`));
    const row = (entry: Setting) =>
      h("li", {}, h("button", { type: "button", class: "mappable", onclick: () => choose(entry) }, h("span", { class: "address" }, addressOf(entry)), h("span", { class: "name" }, entry.name), h("span", { class: "type" }, [entry.data_type, entry.low != null || entry.high != null ? `${entry.low ?? ""} … ${entry.high ?? ""}` : ""].filter(Boolean).join(", "))));
    entries.replaceChildren(...shown.slice(0, 100).map(row));
  };
  /** A line with the value as it is, which is chosen to be typed over. */
  const choose = (entry: Setting) => {
    const start = `${settings.value.trim()}${settings.value.trim() ? "\n" : ""}${addressOf(entry)}=`;
    settings.value = start + (entry.value ?? "");
    settings.focus();
    settings.setSelectionRange(start.length, settings.value.length);
  };
  const choice = h("select", { "aria-label": "Module" });
  const rack = h("ol", { class: "rack", "aria-label": "Modules in their order" });
  const modules = h("fieldset", {}, h("legend", {}, "Modules"), choice, " ", h("button", { type: "button", onclick: () => plug(Number(choice.value)) }, "Plug in"), rack);
  let supported: Modules["supported"] = [];
  let plugged: number[] = [];
  const show = () => {
    const label = (number: number) => supported.find((module) => module.number === number)?.name ?? `module ${number}`;
    const remove = (at: number) => {
      plugged.splice(at, 1);
      show();
    };
    rack.replaceChildren(...plugged.map((number, at) => h("li", {}, label(number), " ", h("button", { type: "button", class: "quiet", "aria-label": `Remove ${label(number)}`, onclick: () => remove(at) }, "Remove"))));
  };
  const plug = (number: number) => {
    plugged.push(number);
    show();
  };
  const make = async ({ id: document }: OpenDocument) => {
    const lines = settings.value.split("\n").map((line) => line.trim()).filter(Boolean);
    const node = { name: name.value, node_id: Number(nodeId.value), bit_rate: Number(bitRate.value), node_name: nodeName.value, modules: plugged, settings: lines };
    await store.take(await store.inTurn(() => ask<Opened>({ do: "configure", document, node })));
  };
  const prepare = async ({ id, state, outline }: OpenDocument) => {
    nodeId.value = String(outline.node_id ?? 1);
    bitRate.value = "250";
    const isXml = /^xd/i.test(state.format);
    name.value = `${state.name.split("/").at(-1)!.replace(/\.[^.]*$/, "")}-node.${isXml ? "xdc" : state.format.toLowerCase().includes("toml") ? "toml" : "dcf"}`;
    settings.value = filter.value = "";
    offered = await ask<Setting[]>({ do: "settings", document: id }).catch(() => []);
    offer();
    const known = await ask<Modules>({ do: "modules", document: id }).catch(() => ({ supported: [], connected: [] }));
    supported = known.supported;
    plugged = [...known.connected];
    modules.hidden = supported.length === 0;
    choice.replaceChildren(...supported.map((module) => h("option", { value: module.number }, [module.name ?? `module ${module.number}`, module.order_code].filter(Boolean).join(", "))));
    show();
  };
  const fields = [
    h("p", { class: "meaning" }, "The description stays as it is; the node is a DCF or XDC beside it."),
    h("label", {}, "Node-ID ", nodeId),
    h("label", {}, "Bit rate ", bitRate),
    h("label", {}, "Name of the node ", nodeName),
    modules,
    h("fieldset", {}, h("legend", {}, "Values"), filter, entries, h("label", { class: "above" }, "Chosen values, one a line ", settings)),
    h("label", {}, "File name ", name),
  ];
  return new Dialog(store, "configure", { title: "Configure a node", form: { fields, label: "Configure", make }, prepare });
}
