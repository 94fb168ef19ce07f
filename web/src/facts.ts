// Middle: forms for the data of the file, the device and the node.

import { ask } from "./engine";
import { disable, h, redraw } from "./dom";
import { fieldOf, focusWanted, foundBy, remark } from "./form";
import type { FieldForm, PartForm } from "./protocol";
import type { Store } from "./store";

const TITLES: Record<string, string> = { FileInfo: "File", DeviceInfo: "Device", DeviceComissioning: "Node" };

const LABELS: Record<string, string> = {
  FileName: "File name", FileVersion: "File version", FileRevision: "File revision", EDSVersion: "Version of the format", CreatedBy: "Created by", CreationDate: "Created on, month-day-year", CreationTime: "Created at",
  ModifiedBy: "Modified by", ModificationDate: "Modified on, month-day-year", ModificationTime: "Modified at", VendorName: "Vendor", VendorNumber: "Vendor-ID", ProductName: "Product", ProductNumber: "Product code", RevisionNumber: "Revision number",
  OrderCode: "Order code", SimpleBootUpMaster: "Boots other nodes", SimpleBootUpSlave: "Is booted", LSS_Supported: "Has LSS", GroupMessaging: "Multiplexed PDOs", Granularity: "Granularity of mapping in bits", DynamicChannelsSupported: "Dynamic channels",
  NrOfRXPDO: "Number of RPDOs", NrOfTXPDO: "Number of TPDOs", CompactPDO: "Compact PDOs", NodeID: "Node-ID", NodeName: "Name of the node", Baudrate: "Bit rate in kbit/s", NetNumber: "Number of the network", NetworkName: "Name of the network",
  CANopenManager: "Is the manager", LSS_SerialNumber: "Serial number for LSS",
};

const YES = /^(BaudRate_\d+|SimpleBootUp(Master|Slave)|LSS_Supported|GroupMessaging|CANopenManager)$/;

export function factsView(store: Store): HTMLElement {
  const view = h("div", { class: "facts-form scroll", tabindex: -1 });
  let asked = 0;
  const wanted = () => `${store.current?.id}`;
  store.onLeave(() => view.dataset.shown !== wanted() && disable(view));
  store.onDraw(async () => {
    const { current } = store;
    view.hidden = store.view !== "facts";
    if (view.hidden || !current) return;
    const number = ++asked;
    const parts = await ask<PartForm[]>({ do: "facts", document: current.id });
    if (number !== asked) return;
    const found = foundBy(current.report.findings);
    const row = (part: PartForm, field: FieldForm): HTMLElement => {
      const at = `${part.place} / ${field.name}`;
      const rate = /^BaudRate_(\d+)$/.exec(field.name)?.[1];
      const label = rate ? `${rate} kbit/s` : (LABELS[field.name] ?? field.name);
      const remarks = (found.get(at) ?? []).map(remark);
      if (!YES.test(field.name)) return h("label", { class: "field" }, h("span", {}, label), h("span", {}, fieldOf(store, current, part.place, field, found, label), ...remarks));
      const set = ({ currentTarget }: Event) => {
        const box = currentTarget as HTMLInputElement;
        void store.change({ do: "change", document: current.id, changes: [{ change: "set", at, value: box.checked ? "1" : "0" }] }).then((isDone) => isDone || (box.checked = !box.checked));
      };
      const box = h("input", { type: "checkbox", checked: /^(1|0x0*1|true)$/i.test(field.text ?? ""), disabled: current.state.is_read_only, "data-key": at, onchange: set });
      return h("label", { class: "choice" }, box, ` ${label}`, ...remarks);
    };
    const section = (part: PartForm): HTMLElement => {
      const rates = part.fields.filter(({ name }) => name.startsWith("BaudRate_"));
      const others = part.fields.filter((field) => !rates.includes(field));
      return h("section", { "data-place": part.place, "aria-label": TITLES[part.place] }, h("h3", {}, TITLES[part.place]), ...(found.get(part.place) ?? []).map(remark), ...(rates.length > 0 ? [h("fieldset", { class: "rates" }, h("legend", {}, "Bit rates"), ...rates.map((field) => row(part, field)))] : []), ...others.map((field) => row(part, field)));
    };
    view.dataset.shown = wanted();
    const hint = !current.outline.is_node && h("p", { class: "meaning" }, "A node-ID and a bit rate belong to a node: Configure makes a DCF or XDC with them.");
    redraw(view, h("h2", {}, "File and device"), hint, h("div", { class: "columns" }, ...parts.map(section)));
    focusWanted(store, view);
  });
  return view;
}
