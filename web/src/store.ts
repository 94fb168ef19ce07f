// What is open and what is shown, and how it changes: each change asks the engine and draws what came of it.

import { ask, make, refusalOf } from "./engine";
import { hex, indexOf } from "./dom";
import type { Home } from "./files";
import type { LogSummary, MadeFile, NetworkView, Opened, Outline, Report, Request, State } from "./protocol";

export type View = "overview" | "form" | "table" | "facts" | "text" | "diff" | "pdo" | "compare" | "network" | "log";

/** The views of each kind of document, the first one at first. */
export const VIEWS: Record<State["kind"], View[]> = {
  device: ["overview", "form", "table", "pdo", "facts", "text", "diff", "compare"],
  network: ["network", "text", "diff"],
  log: ["log"],
};

/** The views that show any object. */
const BY_OBJECT: View[] = ["form", "table", "text"];

const NO_OUTLINE: Outline = { is_node: false, objects: [], pdos: [], mappable: [] };
const NO_REPORT: Report = { findings: [], summary: { errors: 0, warnings: 0, notes: 0 } };

export interface OpenDocument {
  id: number;
  state: State;
  outline: Outline;
  report: Report;
  /** How far the check is, whose report comes a little after the objects. */
  check: "running" | "done" | "failed";
  /** Whether the report has its fixes yet. */
  has_fixes: boolean;
  /** The text that the report is about. */
  checked: number;
  original: string;
  /** Where it is saved in place. */
  home?: Home;
  /** What was saved last. */
  saved?: string;
  network?: NetworkView;
  log?: LogSummary;
  /** What was opened; nothing if it was made here. */
  bytes?: Uint8Array;
  /** The signals of a log that are drawn. */
  plots?: string[];
  /** The documents that a log is read with; those that suit if nothing was chosen. */
  with?: number[];
  /** The state of all documents that network or log were read with. */
  seen?: number;
}

/** A document that is opened again with its changes. */
export interface Draft {
  name: string;
  bytes: Uint8Array;
  text: string;
  encoding: string;
  saved?: string;
  home?: Home;
}

export const textBytes = (text: string): Uint8Array => new TextEncoder().encode(text);

export interface Notice {
  kind: "error" | "note";
  message: string;
  help?: string;
  /** What can be done about it, on buttons. */
  actions?: { label: string; make: () => void }[];
}

/** What a document has, to be compared with what was saved. */
export const contentOf = ({ state }: Pick<OpenDocument, "state">): string => `${state.encoding}\n${state.text}`;

/** The parts of a page that are drawn anew. */
export type Drawing = (store: Store) => unknown;

export class Store {
  documents: OpenDocument[] = [];
  current: OpenDocument | undefined;
  view: View = "overview";
  /** The index of the shown object. */
  index: number | undefined;
  /** The position of the shown PDO. */
  pdo = 0;
  search = "";
  /** The place whose field gets the focus when it is drawn. */
  wanted: string | undefined;
  /** How numbers are shown. */
  base: "text" | "hex" | "dec" = "text";
  /** The document that the shown one is compared with. */
  compared: number | undefined;
  /** The tools whose reactions are shown. */
  tools: string[] = [];
  notice: Notice | undefined;
  /** Counts the changes of all documents: a network is made of several. */
  revision = 0;
  /** Sends what was typed; the text has it replaced. */
  sendTyped: () => Promise<void> = async () => {};
  /** The last of what is done in turn. */
  private turn: Promise<unknown> = Promise.resolve();
  private drawings: Drawing[] = [];
  private leavings: Drawing[] = [];
  private scheduled = false;
  /** The part of the address that is of this page, not of a link. */
  private own = "";

  onDraw(drawing: Drawing): void {
    this.drawings.push(drawing);
  }

  /** Called at once when something else is selected: until the next frame, the page still shows the former fields. */
  onLeave(leaving: Drawing): void {
    this.leavings.push(leaving);
  }

  draw(): void {
    this.leavings.forEach((leaving) => leaving(this));
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame(() => {
      this.scheduled = false;
      if (this.current) void this.readTogether(this.current);
      // one part that fails takes no other with it
      for (const drawing of this.drawings) void (async () => drawing(this))().catch((error: unknown) => this.say(error));
    });
  }

  /** Does something that may be refused, and says so. */
  async attempt(what: () => Promise<unknown>): Promise<boolean> {
    try {
      await what();
      return true;
    } catch (error) {
      this.say(error);
      return false;
    }
  }

  say(error: unknown): void {
    const refusal = refusalOf(error);
    // a part that fails each time would be drawn for ever
    if (this.notice?.message === refusal.message) return;
    this.notice = { kind: "error", ...refusal };
    this.draw();
  }

