// The engine runs here, so that typing never waits for it. When it fails, which is an error of objdict, it is started again and the
// request is answered with an error.

import init, { Workbench } from "./wasm/objdict_wasm.js";
import type { Answer, FromWorker, Made, MadeFile, Opened, Request, ToWorker } from "./protocol";

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
        module = await compiled(data.engine);
        await start();
        resolve();
      } catch (error) {
        reject(error);
      }
    },
    { once: true },
  );
});

/** Compiled while it is loaded, where the host says what it is. */
async function compiled(source: string | ArrayBuffer): Promise<WebAssembly.Module> {
  if (typeof source !== "string") return WebAssembly.compile(source);
  const response = await fetch(source);
  const isKnown = response.headers.get("content-type")?.startsWith("application/wasm");
  return isKnown ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

async function start(): Promise<void> {
  await init({ module_or_path: module });
  workbench = new Workbench();
}

/** So often a device is read and checked before there is a file: a browser compiles functions when they are called first, and
 *  optimises those that are called often. */
const WARM_TURNS = 24;

/** The requests that wait for the engine. */
let waiting = 0;

/** A device with PDOs, and with objects that are in no list, so that there are findings. */
function warmFile(trial: Workbench): Uint8Array {
  const request: Request = { do: "new", name: "warm.eds", profile: 402, vendor: "", vendor_id: 1, product: "", product_code: 1, date: [2026, 1, 1], features: { rpdos: 16, tpdos: 16 } };
  const made = JSON.parse(trial.call(JSON.stringify(request), new Uint8Array())) as { ok: Opened };
  const objects = Array.from({ length: 500 }, (_, at) => `\r\n[${(0x2000 + at).toString(16)}]\r\nParameterName=Object ${at}\r\nObjectType=7\r\nDataType=7\r\nAccessType=rw\r\nDefaultValue=${at}\r\nPDOMapping=0\r\n`);
  return new TextEncoder().encode(made.ok.state.text + objects.join(""));
}

async function warm(): Promise<void> {
  const trial = new Workbench();
  const file = warmFile(trial);
  const ask = (request: Request, bytes?: Uint8Array) => trial.call(JSON.stringify(request), bytes ?? new Uint8Array());
  for (let turn = 0; turn < WARM_TURNS && waiting === 0; turn++) {
    ask({ do: "open", name: "warm.eds" }, file);
    ask({ do: "outline", document: 1 });
    ask({ do: "check", document: 1 });
    ask({ do: "close", document: 1 });
    // of many findings it would keep a file waiting
    if (turn % 8 === 7) ask({ do: "check", document: 0, fixes: true });
    // requests that came meanwhile are counted
    await new Promise((resolve) => setTimeout(resolve));
  }
  trial.free();
}

/** The requests whose answers list files. */
const MAKING: Request["do"][] = ["bytes", "save", "generate", "docs", "dbc", "concise", "build"];

function filesOf(answer: Answer): MadeFile[] {
  const names = "ok" in answer ? (answer.ok as Made).files : [];
  return names.map((name, number) => ({ name, bytes: workbench!.take(number) }));
}

function ask(request: Request, bytes?: Uint8Array): Omit<FromWorker, "id"> {
  if (bytes && bytes.length > MAX_BYTES) {
    const message = `the file has ${bytes.length} bytes, more than the limit of ${MAX_BYTES}`;
    return { answer: JSON.stringify({ error: { message } } satisfies Answer), files: [] };
  }
  const answer = workbench!.call(JSON.stringify(request), bytes ?? new Uint8Array());
  return { answer, files: MAKING.includes(request.do) ? filesOf(JSON.parse(answer) as Answer) : [] };
}

let queue: Promise<void> = started.then(() => warm().catch(start));
self.addEventListener("message", ({ data }: MessageEvent<ToWorker>) => {
  if (!("id" in data)) return;
  const { id, request, bytes } = data;
  waiting++;
  queue = queue
    .then(() => ({ id, ...ask(request, bytes) }))
    .catch(async (error: unknown) => {
      const answer: Answer = { error: { message: `the engine failed: ${String(error)}` } };
      if (module) await start();
      return { id, answer: JSON.stringify(answer), files: [], lost: true } satisfies FromWorker;
    })
    .then((message) => {
      waiting--;
      self.postMessage(message);
    });
});
