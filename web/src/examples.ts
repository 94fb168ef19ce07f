// Devices to try, from the fixtures of the project.

import broken from "../../fixtures/errata/a9-encoder-406.eds?raw";
import node from "../../fixtures/dcf/io-401-node5.dcf?raw";
import drive from "../../fixtures/eds/drive-402.eds?raw";
import inputs from "../../fixtures/xdd/io-401.xdd?raw";

export const EXAMPLES: [label: string, name: string, text: string][] = [
  ["A drive (CiA 402, EDS)", "drive-402.eds", drive],
  ["An IO module (CiA 401, XDD)", "io-401.xdd", inputs],
  ["A configured node (DCF)", "io-401-node5.dcf", node],
  ["An encoder with errors (EDS)", "encoder-406.eds", broken],
];
