// Measures how soon `lippmann view room` shows a change: the time until the first coarse light field, the time until the draft,
// and the PSNR of the draft against the final render.
//   node bench/live_speed.mjs [LIPPMANN]
import { execFileSync, spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const tool = resolve(process.argv[2] ?? join(dirname(dirname(fileURLToPath(import.meta.url))), "build/release/lippmann"));
const folder = mkdtempSync(join(tmpdir(), "lippmann-live-"));
const server = spawn(tool, ["view", "room", "--integrator", "path", "--spp", "64", "--optics", "multiview", "--views", "8x6", "--size", "1024x768", "--port", "0"], { cwd: folder, stdio: ["ignore", "pipe", "ignore"] });
const address = await new Promise((resolve) => server.stdout.once("data", (text) => resolve(String(text).trim())));
const origin = new URL(address).origin;

/** Returns the wall time and the CPU time of the server, in seconds. */
function now() {
  const fields = readFileSync(`/proc/${server.pid}/stat`, "utf8").split(") ")[1].split(" ");
  return { clock: performance.now() / 1000, cpu: (Number(fields[11]) + Number(fields[12])) / 100 };
}
const since = (start) => ((end) => ({ clock: end.clock - start.clock, cpu: end.cpu - start.cpu }))(now());
const text = ({ clock, cpu }) => `${clock.toFixed(2)} s, ${cpu.toFixed(2)} s of processor`;
const median = (all, key) => all.map((one) => one[key]).sort((a, b) => a - b)[all.length >> 1];

let serial = 0;
async function state() {
  const answer = await (await fetch(`${address}live/state/${serial}`)).json();
  serial = answer.serial;
  return answer;
}
async function until(version, passes) {
  for (;;) {
    const { picture } = await state();
    if (picture?.version === version && passes.includes(picture.pass)) return picture;
  }
}
const picture = async (id) => Buffer.from(await (await fetch(`${address}live/views/${id}`)).arrayBuffer());
const change = async (settings) => (await (await fetch(`${address}live/settings`, { method: "POST", headers: { Origin: origin }, body: JSON.stringify({ settings }) })).json()).version;

await until(1, ["coarse", "draft", "final"]);
const firsts = [];
for (let i = 1; i <= 7; i++) {
  await new Promise((resolve) => setTimeout(resolve, 300));
  const start = now();
  const version = await change({ orbit: `${4 * i},5` });
  const { id } = await until(version, ["coarse", "draft", "final"]);
  await picture(id);
  firsts.push(since(start));
}
const start = now();
const version = await change({ orbit: "10,5" });
const draft = await until(version, ["draft"]);
writeFileSync(join(folder, "draft.webp"), await picture(draft.id));
const drafted = since(start);
const final = await until(version, ["final"]);
writeFileSync(join(folder, "final.webp"), await picture(final.id));
const finished = since(start);
const compared = JSON.parse(execFileSync(tool, ["compare", "draft.webp", "final.webp", "--json"], { cwd: folder, encoding: "utf8" }));
console.log("48 views of 128x128 of the room, path traced, after a turn of the camera that cancels work in progress:");
console.log(`  first coarse light field   ${text({ clock: median(firsts, "clock"), cpu: median(firsts, "cpu") })} (medians of ${firsts.length})`);
console.log(`  draft                      ${text(drafted)}`);
console.log(`  as rendered                ${text(finished)}`);
console.log(`  draft beside the render    ${compared.mean.psnr_db.toFixed(1)} dB`);
server.kill();
rmSync(folder, { recursive: true });
