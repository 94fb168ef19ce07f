// Middle: a PDO as eight bytes, with what it carries. Objects are added, moved and removed by mouse and by keyboard; each step changes
// the mapping entries in the file.

import { addressText, committing, disable, finds, h, hex, numberIn, placeOf, prose, redraw } from "./dom";
import type { FieldChange, Mappable, Mapped, Outline, PdoRow } from "./protocol";
import type { Store } from "./store";

const BITS = 64;
const MAX_SHOWN = 200;
const COLOURS = 8;

/** Data types that RPDOs carry as gaps. */
const DUMMIES: Mappable[] = [
  { index: 0x05, sub: 0, bits: 8, name: "gap of 8 bits (UNSIGNED8)", rpdo: true, tpdo: false },
  { index: 0x06, sub: 0, bits: 16, name: "gap of 16 bits (UNSIGNED16)", rpdo: true, tpdo: false },
  { index: 0x07, sub: 0, bits: 32, name: "gap of 32 bits (UNSIGNED32)", rpdo: true, tpdo: false },
];

const TRANSMISSION: [number, string][] = [
  [0, "0: synchronous, after a change"],
  [1, "1: at every SYNC"],
  [2, "2: at every second SYNC"],
  [10, "10: at every tenth SYNC"],
  [252, "252: sampled at SYNC, sent on request (RTR)"],
  [253, "253: sent on request (RTR)"],
  [254, "254: event of the vendor"],
  [255, "255: event of the device profile"],
];

export const bitsOf = (mapped: { bits: number }[]): number => mapped.reduce((sum, { bits }) => sum + bits, 0);

/** The colours of objects: each has its own in all PDOs that carry it. */
export function coloursOf({ pdos }: Outline): (mapped: Mapped) => string {
  const known = new Map<number, number>();
  const key = ({ index, sub }: Mapped) => index * 256 + sub;
  for (const mapped of pdos.flatMap((pdo) => pdo.mapped)) if (!known.has(key(mapped))) known.set(key(mapped), known.size % COLOURS);
  return (mapped) => `colour-${known.get(key(mapped)) ?? 0}`;
}

export const labelOf = (mapped: Mapped): string => mapped.name?.split(" / ").at(-1) ?? (mapped.index < 0x20 ? "gap" : "not described");

/** How many bits are drawn: those of a PDO, or all that are mapped if these are more. */
const drawnBits = (pdo: PdoRow): number => Math.max(BITS, bitsOf(pdo.mapped));
const share = (pdo: PdoRow, bits: number): string => `flex: 0 0 ${(100 * bits) / drawnBits(pdo)}%`;

/** Whether an object ends behind the last bit that a PDO can carry. */
const isBeyond = (pdo: PdoRow, at: number): boolean => bitsOf(pdo.mapped.slice(0, at + 1)) > BITS;

/** The bytes of a PDO to scale, with these blocks in them. */
export function bytesOf(pdo: PdoRow, blocks: HTMLElement[], attributes: Parameters<typeof h>[1] = {}): HTMLElement {
  const isOver = bitsOf(pdo.mapped) > BITS;
  const limit = isOver && h("div", { class: "limit", style: `left: ${(100 * BITS) / drawnBits(pdo)}%`, "aria-hidden": "true" });
  return h("div", { class: isOver ? "bytes over" : "bytes", style: `--byte: ${800 / drawnBits(pdo)}%`, ...attributes }, ...blocks, limit);
}

/** The same for a reader. */
export const picture = (pdo: PdoRow, colour: (mapped: Mapped) => string): HTMLElement =>
  bytesOf(pdo, pdo.mapped.map((mapped, at) => h("span", { class: `mapped ${colour(mapped)}${isBeyond(pdo, at) ? " beyond" : ""}`, style: share(pdo, mapped.bits), title: `${addressText(mapped.index, mapped.sub)} ${labelOf(mapped)}, ${mapped.bits} bits` }, h("span", { class: "name" }, labelOf(mapped)))), { class: `bytes small${bitsOf(pdo.mapped) > BITS ? " over" : ""}` });

