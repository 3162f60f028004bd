"""Tests of the pictures that the scene's camera or a display's viewer sees. Blender runs this file."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import bpy
import mathutils
import numpy as np

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[2] / "blender"), str(pathlib.Path(__file__).resolve().parent)]
import exporter  # noqa: E402
import lippmann  # noqa: E402
from lippmann import displays, engine, frame, job, tool  # noqa: E402

lippmann.register()
exporter.serve(job)


def shining(colour):
    material = bpy.data.materials.new("shining")
    material.use_nodes = True
    tree = material.node_tree
    light = tree.nodes.new("ShaderNodeEmission")
    light.inputs["Color"].default_value = (*colour, 1.0)
    tree.links.new(light.outputs[0], tree.get_output_node("ALL").inputs["Surface"])
    return material


def paint(colour):
    bpy.context.object.data.materials.clear()
    bpy.context.object.data.materials.append(shining(colour))


def new_scene(folder, output, size, sky=(0.0, 0.0, 0.0)):
    bpy.ops.wm.read_factory_settings()
    scene = bpy.context.scene
    bpy.data.objects.remove(bpy.data.objects["Cube"])
    scene.view_settings.view_transform = "Standard"
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (*sky, 1.0)
    scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value = 1.0
    for place, colour in (((0.0, 0.0, 0.0), (1.0, 1.0, 1.0)), ((3.0, -3.0, 2.0), (0.5, 0.5, 0.5)), ((-6.0, 5.0, 0.0), (0.2, 0.2, 0.2))):
        bpy.ops.mesh.primitive_monkey_add(location=place)
        paint(colour)
    scene.render.engine = "LIPPMANN"
    settings = scene.lippmann
    settings.display, settings.output, settings.samples, settings.denoise, settings.folder = "looking-glass-portrait", output, 16, False, str(folder)
    scene.render.resolution_x, scene.render.resolution_y = size
    return scene


def picture(file):
    """Returns the pixel values of a picture file, from 0 to 1, as an array (row from the bottom, column, channel)."""
    image = bpy.data.images.load(str(file))
    image.colorspace_settings.name = "Non-Color"
    return np.array(image.pixels[:]).reshape(image.size[1], image.size[0], -1)[..., :3]


def of_cycles(scene, file):
    scene.render.engine, scene.cycles.samples, scene.cycles.use_denoising, scene.cycles.device = "CYCLES", 16, False, "CPU"
    scene.render.filepath = str(file)
    bpy.ops.render.render(write_still=True)
    return file


def likeness(one, other):
    told = subprocess.run([os.environ["LIPPMANN_TOOL"], "compare", str(one), str(other), "--json"], capture_output=True, check=True)
    return json.loads(told.stdout)["mean"]["ssim"]


class Camera(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.addCleanup(self._folder.cleanup)
        self.folder = pathlib.Path(self._folder.name)

    def still(self):
        bpy.ops.render.render()
        return tool.pictures(self.folder / "still", 0)[0]

    def set_up(self, case, size, output="camera"):
        """Makes a scene whose camera has the attributes in `case`, a dict of names and values."""
        scene = new_scene(self.folder, output, size)
        for name, value in case.items():
            setattr(scene.camera.data, name, value)
        return scene

    def test_the_camera_s_picture_is_that_of_cycles(self):
        cases = [({}, (160, 120)), ({}, (90, 120)), ({"sensor_fit": "VERTICAL", "shift_x": 0.2, "shift_y": -0.15}, (160, 120)), ({"lens": 24.0, "shift_x": -0.3}, (90, 120)),
                 ({"type": "ORTHO", "ortho_scale": 9.0, "shift_y": 0.1}, (160, 120))]
        for case, size in cases:
            with self.subTest(case=case, size=size):
                scene = self.set_up(case, size)
                own = self.still()
                self.assertGreater(picture(own).std(), 0.05)
                alike = likeness(own, of_cycles(scene, self.folder / "cycles.png"))
                print(f"SSIM with Cycles {alike:.4f}: {case} {size}")
                self.assertGreater(alike, 0.95)

    def test_the_viewer_sees_another_perspective_than_the_camera(self):
        scene = self.set_up({}, (90, 120), "single")
        self.assertLess(likeness(self.still(), of_cycles(scene, self.folder / "cycles.png")), 0.95)

    def test_the_camera_s_near_clipping_plane_cuts_a_wall_away(self):
        scene = self.set_up({"clip_start": 4.0}, (160, 120))
        camera = scene.camera
        bpy.ops.mesh.primitive_plane_add(size=50.0, location=camera.matrix_world @ mathutils.Vector((0.0, 0.0, -2.0)), rotation=camera.rotation_euler)
        bpy.context.object.name = "near wall"
        paint((0.0, 0.0, 1.0))
        own = self.still()
        self.assertGreater(likeness(own, of_cycles(scene, self.folder / "cycles.png")), 0.95)
        self.assertTrue(any("near wall" in words for words in engine.last_warnings), engine.last_warnings)

    def test_a_floor_reaches_the_lower_edge_of_what_the_viewer_sees(self):
        for output, size in (("camera", (60, 80)), ("single", (60, 80)), ("quilt", (480, 480))):
            with self.subTest(output=output):
                scene = new_scene(self.folder, output, size, sky=(0.0, 0.0, 1.0))
                bpy.ops.mesh.primitive_plane_add(size=60.0, location=(0.0, 0.0, -1.0))
                paint((1.0, 0.0, 0.0))
                shown = picture(self.still())
                rows = shown.shape[0] // (6 if output == "quilt" else 1)
                for lowest in range(0, shown.shape[0], rows):
                    below = shown[lowest:lowest + rows // 3]
                    self.assertLess((below[..., 2] > below[..., 0] + 0.2).mean(), 0.001)
                self.assertEqual(json.loads((self.folder / "still" / "report.json").read_text())["cut"], "")

    def test_a_wall_behind_the_camera_does_not_hide_the_room_and_is_said(self):
        scene = new_scene(self.folder, "single", (60, 80))
        bpy.ops.mesh.primitive_cube_add(size=20.0, location=(0.0, 0.0, 8.0))
        bpy.context.object.name = "room"
        paint((0.0, 0.0, 1.0))
        self.assertGreater(frame.zone(scene).near, 0.0)
        shown = picture(self.still())
        self.assertGreater((shown[..., 0] > 0.3).mean(), 0.05)
        self.assertTrue(any("'room" in words for words in engine.last_warnings), engine.last_warnings)

    def test_a_scene_without_a_camera_has_no_camera_s_picture(self):
        scene = new_scene(self.folder, "camera", (60, 80))
        bpy.data.objects.remove(scene.camera)
        with self.assertRaisesRegex(tool.ToolError, "has no camera"):
            job.check(scene, True)

    def test_the_camera_s_lens_blurs_what_is_out_of_its_focus(self):
        spread = []
        for focus in (0.0, 1.0):
            scene = self.set_up({}, (160, 120))
            camera = scene.camera
            camera.data.dof.use_dof, camera.data.dof.aperture_fstop = True, 0.1
            camera.data.dof.focus_distance = camera.location.length * (1.0 - 0.5 * focus)
            own = self.still()
            spread.append(likeness(own, of_cycles(scene, self.folder / "cycles.png")))
        self.assertGreater(min(spread), 0.9, spread)

    def test_what_is_chosen_for_a_camera_s_picture_has_the_display_s_shape(self):
        scene = new_scene(self.folder, "quilt", (480, 480))
        scene.lippmann.output = "camera"
        width, height = job.resolution(scene)
        self.assertAlmostEqual(width / height, displays.aspect(displays.chosen(scene)), delta=0.01)

    def test_meshes_without_material_are_as_bright_as_in_cycles(self):
        def linear(values):
            return np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055)**2.4)

        bpy.ops.wm.read_factory_settings()
        scene = bpy.context.scene
        for name in ("Cube", "Light"):
            bpy.data.objects.remove(bpy.data.objects[name])
        bpy.ops.object.light_add(type="SUN", rotation=(0.5, 0.3, 0.0))
        bpy.context.object.data.energy = 1.5
        scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.2, 0.2, 0.2, 1.0)
        bpy.ops.mesh.primitive_plane_add(size=60.0, location=(0.0, 0.0, -1.0))
        bpy.ops.mesh.primitive_cube_add(location=(-1.5, 0.0, 0.0))
        bpy.context.object.data.materials.append(None)  # a slot without material
        bpy.ops.mesh.primitive_uv_sphere_add(location=(1.5, 0.0, 0.0))
        bpy.context.object.shape_key_add(name="Basis")  # exported without being evaluated in animations
        scene.view_settings.view_transform, scene.render.engine = "Standard", "LIPPMANN"
        settings = scene.lippmann
        settings.display, settings.output, settings.samples, settings.folder = "looking-glass-portrait", "camera", 64, str(self.folder)
        scene.render.resolution_x, scene.render.resolution_y, scene.render.filepath = 96, 72, str(self.folder / "saved_")
        scene.frame_start = scene.frame_end = 1
        own = [self.still()]
        bpy.ops.render.render(animation=True)
        own.append(tool.pictures(self.folder / "animation", 1)[0])
        expected = linear(picture(of_cycles(scene, self.folder / "cycles.png")))
        self.assertLess(expected.max(), 1.0)
        for file in own:
            shares = linear(picture(file)).mean() / expected.mean()
            print(f"light of meshes without material: {shares:.4f} of Cycles'")
            self.assertAlmostEqual(shares, 1.0, delta=0.03)


done = unittest.main(argv=["camera_test"], exit=False, verbosity=2)
sys.exit(0 if done.result.wasSuccessful() else 1)
