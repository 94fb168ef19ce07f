import { defineConfig } from "vite";

export default defineConfig({
  // works in any folder of a host
  base: "./",
  build: {
    target: "es2022",
    modulePreload: false,
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 2000,
  },
  worker: { format: "iife" },
  server: { fs: { allow: [".."] } },
});
