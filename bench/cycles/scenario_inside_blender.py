"""Runs inside Blender. Renders a view of a glTF file with Cycles as PNG files with the view transform "Standard", and prints the CPU
seconds.

  blender -b -P scenario_inside_blender.py -- JOB.json

Members of JOB.json:
  file, panorama (or null), width, height, threads
  vertices: vertices per path
  skybox: whether the panorama is visible
  own_surfaces: whether to keep the materials that Blender's importer makes
  camera: name of the camera in the file
  renders: a list of objects with samples, seed and out

Prints a line "RENDER {json}" for each render. The member "unread" lists the features of the file that are not shown.
"""

import json
import pathlib
import sys

import bpy

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import gltf_in_blender as gltf  # noqa: E402


def show(job):
    gltf.load(job["file"], job["own_surfaces"])
    scene = bpy.context.scene
    gltf.surround(scene, job["panorama"])
    gltf.set_up(scene, job["width"], job["height"], job["vertices"], job["threads"])
    scene.camera = next(o for o in bpy.data.objects if o.type == "CAMERA" and o.name.split(".")[0] == job["camera"])
    scene.render.film_transparent = not job["skybox"]
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode = "RGBA"
    scene.render.image_settings.color_depth = "8"
    scene.render.dither_intensity = 0.0
    scene.view_settings.view_transform = "Standard"
    return scene


def main():
    job = json.loads(pathlib.Path(sys.argv[sys.argv.index("--") + 1]).read_text())
    scene = show(job)
    unread = gltf.unread(job["file"])
    scene.render.use_persistent_data = True  # so that only the first render includes the time to set up the scene
    gltf.render(scene, 1, 0, job["renders"][0]["out"])
    for item in job["renders"]:
        before = gltf.cpu_seconds()
        gltf.render(scene, item["samples"], item["seed"], item["out"])
        print("RENDER", json.dumps({**item, "cpu_seconds": gltf.cpu_seconds() - before, "unread": unread}), flush=True)


main()
