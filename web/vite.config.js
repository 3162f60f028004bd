// Builds into dist/, under fixed names that the tool embeds: the page of `lippmann view` (index.html, app.js and app.css) and,
// with `--mode report`, the script of report pages (report.js, and its hash for their content security policy).
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { defineConfig } from "vite";

/// Pages opened from a disk can only run classic scripts, not modules.
const classicScript = {
  name: "classic-script",
  transformIndexHtml: {
    order: "post",
    handler: (html) => html.replace(/<script type="module" crossorigin /, "<script defer ").replace(/ crossorigin /g, " "),
  },
};

const hashOfScript = {
  name: "hash-of-script",
  generateBundle(_, bundle) {
    const { code } = bundle["report.js"];
    if (/<\/script|<!--/i.test(code)) throw new Error("report.js cannot stand in a script element");
    this.emitFile({ type: "asset", fileName: "report.sha256", source: createHash("sha256").update(code).digest("base64") });
  },
};

/// Minifiers do not change texts: comments and indentation of shaders take 5 kB.
const shadersWithoutComments = {
  name: "shaders-without-comments",
  enforce: "pre",
  transform: (code, id) => (/\/(gl|interlace|quilt|shaders)\.ts$/.test(id) ? code.replace(/(^|\s)\/\/ .*$/gm, "").replace(/^\s+/gm, "") : null),
};

const view = {
  plugins: [shadersWithoutComments, classicScript],
  build: {
    target: "es2021",
    modulePreload: false,
    rollupOptions: {
      output: { format: "iife", entryFileNames: "app.js", assetFileNames: "app[extname]" },
    },
  },
};

const report = {
  plugins: [hashOfScript],
  build: {
    target: "es2021",
    modulePreload: false,
    emptyOutDir: false,
    copyPublicDir: false,
    rollupOptions: {
      input: "src/report.ts",
      output: { format: "iife", entryFileNames: "report.js", postBanner: `/*! With uPlot:\n${readFileSync("node_modules/uplot/LICENSE", "utf8")}*/` },
    },
  },
};

export default defineConfig(({ mode }) => ({ base: "./", ...(mode === "report" ? report : view) }));
