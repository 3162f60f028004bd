// In a mock of a WebXR headset, each eye sees what the page shows to an eye at the same place.
import assert from "node:assert/strict";
import { test } from "node:test";
import { closeAfterEach, open, set, sheet, view } from "./support.mjs";

closeAfterEach();

sheet();
const address = await view("sheet");
const button = (page, name = "Enter VR") => page.getByRole("button", { name });

/** Runs in the page: installs a headset with two eyes, whose pictures exactly cover the display's window. */
function mock(refusal) {
  const side = 256;
  const separation = 12; // mm
  const window_mm = () => window.lippmann.fields[0].window_mm;
  const home = () => window.lippmann.fields[0].eye_mm;
  const scale = () => Math.max(1, 600 / home()[2]) / 1000;
  /** Returns an eye's projection matrix by columns, for a frustum through the window's edges. eye: position in the headset's
   *  space. */
  const frustum = (eye) => {
    const { centre, size } = window_mm();
    const [x, y, z] = [0, 1, 2].map((i) => (home()[i] * scale()) + eye[i]); // metres from the display
    const at = (i, sign) => centre[i] * scale() + (sign * size[i] * scale()) / 2 - [x, y][i];
    const near = 0.01;
    const [left, right, below, above] = [at(0, -1), at(0, 1), at(1, -1), at(1, 1)].map((edge) => (edge * near) / z);
    const far = 100;
    return [(2 * near) / (right - left), 0, 0, 0, 0, (2 * near) / (above - below), 0, 0, (right + left) / (right - left), (above + below) / (above - below), -(far + near) / (far - near), -1, 0, 0, (-2 * far * near) / (far - near), 0];
  };
  const viewOf = (x, y, z) => ({
    projectionMatrix: new Float32Array(frustum([x, y, z])),
    transform: { position: { x, y, z }, inverse: { matrix: new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -x, -y, -z, 1]) } },
  });
  const views = () => [-1, 1].map((s) => viewOf((s * separation * scale()) / 2, 0.004, -0.01));
  window.XRWebGLLayer = class {
    constructor(session, gl) {
      const texture = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 2 * side, side, 0, gl.RGBA, gl.UNSIGNED_BYTE, null);
      this.framebuffer = gl.createFramebuffer();
      gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
      Object.assign(window, { mockLayer: this, mockGl: gl });
      this.eyes = new Map();
    }
    getViewport(view) {
      return { x: view.transform.position.x < 0 ? 0 : side, y: 0, width: side, height: side };
    }
  };
  class Session extends EventTarget {
    updateRenderState() {}
    async requestReferenceSpace(kind) {
      if (refusal === "space") throw new Error(`no space of kind ${kind}`);
      return {};
    }
    requestAnimationFrame(draw) {
      if (!this.ended) requestAnimationFrame((now) => draw(now, { getViewerPose: () => ({ views: views() }) }));
      window.mockFrames = (window.mockFrames ?? 0) + 1;
    }
    async end() {
      this.ended = true;
      this.dispatchEvent(new Event("end"));
    }
  }
  const system = new EventTarget();
  system.isSessionSupported = async (mode) => mode === "immersive-vr" && refusal !== "none";
  system.requestSession = async () => {
    if (refusal === "session") throw new Error("the viewer has said no");
    return (window.mockSession = new Session());
  };
  Object.defineProperty(navigator, "xr", { value: system, configurable: true });
  WebGL2RenderingContext.prototype.makeXRCompatible = async () => {};
  /** Returns an eye's picture as RGBA codes, top row first. */
  window.mockCodes = (eye) => {
    const gl = window.mockGl;
    const codes = new Uint8Array(4 * side * side);
    gl.bindFramebuffer(gl.FRAMEBUFFER, window.mockLayer.framebuffer);
    gl.readPixels(eye * side, 0, side, side, gl.RGBA, gl.UNSIGNED_BYTE, codes);
    return [...Array(side).keys()].flatMap((y) => [...codes.subarray(4 * side * (side - 1 - y), 4 * side * (side - y))]);
  };
  /** Positions of the mock's eyes in mm of the display. */
  window.mockEyes = () => views().map(({ transform: { position: p } }) => [p.x, p.y, p.z].map((metres, i) => home()[i] + metres / scale()));
}
const script = (refusal = "") => `(${mock})(${JSON.stringify(refusal)})`;

