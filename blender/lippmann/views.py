"""Light fields from Blender's own engines: for materials that the tool does not have, Cycles or Eevee renders a picture for each view, through cameras where the
display's viewer has his eyes, and the tool lays them out.

The eyes are those of the tool's quilts (src/optics/multi_view.hpp): view v of N stands D tan(cone ((v + 1/2) / N - 1/2)) to the right of the middle, at the
viewing distance D, and looks through the frame of the display: its camera is shifted, not turned.
"""

import contextlib
import math
import shutil
import subprocess

import bpy
from mathutils import Matrix, Vector

from . import displays, frame, job as jobs, tool

NAME = "lippmann-view"
LINES = 8          # of sight to test for walls, across and up
_items = []        # Blender needs the strings of dynamic lists to stay alive
WALL_SHARE = 0.25  # of the lines that walls must hide to be cut, as in the tool (src/stage/front_of_rays.hpp)


def engines(_self=None, _context=None):
    """Returns Blender's other engines as items of a property."""
    named = {engine.bl_idname: engine.bl_label for engine in bpy.types.RenderEngine.__subclasses__() if hasattr(engine, "bl_idname")}
    named = {"BLENDER_EEVEE_NEXT" if (4, 2) <= bpy.app.version < (5, 0) else "BLENDER_EEVEE": "Eevee", "BLENDER_WORKBENCH": "Workbench", **named}
    named.pop("LIPPMANN", None)
    _items[:] = sorted(((name, label, f"Render each view with {label}") for name, label in named.items()), key=lambda item: item[0] != "CYCLES")
    return _items


def eye_offset(view, count, cone, distance):
    """Returns how far to the right of the middle a view's eye stands."""
    return distance * math.tan(cone * ((view + 0.5) / count - 0.5))


def place_camera(camera, zone, right):
    """Puts the camera that far to the right of the middle, looking through the display's frame."""
    camera.matrix_world = zone.world_from_frame @ Matrix.Translation((right, 0.0, zone.distance))
    data = camera.data
    data.sensor_fit, data.sensor_width = "HORIZONTAL", 36.0
    data.lens = data.sensor_width * zone.distance / zone.width
    data.shift_x = -right / zone.width


def hides_scene(scene, depsgraph, zone):
    """Returns whether walls that the scene's camera does not see hide the scene from the display's viewer."""
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
    """Returns (width, height) of a view's picture, and the aspect of its pixels on the display."""
    columns, rows = display["quilt"]["tiles"]
    output = scene.lippmann.output
    width, height = display["quilt"]["size"] if output == "native" else jobs.resolution(scene)  # the size of one view for other outputs
    size = (width // columns, height // rows) if output in ("quilt", "native") else (width, height)
    return size, display["quilt"]["aspect"] * size[1] / size[0]


@contextlib.contextmanager
def lent(*owners):
    """Sets members of owners, each (owner, {name: value}), and restores them afterwards."""
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


def settings_for(scene, engine, camera, size, pixel_aspect):
    """Returns the settings that differ while views are rendered, for lent()."""
    render = scene.render
    wide = pixel_aspect >= 1.0
    values = {"engine": engine, "resolution_x": size[0], "resolution_y": size[1], "resolution_percentage": 100, "pixel_aspect_x": pixel_aspect if wide else 1.0,
              "pixel_aspect_y": 1.0 if wide else 1.0 / pixel_aspect, "use_persistent_data": True, "use_file_extension": True, "use_multiview": False, "use_border": False,
              "filepath": render.filepath}
    picture = {"file_format": "PNG", "color_mode": "RGBA" if render.film_transparent else "RGB", "color_depth": "8"}
    return (scene, {"camera": camera}), (render, values), (render.image_settings, picture)


class Views:
    """Renders frames of a scene as quilts. In the folder, views/ has a picture per view, quilt/ the quilts, native/ the panel's frames."""

    def __init__(self, scene, engine):
        self.display = displays.chosen(scene)
        if not self.display.get("quilt"):
            raise tool.ToolError(f"The display {self.display['name']} has no quilt. Choose one that has, such as {displays.DEFAULT}.")
        refusal = displays.refused_size(scene, jobs.resolution(scene)) if scene.lippmann.output == "quilt" else None
        if refusal:
            raise tool.ToolError(refusal)
        self.scene, self.engine = scene, engine
        self.tool = displays.preferred_tool()
        self.folder = jobs.output_folder(scene) / engine.lower()
        columns, rows = self.display["quilt"]["tiles"]
        self.tiles, self.count = (columns, rows), columns * rows
        self._distance = None

    def _zone(self):
        """Returns the zone of the current frame. An animation keeps the plane's distance of its first frame."""
        if self._distance is None and not frame.placed(self.scene) and self.scene.camera and self.scene.camera.type == "CAMERA":
            self._distance = frame.plane_distance(self.scene)
        return frame.zone(self.scene, self._distance)

    def render(self, numbers, tell=lambda *_: None):
        """Renders the views of these frames. tell: receives a step in words and its finished share."""
        shutil.rmtree(self.folder, ignore_errors=True)
        camera = bpy.data.objects.new(NAME, bpy.data.cameras.new(NAME))
        self.scene.collection.objects.link(camera)
        size, pixel_aspect = tile_of(self.scene, self.display)
        now = self.scene.frame_current
        try:
            for index, number in enumerate(numbers):
                self.scene.frame_set(number)
                zone = self._zone()
                self._prepare(camera, zone)
                with lent(*settings_for(self.scene, self.engine, camera, size, pixel_aspect)):
                    self._render_frame(camera, zone, number, lambda share, i=index, n=number: tell(f"rendering the views of frame {n}", (i + share) / len(numbers)))
        finally:
            data = camera.data
            bpy.data.objects.remove(camera)
            bpy.data.cameras.remove(data)
            self.scene.frame_set(now)

    def _prepare(self, camera, zone):
        cut = hides_scene(self.scene, bpy.context.evaluated_depsgraph_get(), zone)
        camera.data.clip_start = zone.near if cut else 1e-3 * zone.distance
        camera.data.clip_end = 1e3 * zone.distance

    def _render_frame(self, camera, zone, number, tell):
        for view in range(self.count):
            tell(view / self.count)
            place_camera(camera, zone, eye_offset(view, self.count, zone.cone, zone.distance))
            self.scene.render.filepath = str(self.folder / "views" / f"frame_{number:04d}" / f"view_{view:03d}")
            bpy.ops.render.render(write_still=True, scene=self.scene.name)

    def _convert(self, *words):
        done = subprocess.run([self.tool, "convert", *(str(word) for word in words), "--quiet"], capture_output=True, text=True)
        if done.returncode:
            raise tool.ToolError(tool.last_message(done.stderr))

    def lay_out(self, native):
        """Makes quilts and, if native, frames of the panel. Returns the pictures of the last step."""
        quilts, frames = self.folder / "quilt", self.folder / "native"
        columns, rows = self.tiles
        self._convert(self.folder / "views", quilts, "--from", "views", "--views", f"{self.count}x1", "--to", "quilt", "--quilt", f"{columns}x{rows}", "--aspect",
                      self.display["quilt"]["aspect"])
        if native:
            self._convert(quilts, frames, "--from", "quilt", "--to", "native", "--display", displays.argument(self.scene))
        return sorted(path for path in (frames if native else quilts).rglob("*.png"))
