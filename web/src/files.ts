// The files that `objdict open` serves: open when the page is loaded, in a list, and saved in place. Elsewhere there are none.

import { Refused, ask } from "./engine";
import { Dialog } from "./dialog";
import { finds, h, redraw } from "./dom";
import type { Opened, Refusal } from "./protocol";
import { contentOf, type OpenDocument, type Store } from "./store";

/** A file as the command lists it (crates/objdict-cli/src/open/files.rs). */
interface Served {
  name: string;
  kind: "description" | "network" | "other";
  /** Of a network, the numbers of the descriptions of its nodes. */
  nodes: number[];
  is_open: boolean;
  is_read_only: boolean;
}

/** Where a document is from. */
export interface Home {
  number: number;
  /** The version on the disk that it is made of. */
  etag: string;
  /** Another version there, which was told. */
  seen?: string;
}

/** How often it is asked whether another program has changed a file, in ms. */
const PERIOD = 2000;

/** So many are drawn; the search has the others. */
const MAX_SHOWN = 400;

/** What is asked before something is lost. */
interface Question {
  title: string;
  question: string;
  answer: string;
  make: () => Promise<unknown>;
}

export class Files {
  readonly buttons: HTMLElement[];
  private readonly place = document.querySelector<HTMLMetaElement>('meta[name="objdict-files"]')?.content;
  private list: Served[] = [];
  private readonly entries = h("ul", { class: "candidates" });
  private readonly search = h("input", { type: "search", placeholder: "Name", "aria-label": "Search files", oninput: () => this.drawList() });
  private readonly listed: Dialog;
  private readonly asked: Dialog<Question>;
  /** What is saved is not compared with the disk meanwhile. */
  private turn: Promise<unknown> = Promise.resolve();

  constructor(private readonly store: Store) {
    this.listed = new Dialog(store, "files", { title: "Files", choices: [this.search, this.entries], prepare: () => this.listAgain() });
    this.asked = questionDialog(store);
    const show = h("button", { onclick: () => this.listed.show() }, "Files …");
    const save = h("button", { title: "Ctrl+S", onclick: () => void this.save() }, "Save");
    this.buttons = this.place === undefined ? [] : [show, save];
    store.onDraw(() => (save.disabled = !this.canSave()));
  }

  /** Whether a document has changes that are in no file. */
  isChanged(document: OpenDocument): boolean {
    return document.saved === undefined ? document.state.is_changed : contentOf(document) !== document.saved;
  }

  /** Loads the list and opens what was named on the command line. */
  async start(): Promise<void> {
    if (this.place === undefined) return;
    const isListed = await this.store.attempt(() => this.load());
    for (const number of this.list.keys()) if (this.list[number]!.is_open) await this.open(number);
    const { documents } = this.store;
    const named = documents.find(({ home }) => home && this.list[home.number]!.is_open) ?? documents[0];
    if (named) this.store.show(named);
    else if (isListed) this.listed.show();
    setInterval(() => void this.inTurn(() => this.look()), PERIOD);
  }

  private async load(): Promise<void> {
    this.list = ((await (await this.fetch("")).json()) as { files: Served[] }).files;
  }

  /** The list with what is new in the folders. */
  private async listAgain(): Promise<void> {
    this.drawList();
    await this.load();
    this.drawList();
  }

  private inTurn(what: () => Promise<unknown>): Promise<unknown> {
    return (this.turn = this.turn.then(what).catch(() => {}));
  }

  /** Looks for files that other programs have changed. */
  private async look(): Promise<void> {
    if (document.hidden) return;
    for (const shown of this.store.documents.filter(({ home, state }) => home && state.kind !== "log")) {
      const home = shown.home!;
      const found = await fetch(`${this.place}/${home.number}`, { method: "HEAD" }).catch(() => undefined);
      const etag = found?.ok ? found.headers.get("etag")! : home.etag;
      if (etag === home.etag) home.seen = undefined;
      else if (etag !== home.seen) await this.follow(shown, (home.seen = etag));
    }
  }

  /** Takes over a file that another program has changed, or asks if it has changes here too. */
  private async follow(shown: OpenDocument, etag: string): Promise<void> {
    const { name } = this.list[shown.home!.number]!;
    await this.store.settled();
    if (!this.isChanged(shown)) {
      if (await this.reload(shown)) this.say(`${name} was changed by another program, and is shown as it is now.`);
      // what was typed meanwhile is asked about the next time
      else shown.home!.seen = undefined;
      return;
    }
    const message = `\`${name}\` was changed by another program, and has changes here that are not saved`;
    const actions = [
      { label: "Load it from the disk", make: () => void this.reload(shown) },
      { label: "Compare", make: () => void this.store.attempt(() => this.compare(shown)) },
      { label: "Replace it on the disk …", make: () => ((shown.home!.etag = etag), this.store.show(shown), void this.save()) },
    ];
    this.store.notice = { kind: "error", message, actions };
    this.store.draw();
  }