const framesLater = (page, count) => page.evaluate((count) => ((window.mockFrames = 0), new Promise((resolve) => {
  const wait = () => (window.mockFrames >= count ? resolve() : requestAnimationFrame(wait));
  wait();
})), count);

/** PSNR of an eye's picture in the headset against the page's picture for the same eye. */
const psnrOf = (page, eye) => page.evaluate(async (eye) => {
  const shown = window.mockCodes(eye);
  const before = window.lippmann.state.eye;
  window.lippmann.set({ eye: window.mockEyes()[eye] });
  const wanted = await window.lippmann.picture(256, 256);
  window.lippmann.set({ eye: before });
  let sum = 0;
  for (let i = 0; i < wanted.length; i++) sum += (wanted[i] - shown[i]) ** 2;
  return sum === 0 ? 200 : 10 * Math.log10((255 ** 2 * 0.75 * wanted.length) / sum);
}, eye);

test("without a headset there is no button", async () => {
  const page = await open(address, { script: script("none") });
  assert.equal(await button(page).isVisible(), false);
  const plain = await open(address);
  assert.equal(await button(plain).isVisible(), false);
});

test("each eye of a headset has its view", async () => {
  const page = await open(address, { script: script() });
  await button(page).press("Enter");
  await page.waitForSelector('#stage[data-headset="true"]');
  assert.equal(await button(page, "Leave VR").isVisible(), true);
  await framesLater(page, 3);
  const psnr = [await psnrOf(page, 0), await psnrOf(page, 1)];
  console.log(`left ${psnr[0].toFixed(1)} dB, right ${psnr[1].toFixed(1)} dB beside the page's own pictures`);
  psnr.forEach((one) => assert.ok(one >= 40, `${one} dB`));
  const differ = await page.evaluate(() => {
    const [left, right] = [window.mockCodes(0), window.mockCodes(1)];
    return left.filter((code, i) => code !== right[i]).length / left.length;
  });
  assert.ok(differ > 0.02, `both eyes see the same: ${differ}`);
  await button(page, "Leave VR").press("Enter");
  await page.waitForSelector('#stage[data-headset="false"]');
  await set(page, { frame: 2 });
  assert.equal(await page.getAttribute("#stage", "data-frame"), "2");
});

test("playback continues in and after the headset", async () => {
  const page = await open(address, { script: script() });
  await button(page).click();
  await page.waitForSelector('#stage[data-headset="true"]');
  await page.evaluate(() => window.lippmann.set({ frame: 4 }));
  await page.evaluate(() => window.lippmann.picture(8, 8));
  await framesLater(page, 3);
  await page.keyboard.press("Tab");
  assert.ok((await psnrOf(page, 0)) >= 40);
  await page.evaluate(() => window.mockSession.end());
  await page.waitForSelector('#stage[data-headset="false"][data-frame="4"]');
  assert.equal(await button(page).isVisible(), true);
});

for (const [refusal, reason] of [["session", "the viewer has said no"], ["space", "no space of kind local"]])
  test(`a headset that cannot be entered says why: ${refusal}`, async () => {
    const page = await open(address, { script: script(refusal) });
    await button(page).click();
    await page.waitForFunction(() => document.querySelector("#notice").textContent !== "");
    assert.match(await page.textContent("#notice"), new RegExp(`Cannot enter the headset: ${reason}`));
    assert.equal(await page.getAttribute("#stage", "data-headset"), "false");
    await set(page, { frame: 1 });
    assert.equal(await page.getAttribute("#stage", "data-frame"), "1");
  });
