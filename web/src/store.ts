// What is open and what is shown, and how it changes: each change asks the engine and draws what came of it.

import { Refused, ask } from "./engine";
import type { Home } from "./files";
import type { Opened, Outline, Report, Request, State } from "./protocol";

export type View = "form" | "text" | "diff" | "pdo" | "compare";

export interface OpenDocument {
  id: number;
  state: State;
  outline: Outline;
  report: Report;
  /** Whether the report has its fixes yet. */
  has_fixes: boolean;
  original: string;
  /** Where it is saved in place. */
  home?: Home;
}

export interface Notice {
  kind: "error" | "note";
  message: string;
  help?: string;
}

/** The parts of a page that are drawn anew. */
export type Drawing = (store: Store) => void;

export class Store {
  documents: OpenDocument[] = [];
  current: OpenDocument | undefined;
  view: View = "form";
  /** The index of the shown object. */
  index: number | undefined;
  /** The position of the shown PDO. */
  pdo = 0;
  search = "";
  notice: Notice | undefined;
  private drawings: Drawing[] = [];
  private scheduled = false;

  onDraw(drawing: Drawing): void {
    this.drawings.push(drawing);
  }

  draw(): void {
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame(() => {
      this.scheduled = false;
      const key = (document.activeElement as HTMLElement | null)?.dataset?.key;
      this.drawings.forEach((drawing) => drawing(this));
      if (key && (document.activeElement === document.body || !document.activeElement)) {
        document.querySelector<HTMLElement>(`[data-key="${CSS.escape(key)}"]`)?.focus();
      }
    });
  }

  /** Does something that may be refused, and says so. */
  async attempt(what: () => Promise<void>): Promise<boolean> {
    try {
      await what();
      return true;
    } catch (error) {
      const help = error instanceof Refused ? error.help : undefined;
      this.notice = { kind: "error", message: error instanceof Error ? error.message : String(error), help };
      this.draw();
      return false;
    }
  }

  async open(name: string, bytes: Uint8Array): Promise<boolean> {
    return this.attempt(async () => this.take(await ask<Opened>({ do: "open", name }, bytes)));
  }

  /** Shows a document that the engine has opened. */
  async take({ document: id, state }: Opened): Promise<void> {
    const [outline, report] = await Promise.all([
      ask<Outline>({ do: "outline", document: id }),
      ask<Report>({ do: "check", document: id }),
    ]);
    this.current = { id, state, outline, report, has_fixes: false, original: state.text };
    this.documents.push(this.current);
    this.notice = state.devices > 1 ? { kind: "note", message: `The file has ${state.devices} devices; the first is shown.` } : undefined;
    this.search = "";
    const wanted = indexInAddress();
    this.index = outline.objects.find((object) => object.index === wanted)?.index ?? outline.objects[0]?.index;
    if (this.view === "compare" || this.view === "diff") this.view = "form";
    this.draw();
    void this.findFixes(this.current);
  }

  /** Which fixes are sound takes some checks of the text, so they come behind the findings. */
  private async findFixes(of: OpenDocument): Promise<void> {
    const text = of.state.text;
    const report = await ask<Report>({ do: "check", document: of.id, fixes: true }).catch(() => undefined);
    if (!report || of.state.text !== text) return;
    of.report = report;
    of.has_fixes = true;
    this.draw();
  }

  /** Changes the current document. */
  async change(request: Request): Promise<boolean> {
    const of = this.current;
    if (!of) return false;
    return this.attempt(async () => {
      const state = await ask<State>(request);
      this.notice = undefined;
      await this.refresh(of, state);
    });
  }

  async refresh(of: OpenDocument, state: State): Promise<void> {
    const [outline, report] = await Promise.all([
      ask<Outline>({ do: "outline", document: of.id }),
      ask<Report>({ do: "check", document: of.id }),
    ]);
    Object.assign(of, { state, outline, report, has_fixes: false });
    this.draw();
    void this.findFixes(of);
  }

  async close(document: OpenDocument): Promise<void> {
    await this.attempt(() => ask({ do: "close", document: document.id }));
    this.documents = this.documents.filter((other) => other !== document);
    if (this.current === document) this.current = this.documents.at(-1);
    this.index = this.current?.outline.objects[0]?.index;
    this.view = "form";
    this.draw();
  }

  show(document: OpenDocument): void {
    this.current = document;
    this.index = document.outline.objects[0]?.index;
    this.pdo = 0;
    this.draw();
  }

  /** Shows an object, and has it in the address. */
  select(index: number, view: View = "form"): void {
    this.index = index;
    this.view = view;
    history.replaceState(null, "", `#${index.toString(16).toUpperCase().padStart(4, "0")}`);
    this.draw();
  }

  /** After the engine failed: what is open is opened again, as it was. */
  async reopen(): Promise<void> {
    const former = this.documents;
    const message = "The engine failed, which is an error of objdict, and was started again. The files are open as they were; undo begins here.";
    this.documents = [];
    this.current = undefined;
    for (const { state, home } of former) {
      const isOpen = await this.open(state.name, new TextEncoder().encode(state.text));
      if (isOpen) this.documents.at(-1)!.home = home;
    }
    this.notice = { kind: "error", message };
    this.draw();
  }
}

/** The index in the address of the page: `#6041`. */
export function indexInAddress(): number | undefined {
  const found = /^#(?:0x)?([0-9a-f]{4})h?$/i.exec(location.hash);
  return found ? parseInt(found[1]!, 16) : undefined;
}