  /** Changes a document to what is on the disk, so that undo takes it back, and what is typed meanwhile is not lost. */
  private reload(shown: OpenDocument): Promise<boolean> {
    let isDone = false;
    const reload = async () => {
      const { name, bytes, home } = await this.read(shown.home!.number);
      const { document, state } = await ask<Opened>({ do: "open", name }, bytes);
      await ask({ do: "close", document });
      isDone = await this.store.restore({ name, bytes, text: state.text, encoding: state.encoding, saved: contentOf({ state }), home });
    };
    return this.store.attempt(reload).then(() => isDone);
  }

  /** Compares with what is on the disk, which has no place of its own there. */
  private async compare(shown: OpenDocument): Promise<void> {
    const { store } = this;
    const { name, bytes } = await this.read(shown.home!.number);
    store.compared = (await store.load(`disk/${name}`, bytes)).id;
    store.show(shown);
    store.view = "compare";
  }

  /** What is on the disk now. */
  private async read(number: number): Promise<{ name: string; bytes: Uint8Array; home: Home }> {
    const response = await this.fetch(`/${number}`);
    const home = { number, etag: response.headers.get("etag")! };
    return { name: this.list[number]!.name, bytes: new Uint8Array(await response.arrayBuffer()), home };
  }

  /** Asks before the shown file is replaced; `false` if it cannot be saved in place. */
  async save(): Promise<boolean> {
    const [home, shown] = [this.canSave(), this.store.current];
    if (!home || !shown) return false;
    const { name } = this.list[home.number]!;
    const isTaken = await this.store.attempt(() => this.store.settled());
    if (isTaken && this.isChanged(shown)) this.asked.show({ title: "Save", question: `Replace ${name} on the disk?`, answer: "Replace", make: () => this.inTurn(() => this.write(shown)) });
    else if (isTaken) this.say(`${name} has no changes.`);
    return true;
  }

  /** Asks before changes that are in no file are thrown away. */
  async close(document: OpenDocument): Promise<void> {
    const isTaken = await this.store.attempt(() => this.store.settled());
    if (isTaken && !this.isChanged(document)) return this.store.close(document);
    this.asked.show({ title: "Close", question: `${document.state.name} has changes that are not saved.`, answer: "Close without saving", make: () => this.store.close(document) });
  }

  private canSave(): Home | undefined {
    const home = this.store.current?.home;
    return home && !this.list[home.number]!.is_read_only ? home : undefined;
  }

  private async write(document: OpenDocument): Promise<void> {
    const home = document.home!;
    await this.store.attempt(async () => {
      const saved = contentOf(document);
      const { files } = await this.store.make({ do: "bytes", document: document.id });
      const response = await this.fetch(`/${home.number}`, { method: "PUT", headers: { "If-Match": home.etag }, body: files[0]!.bytes as BodyInit });
      home.etag = response.headers.get("etag")!;
      document.saved = saved;
      this.say(`${this.list[home.number]!.name} is saved.`);
    });
  }

  private say(message: string): void {
    this.store.notice = { kind: "note", message };
    this.store.draw();
  }

  /** Opens a file, of a network the descriptions of its nodes first. */
  private async open(number: number): Promise<void> {
    const { store } = this;
    const { nodes } = this.list[number]!;
    for (const node of nodes) await this.open(node);
    const known = store.documents.find((document) => document.home?.number === number);
    if (known) return store.show(known);
    await store.attempt(async () => {
      const { name, bytes, home } = await this.read(number);
      await store.load(name, bytes, home);
    });
  }

  private async fetch(below: string, options: RequestInit = {}): Promise<Response> {
    const response = await fetch(`${this.place}${below}`, options).catch(() => {
      throw new Refused({ message: "`objdict open` does not answer", help: "start it again, or save the file elsewhere with `Save as …`" });
    });
    if (response.ok) return response;
    const answer = (await response.json().catch(() => undefined)) as { error: Refusal } | undefined;
    throw new Refused(answer?.error ?? { message: `\`objdict open\` answered with ${response.status}` });
  }

  private drawList(): void {
    const isWanted = ({ name }: Served) => finds(this.search.value, name);
    const row = (number: number, of = ""): HTMLElement => {
      const { name, kind, nodes } = this.list[number]!;
      const open = () => void this.listed.run(() => this.open(number));
      const button = h("button", { type: "button", class: "mappable", onclick: open }, h("span", { class: "name" }, name), h("span", { class: "type" }, kind === "network" ? "network" : of));
      return h("li", {}, button, nodes.length > 0 && h("ul", {}, ...nodes.map((node) => row(node, "of the network"))));
    };
    const wanted = [...this.list.keys()].filter((number) => isWanted(this.list[number]!));
    const rows = wanted.slice(0, MAX_SHOWN).map((number) => row(number));
    if (wanted.length > MAX_SHOWN) rows.push(h("li", {}, `and ${wanted.length - MAX_SHOWN} more`));
    redraw(this.entries, ...rows);
  }
}

function questionDialog(store: Store): Dialog<Question> {
  const [title, question, answer] = [h("span", {}), h("p", {}), h("span", {})];
  const prepare = (asked: Question) => {
    title.textContent = asked.title;
    question.textContent = asked.question;
    answer.textContent = asked.answer;
  };
  return new Dialog<Question>(store, "ask", { title, form: { fields: [question], label: answer, make: ({ make }) => make() }, prepare });
}
