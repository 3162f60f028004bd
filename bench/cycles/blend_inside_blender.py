"""Runs inside Blender. Renders what the viewer of a display sees, with Cycles and with the add-on's preview (see
bench/blender_scenes.py).

  blender -b FILE.blend --python blend_inside_blender.py -- JOB.json

Members of JOB.json:
  folder: folder for the pictures
  size: longer side of the pictures in pixels
  samples: samples per pixel of both renderers
  addon: the folder that contains the add-on's folder

Writes cycles.png and ours.png, both with the view transform "Standard". Writes result.json with the add-on's "warnings", and with
"refused", the reason for a missing picture or "".
"""

import json
import pathlib
import sys

import bpy
import mathutils

job = json.loads(pathlib.Path(sys.argv[sys.argv.index("--") + 1]).read_text())
sys.path.insert(0, job["addon"])
import lippmann  # noqa: E402
from lippmann import engine, frame  # noqa: E402

lippmann.register()
folder = pathlib.Path(job["folder"])
scene = bpy.context.scene


def first_camera():
    cameras = [thing for thing in scene.objects if thing.type == "CAMERA"]
    return scene.camera or (cameras[0] if cameras else None)


def prepare():
    render = scene.render
    scene.lippmann.output = "single"  # set first, because it changes the resolution
    scene.camera = first_camera()
    shrink = job["size"] / max(render.resolution_x, render.resolution_y)
    render.resolution_x, render.resolution_y = (max(8, round(n * shrink)) for n in (render.resolution_x, render.resolution_y))
    render.resolution_percentage = 100
    render.use_border = render.use_compositing = render.use_sequencer = render.film_transparent = False
    render.pixel_aspect_x = render.pixel_aspect_y = 1.0
    render.image_settings.file_format, render.image_settings.color_mode, render.dither_intensity = "PNG", "RGB", 0.0
    view = scene.view_settings
    view.view_transform, view.look, view.exposure, view.gamma = "Standard", "None", 0.0, 1.0
    scene.frame_set(scene.frame_current)


def render_as(name, program):
    scene.render.engine = program
    scene.render.filepath = str(folder / name)
    bpy.ops.render.render(write_still=True)


def add_viewer_camera():
    """Adds and returns a camera at the position of the display's viewer."""
    zone = frame.zone(scene)
    camera = bpy.data.cameras.new("eye")
    camera.sensor_fit, camera.lens = "VERTICAL", camera.sensor_height * zone.distance / zone.height
    camera.clip_start, camera.clip_end = 1e-3 * zone.distance, 1e3 * zone.distance
    eye = bpy.data.objects.new("eye", camera)
    eye.matrix_world = zone.world_from_frame @ mathutils.Matrix.Translation((0.0, 0.0, zone.distance))
    scene.collection.objects.link(eye)
    return eye


def by_cycles():
    cycles = scene.cycles
    cycles.device, cycles.samples, cycles.use_adaptive_sampling, cycles.use_denoising = "CPU", job["samples"], False, False
    cycles.sample_clamp_indirect = cycles.sample_clamp_direct = 0.0
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = cycles.transmission_bounces = 12
    cycles.caustics_reflective = cycles.caustics_refractive = True
    cycles.blur_glossy = 0.0
    cycles.pixel_filter_type = "BOX"
    cycles.filter_width = 1.0
    own, scene.camera = scene.camera, add_viewer_camera()
    render_as("cycles.png", "CYCLES")
    scene.camera = own


def by_lippmann():
    settings = scene.lippmann
    settings.samples, settings.folder, settings.full_depth = job["samples"], str(folder / "lippmann"), True
    render_as("ours.png", "LIPPMANN")


refused = "" if first_camera() else "the scene has no camera"
if not refused:
    prepare()
    by_cycles()
    try:
        by_lippmann()
    except RuntimeError as error:
        refused = str(error)
(folder / "result.json").write_text(json.dumps({"warnings": engine.last_warnings, "refused": refused}))
