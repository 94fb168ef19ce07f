// Middle: a network. What it sends and how late that may be, who is linked with whom, and all files that are built of it.

import { finds, h, hex, redraw } from "./dom";
import { download } from "./output";
import type { LinkChange, Mappable, NetworkEnd, NetworkView, Overview, Side, Timing } from "./protocol";
import type { Store } from "./store";
import { zip } from "./zip";

const MAX_SHOWN = 200;

const percent = (thousandths: number): string => `${(thousandths / 1000).toFixed(1)} %`;
const milliseconds = (nanoseconds: number | undefined | null): string => (nanoseconds == null ? "" : `${+(nanoseconds / 1e6).toFixed(3)} ms`);
const hexText = (canId: string): string => `${canId.replace(/^0x/, "").replace(/h$/, "")}h`;
const ends = (list: NetworkEnd[]): string => list.map((end) => `${end.service} of ${end.node}`).join(", ");

/** An end of a link as a network file spells it. */
const endOf = (side: Side, entry?: Mappable): string =>
  entry ? `${side.node}.${hex(entry.index, 4)}${entry.sub > 0 ? `:${entry.sub.toString(16).toUpperCase()}` : ""}` : side.node;

export function table(titles: string[], rows: (string | HTMLElement)[][], caption: string): HTMLElement {
  const head = h("tr", {}, ...titles.map((title) => h("th", { scope: "col" }, title)));
  const body = rows.map((row) => h("tr", {}, ...row.map((cell) => h("td", {}, cell))));
  return h("div", { class: "wide", tabindex: 0, role: "region", "aria-label": caption }, h("table", {}, h("caption", {}, caption), h("thead", {}, head), h("tbody", {}, ...body)));
}

function facts({ nodes, bit_rate }: Overview, timing: Timing | undefined, missing: [string, string][]): HTMLElement {
  const count = nodes.length + missing.length;
  const parts = [`${count} node${count === 1 ? "" : "s"}`, bit_rate ? `${bit_rate} kbit/s` : "no bit rate, so no load"];
  if (missing.length > 0) parts.push(`no verdict about load and times: ${missing.length === 1 ? "one node was" : `${missing.length} nodes were`} not read`);
  if (timing) parts.push(`load ${percent(timing.average)} on average, ${percent(timing.worst)} at worst`, timing.is_met ? "all messages are in time" : "some messages may be late");
  return h("p", { class: "facts load" }, parts.join(" · "));
}

function tables(overview: Overview, timing: Timing | undefined): HTMLElement[] {
  const timed = new Map(timing?.messages.map((message) => [hexText(message.can_id), message]));
  const nodes = overview.nodes.map((node) => [node.node_id == null ? "?" : String(node.node_id), node.is_manager ? `${node.name} (manager)` : node.name, node.description, node.heartbeat ? `${node.heartbeat} ms` : "", String(node.downloads)]);
  const messages = overview.messages
    .filter((message) => message.senders.length > 0)
    .map((message) => {
      const time = timed.get(hexText(message.can_id));
      const response = time?.response == null ? (time?.is_unbounded ? "at any time" : "") : milliseconds(time.response);
      const late = time?.is_missed ? h("span", { class: "remark error" }, `${response || "no bound"}, too late`) : response;
      return [hexText(message.can_id), ends(message.senders), ends(message.receivers), message.bytes == null ? "" : String(message.bytes), message.trigger, message.period == null ? "" : milliseconds(message.period * 1000), late, milliseconds(time?.deadline)];
    });
  const carried = overview.links.flatMap((link) =>
    link.entries.map((entry) => [hexText(link.can_id), link.sender ? `${link.sender.service} of ${link.sender.node}` : "no node", entry.from ?? "", link.receiver ? `${link.receiver.service} of ${link.receiver.node}` : "no node", entry.to ?? ""]),
  );
  const rates = timing?.rates.map((rate) => [`${rate.bit_rate} kbit/s`, percent(rate.worst), rate.fits ? "fits" : "does not fit"]) ?? [];
  const boot = overview.boot?.nodes.map((node) => [String(node.node_id), node.name, h("ol", {}, ...node.steps.map((step) => h("li", {}, step)))]) ?? [];
  return [
    table(["Node", "Name", "Description", "Heartbeat", "Downloads"], nodes, "Nodes"),
    table(["CAN-ID", "From", "To", "Bytes", "Trigger", "Period", "Received after", "Deadline"], messages, "Messages, highest priority first"),
    h("details", {}, h("summary", {}, `What PDOs carry (${carried.length})`), table(["CAN-ID", "From", "Entry", "To", "Entry"], carried.slice(0, MAX_SHOWN), "What PDOs carry")),
    ...(rates.length > 0 ? [h("details", {}, h("summary", {}, "Load at other bit rates"), table(["Bit rate", "Load at worst", ""], rates, "Load at other bit rates"))] : []),
    ...(boot.length > 0 ? [h("details", {}, h("summary", {}, `How ${overview.boot!.manager} boots the nodes`), table(["Node", "Name", "Steps"], boot, "Boot plan"))] : []),
  ];
}

