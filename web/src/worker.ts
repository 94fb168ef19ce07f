// The engine runs here, so that typing never waits for it. When it fails, which is an error of objdict, it is started again and the
// request is answered with an error.

import init, { Workbench } from "./wasm/objdict_wasm.js";
import type { Answer, FromWorker, Made, MadeFile, Request, ToWorker } from "./protocol";

/** The largest file that is opened, as for the command. */
const MAX_BYTES = 64 << 20;

let module: WebAssembly.Module;
let workbench: Workbench | undefined;

const started = new Promise<void>((resolve, reject) => {
  self.addEventListener(
    "message",
    async ({ data }: MessageEvent<ToWorker>) => {
      try {
        if (!("engine" in data)) return;
        const source = data.engine;
        const bytes = typeof source === "string" ? await (await fetch(source)).arrayBuffer() : source;
        module = await WebAssembly.compile(bytes);
        await start();
        resolve();
      } catch (error) {
        reject(error);
      }
    },
    { once: true },
  );
});

async function start(): Promise<void> {
  const instance = await init({ module_or_path: module });
  void instance;
  workbench = new Workbench();
}

function filesOf(answer: Answer): MadeFile[] {
  const names = "ok" in answer ? (answer.ok as Made | null)?.files : undefined;
  if (!Array.isArray(names)) return [];
  return names.map((name, number) => ({ name, bytes: workbench!.take(number) }));
}

function ask(request: Request, bytes?: Uint8Array): Omit<FromWorker, "id"> {
  if (bytes && bytes.length > MAX_BYTES) {
    const message = `the file has ${bytes.length} bytes, more than the limit of ${MAX_BYTES}`;
    return { answer: { error: { message } }, files: [] };
  }
  const answer = JSON.parse(workbench!.call(JSON.stringify(request), bytes ?? new Uint8Array())) as Answer;
  return { answer, files: filesOf(answer) };
}

let queue: Promise<void> = started;
self.addEventListener("message", ({ data }: MessageEvent<ToWorker>) => {
  if (!("id" in data)) return;
  const { id, request, bytes } = data;
  queue = queue
    .then(() => ({ id, ...ask(request, bytes) }))
    .catch(async (error: unknown) => {
      const failed: FromWorker = { id, answer: { error: { message: `the engine failed: ${String(error)}` } }, files: [], lost: true };
      if (module) await start();
      return failed;
    })
    .then((message) => self.postMessage(message));
});
