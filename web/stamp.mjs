// Checks that the built page in dist/ matches the sources: dist/stamp.txt holds a hash of both.
//   node stamp.mjs           fails if they do not match
//   node stamp.mjs --write   writes the hash after a build
import { createHash } from "node:crypto";
import { existsSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const folder = dirname(fileURLToPath(import.meta.url));
const stamp = join(folder, "dist/stamp.txt");

const files = [
  "index.html",
  "package.json",
  "package-lock.json",
  "tsconfig.json",
  "vite.config.js",
  ...readdirSync(join(folder, "src")).map((name) => `src/${name}`),
  "public/app.css",
  ...["index.html", "app.js", "app.css", "report.js", "report.sha256"].map((name) => `dist/${name}`),
].sort();

const hash = createHash("sha256");
for (const name of files) hash.update(name).update("\0").update(readFileSync(join(folder, name))).update("\0");
const text = `${hash.digest("hex")}\n`;

if (process.argv.includes("--write")) {
  writeFileSync(stamp, text);
} else if (!existsSync(stamp) || readFileSync(stamp, "utf8") !== text) {
  console.error("web/dist was not built from these sources: run `npm ci && npm run build` in web/");
  process.exit(1);
}
