"""Renders light fields with Blender's own engines, for materials that the tool does not support. Cycles or Eevee renders each
view. Then the tool arranges the views in a quilt.

The cameras are those of src/optics/multi_view.hpp. For viewing distance D, the camera of view v of N is D tan(cone ((v + 1/2) / N
- 1/2)) to the right of the middle. Its lens is shifted, not turned, so that each picture shows the display's rectangle.
"""

import contextlib
import functools
import json
import math
import pathlib
import shutil
import subprocess
import tempfile
import time
from dataclasses import dataclass

import bpy
from mathutils import Matrix, Vector

from . import displays, frame, job as jobs, tool, versions

NAME = "lippmann-view"
DRAWN = {"BLENDER_EEVEE", "BLENDER_EEVEE_NEXT", "BLENDER_WORKBENCH"}  # the engines that need OpenGL
NO_OPENGL = "Eevee and Workbench need OpenGL, and this Blender without a window finds none. Use Cycles, or start it with `xvfb-run -a blender -b`."
LINES = 8          # hides_scene() casts LINES x LINES rays through the picture
_items = []        # kept, because Blender does not keep the strings of dynamic lists alive
WALL_SHARE = 0.25  # walls are cut if they hide this share of the rays, as in the tool (src/stage/front_of_rays.hpp)


def engines(_self=None, _context=None):
    named = {engine.bl_idname: engine.bl_label for engine in bpy.types.RenderEngine.__subclasses__() if hasattr(engine, "bl_idname")}
    named = {versions.eevee(): "Eevee", "BLENDER_WORKBENCH": "Workbench", **named}
    named.pop("LIPPMANN", None)
    _items[:] = sorted(((name, label, f"Render each view with {label}") for name, label in named.items()), key=lambda item: item[0] != "CYCLES")
    return _items


def eye_offset(view, count, cone, distance):
    """Returns how far a view's camera is to the right of the middle. cone: in radians."""
    return distance * math.tan(cone * ((view + 0.5) / count - 0.5))


def place_camera(camera, zone, right):
    """Moves the camera to the viewing distance and to the right by `right`. Shifts its lens so that the picture shows the
    display's rectangle."""
    camera.matrix_world = zone.world_from_frame @ Matrix.Translation((right, 0.0, zone.distance))
    data = camera.data
    data.sensor_fit, data.sensor_width = "HORIZONTAL", 36.0
    data.lens = data.sensor_width * zone.distance / zone.width
    data.shift_x = -right / zone.width