/** Each node as a card; those that were not read say which file to drop. */
function nodeCards({ nodes }: Overview, missing: [string, string][]): HTMLElement {
  const read = nodes.map((node, at) => h("li", { class: `card node colour-${at % 8}` }, h("strong", {}, node.name), ` ${node.node_id ?? "?"}`, h("p", { class: "meaning" }, node.is_manager ? "manager" : node.description)));
  const unread = missing.map(([node, file]) => h("li", { class: "card node missing" }, h("strong", {}, node), h("p", { class: "remark warning" }, "drop ", h("code", {}, file), " here")));
  return h("ul", { class: "plain nodes", "aria-label": "Nodes" }, ...read, ...unread);
}

/** The picture as an image: nothing in it can run. */
const picture = (svg: string): HTMLElement =>
  h("div", { class: "wide picture", tabindex: 0, role: "region", "aria-label": "Picture of the network" }, h("img", { src: `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg)}`, alt: "Nodes as columns, messages as rows with arrows from sender to receivers; the table of messages has the same" }));

/** One side of the board: the entries of a node, to drag or to choose. */
class Column {
  readonly element: HTMLElement;
  private choice = h("select", { onchange: () => this.show() });
  private filter = h("input", { type: "search", placeholder: "Index or name", oninput: () => this.show() });
  private list = h("ul", { class: "candidates" });
  private sides: Side[] = [];
  /** The name of the node: it stays when the text changes. */
  private node = "";

  constructor(
    private which: "tpdo" | "rpdo",
    private item: (side: Side, entry: Mappable | undefined) => Record<string, string | boolean | ((event: never) => void)>,
  ) {
    const title = which === "tpdo" ? "Sends" : "Receives";
    this.choice.setAttribute("aria-label", `Node that ${title.toLowerCase()}`);
    this.filter.setAttribute("aria-label", `Search entries of the node that ${title.toLowerCase()}`);
    this.choice.addEventListener("change", () => (this.node = this.choice.value));
    this.element = h("section", { class: `side ${which}`, "aria-label": title }, h("h3", {}, title), this.choice, this.filter, this.list);
  }

  draw(sides: Side[], first: number): void {
    this.sides = sides;
    if (!sides.some((side) => side.node === this.node)) this.node = (sides[first] ?? sides[0])?.node ?? "";
    this.choice.replaceChildren(...sides.map((side) => h("option", { value: side.node, selected: side.node === this.node }, side.node_id == null ? side.node : `${side.node} (node ${side.node_id})`)));
    this.show();
  }

  show(): void {
    const side = this.sides.find((side) => side.node === this.choice.value);
    if (!side) return;
    const row = (label: string, name: string, type: string, entry?: Mappable) =>
      h("li", {}, h("button", { class: "mappable", type: "button", ...this.item(side, entry) }, h("span", { class: "address" }, label), h("span", { class: "name" }, name), h("span", { class: "type" }, type)));
    const entries = side.entries.filter((entry) => entry[this.which]).filter((entry) => finds(this.filter.value, `${hex(entry.index, 4)}h:${hex(entry.sub, 2)} ${entry.name}`));
    const shown = entries.slice(0, MAX_SHOWN).map((entry) => row(`${hex(entry.index, 4)}h:${hex(entry.sub, 2)}`, entry.name, `${entry.bits} bits`, entry));
    if (side.is_manager) shown.unshift(row(side.node, "the manager, which has the other side of each PDO", ""));
    redraw(this.list, ...(shown.length > 0 ? shown : [h("li", { class: "nothing" }, "No entries that PDOs can carry.")]));
  }
}

