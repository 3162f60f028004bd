"""Runs inside Blender. Renders a glTF file with Cycles, and prints the CPU seconds.

  blender -b -P inside_blender.py -- FILE.gltf OUT.exr WIDTH HEIGHT SAMPLES VERTICES THREADS SEED [PANORAMA]
"""

import pathlib
import sys

import bpy

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import gltf_in_blender as gltf  # noqa: E402

file, out, width, height, samples, vertices, threads, seed, *panorama = sys.argv[sys.argv.index("--") + 1:]
gltf.load(file)
scene = bpy.context.scene
gltf.surround(scene, *panorama or [None])
gltf.set_up(scene, int(width), int(height), int(vertices), int(threads))
scene.camera = gltf.camera()
start = gltf.cpu_seconds()
gltf.render(scene, int(samples), int(seed), out)
print(f"CYCLES_SECONDS {gltf.cpu_seconds() - start:.3f}")