def hides_scene(scene, depsgraph, zone):
    """Returns whether the scene is hidden from the display's viewer by walls that are outside the camera's view."""
    if zone.near <= 0.0:
        return False
    to_world = zone.world_from_frame
    eye = to_world @ Vector((0.0, 0.0, zone.distance))
    near = to_world @ Vector((0.0, 0.0, zone.distance - zone.near))
    hidden = 0
    for i in range(LINES * LINES):
        x, y = ((i % LINES + 0.5) / LINES - 0.5) * zone.width, ((i // LINES + 0.5) / LINES - 0.5) * zone.height
        direction = (to_world @ Vector((x, y, 0.0)) - eye).normalized()
        is_met, place, normal, *_ = scene.ray_cast(depsgraph, eye, direction, distance=zone.near)
        hidden += is_met and (normal.dot(near - place) > 0.0) != (normal.dot(eye - place) > 0.0)
    return hidden >= WALL_SHARE * LINES * LINES


def tile_of(scene, display):
    """Returns the (width, height) of a view's picture, and the width / height of its pixels on the display."""
    columns, rows = display["quilt"]["tiles"]
    output = scene.lippmann.output
    width, height = display["quilt"]["size"] if output == "native" else jobs.resolution(scene)  # for other outputs, the resolution of one view
    size = (width // columns, height // rows) if output in ("quilt", "native") else (width, height)
    return size, display["quilt"]["aspect"] * size[1] / size[0]


def refused(scene, display):
    if not display.get("quilt"):
        return f"The display {display['name']} has no quilt. Choose one that has, such as {displays.DEFAULT}."
    return displays.refused_size(scene, jobs.resolution(scene)) if scene.lippmann.output == "quilt" else None


@contextlib.contextmanager
def lent(*owners):
    """A context manager that sets attributes, and restores them at its end. owners: pairs (object, {name of an attribute:
    value})."""
    before = [(owner, {name: getattr(owner, name) for name in values}) for owner, values in owners]
    try:
        for owner, values in owners:
            for name, value in values.items():
                setattr(owner, name, value)
        yield
    finally:
        for owner, values in reversed(before):
            for name, value in values.items():
                setattr(owner, name, value)


def lacks_denoiser(scene, engine):
    """Returns whether the scene's denoising makes Cycles fail, because Blender is built without a denoiser, as Debian's is."""
    if engine != "CYCLES" or not scene.cycles.use_denoising:
        return False
    import _cycles  # exists only where Cycles does
    return not _cycles.with_openimagedenoise


def settings_for(scene, engine, camera, size, pixel_aspect):
    render = scene.render
    wide = pixel_aspect >= 1.0
    values = {"engine": engine, "resolution_x": size[0], "resolution_y": size[1], "resolution_percentage": 100, "pixel_aspect_x": pixel_aspect if wide else 1.0,
              "pixel_aspect_y": 1.0 if wide else 1.0 / pixel_aspect, "use_persistent_data": True, "use_file_extension": True, "use_multiview": False, "use_border": False,
              "filepath": render.filepath, "use_lock_interface": True}  # otherwise viewports would draw, or even render, during each view
    picture = {**versions.still_format(render.image_settings), "color_mode": "RGBA" if render.film_transparent else "RGB", "color_depth": "8"}
    cycles = [(scene.cycles, {"use_denoising": False})] if lacks_denoiser(scene, engine) else []
    return (scene, {"camera": camera}), (render, values), (render.image_settings, picture), *cycles


@functools.cache
def has_opengl():
    """Tests in a second Blender whether OpenGL works without a window, because Blender crashes if it does not."""
    with tempfile.TemporaryDirectory(prefix="lippmann-") as folder:
        picture = pathlib.Path(folder) / "drawn.png"
        program = ("import bpy; render = bpy.context.scene.render; render.engine, render.resolution_x, render.resolution_y = 'BLENDER_WORKBENCH', 8, 8; "
                   f"render.filepath = {str(picture)!r}; bpy.ops.render.render(write_still=True); picture = bpy.data.images.load(render.filepath); "
                   "assert max(picture.pixels[:3]) > 0.0")
        words = [bpy.app.binary_path, "-b", "--factory-startup", "-noaudio", "--python-exit-code", "1", "--python-expr", program]
        return subprocess.run(words, stdin=subprocess.DEVNULL, capture_output=True).returncode == 0


@dataclass
class Step:
    words: str
    share: float  # share of all work that is done
    seconds_left: float | None = None  # None: unknown
    renders: bool = False  # whether Blender must render a picture before the next step


class Views:
    """Renders frames of a scene as quilts. In the folder, views/ has a picture per view, quilt/ the quilts, native/ the
    panel's frames."""

    def __init__(self, scene, engine):
        self.display = displays.chosen(scene)
        refusal = refused(scene, self.display)
        if refusal:
            raise tool.ToolError(refusal)
        if bpy.app.background and engine in DRAWN and not has_opengl():
            raise tool.ToolError(NO_OPENGL)
        self.scene, self.engine = scene, engine
        self.tool = displays.preferred_tool()
        self.folder = jobs.output_folder(scene) / engine.lower()
        self.pictures = []
        columns, rows = self.display["quilt"]["tiles"]
        self.tiles, self.count = (columns, rows), columns * rows
        self._drawn = self.folder / "rendering.png"  # the view that Blender renders; moved when it is complete
        self._record = self.folder / "views.json"
        self._distance = None

    def result(self):
        noise = " This Blender has no denoiser, so the views are noisy." if lacks_denoiser(self.scene, self.engine) else ""
        return f"The pictures are in {self.pictures[0].parent}.{noise}"

    def _zone(self):
        """Returns the zone of the current frame. All frames of an animation use the plane's distance in the first frame."""
        if self._distance is None and not frame.placed(self.scene) and self.scene.camera and self.scene.camera.type == "CAMERA":
            self._distance = frame.plane_distance(self.scene)
        return frame.zone(self.scene, self._distance)

    def _view(self, number, view):
        return self.folder / "views" / f"frame_{number:04d}" / f"view_{view:03d}.png"

    def steps(self, numbers):
        """Renders frames, as a generator of Steps. If step.renders is true, the caller must let Blender render a picture
        before the next step. Closing the generator restores the scene. Complete views are used again until the scene changes."""
        now = self.scene.frame_current
        try:
            self.scene.frame_set(numbers[0])
            self._zone()
            yield Step("comparing the scene with the last one", 0.0)
            self._keep_only(self._key())
            try:
                yield from self._frames(numbers)
            finally:
                self.scene.frame_set(numbers[0])
                self._remember(self._key())  # the key has changed, because engines add properties to the scene
        finally:
            self.scene.frame_set(now)

    def _key(self):
        scene = self.scene
        view, render = scene.view_settings, scene.render
        looks = [str(getattr(view, name)) for name in ("view_transform", "look", "exposure", "gamma", "use_curve_mapping")]
        looks += [scene.display_settings.display_device, self.engine, render.film_transparent, *jobs.resolution(scene), scene.lippmann.output]
        return jobs.digest([jobs.hash_of(scene), looks, self.display, self._distance])

    def _keep_only(self, key):
        """Removes pictures of earlier renders unless their scene had the hash `key`."""
        if not self.scene.lippmann.resume or key not in self._keys():
            shutil.rmtree(self.folder, ignore_errors=True)
            self._remember(key)

    def _keys(self):
        """Returns the hashes of the scene whose pictures are in the folder. Empty if the record is missing or damaged."""
        try:
            return json.loads(self._record.read_text())
        except (OSError, ValueError):
            return []

    def _remember(self, key):
        keys = self._keys()
        if key not in keys:
            self.folder.mkdir(parents=True, exist_ok=True)
            unfinished = self._record.with_suffix(".part")
            unfinished.write_text(json.dumps([*keys, key]))
            unfinished.replace(self._record)

    def _frames(self, numbers):
        """Yields Steps that render the missing views, and makes each quilt once its views are complete."""
        missing = {number: [view for view in range(self.count) if not self._view(number, view).is_file()] for number in numbers}
        total, left = len(missing) * self.count, sum(map(len, missing.values()))
        begin, rendered = time.monotonic(), 0
        camera = bpy.data.objects.new(NAME, bpy.data.cameras.new(NAME))
        self.scene.collection.objects.link(camera)
        size, pixel_aspect = tile_of(self.scene, self.display)
        try:
            for number in numbers:
                self.scene.frame_set(number)
                zone = self._zone()
                self._prepare(camera, zone)
                with lent(*settings_for(self.scene, self.engine, camera, size, pixel_aspect)):
                    self.scene.render.filepath = str(self._drawn.with_suffix(""))
                    for view in missing[number]:
                        place_camera(camera, zone, eye_offset(view, self.count, zone.cone, zone.distance))
                        seconds = (time.monotonic() - begin) / rendered * (left - rendered) if rendered else None
                        yield Step(f"rendering the views of frame {number}", (total - left + rendered) / total, seconds, True)
                        self._keep(number, view)
                        rendered += 1
                yield from self._lay_out(number)
        finally:
            self._drawn.unlink(missing_ok=True)
            data = camera.data
            bpy.data.objects.remove(camera)
            bpy.data.cameras.remove(data)

    def _keep(self, number, view):
        if not self._drawn.is_file():
            raise tool.ToolError(f"Blender has written no picture of view {view} of frame {number}.")
        place = self._view(number, view)
        place.parent.mkdir(parents=True, exist_ok=True)
        self._drawn.replace(place)

    def _prepare(self, camera, zone):
        cut = hides_scene(self.scene, bpy.context.evaluated_depsgraph_get(), zone)
        camera.data.clip_start = zone.near if cut else 1e-3 * zone.distance
        camera.data.clip_end = 1e3 * zone.distance

    def _convert(self, step, *words):
        child = tool.Child([self.tool, "convert", *words, "--quiet"], self.folder / "lippmann.log")
        try:
            while child.running():
                yield Step(step, 1.0)
                child.wait(0.05)
            child.check()
        finally:
            child.stop()

    def _lay_out(self, number):
        name, (columns, rows) = f"frame_{number:04d}", self.tiles
        quilts, frames = self.folder / "quilt", self.folder / "native"
        if not tool.pictures(quilts, number):
            yield from self._convert(f"laying out the quilt of frame {number}", self.folder / "views" / name, quilts / f"{name}.png", "--from", "views",
                                     "--views", f"{self.count}x1", "--to", "quilt", "--quilt", f"{columns}x{rows}", "--aspect", str(self.display["quilt"]["aspect"]))
        is_native = self.scene.lippmann.output == "native"
        if is_native and not tool.pictures(frames, number):
            yield from self._convert(f"making frame {number} of the panel", tool.pictures(quilts, number)[0], frames / f"{name}.png", "--from", "quilt",
                                     "--to", "native", "--display", displays.argument(self.scene))
        self.pictures += tool.pictures(frames if is_native else quilts, number)
