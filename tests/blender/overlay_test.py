"""Tests of the add-on's drawing in the viewport and in its panel. Needs a Blender with windows.

If the environment variable SCREENSHOTS names a folder, the pictures are saved there.
"""

import os
import pathlib
import sys
import unittest
import unittest.mock

import bpy
import gpu
import mathutils
import numpy as np
from bpy_extras.view3d_utils import location_3d_to_region_2d

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "blender"))
import lippmann  # noqa: E402
from lippmann import displays, engine, frame, overlay, panel  # noqa: E402

SAMPLES = 60  # tested points per line
NEAR_PX, NEAR_COLOUR = 2, 0.25  # tolerances in pixels and in colour: lines are 2 pixels wide and partly transparent

lippmann.register()
bpy.context.preferences.view.show_splash = False


def place_frame(scene):
    scene.render.engine, scene.lippmann.display = "LIPPMANN", "looking-glass-portrait"
    bpy.ops.lippmann.place_at_selected()
    bpy.ops.object.select_all(action="DESELECT")  # the outline of selected objects has the colour of the lines
    bpy.context.view_layer.update()
    return frame.zone(scene)


def look_at(view, zone):
    view.view_perspective = "PERSP"
    view.view_rotation = zone.world_from_frame.to_quaternion() @ mathutils.Euler((-0.5, 1.0, 0.0)).to_quaternion()
    view.view_location = zone.world_from_frame @ mathutils.Vector((0.0, 0.0, 0.5 * zone.distance))
    view.view_distance = 1.6 * zone.distance


class Overlay(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(os.environ["SCREENSHOTS"]) if "SCREENSHOTS" in os.environ else None

    def read_view(self):
        """Reads the frame buffer, because screenshots are black in newer versions of Xvfb."""
        width, height = self.region.width, self.region.height
        pixels = gpu.state.active_framebuffer_get().read_color(0, 0, width, height, 4, 0, "FLOAT")
        pixels.dimensions = width * height * 4
        self.pixels = np.array(pixels, np.float32).reshape(height, width, 4)

    def screenshot(self, name):
        """Returns the picture of the 3D view as an array (y, x, 3), with the bottom row first."""
        handler = bpy.types.SpaceView3D.draw_handler_add(self.read_view, (), "WINDOW", "POST_PIXEL")
        bpy.ops.wm.redraw_timer(type="DRAW_WIN", iterations=2)
        bpy.types.SpaceView3D.draw_handler_remove(handler, "WINDOW")
        if self.folder:
            height, width = self.pixels.shape[:2]
            image = bpy.data.images.new(name, width, height, is_data=True)
            image.pixels.foreach_set(np.concatenate((self.pixels[..., :3], np.ones((height, width, 1), np.float32)), axis=2).ravel())
            image.save(filepath=str(self.folder / f"{name}.png"))
        return self.pixels[..., :3]

    def share_drawn(self, picture, corners, colour):
        """Returns the share of points along lines at which the picture has the given colour. corners: the two ends of each
        line, in the display's space."""
        found = []
        for start, end in zip(corners[::2], corners[1::2]):
            for share in np.linspace(0.0, 1.0, SAMPLES):
                point = self.zone.world_from_frame @ mathutils.Vector(start).lerp(mathutils.Vector(end), share)
                x, y = (int(at) for at in location_3d_to_region_2d(self.region, self.view, point))
                around = picture[max(y - NEAR_PX, 0):y + NEAR_PX + 1, max(x - NEAR_PX, 0):x + NEAR_PX + 1]
                found.append((np.abs(around - colour[:3]).max(axis=2) < NEAR_COLOUR).any())
        return np.mean(found)

    def test_lines_lie_at_the_zone_and_can_be_hidden(self):
        window = bpy.context.window_manager.windows[0]
        area = next(area for area in window.screen.areas if area.type == "VIEW_3D")
        self.region, self.view = next(region for region in area.regions if region.type == "WINDOW"), area.spaces.active.region_3d
        settings = next(area for area in window.screen.areas if area.type == "PROPERTIES")
        with bpy.context.temp_override(window=window, area=area, region=self.region):
            scene = bpy.context.scene
            self.zone = place_frame(scene)
            look_at(self.view, self.zone)
            settings.spaces.active.context = "RENDER"
            shown = self.screenshot("overlay")
            scene.lippmann.show_overlay = False
            hidden = self.screenshot("no_overlay")
            scene.lippmann.show_overlay, scene.render.engine = True, "BLENDER_WORKBENCH"
            other = self.screenshot("other_engine")
            lines = [(corners, colour) for kind, corners, colour in overlay.figures(self.zone) if kind == "LINES"]
            self.assertEqual([colour for _, colour in lines], [overlay.SHARP, overlay.PLANE, overlay.ZONE])
            for corners, colour in lines:
                self.assertGreater(self.share_drawn(shown, corners, colour), 0.9, colour)
                for picture in (hidden, other):
                    self.assertLess(self.share_drawn(picture, corners, colour), 0.1, colour)

    def test_the_panel_is_drawn_in_every_state(self):
        window = bpy.context.window_manager.windows[0]
        area = next(area for area in window.screen.areas if area.type == "PROPERTIES")
        scene, own, drawn = bpy.context.scene, panel.LIPPMANN_PT_light_field.draw, []

        def draw(drawing, context):
            own(drawing, context)
            drawn.append(state)

        with bpy.context.temp_override(window=window, area=area), unittest.mock.patch.object(panel.LIPPMANN_PT_light_field, "draw", draw):
            scene.render.engine, scene.lippmann.display = "LIPPMANN", "looking-glass-portrait"
            area.spaces.active.context = "RENDER"
            states = {"a size that is refused": lambda: setattr(scene.render, "resolution_x", 4), "warnings": lambda: engine.last_warnings.append("The sky is lost."),
                      "a view transform": lambda: setattr(scene.view_settings, "view_transform", "Filmic"), "a file": lambda: setattr(scene.lippmann, "calibration", "/nowhere"),
                      "no camera": lambda: setattr(scene, "camera", None), "no tool": displays.forget}
            with unittest.mock.patch.dict(os.environ):
                for state, make in states.items():
                    if state == "no tool":
                        os.environ["LIPPMANN_TOOL"] = "/nowhere/lippmann"
                    make()
                    area.tag_redraw()
                    bpy.ops.wm.redraw_timer(type="DRAW_WIN_SWAP", iterations=1)
                    self.assertEqual(drawn[-1:], [state])
            displays.forget()


def run():
    tests = unittest.defaultTestLoader.loadTestsFromTestCase(Overlay)  # unittest.main() finds no tests in a timer
    result = unittest.TextTestRunner(verbosity=2).run(tests)
    sys.stdout.flush(), sys.stderr.flush()
    os._exit(0 if result.testsRun and result.wasSuccessful() else 1)  # sys.exit() would end only the timer


bpy.app.timers.register(run, first_interval=0.5)
