"""Tests of the files that the add-on writes, and of the changes after which it exports a scene again. Blender runs this file."""

import io
import pathlib
import sys
import tempfile
import unittest

import bpy

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[2] / "blender"), str(pathlib.Path(__file__).resolve().parent)]
import exporter  # noqa: E402
import lippmann  # noqa: E402
from lippmann import contents, displays, engine, job, look, progress, saving, tool  # noqa: E402

lippmann.register()
exporter.serve(job)


def new_scene(folder, output, size=(60, 80)):
    bpy.ops.wm.read_factory_settings()
    scene = bpy.context.scene
    scene.render.engine = "LIPPMANN"
    scene.view_settings.view_transform = "Standard"
    settings = scene.lippmann
    settings.display, settings.output, settings.samples, settings.folder = "looking-glass-portrait", output, 1, str(folder)
    scene.render.resolution_x, scene.render.resolution_y = size
    scene.render.filepath = str(pathlib.Path(folder) / "saved_")
    return scene


def add_noise(material):
    """Links a noise texture to the material's colour. The export must bake it."""
    tree = material.node_tree
    tree.links.new(tree.nodes.new("ShaderNodeTexNoise").outputs["Color"], tree.nodes["Principled BSDF"].inputs["Base Color"])


class InFolder(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.addCleanup(self._folder.cleanup)
        self.folder = pathlib.Path(self._folder.name)


class Saving(InFolder):
    def saved(self):
        return sorted(path.name for path in self.folder.glob("saved_*"))

    def test_a_quilt_is_saved_under_a_name_with_its_tiles(self):
        scene = new_scene(self.folder, "quilt", (80, 60))
        bpy.ops.render.render(write_still=True)
        self.assertEqual(self.saved(), ["saved__qs8x6a0.75.png"])
        scene.frame_start = scene.frame_end = 3
        bpy.ops.render.render(animation=True)
        self.assertEqual(self.saved(), ["saved_0003_qs8x6a0.75.png", "saved__qs8x6a0.75.png"])

    def test_what_blender_saves_is_the_tool_s_picture_whatever_the_view_transform(self):
        scene = new_scene(self.folder, "single")
        scene.view_settings.view_transform, scene.view_settings.exposure = "Filmic", 1.0
        bpy.ops.render.render(write_still=True)
        self.assertEqual((self.folder / "saved_.png").read_bytes(), tool.pictures(self.folder / "still", 0)[0].read_bytes())
        self.assertIn("through Filmic", engine.last_warnings[-1])

    def test_a_copy_of_the_last_picture_has_the_tiles_in_its_name(self):
        saving.remember(self.folder / "nothing.png", False)
        self.assertFalse(bpy.ops.lippmann.save_as.poll())
        scene = new_scene(self.folder, "quilt", (80, 60))
        scene.view_settings.view_transform = "Filmic"
        bpy.ops.render.render()
        picture, = tool.pictures(self.folder / "still", 0)
        for name in ("copy.png", "copy_qs8x6a0.75.png"):
            bpy.ops.lippmann.save_as(filepath=str(self.folder / name))
            copy, = self.folder.glob("copy*")
            self.assertEqual((copy.name, copy.read_bytes()), ("copy_qs8x6a0.75.png", picture.read_bytes()))
            copy.unlink()
        with self.assertRaisesRegex(RuntimeError, "cannot be written"):
            bpy.ops.lippmann.save_as(filepath=str(self.folder / "missing" / "copy.png"))

    def test_names_stay_where_blender_knows_finished_frames_by_them(self):
        scene = new_scene(self.folder, "quilt", (80, 60))
        scene.frame_start = scene.frame_end = 3
        scene.render.use_overwrite = False
        bpy.ops.render.render(animation=True)
        self.assertEqual(self.saved(), ["saved_0003.png"])

    def test_other_engines_and_formats_save_their_own_pictures(self):
        scene = new_scene(self.folder, "single")
        scene.render.image_settings.file_format = "BMP"
        bpy.ops.render.render(write_still=True)
        self.assertEqual((self.folder / "saved_.bmp").read_bytes()[:2], b"BM")
        scene.render.image_settings.file_format, scene.render.engine = "PNG", "BLENDER_WORKBENCH"
        self.assertFalse(saving.is_ours(scene))

    def test_tiles_are_found_in_names_of_quilts_alone(self):
        self.assertEqual(saving.quilt_suffix("frame_0000_qs8x6a0.75.png"), "_qs8x6a0.75")
        self.assertEqual(saving.quilt_suffix("frame_0000.png"), "")

    def test_blender_s_view_transform_becomes_the_add_on_s_tone(self):
        scene = new_scene(self.folder, "single")
        view = scene.view_settings
        view.view_transform, view.exposure, view.gamma = "Filmic", 0.5, 1.2
        self.assertIn("Filmic", look.lost(view))
        bpy.ops.lippmann.take_over_view_transform()
        self.assertIsNone(look.lost(view))
        self.assertEqual(job.more_flags(scene, True), ["--tone", "agx", "--exposure", "0.5"])
        scene.lippmann.extra = "--tone none"
        self.assertEqual(job.more_flags(scene, True), ["--exposure", "0.5", "--tone", "none"])

    def test_files_that_are_not_saved_have_a_folder_of_their_own_in_each_session(self):
        scene = new_scene("//lippmann/", "single")
        folder = job.output_folder(scene)
        self.addCleanup(folder.parent.rmdir)
        self.assertEqual(folder, job.output_folder(scene))
        self.assertTrue(folder.parent.is_dir())
        before, job._of_session = job._of_session, None  # as after a restart of Blender
        other = job.output_folder(scene)
        self.addCleanup(other.parent.rmdir)
        self.assertNotEqual(folder, other)
        job._of_session = before

    def test_quilts_without_whole_pixels_per_view_are_refused(self):
        scene = new_scene(self.folder, "quilt", (100, 3360))
        sentence = displays.refused_size(scene, job.resolution(scene))
        self.assertEqual(sentence, "A quilt of 8 x 6 views cannot have 100 x 3360 pixels, because views have whole pixels. Press Match Resolution, or set 96 x 3360, at 100 %.")
        with self.assertRaisesRegex(tool.ToolError, "cannot have 100 x 3360 pixels"):
            job.check(scene, True)
        for size, fitting in (((3361, 3360), "3360 x 3360"), ((7, 60), "8 x 60"), ((3, 2), "8 x 6")):
            self.assertIn(f"or set {fitting}, at 100 %", displays.refused_size(scene, size))
        for size in ((3360, 3360), (1680, 840), (8, 6)):
            self.assertIsNone(displays.refused_size(scene, size))
        scene.lippmann.extra = "--views 2x1"
        self.assertIsNone(displays.refused_size(scene, (7, 60)))
        scene.lippmann.output = "native"
        self.assertIn("1536 x 2048", displays.refused_size(scene, (60, 80)))

    def test_quilts_that_a_display_pads_are_accepted(self):
        scene = new_scene(self.folder, "quilt")
        for one in displays.known():
            if "quilt" in one:
                scene.lippmann.display = one["name"]
                self.assertIsNone(displays.refused_size(scene, tuple(one["quilt"]["size"])), one["name"])
        scene.lippmann.display = "looking-glass-16-gen2"
        self.assertIsNone(displays.refused_size(scene, (2048, 2048)))
        self.assertIn("or set 5 x 9, at 100 %", displays.refused_size(scene, (4, 8)))


class Exporting(InFolder):
    def render(self, **settings):
        """Renders with the given settings of the add-on. Returns whether the scene was exported again."""
        scene = bpy.context.scene
        for name, value in settings.items():
            setattr(scene.lippmann, name, value)
        before = job.stamp(self.folder / "scene.glb")
        bpy.ops.render.render()
        return job.stamp(self.folder / "scene.glb") != before

    def test_an_unchanged_scene_is_exported_once(self):
        scene = new_scene(self.folder, "single")
        self.assertTrue(self.render())
        warnings = list(engine.last_warnings)
        bpy.ops.object.select_all(action="SELECT")
        self.assertFalse(self.render())
        self.assertFalse(self.render(samples=1, denoise=False, extra="--exposure 1", tone="agx", full_depth=True))
        scene.render.resolution_x = 90
        self.assertFalse(self.render())
        self.assertEqual(engine.last_warnings, warnings)
        changes = [lambda: setattr(bpy.data.objects["Cube"], "location", (1.0, 0.0, 0.0)), lambda: setattr(bpy.data.meshes["Cube"].vertices[0].co, "x", 2.0),
                   lambda: bpy.data.materials["Material"].node_tree.nodes["Principled BSDF"].inputs.__getitem__("Metallic").__setattr__("default_value", 0.5),
                   lambda: setattr(bpy.data.lights["Light"], "energy", 1.0), lambda: setattr(scene, "frame_current", 2), lambda: (self.folder / "scene.glb").write_bytes(b"")]
        for index, change in enumerate(changes):
            change()
            self.assertTrue(self.render(), index)
            self.assertFalse(self.render(), index)

    def test_a_changed_texture_is_exported_again(self):
        new_scene(self.folder, "single")
        file = self.folder / "bark.png"
        image = bpy.data.images.new("bark", 4, 4)
        image.filepath_raw, image.file_format = str(file), "PNG"
        image.save()
        tree = bpy.data.materials["Material"].node_tree
        node = tree.nodes.new("ShaderNodeTexImage")
        node.image = bpy.data.images.load(str(file))
        tree.links.new(node.outputs["Color"], tree.nodes["Principled BSDF"].inputs["Base Color"])
        self.assertTrue(self.render())
        self.assertFalse(self.render())
        image.pixels[:] = [1.0] * 64
        image.save()
        self.assertTrue(self.render())

    def test_what_does_not_change_is_not_baked_again(self):
        new_scene(self.folder, "single")
        add_noise(bpy.data.materials["Material"])
        self.render(bake_size=64)
        exported = (self.folder / "scene.glb").read_bytes()

        def baked():
            return {path.name: path.stat().st_mtime_ns for path in (self.folder / "baked").iterdir()}

        first = baked()
        self.assertEqual(len(first), 1)
        (self.folder / "scene.json").unlink()
        self.assertTrue(self.render())
        self.assertEqual(baked(), first)
        self.assertEqual((self.folder / "scene.glb").read_bytes(), exported)
        bpy.data.objects["Light"].location.x += 1.0
        self.assertTrue(self.render())
        self.assertEqual(baked(), first)
        bpy.data.materials["Material"].node_tree.nodes["Noise Texture"].inputs["Scale"].default_value = 9.0
        self.assertTrue(self.render())
        self.assertEqual(len(baked()), 1)
        self.assertNotEqual(baked().keys(), first.keys())

    def test_datablocks_have_hashes_of_what_they_hold(self):
        scene = new_scene(self.folder, "single")
        group = bpy.data.node_groups.new("paint", "ShaderNodeTree")
        value = group.nodes.new("ShaderNodeValue")
        bpy.data.materials["Material"].node_tree.nodes.new("ShaderNodeGroup").node_tree = group

        def read():
            bpy.data.libraries.write(str(self.folder / "one.blend"), {scene})
            return contents.Contents(self.folder / "one.blend")

        before = read()
        self.assertEqual(before.by_name, read().by_name)
        value.outputs[0].default_value = 3.0
        after = read()
        self.assertEqual({name for name in after.by_name if after.by_name[name] != before.by_name[name]}, {"NTpaint"})
        self.assertNotEqual(before.with_references("MAMaterial"), after.with_references("MAMaterial"))
        self.assertEqual(before.with_references("LALight"), after.with_references("LALight"))
        bpy.data.objects["Cube"].parent = bpy.data.objects["Light"]
        self.assertNotEqual(after.by_name["OBCube"], read().by_name["OBCube"])

    def test_a_file_of_another_form_is_refused(self):
        (self.folder / "other.blend").write_bytes(b"\x1f\x8b compressed")
        with self.assertRaisesRegex(ValueError, "no uncompressed .blend file"):
            contents.Contents(self.folder / "other.blend")


class Progress(unittest.TestCase):
    def test_steps_have_their_share_and_time(self):
        self.assertEqual(progress.sentence("rendering frame 3", 0.421, 75.2), "rendering frame 3, 42 %, about 1:15 left")
        self.assertEqual(progress.sentence("exporting the scene", 0.0, None), "exporting the scene")
        self.assertEqual([progress.clock(seconds) for seconds in (7.4, 3725)], ["7 s", "1:02:05"])

    def test_the_terminal_gets_a_line_for_each_step_and_then_every_few_seconds(self):
        now, file = [0.0], io.StringIO()
        terminal = progress.Terminal(lambda: now[0], file)
        for seconds, step, share in ((0, "exporting", 0.0), (1, "exporting", 0.5), (2, "rendering", 0.0), (4, "rendering", 0.3), (8, "rendering", 0.4), (20, "rendering", 0.4)):
            now[0] = seconds
            terminal.say(step, share, None)
        self.assertEqual(file.getvalue(), "lippmann: exporting\nlippmann: rendering\nlippmann: rendering, 40 %\n")

    def test_a_child_s_steps_are_read(self):
        with tempfile.TemporaryDirectory() as folder:
            line = '{"step": "baking wood", "share": 0.5, "seconds_left": 3.5}'
            child = tool.Child([sys.executable, "-c", f"import sys; sys.stderr.write({line!r} + chr(10))"], pathlib.Path(folder) / "log")
            child._process.wait()
            child.check()
            self.assertEqual((child.step, child.share, child.seconds_left), ("baking wood", 0.5, 3.5))


done = unittest.main(argv=["saving_test"], exit=False, verbosity=2)
sys.exit(0 if done.result.wasSuccessful() else 1)
