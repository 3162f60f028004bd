"""Renders a still, changes one part of the scene, and renders again. The second picture must show the change. Blender runs this
file."""

import pathlib
import sys
import tempfile
import unittest

import bpy
import numpy as np

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[2] / "blender"), str(pathlib.Path(__file__).resolve().parent)]
import exporter  # noqa: E402
import lippmann  # noqa: E402
from lippmann import job, tool  # noqa: E402

lippmann.register()
exporter.serve(job)


def show_image(material, image):
    tree = material.node_tree
    node = tree.nodes.new("ShaderNodeTexImage")
    node.image = image
    tree.links.new(node.outputs["Color"], tree.nodes["Principled BSDF"].inputs["Base Color"])


def moved_by_keys(thing):
    for frame, height in ((1, 0.0), (10, 1.0)):
        thing.location.z = height
        thing.keyframe_insert("location", frame=frame)


def shaped(thing):
    thing.shape_key_add(name="Basis")
    key = thing.shape_key_add(name="stretched")
    key.value = 0.0  # Blender 5 begins with 1
    for point in key.data:
        point.co.x *= 2.0
    return key


class Changes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        bpy.ops.wm.read_factory_settings()
        self.scene = scene = bpy.context.scene
        scene.render.engine = "LIPPMANN"
        scene.view_settings.view_transform = "Standard"
        settings = scene.lippmann
        settings.output, settings.samples, settings.denoise, settings.folder = "camera", 16, False, str(self.folder)
        scene.render.resolution_x, scene.render.resolution_y = 64, 48
        self.cube = bpy.data.objects["Cube"]
        self.material = self.cube.data.materials[0]

    def picture(self):
        bpy.ops.render.render()
        image = bpy.data.images.load(str(tool.pictures(self.folder / "still", 0)[0]))
        values = np.array(image.pixels, np.float32)
        bpy.data.images.remove(image)
        return values

    def check_change(self, change):
        """The picture of an unchanged scene has the same bytes, without another export. After `change`, at least 1 % of the
        values differ by more than 5 %."""
        first, exported = self.picture(), job.stamp(self.folder / "scene.glb")
        self.assertTrue(np.array_equal(self.picture(), first))
        self.assertEqual(job.stamp(self.folder / "scene.glb"), exported)
        change()
        self.assertGreater(np.mean(np.abs(self.picture() - first) > 0.05), 0.01)

    def test_a_vertex(self):
        self.check_change(lambda: setattr(self.cube.data.vertices[0].co, "z", 3.0))

    def test_a_parameter_of_a_modifier(self):
        array = self.cube.modifiers.new("array", "ARRAY")
        self.check_change(lambda: setattr(array, "count", 3))

    def test_the_colour_of_a_material(self):
        socket = self.material.node_tree.nodes["Principled BSDF"].inputs["Base Color"]
        self.check_change(lambda: setattr(socket, "default_value", (1.0, 0.0, 0.0, 1.0)))

    def test_a_file_of_an_image(self):
        image = bpy.data.images.new("bark", 4, 4)
        image.filepath_raw, image.file_format = str(self.folder / "bark.png"), "PNG"
        image.save()
        show_image(self.material, bpy.data.images.load(image.filepath_raw))

        def paint():
            image.pixels[:] = [1.0, 0.0, 0.0, 1.0] * 16
            image.save()

        self.check_change(paint)

    def test_pixels_that_are_painted_and_not_saved(self):
        image = bpy.data.images.new("bark", 4, 4)
        show_image(self.material, image)
        self.check_change(lambda: image.pixels.foreach_set(np.tile(np.float32([1.0, 0.0, 0.0, 1.0]), 16)))

    def test_painted_pixels_of_a_file(self):
        image = bpy.data.images.new("bark", 4, 4)
        image.filepath_raw, image.file_format = str(self.folder / "bark.png"), "PNG"
        image.save()
        loaded = bpy.data.images.load(image.filepath_raw)
        show_image(self.material, loaded)
        self.check_change(lambda: loaded.pixels.foreach_set(np.tile(np.float32([1.0, 0.0, 0.0, 1.0]), 16)))

    def test_a_light(self):
        self.check_change(lambda: setattr(bpy.data.lights["Light"], "energy", 100.0))

    def test_the_light_of_the_world(self):
        background = self.scene.world.node_tree.nodes["Background"].inputs["Color"]
        self.check_change(lambda: setattr(background, "default_value", (0.0, 0.0, 1.0, 1.0)))

    def test_the_frame_of_an_animation(self):
        moved_by_keys(self.cube)
        self.scene.frame_set(1)
        self.check_change(lambda: self.scene.frame_set(10))

    def test_a_shape_key(self):
        key = shaped(self.cube)
        self.check_change(lambda: setattr(key, "value", 1.0))

    def test_the_place_of_the_camera(self):
        self.check_change(lambda: setattr(self.scene.camera, "location", self.scene.camera.location * 1.3))

    def test_a_picture_outside_the_scene_changes_nothing(self):
        bpy.ops.render.render()
        bpy.data.images.load(str(tool.pictures(self.folder / "still", 0)[0]))
        bpy.ops.render.render()
        exported = job.stamp(self.folder / "scene.glb")
        bpy.ops.render.render()
        self.assertEqual(job.stamp(self.folder / "scene.glb"), exported)

    def test_persistent_data_follows_its_setting(self):
        for keeps in (True, False):
            self.scene.lippmann.keep_scene = keeps
            self.picture()
            self.assertEqual(self.scene.render.use_persistent_data, keeps)

    def test_a_still_after_an_animation_is_a_still(self):
        self.scene.frame_end = 2
        self.scene.render.filepath = str(self.folder / "frame_")
        bpy.ops.render.render(animation=True)
        finished = job.stamp(self.folder / "animation" / "report.json")
        self.picture()
        self.assertEqual(job.stamp(self.folder / "animation" / "report.json"), finished)


done = unittest.main(argv=["changes_test"], exit=False, verbosity=2)
sys.exit(0 if done.result.wasSuccessful() else 1)