  /** Opens a file; the document if it was not refused. */
  async open(name: string, bytes: Uint8Array, home?: Home): Promise<OpenDocument | undefined> {
    let opened: OpenDocument | undefined;
    await this.attempt(async () => (opened = await this.load(name, bytes, home)));
    return opened;
  }

  async load(name: string, bytes: Uint8Array, home?: Home): Promise<OpenDocument> {
    return this.take(await ask<Opened>({ do: "open", name }, bytes), bytes, home);
  }

  /** Shows a document that the engine has opened. */
  async take({ document: id, state, notes }: Opened, bytes?: Uint8Array, home?: Home): Promise<OpenDocument> {
    const opened: OpenDocument = { id, state, home, bytes, outline: NO_OUTLINE, report: NO_REPORT, check: "running", has_fixes: false, checked: state.revision, original: state.text };
    const [outline, checked] = this.read(opened);
    await outline;
    this.documents.push(opened);
    this.revision++;
    this.notice = state.devices > 1 ? { kind: "note", message: `The file has ${state.devices} devices; the first is shown.` } : undefined;
    if (notes && notes.length > 0) this.notice = { kind: "note", message: notes.join("; ") };
    this.view = VIEWS[state.kind][0]!;
    this.show(opened);
    this.follow();
    // the document can be used while the engine checks
    void this.attempt(async () => {
      await checked;
      this.draw();
    });
    return opened;
  }

  /** Shows what the address of the page names: the object of `#6041`, the PDO of `#TPDO2`. */
  follow(): void {
    if (location.hash === this.own) return this.draw();
    const { objects, pdos } = this.current?.outline ?? NO_OUTLINE;
    const index = /^#(?:0x)?([0-9a-f]{4})h?$/i.exec(location.hash)?.[1];
    const found = objects.find((object) => object.index === parseInt(index ?? "", 16));
    if (found) [this.index, this.own] = [found.index, location.hash];
    if (found && !BY_OBJECT.includes(this.view)) this.view = "form";
    const pdo = pdos.findIndex(({ kind, number }) => `#${kind}${number}`.toLowerCase() === location.hash.toLowerCase());
    if (pdo >= 0) [this.pdo, this.view] = [pdo, "pdo"];
    this.draw();
  }

  /** What is shown of a document beside its text: first its objects, then what the check finds. */
  private read(of: OpenDocument): Promise<void>[] {
    const { id: document, state } = of;
    if (state.kind !== "device") return [];
    const outlined = ask<Outline>({ do: "outline", document }).then((outline) => void (of.outline = outline));
    const checked = ask<Report>({ do: "check", document, tools: this.tools }).then((report) => {
      Object.assign(of, { report, check: "done", has_fixes: false, checked: state.revision });
      // what is drawn now asks before
      setTimeout(() => void this.findFixes(of));
    });
    // of both, who waits for them tells the first failure
    checked.catch(() => {
      Object.assign(of, { report: NO_REPORT, check: "failed", has_fixes: true });
      this.draw();
    });
    return [outlined, checked];
  }

  /** Reads a network or a log with the documents as they are now. */
  private async readTogether(of: OpenDocument): Promise<void> {
    if (of.state.kind === "device" || of.seen === this.revision) return;
    of.seen = this.revision;
    const is_read = await this.attempt(async () => {
      if (of.state.kind === "network") {
        of.network = await ask<NetworkView>({ do: "network", document: of.id });
        of.report = of.network.report;
      } else {
        of.log = await ask<LogSummary>({ do: "decode", document: of.id, with: this.descriptionsFor(of), plots: of.plots ?? [] });
        of.report = of.log.report;
      }
    });
    Object.assign(of, { check: is_read ? "done" : "failed", has_fixes: true });
    this.draw();
  }

  /** What a log is read with: what was chosen, else the network that is open, else all descriptions. */
  descriptionsFor(log: OpenDocument): number[] {
    const ids = (kind: State["kind"]) => this.documents.filter((document) => document.state.kind === kind).map(({ id }) => id);
    const chosen = log.with?.filter((id) => this.documents.some((document) => document.id === id));
    const networks = ids("network");
    return chosen ?? (networks.length > 0 ? networks.slice(-1) : ids("device"));
  }

  /** Which fixes are sound takes some checks of the text, so they come behind the findings. */
  private async findFixes(of: OpenDocument): Promise<void> {
    const { revision } = of.state;
    const report = await ask<Report>({ do: "check", document: of.id, fixes: true, tools: this.tools }).catch(() => of.report);
    if (of.state.revision !== revision) return;
    Object.assign(of, { report, has_fixes: true, checked: revision });
    this.draw();
  }

  /** Does one thing after the other, in the order in which the user asked for them. */
  enqueue<T>(what: () => Promise<T>): Promise<T> {
    const done = this.turn.then(what);
    this.turn = done.catch(() => {});
    return done;
  }