/** The changes of the mapping entries that give a list of objects. */
export function mappingChanges(pdo: PdoRow, mapped: Mapped[], field: string): FieldChange[] {
  const number = ({ index, sub, bits }: Mapped) => ((index << 16) | (sub << 8) | bits) >>> 0;
  const changes: FieldChange[] = [];
  for (let sub = 1; sub <= Math.max(mapped.length, ...pdo.slots.map((slot) => slot.sub)); sub++) {
    const at = placeOf(pdo.mapping, sub);
    const object = mapped[sub - 1];
    const wanted = object ? number(object) : 0;
    const slot = pdo.slots.find((slot) => slot.sub === sub);
    const value = `0x${hex(wanted, 8)}`;
    if (slot && (slot.number ?? 0) !== wanted) changes.push({ change: "set", at: `${at} / ${field}`, value });
    else if (!slot && object) {
      const fields: [string, string][] = [["ParameterName", `Mapped object ${sub}`], ["ObjectType", "0x7"], ["DataType", "0x0007"], ["AccessType", "rw"], [field, value], ["PDOMapping", "0"]];
      changes.push({ change: "add", at, fields });
    }
  }
  const added = changes.filter(({ change }) => change === "add").length;
  if (added > 0) changes.push({ change: "set", at: `${placeOf(pdo.mapping)} / SubNumber`, value: String(pdo.slots.length + added + 1) });
  if (mapped.length !== pdo.mapped_count) changes.push({ change: "set", at: `${placeOf(pdo.mapping, 0)} / ${field}`, value: String(mapped.length) });
  return changes;
}

