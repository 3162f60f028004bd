// Sets up a scenario in three.js, renders samples, and returns their mean as linear light.
import * as THREE from "three";
import { DRACOLoader } from "three/addons/loaders/DRACOLoader.js";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { HDRLoader } from "three/addons/loaders/HDRLoader.js";
import { MeshoptDecoder } from "three/addons/libs/meshopt_decoder.module.js";
import { WebGLPathTracer } from "three-gpu-pathtracer";

const renderer = new THREE.WebGLRenderer({ alpha: true });
const tracer = new WebGLPathTracer(renderer);

function load(file) {
  const loader = new GLTFLoader();
  loader.setDRACOLoader(new DRACOLoader().setDecoderPath("/node_modules/three/examples/jsm/libs/draco/gltf/"));
  loader.setMeshoptDecoder(MeshoptDecoder);
  return loader.loadAsync(file);
}

/** Applies the first animation at time 0, which is frame 0 of the other renderers. */
function pose(gltf) {
  if (gltf.animations.length === 0) return;
  const mixer = new THREE.AnimationMixer(gltf.scene);
  mixer.clipAction(gltf.animations[0]).play();
  mixer.setTime(0);
}

async function light(scene, job) {
  if (!job.panorama) return;
  const panorama = await new HDRLoader().loadAsync("/scenario/panorama");
  panorama.mapping = THREE.EquirectangularReflectionMapping;
  scene.environment = panorama;
  if (job.skybox) scene.background = panorama;
}

function cameraOf(gltf, job) {
  const camera = gltf.cameras.find((c) => c.name === job.camera || c.parent?.name === job.camera);
  if (!camera) throw new Error(`the file has no camera ${job.camera}`);
  camera.aspect = job.width / job.height;
  camera.updateProjectionMatrix();
  return camera;
}

/** Treats all paths and pixels alike: no coarse first picture, and no rougher materials after a bounce. */
function measureAlike(vertices) {
  Object.assign(tracer, { renderToCanvas: false, rasterizeScene: false, dynamicLowRes: false, minSamples: 0, renderDelay: 0, fadeDuration: 0 });
  Object.assign(tracer, { bounces: vertices, transmissiveBounces: vertices, filterGlossyFactor: 0, multipleImportanceSampling: true });
  tracer.tiles.set(1, 1);
}

window.setUp = async (job) => {
  renderer.setPixelRatio(1);
  renderer.setSize(job.width, job.height);
  const gltf = await load("/scenario/scene.glb"), scene = new THREE.Scene();
  scene.add(gltf.scene);
  pose(gltf);
  await light(scene, job);
  scene.updateMatrixWorld(true);
  measureAlike(job.vertices);
  tracer.setScene(scene, cameraOf(gltf, job));
};

/** Adds up to 8 samples, but at most `wanted` in total, waits until they are drawn, and returns the total. */
window.sample = async (wanted) => {
  for (let i = 0; i < 8 && tracer.samples < wanted; ++i) tracer.renderSample();
  if (tracer.isCompiling) await new Promise((done) => setTimeout(done, 100));
  else renderer.readRenderTargetPixels(tracer.target, 0, 0, 1, 1, new Float32Array(4));
  return tracer.samples;
};

/** Starts another picture with independent noise. */
window.begin = () => tracer.reset();

/** Returns the mean as RGBA floats, lowest row first, in base64. */
window.picture = () => {
  const { width, height } = tracer.target, values = new Float32Array(4 * width * height);
  renderer.readRenderTargetPixels(tracer.target, 0, 0, width, height, values);
  return btoa(Array.from(new Uint8Array(values.buffer), (byte) => String.fromCharCode(byte)).join(""));
};
