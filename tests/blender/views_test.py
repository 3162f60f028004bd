"""Tests of light fields that Blender's own engines render: their cameras and their layout. Blender runs this file."""

import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

import _cycles
import bpy
import mathutils

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "blender"))
import lippmann  # noqa: E402
from lippmann import engine, frame, render_views, saving, tool, views  # noqa: E402

lippmann.register()


def shining_monkey(place, colour):
    bpy.ops.mesh.primitive_monkey_add(location=place)
    material = bpy.data.materials.new("shining")
    material.use_nodes = True
    light = material.node_tree.nodes.new("ShaderNodeEmission")
    light.inputs["Color"].default_value = (*colour, 1.0)
    material.node_tree.links.new(light.outputs[0], material.node_tree.get_output_node("ALL").inputs["Surface"])
    bpy.context.object.data.materials.append(material)


class Views(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.addCleanup(self._folder.cleanup)
        self.folder = pathlib.Path(self._folder.name)

    def new_scene(self, output="quilt", size=(240, 160)):
        bpy.ops.wm.read_factory_settings()
        scene = bpy.context.scene
        bpy.data.objects.remove(bpy.data.objects["Cube"])
        scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value = 0.0
        for place, shade in (((0.0, 0.0, 0.0), 1.0), ((1.5, -1.5, 1.0), 0.5), ((-3.0, 2.5, 0.0), 0.3)):
            shining_monkey(place, (shade, shade, shade))
        scene.view_settings.view_transform = "Standard"
        scene.render.engine, scene.cycles.samples, scene.cycles.use_denoising, scene.cycles.device = "LIPPMANN", 8, False, "CPU"
        (self.folder / "small.toml").write_text('base = "looking-glass-portrait"\npixels = [48, 64]\n[quilt]\ntiles = [4, 2]\nsize = [240, 160]\naspect = 0.75\n')
        settings = scene.lippmann
        settings.calibration, settings.output, settings.samples, settings.denoise, settings.folder = str(self.folder / "small.toml"), output, 8, False, str(self.folder)
        settings.full_depth, settings.extra = True, "--angular-filter none"
        scene.render.resolution_x, scene.render.resolution_y = size
        return scene

    def pictures(self, *parts):
        return sorted(self.folder.joinpath(*parts).rglob("*.png"))

    def test_views_of_cycles_are_those_of_the_tool(self):
        scene = self.new_scene()
        bpy.ops.render.render()
        own = tool.pictures(self.folder / "still", 0)[0]
        bpy.ops.lippmann.render_views(engine="CYCLES")
        quilt, = self.pictures("cycles", "quilt")
        self.assertEqual(quilt.name, "frame_0001_qs4x2a0.75.png")
        told = subprocess.run([os.environ["LIPPMANN_TOOL"], "compare", own, quilt, "--json"], capture_output=True, check=True)
        alike = json.loads(told.stdout)["mean"]["ssim"]
        print(f"SSIM of quilts {alike:.4f}")
        self.assertGreater(alike, 0.95)
        first, last = (self.pictures("cycles", "views")[index].read_bytes() for index in (0, -1))
        self.assertNotEqual(first, last)
        self.assertEqual((engine.last_folder, saving.shown_picture()), (str(quilt.parent), quilt))
        self.assertEqual((scene.render.engine, scene.camera.name, tuple(scene.render.resolution_x for _ in (0,))), ("LIPPMANN", "Camera", (240,)))
        self.assertNotIn(views.NAME, bpy.data.objects)

    def test_an_animation_becomes_native_frames(self):
        scene = self.new_scene("native", (48, 64))
        scene.cycles.samples, scene.frame_start, scene.frame_end = 1, 3, 4
        bpy.ops.lippmann.render_views(engine="CYCLES", animation=True)
        self.assertEqual([path.name for path in self.pictures("cycles", "native")], ["frame_0003.png", "frame_0004.png"])
        self.assertEqual(tuple(bpy.data.images["frame_0003.png"].size), (48, 64))

    def test_rendering_continues_where_it_was_stopped(self):
        scene = self.new_scene(size=(80, 40))
        scene.cycles.samples, scene.render.use_persistent_data = 1, False
        steps = views.Views(scene, "CYCLES").steps([1])
        # The first of the four steps compares the scene with the last rendered one. The others render views, of which
        # the last is not saved.
        for _ in range(4):
            if next(steps).renders:
                bpy.ops.render.render(write_still=True)
        steps.close()
        begun = {path.name: path.stat().st_mtime_ns for path in self.pictures("cycles")}
        self.assertEqual(sorted(begun), ["view_000.png", "view_001.png"])
        self.assertEqual((scene.render.engine, scene.render.use_persistent_data, scene.camera.name), ("LIPPMANN", False, "Camera"))
        self.assertNotIn(views.NAME, bpy.data.objects)
        self.assertEqual(self.render_and_count(), 6)
        kept = {path.name: path.stat().st_mtime_ns for path in self.pictures("cycles", "views")}
        self.assertEqual({name: kept[name] for name in begun}, begun)
        self.assertEqual(self.render_and_count(), 0)
        scene.cycles.samples = 2
        self.assertEqual(self.render_and_count(), 8)
        (self.pictures("cycles", "views")[0].parents[2] / "views.json").write_text('["')
        self.assertEqual(self.render_and_count(), 8)
        scene.lippmann.resume = False
        self.assertEqual(self.render_and_count(), 8)

    def render_and_count(self):
        """Returns how many pictures Blender rendered."""
        made = []

        def count(*_):
            made.append(1)

        bpy.app.handlers.render_complete.append(count)
        bpy.ops.lippmann.render_views(engine="CYCLES")
        bpy.app.handlers.render_complete.remove(count)
        return len(made)

    def test_a_failed_render_is_said_in_blender_s_words(self):
        scene = self.new_scene(size=(80, 40))
        scene.render.engine, scene.camera = "CYCLES", None
        self.assertRaisesRegex(tool.ToolError, "^(?!Error).*no camera", render_views.render_picture, scene)

    def test_engines_that_cannot_draw_are_refused(self):
        self.new_scene()
        hidden = {**os.environ, "__EGL_VENDOR_LIBRARY_DIRS": str(self.folder), "LIBGL_DRIVERS_PATH": str(self.folder)}
        hidden.pop("DISPLAY", None)
        with unittest.mock.patch.dict(os.environ, hidden, clear=True), unittest.mock.patch.object(views, "has_opengl", views.has_opengl.__wrapped__):
            self.assertRaisesRegex(RuntimeError, "need OpenGL", bpy.ops.lippmann.render_views, engine="BLENDER_WORKBENCH")

    def test_eyes_stand_where_the_quilt_s_do(self):
        self.assertAlmostEqual(views.eye_offset(0, 4, math.radians(40.0), 2.0), -2.0 * math.tan(math.radians(15.0)))
        self.assertAlmostEqual(sum(views.eye_offset(view, 5, 0.7, 3.0) for view in range(5)), 0.0)

    def test_views_have_the_size_of_the_output_s_tiles(self):
        for output, size, tile in (("quilt", (240, 160), (60, 80)), ("quilt", (248, 120), (62, 60)), ("native", (48, 64), (60, 80)), ("views", (90, 120), (90, 120))):
            scene = self.new_scene(output, size)
            made = views.Views(scene, "CYCLES")
            found, pixel_aspect = views.tile_of(scene, made.display)
            self.assertEqual(found, tile)
            self.assertAlmostEqual(pixel_aspect * tile[0] / tile[1], 0.75, places=3)

    def test_every_eye_frames_the_plane_of_the_display(self):
        scene = self.new_scene()
        zone = frame.zone(scene)
        camera = scene.camera
        scene.render.resolution_x, scene.render.resolution_y = 75, 100
        for right in (-1.0, 0.0, 2.0):
            views.place_camera(camera, zone, right)
            bpy.context.view_layer.update()
            for corner in camera.data.view_frame(scene=scene):
                place = zone.world_from_frame.inverted() @ camera.matrix_world @ (corner * (-zone.distance / corner.z))
                self.assertAlmostEqual(abs(place.x), 0.5 * zone.width, places=3)
                self.assertAlmostEqual(abs(place.y), 0.5 * zone.height, places=3)
                self.assertAlmostEqual(place.z, 0.0, places=3)

    def test_a_wall_behind_the_camera_is_cut_away(self):
        scene = self.new_scene()
        zone = frame.zone(scene)
        self.assertFalse(views.hides_scene(scene, bpy.context.evaluated_depsgraph_get(), zone))
        bpy.ops.mesh.primitive_plane_add(size=60.0, location=(0.0, 0.0, -1.0))
        self.assertFalse(views.hides_scene(scene, bpy.context.evaluated_depsgraph_get(), frame.zone(scene)))
        behind = scene.camera.matrix_world @ mathutils.Vector((0.0, 0.0, 1.0))
        bpy.ops.mesh.primitive_plane_add(size=60.0, location=behind, rotation=scene.camera.rotation_euler)
        self.assertTrue(views.hides_scene(scene, bpy.context.evaluated_depsgraph_get(), frame.zone(scene)))

    def test_views_are_noisy_where_blender_has_no_denoiser(self):
        scene = self.new_scene(size=(80, 40))
        scene.cycles.samples, scene.cycles.use_denoising = 1, True
        made = views.Views(scene, "CYCLES")
        for step in made.steps([1]):
            if step.renders:
                bpy.ops.render.render(write_still=True)
        self.assertEqual("no denoiser" in made.result(), not _cycles.with_openimagedenoise)
        self.assertTrue(scene.cycles.use_denoising)

    def test_views_are_pictures_where_the_output_is_a_video(self):
        scene = self.new_scene()
        kept = scene.render.image_settings
        if hasattr(kept, "media_type"):
            kept.media_type = "VIDEO"
        kept.file_format = "FFMPEG"
        with views.lent(*views.settings_for(scene, "CYCLES", scene.camera, (8, 8), 1.0)):
            self.assertEqual(kept.file_format, "PNG")
        self.assertEqual(kept.file_format, "FFMPEG")

    def test_displays_without_a_quilt_are_refused(self):
        scene = self.new_scene()
        scene.lippmann.calibration, scene.lippmann.display = "", "lenticular-60lpi-600dpi"
        with self.assertRaisesRegex(tool.ToolError, "has no quilt"):
            views.Views(scene, "CYCLES")

    def test_other_engines_are_offered(self):
        names = [name for name, *_ in views.engines()]
        self.assertEqual(names[0], "CYCLES")
        self.assertNotIn("LIPPMANN", names)


done = unittest.main(argv=["views_test"], exit=False, verbosity=2)
sys.exit(0 if done.result.wasSuccessful() else 1)
