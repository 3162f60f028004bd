"""Runs inside Blender. Renders views of a glTF animation with Cycles one after another, and prints the CPU seconds of each.

  blender -b -P views_inside_blender.py -- JOB.json

Members of JOB.json:
  file, panorama (or null), width, height, threads, frames_per_second
  vertices: vertices per path
  distance, window_height: distance and height of the rectangle that all views show, in the units of the camera
  eyes: the offset of each view to the right of the camera
  renders: a list of objects with frame, view, samples, seed and out

Prints a line "VIEW {json}" for each render. The scene stays loaded between renders.
"""

import json
import math
import pathlib
import sys

import bpy
from mathutils import Matrix

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import gltf_in_blender as gltf  # noqa: E402


class Views:
    """Off-axis cameras to the left and right of the file's camera. All of them show the same rectangle."""

    def __init__(self, job):
        self.job = job
        gltf.load(job["file"])
        self.scene = bpy.context.scene
        gltf.surround(self.scene, job["panorama"])
        gltf.set_up(self.scene, job["width"], job["height"], job["vertices"], job["threads"])
        self.scene.render.use_persistent_data = True
        self.file_camera = gltf.camera()
        self.camera = bpy.data.objects.new("eye", bpy.data.cameras.new("eye"))
        self.camera.data.clip_start, self.camera.data.clip_end = 1e-3 * job["distance"], 1e4 * job["distance"]
        self.scene.collection.objects.link(self.camera)
        self.scene.camera = self.camera
        self.window = job["window_height"] * max(1.0, job["width"] / job["height"])
        # Blender frames per frame of the job
        self.frames_per_frame = self.scene.render.fps / job["frames_per_second"]

    def show(self, frame, view):
        at = frame * self.frames_per_frame
        self.scene.frame_set(int(at), subframe=at - int(at))
        eye = self.job["eyes"][view]
        placement = self.file_camera.matrix_world.normalized()
        self.camera.matrix_world = placement @ Matrix.Translation((eye, 0.0, 0.0))
        self.camera.data.angle = 2.0 * math.atan(0.5 * self.window / self.job["distance"])
        self.camera.data.shift_x = -eye / self.window


def main():
    job = json.loads(pathlib.Path(sys.argv[sys.argv.index("--") + 1]).read_text())
    views = Views(job)
    warm = job["renders"][0]
    views.show(warm["frame"], warm["view"])
    gltf.render(views.scene, 1, 0, warm["out"])
    for item in job["renders"]:
        views.show(item["frame"], item["view"])
        before = gltf.cpu_seconds()
        gltf.render(views.scene, item["samples"], item["seed"], item["out"])
        print("VIEW", json.dumps({**item, "cpu_seconds": gltf.cpu_seconds() - before}), flush=True)


main()