/** Links as the file has them, and a board on which an entry is dragged to another one. */
function board(store: Store): { element: HTMLElement; draw: (view: NetworkView) => void } {
  /** The end that was chosen or is dragged. */
  let from: string | undefined;
  let dragged: { link: number; end: number } | undefined;
  const change = (link: LinkChange) => void store.change({ do: "link", document: store.current!.id, link });
  const drop = (to: string) => {
    if (dragged) change({ change: "move", link: dragged.link, end: dragged.end, to });
    else if (from) change({ change: "add", from, to });
    from = dragged = undefined;
    say();
  };
  const status = h("p", { class: "meaning", role: "status" });
  const say = () => {
    status.textContent = from ? `${from} is chosen: choose where it goes on the right.` : "Drag an entry from the left to one on the right, or choose both with Enter.";
    for (const button of element.querySelectorAll<HTMLElement>(".tpdo .mappable")) button.setAttribute("aria-pressed", String(button.dataset.end === from));
  };
  const over = (event: DragEvent) => event.preventDefault();
  const dropped = (to: string, which: 0 | 1) => (event: DragEvent) => {
    event.preventDefault();
    event.stopPropagation();
    if (dragged ? (dragged.end === 0) === (which === 0) : which === 1) drop(to);
  };
  const left = new Column("tpdo", (side, entry) => {
    const end = endOf(side, entry);
    return { draggable: "true", "data-end": end, "aria-pressed": "false", ondragstart: () => ((from = end), (dragged = undefined)), ondragover: over, ondrop: dropped(end, 0), onclick: () => ((from = from === end ? undefined : end), say()) };
  });
  const right = new Column("rpdo", (side, entry) => {
    const end = endOf(side, entry);
    return { "data-end": end, ondragover: over, ondrop: dropped(end, 1), onclick: () => (from ? drop(end) : say()) };
  });
  const list = h("ul", { class: "links" });
  const element = h("section", { class: "board", "aria-label": "Links" }, h("h3", {}, "Links"), list, status, h("div", { class: "sides" }, left.element, right.element));
  element.addEventListener("dragend", () => ((from = dragged = undefined), say()));
  const endChip = (text: string, link: number, end: number, label: string) =>
    h("code", { draggable: "true", class: "end", title: `Drag to another entry that ${label}`, ondragstart: () => ((dragged = { link, end }), (from = undefined)) }, text);
  return {
    element,
    draw: ({ sides = [], links = [], can_link }) => {
      element.hidden = !can_link && links.length === 0;
      element.querySelector<HTMLElement>(".sides")!.hidden = status.hidden = !can_link;
      redraw(
        list,
        ...links.map((link, number) =>
          h("li", {}, endChip(link.from, number, 0, "sends"), " → ", ...link.to.flatMap((to, at) => [at > 0 ? ", " : "", endChip(to, number, at + 1, "receives")]), " ", h("button", { class: "quiet", "aria-label": `Remove the link of ${link.from}`, onclick: () => change({ change: "remove", link: number }) }, "Remove")),
        ),
        ...(links.length === 0 ? [h("li", { class: "nothing" }, "The file has no links.")] : []),
      );
      left.draw(sides, 0);
      right.draw(sides, 1);
      say();
    },
  };
}

export function networkView(store: Store): HTMLElement {
  const view = h("div", { class: "network scroll" });
  const links = board(store);
  const head = h("div", {});
  const rest = h("div", {});
  view.append(head, links.element, rest);
  let shown: NetworkView | undefined;
  const build = () =>
    void store.attempt(async () => {
      const { files, notes } = await store.make({ do: "build", document: store.current!.id });
      download(`${store.current!.state.name.replace(/\.[^.]*$/, "")}.zip`, zip(files));
      store.notice = notes.length > 0 ? { kind: "note", message: notes.join("; ") } : undefined;
      store.draw();
    });
  store.onDraw(() => {
    const network = store.current?.network;
    // until the engine has read this network, the links would be those of another one
    view.hidden = store.view !== "network" || !network;
    if (view.hidden || !network || network === shown) return;
    shown = network;
    const { overview, timing, missing = [] } = network;
    rest.hidden = !overview;
    if (!overview) {
      links.element.hidden = true;
      redraw(head, h("p", { class: "nothing" }, "The text is not a network that can be read; the findings say why."));
      return;
    }
    redraw(head, h("div", { class: "bar" }, h("h2", {}, overview.name ?? "Network"), h("button", { class: "main", onclick: build, disabled: missing.length > 0 }, "Build and download")), facts(overview, timing, missing), nodeCards(overview, missing), picture(network.picture ?? ""));
    links.draw(network);
    redraw(rest, ...tables(overview, timing));
  });
  return view;
}
