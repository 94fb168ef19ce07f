// The program that is tested with: that of `OBJDICT`, else the debug build.
import { fileURLToPath } from "node:url";

export const objdict = process.env.OBJDICT ?? fileURLToPath(new URL("../../../target/debug/objdict", import.meta.url));
export const fixture = (name) => fileURLToPath(new URL(`../../../fixtures/${name}`, import.meta.url));
