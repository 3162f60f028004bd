// Builds the page into dist/: index.html, app.js and app.css under names that stay, which the program embeds.
import { defineConfig } from "vite";

/// Pages that are opened from a disk may run classic scripts only, no modules.
const classicScript = {
  name: "classic-script",
  transformIndexHtml: {
    order: "post",
    handler: (html) => html.replace(/<script type="module" crossorigin /, "<script defer ").replace(/ crossorigin /g, " "),
  },
};

export default defineConfig({
  base: "./",
  plugins: [classicScript],
  build: {
    target: "es2021",
    modulePreload: false,
    rollupOptions: {
      output: { format: "iife", entryFileNames: "app.js", assetFileNames: "app[extname]" },
    },
  },
});
