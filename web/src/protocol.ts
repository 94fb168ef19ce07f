// What the page asks the engine, and what it answers (crates/objdict-wasm/src/request.rs).

export interface TextEdit {
  line: number;
  column: number;
  end_line: number;
  end_column: number;
  text: string;
}

export type FieldChange =
  | { change: "set"; at: string; value: string }
  | { change: "remove"; at: string }
  | { change: "add"; at: string; fields: [string, string][] };

export interface NewDevice {
  name: string;
  profile: number;
  vendor: string;
  vendor_id: number;
  product: string;
  product_code: number;
  date: [number, number, number];
}

export type Request =
  | { do: "open"; name: string }
  | { do: "close" | "state" | "original" | "bytes" | "outline" | "undo" | "redo"; document: number }
  | { do: "form"; document: number; index: number }
  | { do: "check"; document: number; fixes?: boolean }
  | { do: "edit"; document: number; edits: TextEdit[] }
  | { do: "encode"; document: number; encoding: string }
  | { do: "change"; document: number; changes: FieldChange[] }
  | { do: "patch"; document: number; patch: string }
  | { do: "fix-all"; document: number; unsafe?: boolean }
  | { do: "add-objects"; document: number; profile: number; indexes: number[] }
  | { do: "save"; document: number; name: string; node_id?: number; bit_rate?: number }
  | { do: "generate"; document: number; target: string }
  | { do: "docs"; document: number; form: string }
  | { do: "dbc"; document: number; node_id?: number }
  | { do: "concise"; document: number; node_id?: number; all?: boolean }
  | { do: "compare"; old: number; new: number }
  | { do: "profiles" }
  | { do: "profile-objects"; document: number; profile: number }
  | ({ do: "new" } & NewDevice);

export interface State {
  name: string;
  format: string;
  encoding: string;
  text: string;
  is_read_only: boolean;
  is_changed: boolean;
  can_undo: boolean;
  can_redo: boolean;
  devices: number;
}

export interface Opened {
  document: number;
  state: State;
}

export interface SubRow {
  sub: number;
  name: string;
  data_type?: string;
  words?: string;
}

export interface ObjectRow {
  index: number;
  name: string;
  kind: string;
  data_type?: string;
  words?: string;
  line?: number;
  subs: SubRow[];
}

export interface Mapped {
  index: number;
  sub: number;
  bits: number;
  name?: string;
}

export interface PdoRow {
  kind: "RPDO" | "TPDO";
  number: number;
  communication: number;
  mapping: number;
  cob_id?: string;
  can_id?: number;
  is_valid?: boolean;
  transmission_type?: number;
  transmission_words?: string;
  inhibit_time?: number;
  event_timer?: number;
  communication_subs: number[];
  mapped_count?: number;
  /** The described mapping entries. */
  slots: { sub: number; number?: number }[];
  mapped: Mapped[];
}

export interface Mappable {
  index: number;
  sub: number;
  bits: number;
  name: string;
  rpdo: boolean;
  tpdo: boolean;
}

export interface Outline {
  product?: string;
  vendor?: string;
  profile?: number;
  node_id?: number;
  is_node: boolean;
  objects: ObjectRow[];
  pdos: PdoRow[];
  mappable: Mappable[];
}

export interface FieldForm {
  name: string;
  text?: string;
  line?: number;
}

export interface PartForm {
  place: string;
  sub?: number;
  name: string;
  data_type?: string;
  words?: string;
  line?: number;
  fields: FieldForm[];
}

export interface ObjectForm {
  index: number;
  name: string;
  kind: string;
  has_subs: boolean;
  parts: PartForm[];
}

/** The document of `objdict check --format json`. */
export interface Report {
  findings: Finding[];
  omitted: { rule: string; count: number }[];
  summary: { errors: number; warnings: number; notes: number; suppressed: number };
}

export interface Position {
  line: number;
  column: number;
  end_line: number;
  end_column: number;
  place?: string;
  message: string;
}

export interface Finding extends Position {
  rule: string;
  severity: "error" | "warning" | "note";
  help?: string;
  related?: Position[];
  places?: Position[];
  fingerprint: string;
  fix?: { title: string; safety: "safe" | "unsafe"; encoding?: string; edits: TextEdit[] };
}

export interface Made {
  files: string[];
  notes: string[];
}

export interface MadeFile {
  name: string;
  bytes: Uint8Array;
}

export interface Change {
  rule: string;
  index?: number;
  sub?: number;
  old?: string;
  new?: string;
  message: string;
  verdict: string;
  effects: { audience: string; verdict: string; reason: string }[];
}

export interface ProfileRow {
  number: number;
  title: string;
}

export interface ProfileObject {
  index: number;
  name: string;
  kind: string;
  has: boolean;
}

export interface Refusal {
  message: string;
  help?: string;
}

export type Answer = { ok: unknown } | { error: Refusal };

/** To the worker: where the engine is, then requests. */
export type ToWorker = { engine: string | ArrayBuffer } | { id: number; request: Request; bytes?: Uint8Array };
/** From the worker: answers by the numbers of their requests. `lost` says that the engine had to be started again. */
export interface FromWorker {
  id: number;
  answer: Answer;
  files: MadeFile[];
  lost?: boolean;
}
