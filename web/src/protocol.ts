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
  features: Record<string, boolean | number | string | string[]>;
}

export interface NewNode {
  name: string;
  node_id: number;
  bit_rate?: number;
  node_name?: string;
  modules: number[];
  settings: string[];
}

export type LinkChange =
  | { change: "add"; from: string; to: string }
  | { change: "move"; link: number; end: number; to: string }
  | { change: "remove"; link: number };

/** Which frames are shown: all of an empty list. */
export interface FrameFilter {
  nodes: number[];
  kinds: string[];
  text: string;
}

export type Request =
  | { do: "open"; name: string }
  | { do: "close" | "state" | "original" | "bytes" | "outline" | "undo" | "redo" | "modules" | "network" | "build"; document: number }
  | { do: "form"; document: number; index: number }
  | { do: "facts" | "settings"; document: number }
  | { do: "insert"; document: number; objects: [index: number, object: NewObject][] }
  | { do: "copy"; document: number; from: number; indexes: number[] }
  | { do: "language"; document: number; about: LanguageQuestion }
  | { do: "check"; document: number; fixes?: boolean; places?: boolean; tools?: string[] }
  | { do: "edit"; document: number; revision: number; edits: TextEdit[] }
  | { do: "encode"; document: number; encoding: string }
  | { do: "change"; document: number; changes: FieldChange[] }
  | { do: "patch"; document: number; patch: string }
  | { do: "fix-all"; document: number; unsafe?: boolean; tools?: string[] }
  | { do: "add-objects"; document: number; profile: number; indexes: number[] }
  | { do: "save"; document: number; name: string; node_id?: number; bit_rate?: number; storage?: "compact" | "expanded" }
  | { do: "generate"; document: number; target: string }
  | { do: "docs"; document: number; form: string }
  | { do: "dbc"; document: number; node_id?: number }
  | { do: "concise"; document: number; node_id?: number; all?: boolean }
  | { do: "compare"; old: number; new: number }
  | { do: "profiles" | "tools" | "new-network" }
  | { do: "profile-objects"; document: number; profile: number }
  | ({ do: "new" } & NewDevice)
  | { do: "configure"; document: number; node: NewNode }
  | { do: "link"; document: number; link: LinkChange }
  | { do: "decode"; document: number; with: number[]; plots: string[] }
  | { do: "frames"; document: number; filter: FrameFilter; first?: number; count: number; line?: number };

export interface State {
  name: string;
  kind: "device" | "network" | "log";
  format: string;
  encoding: string;
  text: string;
  is_read_only: boolean;
  is_changed: boolean;
  can_undo: boolean;
  can_redo: boolean;
  /** Counts the texts of the document. */
  revision: number;
  devices: number;
}

export interface Opened {
  document: number;
  state: State;
  notes?: string[];
}

export interface SubRow {
  sub: number;
  name: string;
  data_type?: string;
}

export interface ObjectRow {
  index: number;
  name: string;
  kind: string;
  data_type?: string;
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
  /** The value as CiA 306 spells it, if the text states it elsewhere or spells it differently. */
  value?: string;
}

export interface PartForm {
  place: string;
  sub?: number;
  name: string;
  data_type?: string;
  words?: string;
  unit?: string;
  fields: FieldForm[];
}

export interface ObjectForm {
  index: number;
  name: string;
  kind: string;
  has_subs: boolean;
  parts: PartForm[];
}

/** An object as JSON of the model (docs/json.md). */
export interface NewObject {
  name: string;
  object_type: string;
  data_type?: string;
  access?: string;
  pdo_mapping?: string;
  default?: unknown;
  sub_number?: number;
  subs?: Record<string, Omit<NewObject, "subs">>;
}

/** An entry that a configuration may set. */
export interface Setting {
  index: number;
  sub: number;
  name: string;
  data_type?: string;
  value?: string;
  words?: string;
  low?: string;
  high?: string;
}

/** A place in a text, both counted from 0, the column in UTF-16. */
export type Place = { line: number; character: number };
/** An answer of the language server about a text. */
export type Hover = { contents: { value: string } };
export type Completion = { label: string; detail?: string; documentation?: { value: string }; textEdit?: { range: { start: Place; end: Place }; newText: string } };
export type Tokens = { kinds: string[]; tokens?: { data: number[] } };
export type LanguageQuestion = ({ ask: "hover" | "completion" } & Place) | { ask: "tokens" };

