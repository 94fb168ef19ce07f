// The engine as the page sees it: requests with answers.

import engineUrl from "./wasm/objdict_wasm_bg.wasm?url";
import type { Answer, FromWorker, MadeFile, Refusal, Request, ToWorker } from "./protocol";

/** A request that was refused. */
export class Refused extends Error {
  readonly help?: string;
  constructor(refusal: Refusal) {
    super(refusal.message);
    this.help = refusal.help;
  }
}

/** What an error says, and what to do about it. */
export function refusalOf(error: unknown): Refusal {
  const message = error instanceof Error ? error.message : String(error);
  return { message, help: error instanceof Refused ? error.help : undefined };
}

interface Waiting {
  resolve(answer: { ok: unknown; files: MadeFile[] }): void;
  reject(error: Refused): void;
}

const waiting = new Map<number, Waiting>();
let next = 0;
let onLost: () => void = () => {};
let worker: Worker | undefined;

/** Starts the engine: from the host, or from what the single file has in it. */
export async function startEngine(whenLost: () => void): Promise<void> {
  onLost = whenLost;
  const code = document.getElementById("embedded-worker");
  const wasm = document.getElementById("embedded-engine");
  if (code && wasm) {
    worker = new Worker(URL.createObjectURL(new Blob([await unpacked(code)], { type: "text/javascript" })));
    const engine = await unpacked(wasm);
    worker.postMessage({ engine } satisfies ToWorker, [engine]);
  } else {
    worker = new Worker(new URL("./worker.ts", import.meta.url));
    worker.postMessage({ engine: new URL(engineUrl, document.baseURI).href } satisfies ToWorker);
  }
  worker.onmessage = ({ data }: MessageEvent<FromWorker>) => {
    const entry = waiting.get(data.id);
    waiting.delete(data.id);
    if (data.lost) onLost();
    const answer = JSON.parse(data.answer) as Answer;
    if ("ok" in answer) entry?.resolve({ ok: answer.ok, files: data.files });
    else entry?.reject(new Refused(answer.error));
  };
}

async function unpacked(element: HTMLElement): Promise<ArrayBuffer> {
  const bytes = Uint8Array.from(atob(element.textContent!.trim()), (character) => character.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

function send(request: Request, bytes?: Uint8Array): Promise<{ ok: unknown; files: MadeFile[] }> {
  const id = next++;
  return new Promise((resolve, reject) => {
    waiting.set(id, { resolve, reject });
    worker!.postMessage({ id, request, bytes } satisfies ToWorker);
  });
}

/** The data that a request gives. */
export async function ask<T>(request: Request, bytes?: Uint8Array): Promise<T> {
  return (await send(request, bytes)).ok as T;
}

/** The files that a request makes, with the notes about them. */
export async function make(request: Request): Promise<{ files: MadeFile[]; notes: string[] }> {
  const { ok, files } = await send(request);
  return { files, notes: (ok as { notes: string[] }).notes };
}
