// Changes that are in no file survive a reload, a crash and a closed window: the browser keeps them until they are saved or given up.

import { del, get, keys, set } from "idb-keyval";
import type { Files } from "./files";
import { textBytes, type Draft, type OpenDocument, type Store } from "./store";

/** So long the page is left alone before what has changed is kept, in ms. */
const PAUSE = 300;

/** So long the former page of the tab may hold its lock while it is reloaded, in ms. */
const PATIENCE = 5000;

/** Where the tab has the name of its page. */
const KEY = "objdict-page";

const draftOf = ({ state, bytes, original, saved, home }: OpenDocument): Draft => ({ name: state.name, bytes: bytes ?? textBytes(original), text: state.text, encoding: state.encoding, saved, home });

export class Drafts {
  /** The name of this page, and of a lock that it holds as long as it lives. */
  private readonly page = crypto.randomUUID();
  private kept = "[]";
  private timer = 0;

  constructor(
    private readonly store: Store,
    private readonly files: Files,
  ) {}

  /** Opens what pages that are gone have left, and keeps the changes of this one from now on. */
  async start(): Promise<void> {
    // a browser that keeps nothing does without
    if (!navigator.locks || !window.indexedDB) return;
    await new Promise<void>((resolve) => void navigator.locks.request(this.page, () => (resolve(), new Promise(() => {}))));
    this.store.onDraw(() => {
      clearTimeout(this.timer);
      this.timer = window.setTimeout(() => void this.store.attempt(() => this.keep()), PAUSE);
    });
    addEventListener("pagehide", () => void this.keep());
    const former = sessionStorage.getItem(KEY);
    sessionStorage.setItem(KEY, this.page);
    for (const page of (await keys<string>().catch(() => [])).filter((page) => page !== this.page)) {
      // a page of another tab that is open keeps its own
      const options = page === former ? { signal: AbortSignal.timeout(PATIENCE) } : { ifAvailable: true };
      await navigator.locks.request(page, options, (lock) => lock && this.take(page)).catch(() => {});
    }
  }

  private async take(page: string): Promise<void> {
    const drafts = (await get<Draft[]>(page)) ?? [];
    const [restored, refused]: Draft[][] = [[], []];
    for (const draft of drafts) ((await this.store.restore(draft)) ? restored : refused)!.push(draft);
    await this.keep();
    // what was refused is tried again the next time
    await (refused!.length > 0 ? set(page, refused) : del(page));
    if (restored!.length === 0) return;
    const names = restored!.map(({ name }) => name).join(", ");
    this.store.notice = { kind: "note", message: `Opened again with changes that were not saved: ${names}` };
    this.store.draw();
  }

  private async keep(): Promise<void> {
    const changed = this.store.documents.filter((document) => document.state.kind !== "log" && this.files.isChanged(document));
    const kept = JSON.stringify(changed.map(({ id, state, saved }) => [id, state.revision, state.name, saved?.length]));
    if (kept === this.kept) return;
    await (changed.length > 0 ? set(this.page, changed.map(draftOf)) : del(this.page));
    this.kept = kept;
  }
}