/** The document of `objdict check --format json`, as far as it is shown. */
export interface Report {
  findings: Finding[];
  summary: { errors: number; warnings: number; notes: number };
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
  index?: number;
  sub?: number;
  message: string;
  verdict: string;
  effects: { audience: string; verdict: string; reason: string }[];
}

export interface Feature {
  word: string;
  kind: "flag" | "number" | "name" | "names";
  range?: [number, number];
  names: string[];
  meaning: string;
  /** Whether devices of every profile may have it. */
  is_general: boolean;
}

export interface ProfileRow {
  number: number;
  title: string;
  features: Feature[];
}

/** The modules of a coupler. */
export interface Modules {
  supported: { number: number; name?: string; order_code?: string }[];
  connected: number[];
}

export interface NetworkEnd {
  node: string;
  service: string;
}

/** The document of `objdict network show --format json`, as far as it is shown. */
export interface Overview {
  name?: string;
  bit_rate?: number;
  nodes: { node_id?: number; name: string; description: string; is_manager: boolean; heartbeat: number; downloads: number }[];
  links: { can_id: string; sender?: NetworkEnd; receiver?: NetworkEnd; entries: { from?: string; to?: string }[] }[];
  messages: { can_id: string; senders: NetworkEnd[]; receivers: NetworkEnd[]; bytes?: number; trigger: string; period?: number }[];
  boot?: { manager: string; nodes: { node_id: number; name: string; steps: string[] }[] };
}

/** Load in thousandths of a percent, times in nanoseconds. */
export interface Timing {
  average: number;
  worst: number;
  is_met: boolean;
  rates: { bit_rate: number; worst: number; fits: boolean }[];
  messages: { can_id: string; response?: number; deadline?: number; is_missed: boolean; is_unbounded: boolean }[];
}

/** What a node can send and receive. */
export interface Side {
  node: string;
  node_id?: number;
  is_manager: boolean;
  entries: Mappable[];
}

/** Of a text that is no network there is only the report. */
export interface NetworkView {
  report: Report;
  overview?: Overview;
  picture?: string;
  timing?: Timing;
  sides?: Side[];
  /** Nodes whose descriptions were not read, with their files. */
  missing?: [node: string, file: string][];
  links?: { from: string; to: string[]; line: number }[];
  can_link?: boolean;
}

export interface BusReport {
  channel?: string;
  frames: number;
  frames_per_second: number;
  load?: number;
  kinds: { kind: string; frames: number }[];
  nodes: { node: number; name?: string; frames: number; frames_per_second: number; load?: number; state?: string; boot_ups: number; lost_heartbeats: number; emergencies: number; aborted_transfers: number }[];
  messages: { can_id: number; extended: boolean; kind: string; name: string; frames: number; cycle?: { min: string; mean: string; max: string }; described?: string }[];
  undescribed: number[];
}

/** Something that went wrong on a bus. */
export interface Incident {
  number: number;
  kind: string;
  state: "unresolved" | "recovered" | "warning";
  channel?: string;
  start: string;
  text: string;
  /** The first and the last of its frames. */
  frames: { time: string; line: number; text: string }[];
  causes: string[];
  checks: string[];
  why: string;
}

/** A signal over time, in seconds since the first frame. */
export interface Plot {
  name: string;
  unit: string;
  points: [from: number, to: number, least: number, greatest: number, last: number][];
  runs: [from: number, to: number, word: number][];
  words: string[];
}

/** A log that was read with descriptions. */
export interface LogSummary {
  form: string;
  /** How many frames can be listed. */
  rows: number;
  /** What the incidents say together. */
  verdict: string;
  incidents: Incident[];
  plots: Plot[];
  buses: BusReport[];
  notes: string[];
  bad_lines: [line: number, reason: string][];
  bad_count: number;
  report: Report;
}

export interface Frames {
  total: number;
  first: number;
  /** Time, channel, CAN-ID, data and words. */
  rows: { seconds: number; line: number; node?: number; kind: string; cells: [string, string, string, string, string] }[];
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
/** From the worker: answers by the numbers of their requests, as JSON, which is cheaper to hand over than what it says. `lost` says that the engine had to be started again. */
export interface FromWorker {
  id: number;
  answer: string;
  files: MadeFile[];
  lost?: boolean;
}