  /** The same after what was typed so far. */
  inTurn<T>(what: () => Promise<T>): Promise<T> {
    const typed = this.sendTyped();
    return this.enqueue(async () => {
      await typed;
      return what();
    });
  }

  /** Ends when all that was typed and changed so far is in the documents. */
  settled(): Promise<void> {
    return this.inTurn(async () => {});
  }

  /** Changes a document, also one that is no longer shown. */
  async change(request: Request & { document: number }): Promise<boolean> {
    return this.attempt(() => this.edit(request));
  }

  /** The same, for those who say themselves why it was refused. */
  async edit(request: Request & { document: number }): Promise<void> {
    const of = this.documents.find(({ id }) => id === request.document);
    await this.inTurn(async () => {
      const state = await ask<State>(request);
      if (of) of.state = state;
    });
    this.notice = undefined;
    if (of) await this.refresh(of);
  }

  /** The files that a request makes of the documents as they are now. */
  make(request: Request): Promise<{ files: MadeFile[]; notes: string[] }> {
    return this.inTurn(() => make(request));
  }

  /** Reads the objects and findings of a document again. */
  async refresh(of: OpenDocument): Promise<void> {
    await Promise.all(this.read(of));
    this.changed();
  }

  /** The findings anew, with the reactions of other tools. */
  async recheck(): Promise<void> {
    await this.attempt(async () => {
      for (const document of this.documents) await Promise.all(this.read(document));
    });
    this.draw();
  }

  /** After a change of a document, of which others may be made. */
  changed(): void {
    this.revision++;
    this.draw();
  }

  async close(document: OpenDocument): Promise<void> {
    await this.attempt(() => ask({ do: "close", document: document.id }));
    this.documents = this.documents.filter((other) => other !== document);
    const last = this.documents.at(-1);
    this.revision++;
    if (this.current === document && last) this.show(last);
    else if (!last) this.current = undefined;
    this.draw();
  }

  show(document: OpenDocument): void {
    this.current = document;
    this.index = document.outline.objects[0]?.index;
    this.pdo = 0;
    this.search = "";
    const views = VIEWS[document.state.kind];
    if (!views.includes(this.view)) this.view = views[0]!;
    this.draw();
  }

  /** Shows an object, and has it in the address. */
  select(index: number, view: View = this.view === "table" ? "table" : "form"): void {
    this.index = index;
    this.view = view;
    this.address(hex(index, 4));
  }

  /** Shows the field of a place, such as `0x1018sub1 / DefaultValue`; `false` if there is none. */
  selectPlace(place: string): boolean {
    const index = indexOf(place);
    const isObject = this.current?.outline.objects.some((object) => object.index === index);
    if (!isObject && !/^(FileInfo|DeviceInfo|DeviceComissioning)\b/.test(place)) return false;
    this.wanted = place;
    if (isObject) this.select(index!);
    else this.view = "facts";
    this.draw();
    return true;
  }

  private address(own: string): void {
    this.own = `#${own}`;
    history.replaceState(null, "", this.own);
    this.draw();
  }

  /** Shows a PDO, and has it in the address. */
  selectPdo(position: number): void {
    const pdo = this.current!.outline.pdos[position]!;
    this.pdo = position;
    this.view = "pdo";
    this.address(`${pdo.kind}${pdo.number}`);
  }

  /** Opens a file as it was and changes it to what became of it; a file of the disk that is open already is changed. `false` if that was refused. */
  async restore({ name, bytes, text, encoding, saved, home }: Draft): Promise<boolean> {
    const known = home && this.documents.find((document) => document.home?.number === home.number);
    const of = known ?? (await this.open(name, bytes, home));
    if (!of) return false;
    const document = of.id;
    const isEncoded = of.state.encoding === encoding || (await this.change({ do: "encode", document, encoding }));
    if (!isEncoded) return false;
    if (of.state.kind !== "log" && of.state.text !== text) {
      const lines = of.state.text.split(/\r\n|\r|\n/);
      const edits = [{ line: 1, column: 1, end_line: lines.length, end_column: [...lines.at(-1)!].length + 1, text }];
      if (!(await this.change({ do: "edit", document, revision: of.state.revision, edits }))) return false;
    }
    Object.assign(of, { saved, home });
    this.draw();
    return true;
  }

  /** After the engine failed: what is open is opened again, as it was. */
  async reopen(): Promise<void> {
    const former = this.documents;
    const message = "The engine failed, which is an error of objdict, and was started again. The files are open as they were; undo takes all changes of a file back at once.";
    this.documents = [];
    this.current = undefined;
    for (const { state, bytes, original, home, saved } of former) {
      const { name, text, encoding } = state;
      await this.restore({ name, bytes: bytes ?? textBytes(original), text, encoding, home, saved });
    }
    this.notice = { kind: "error", message };
    this.draw();
  }
}