export function pdoView(store: Store): HTMLElement {
  const view = h("div", { class: "pdo scroll" });
  let filter = "";

  const field = () => (store.current!.outline.is_node ? "ParameterValue" : "DefaultValue");
  /** The changes wait for each other: each is made of the mapping that the one before has left. */
  let changes: Promise<unknown> = Promise.resolve();
  const change = (of: PdoRow, made: (mapped: Mapped[]) => Mapped[], focus?: number) => {
    const document = store.current!;
    changes = changes.then(async () => {
      const pdo = document.outline.pdos.find(({ mapping }) => mapping === of.mapping);
      if (!pdo) return;
      const done = await store.change({ do: "change", document: document.id, changes: mappingChanges(pdo, made(pdo.mapped), field()) });
      if (done && focus !== undefined) requestAnimationFrame(() => view.querySelector<HTMLElement>(`[data-key="mapped-${focus}"]`)?.focus());
    });
  };
  const add = (pdo: PdoRow, { index, sub, bits, name }: Mappable, at?: number, keepsFocus = false) =>
    change(pdo, (mapped) => mapped.toSpliced(at ?? mapped.length, 0, { index, sub, bits, name }), keepsFocus ? undefined : (at ?? pdo.mapped.length));
  const move = (pdo: PdoRow, from: number, to: number) => {
    if (to < 0 || to >= pdo.mapped.length || from === to) return;
    change(pdo, (mapped) => mapped.toSpliced(from, 1).toSpliced(to, 0, ...mapped.slice(from, from + 1)), to);
  };
  const remove = (pdo: PdoRow, at: number) =>
    change(pdo, (mapped) => mapped.toSpliced(at, 1), Math.max(0, at - 1));
  const communication = (pdo: PdoRow, sub: number, value: string) =>
    store.change({ do: "change", document: store.current!.id, changes: [{ change: "set", at: `${placeOf(pdo.communication, sub)} / ${field()}`, value }] });

  /** What is dragged: the position of a mapped object, or of one that can be mapped. */
  let dragged: { from: number } | { mappable: Mappable } | undefined;
  const drop = (pdo: PdoRow, at: number) => (event: DragEvent) => {
    event.preventDefault();
    event.stopPropagation();
    const what = dragged;
    dragged = undefined;
    if (!what) return;
    if ("from" in what) move(pdo, what.from, Math.min(at, pdo.mapped.length - 1));
    else add(pdo, what.mappable, at);
  };
  view.addEventListener("dragend", () => {
    dragged = undefined;
    store.draw();
  });
  const over = (event: DragEvent) => event.preventDefault();

  const block = (pdo: PdoRow, mapped: Mapped, at: number): HTMLElement => {
    const label = mapped.name ?? labelOf(mapped);
    return h(
      "div",
      {
        class: `mapped ${coloursOf(store.current!.outline)(mapped)}${isBeyond(pdo, at) ? " beyond" : ""}`,
        style: share(pdo, mapped.bits),
        role: "listitem",
        tabindex: 0,
        draggable: "true",
        title: `${addressText(mapped.index, mapped.sub)} ${label}, ${mapped.bits} bits`,
        "aria-label": `${addressText(mapped.index, mapped.sub)} ${label}, ${mapped.bits} bits. Alt with arrow keys moves, Delete removes`,
        "data-key": `mapped-${at}`,
        ondragstart: () => (dragged = { from: at }),
        ondragover: over,
        ondrop: drop(pdo, at),
        onkeydown: (event: KeyboardEvent) => {
          const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
          if (event.altKey && by) move(pdo, at, at + by);
          else if (by) view.querySelector<HTMLElement>(`[data-key="mapped-${at + by}"]`)?.focus();
          else if (event.key === "Delete" || event.key === "Backspace") remove(pdo, at);
          else return;
          event.preventDefault();
        },
      },
      h("span", { class: "address" }, addressText(mapped.index, mapped.sub)),
      h("span", { class: "name" }, label),
      h("button", { class: "quiet", "aria-label": `Remove ${label}`, onclick: () => remove(pdo, at) }, "×"),
    );
  };

  const bytes = (pdo: PdoRow): HTMLElement => {
    const used = bitsOf(pdo.mapped);
    const left = BITS - used;
    const words = left >= 0 ? `${left} of 64 bits left` : `${-left} bits more than a PDO can carry`;
    return h(
      "section",
      { "aria-label": "Content" },
      h("div", { class: "scale", "aria-hidden": "true" }, ...Array.from({ length: Math.ceil(drawnBits(pdo) / 8) }, (_, byte) => h("span", { style: share(pdo, 8), class: byte < 8 ? undefined : "remark error" }, left < 0 ? `${byte}` : `byte ${byte}`))),
      bytesOf(pdo, pdo.mapped.map((mapped, at) => block(pdo, mapped, at)), { role: "list", "aria-label": "Mapped objects", ondragover: over, ondrop: drop(pdo, pdo.mapped.length) }),
      h("p", { role: "status", class: left < 0 ? "remark error" : "meaning" }, words),
    );
  };

  const setting = (pdo: PdoRow, sub: number, label: string, text: string, meaning: string, choices?: [number, string][]): HTMLElement | false => {
    if (!pdo.communication_subs.includes(sub)) return false;
    const id = `pdo-${sub}`;
    const input = h("input", { id, value: text, "data-key": id, list: choices ? `${id}-choices` : undefined, autocomplete: "off", ...committing(text, (value) => communication(pdo, sub, value.split(":")[0]!.trim())) });
    return h(
      "div",
      { class: "field" },
      h("label", { for: id }, label),
      h("div", {}, input, choices && h("datalist", { id: `${id}-choices` }, ...choices.map(([value, words]) => h("option", { value: String(value) }, words))), h("p", { class: "meaning" }, meaning)),
    );
  };

  const settings = (pdo: PdoRow): HTMLElement => {
    const canId = pdo.can_id == null ? "" : `CAN-ID ${hex(pdo.can_id, 3)}h on this node${store.current!.outline.node_id ? "" : " (with node-ID 1)"}. `;
    const inhibit = pdo.inhibit_time ? `${pdo.inhibit_time / 10} ms at least between two messages` : "no inhibit time";
    const event = pdo.event_timer ? `sent every ${pdo.event_timer} ms at the latest` : "no event timer";
    const number = numberIn(pdo.cob_id ?? "");
    const cobId = Number.isNaN(number) ? (pdo.cob_id ?? "") : `0x${hex(number, 8)}`;
    return h(
      "section",
      { "aria-label": "Communication" },
      setting(pdo, 1, "COB-ID", cobId, `${canId}Bit 31 makes the PDO not valid; it is ${pdo.is_valid === false ? "not valid" : "valid"}.`),
      validity(pdo),
      setting(pdo, 2, "Transmission type", String(pdo.transmission_type ?? ""), pdo.transmission_words ?? "", TRANSMISSION),
      setting(pdo, 3, "Inhibit time", String(pdo.inhibit_time ?? ""), `In multiples of 100 µs: ${inhibit}.`),
      setting(pdo, 5, "Event timer", String(pdo.event_timer ?? ""), `In milliseconds: ${event}.`),
    );
  };

  const validity = (pdo: PdoRow): HTMLElement | false => {
    const [, prefix = "", digits = ""] = /^(\$NODEID\+)?(.+)$/i.exec(pdo.cob_id ?? "") ?? [];
    const number = numberIn(digits);
    if (Number.isNaN(number)) return false;
    const flipped = `${prefix}0x${hex((number ^ 0x80000000) >>> 0, 8)}`;
    return h("button", { onclick: () => void communication(pdo, 1, flipped) }, pdo.is_valid === false ? "Make the PDO valid" : "Make the PDO not valid");
  };

  const candidates = (pdo: PdoRow): HTMLElement => {
    const all = [...store.current!.outline.mappable.filter((entry) => (pdo.kind === "RPDO" ? entry.rpdo : entry.tpdo)), ...(pdo.kind === "RPDO" ? DUMMIES : [])];
    const left = BITS - bitsOf(pdo.mapped);
    const shown = (): Mappable[] => all.filter((entry) => finds(filter, `${addressText(entry.index, entry.sub)} ${entry.name}`));
    const input = h("input", {
      type: "search",
      value: filter,
      placeholder: "Address or name",
      "aria-label": "Search objects that can be mapped",
      "data-key": "mappable-search",
      onkeydown: (event: KeyboardEvent) => {
        const isMapped = ({ index, sub }: Mappable) => pdo.mapped.some((mapped) => mapped.index === index && mapped.sub === sub);
        const next = event.key === "Enter" ? shown().find((entry) => entry.bits <= left && !isMapped(entry)) : undefined;
        if (next) add(pdo, next, undefined, true);
      },
      oninput: ({ currentTarget }: Event) => {
        filter = (currentTarget as HTMLInputElement).value;
        store.draw();
      },
    });
    const row = (entry: Mappable) =>
      h(
        "li",
        { draggable: "true", ondragstart: () => (dragged = { mappable: entry }) },
        h("button", { class: entry.bits > left ? "mappable misfit" : "mappable", onclick: () => add(pdo, entry), "data-key": `mappable-${entry.index}-${entry.sub}` }, h("span", { class: "address" }, addressText(entry.index, entry.sub)), h("span", { class: "name" }, entry.name), h("span", { class: "type" }, entry.bits > left ? `${entry.bits} bits: does not fit` : `${entry.bits} bits`)),
      );
    return h("section", { "aria-label": "Objects that can be mapped" }, h("h3", {}, "Objects that can be mapped"), h("p", { class: "meaning" }, "A click adds an object, Enter the first one that fits; drag it to another place."), input, h("ul", { class: "candidates" }, ...shown().slice(0, MAX_SHOWN).map(row)));
  };

  const found = (pdo: PdoRow): HTMLElement | false => {
    const objects = [placeOf(pdo.communication), placeOf(pdo.mapping)];
    const about = store.current!.report.findings.filter((finding) => [finding, ...(finding.places ?? [])].some((at) => objects.some((object) => at.place?.startsWith(object))));
    return about.length > 0 && h("section", { "aria-label": "Findings about this PDO" }, ...about.map((finding) => h("p", { class: `remark ${finding.severity}` }, ...prose(finding.message))));
  };

  const wanted = () => `${store.current?.id}-${store.pdo}`;
  store.onLeave(() => view.dataset.shown !== wanted() && disable(view));
  store.onDraw(() => {
    view.hidden = store.view !== "pdo";
    const pdo = store.current?.outline.pdos[store.pdo];
    // what is dragged stays in the page until it is dropped
    if (view.hidden || dragged) return;
    if (!pdo) return redraw(view, h("p", { class: "nothing" }, "The device has no PDOs."));
    view.dataset.shown = wanted();
    redraw(
      view,
      h("h2", {}, `${pdo.kind} ${pdo.number} `, h("span", { class: "type" }, `${hex(pdo.communication, 4)}h, ${hex(pdo.mapping, 4)}h`)),
      bytes(pdo),
      found(pdo),
      candidates(pdo),
      settings(pdo),
    );
    if (store.wanted !== "PDO") return;
    store.wanted = undefined;
    view.querySelector<HTMLElement>('[data-key="mappable-search"]')?.focus();
  });
  return view;
}
