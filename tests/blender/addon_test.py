"""Tests of the Blender add-on. Run with: blender -b --factory-startup --python addon_test.py"""

import ast
import json
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import tomllib
import types
import unittest
import unittest.mock

import bpy
import mathutils
import numpy as np

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[2] / "blender"), str(pathlib.Path(__file__).resolve().parent)]
import exporter  # noqa: E402
import lippmann  # noqa: E402
from lippmann import contents, displays, engine, exposure, film, frame, look, losses, materials, overlay, panel, progress, scene_export, tool, versions  # noqa: E402
from lippmann import job as jobs  # noqa: E402

lippmann.register()
exporter.serve(jobs)

WHITE = (1.0, 1.0, 1.0, 1.0)


def new_scene(folder, output, samples=16, size=(60, 80)):
    bpy.ops.wm.read_factory_settings()
    scene = bpy.context.scene
    scene.render.engine = "LIPPMANN"
    scene.view_settings.view_transform = "Standard"
    settings = scene.lippmann
    settings.display, settings.output, settings.samples, settings.folder = "looking-glass-portrait", output, samples, str(folder)
    scene.render.resolution_x, scene.render.resolution_y = size
    scene.render.filepath = str(pathlib.Path(folder) / "blender_")
    return scene


def gltf(folder):
    data = (pathlib.Path(folder) / "scene.glb").read_bytes()
    return json.loads(data[20:20 + struct.unpack_from("<I", data, 12)[0]])


def positions(folder, channel):
    """Returns the key translations, as an array (keys, 3), of one channel of the first animation in scene.glb."""
    data, document = (pathlib.Path(folder) / "scene.glb").read_bytes(), gltf(folder)
    sampler = document["animations"][0]["samplers"][channel["sampler"]]
    accessor = document["accessors"][sampler["output"]]
    view = document["bufferViews"][accessor["bufferView"]]
    start = 20 + struct.unpack_from("<I", data, 12)[0] + 8 + view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    return np.frombuffer(data, np.float32, 3 * accessor["count"], start).reshape(-1, 3)


def contrast(picture):
    image = bpy.data.images.load(str(picture))
    values = np.empty(len(image.pixels), np.float32)
    image.pixels.foreach_get(values)
    return values.reshape(-1, image.channels)[:, :3].std()


def add_figure(scene):
    """Adds a plane that a bone rotates and a shape key raises, from frame 5 to frame 6."""
    bpy.ops.object.armature_add()
    skeleton = bpy.context.object
    bone = skeleton.pose.bones[0]
    bone.rotation_mode = "XYZ"
    bpy.ops.mesh.primitive_plane_add()
    figure = bpy.context.object
    figure.modifiers.new("bent", "ARMATURE").object = skeleton
    figure.vertex_groups.new(name="Bone").add(range(4), 1.0, "REPLACE")
    figure.shape_key_add(name="Basis")
    raised = figure.shape_key_add(name="raised")
    for point in raised.data:
        point.co.z += 1.0
    for number, share in ((5, 0.0), (6, 1.0)):
        bone.rotation_euler.x, raised.value = 1.5 * share, share
        bone.keyframe_insert("rotation_euler", frame=number)
        raised.keyframe_insert("value", frame=number)


def add_missing_library(scene, folder):
    thing = bpy.data.objects.new("guest", bpy.data.meshes["Cube"])
    bpy.data.libraries.write(str(folder / "guests.blend"), {thing})
    bpy.data.objects.remove(thing)
    with bpy.data.libraries.load(str(folder / "guests.blend"), link=True) as (_, here):
        here.objects = ["guest"]
    scene.collection.objects.link(here.objects[0])
    (folder / "guests.blend").unlink()


def open_with_names_replaced(file, names):
    """Saves the scene, replaces byte strings in the file, and opens it. Blender itself cannot set names that are not UTF-8.
    names: {old: new} of equal lengths."""
    bpy.ops.wm.save_as_mainfile(filepath=str(file), compress=False)
    data = file.read_bytes()
    for old, new in names.items():
        data = data.replace(old, new)
    file.write_bytes(data)
    bpy.ops.wm.open_mainfile(filepath=str(file))
    return bpy.context.scene


def failure(operator, **arguments):
    try:
        operator(**arguments)
    except RuntimeError as error:
        return str(error)
    return ""


def new_group(name, kind, inputs, outputs):
    group = bpy.data.node_groups.new(name, kind)
    for sockets, side in ((inputs, "INPUT"), (outputs, "OUTPUT")):
        for socket, of_type in sockets.items():
            if hasattr(group, "interface"):
                group.interface.new_socket(socket, in_out=side, socket_type=of_type)
            else:
                (group.inputs if side == "INPUT" else group.outputs).new(of_type, socket)
    return group


class Material:
    def __init__(self, name):
        self.material = bpy.data.materials.new(name)
        self.material.use_nodes = True
        self.tree = self.material.node_tree
        self.tree.nodes.clear()
        self.output = self.node("ShaderNodeOutputMaterial")

    def node(self, kind, **values):
        node = self.tree.nodes.new(kind)
        for name, value in values.items():
            node.inputs[name.replace("_", " ")].default_value = value
        return node

    def feed(self, source, node, name, output=0):
        self.tree.links.new(source.outputs[output], node.inputs[name])
        return node

    def shows(self, shader):
        self.feed(shader, self.output, "Surface")
        return self.material


def arrived(scene, folder, materials):
    """Exports the scene with a small plane for each material. Returns {name: material in the glTF file}."""
    for index, material in enumerate(materials):
        bpy.ops.mesh.primitive_plane_add(size=0.1, location=(0.2 * index, 0.0, 0.0))
        bpy.context.object.data.materials.append(material)
    bpy.ops.render.render()
    return {material["name"]: material for material in gltf(folder)["materials"]}


class AddOn(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.addCleanup(self._folder.cleanup)
        self.folder = pathlib.Path(self._folder.name)

    def test_preview_and_middle_view_agree(self):
        new_scene(self.folder / "one", "single", samples=64)
        bpy.ops.render.render()
        scene = new_scene(self.folder / "many", "views", samples=64, size=(60, 80))
        scene.lippmann.extra = "--views 3x1 --size 180x80 --full-depth --angular-filter none"
        bpy.ops.render.render()
        preview = tool.pictures(self.folder / "one" / "still", 0)
        views = tool.pictures(self.folder / "many" / "still", 0)
        self.assertEqual((len(preview), len(views)), (1, 3))
        told = subprocess.run([os.environ["LIPPMANN_TOOL"], "compare", preview[0], views[1], "--json"], capture_output=True, check=True)
        self.assertGreater(json.loads(told.stdout)["mean"]["ssim"], 0.99)
        self.assertGreater(contrast(preview[0]), 0.05)

    def test_an_animation_has_its_frames_moves_by_constraints_and_resumes(self):
        scene = new_scene(self.folder, "quilt", samples=1, size=(80, 60))
        scene.frame_start, scene.frame_end = 3, 4
        cube = bpy.data.objects["Cube"]
        for number, place in ((3, 0.0), (4, 2.0)):
            cube.location.x = place
            cube.keyframe_insert("location", frame=number)
        bpy.ops.mesh.primitive_plane_add()
        follower = bpy.context.object
        follower.constraints.new("COPY_LOCATION").target = cube
        interrupted = jobs.Job(scene, False)
        interrupted.frame(3)
        interrupted.stop()
        before = [path.stat().st_mtime_ns for path in tool.pictures(self.folder / "animation", 3)]
        bpy.ops.render.render(animation=True)
        self.assertEqual(before, [path.stat().st_mtime_ns for path in tool.pictures(self.folder / "animation", 3)])
        self.assertTrue(tool.pictures(self.folder / "animation", 3) and tool.pictures(self.folder / "animation", 4))
        self.assertTrue((self.folder / "blender_0004_qs8x6a0.75.png").is_file())
        document = gltf(self.folder)
        moved = {document["nodes"][channel["target"]["node"]]["name"] for motion in document["animations"] for channel in motion["channels"]}
        self.assertTrue(any(name.startswith("Plane") for name in moved), moved)

    def test_a_frame_stands_at_the_camera_s_focus_and_at_objects(self):
        scene = new_scene(self.folder, "single")
        scene.camera.data.dof.focus_distance = 5.0
        bpy.ops.lippmann.place_at_focus()
        zone = frame.zone(scene)
        away = (scene.camera.matrix_world.translation - zone.world_from_frame.translation).length
        self.assertAlmostEqual(away, 5.0, places=4)
        bpy.ops.lippmann.place_at_selected()
        self.assertLess(frame.zone(scene).world_from_frame.translation.length, 1e-5)
        self.assertAlmostEqual(scene.lippmann.frame.lippmann.height, 2.4, places=5)

    def test_without_depth_of_field_the_plane_stands_amid_what_the_camera_sees(self):
        scene = new_scene(self.folder, "single")
        camera, cube = scene.camera, bpy.data.objects["Cube"]

        def plane():
            bpy.context.view_layer.update()
            return -(camera.matrix_world.inverted() @ frame.zone(scene).world_from_frame.translation).z

        camera.data.dof.focus_distance = 0.0  # files of old Blender versions contain 0
        self.assertAlmostEqual(plane(), (camera.location - cube.location).length, delta=1.8)  # may be anywhere on the cube
        camera.location = 3.0 * camera.location
        self.assertAlmostEqual(plane(), (camera.location - cube.location).length, delta=1.8)
        camera.data.type, camera.data.ortho_scale = "ORTHO", 4.0
        self.assertAlmostEqual(plane(), (camera.location - cube.location).length, delta=1.8)
        bpy.ops.mesh.primitive_plane_add(size=4.0, location=0.5 * camera.location)
        bpy.context.object.hide_render = True
        self.assertAlmostEqual(plane(), (camera.location - cube.location).length, delta=1.8)
        camera.data.dof.use_dof, camera.data.dof.focus_distance = True, 5.0
        self.assertAlmostEqual(plane(), 5.0, places=4)
        camera.data.dof.use_dof = False
        bpy.data.objects.remove(cube)
        self.assertAlmostEqual(plane(), 5.0, places=4)
        camera.data.dof.focus_distance = 0.0
        self.assertAlmostEqual(plane(), frame.UNFOCUSED, places=4)

    def test_an_animation_keeps_the_distance_that_its_first_frame_has(self):
        scene = new_scene(self.folder, "single", samples=1)
        scene.frame_start, scene.frame_end = 1, 2
        cube = bpy.data.objects["Cube"]
        away = (scene.camera.matrix_world.translation - cube.location).normalized()
        for number in (1, 2):
            cube.location = -8.0 * (number - 1) * away
            cube.keyframe_insert("location", frame=number)
        bpy.ops.render.render(animation=True)
        eyes = [node for node in gltf(self.folder)["nodes"] if "camera" in node]
        self.assertEqual(len(eyes), 1)
        moved = [channel for channel in gltf(self.folder)["animations"][0]["channels"] if "camera" in gltf(self.folder)["nodes"][channel["target"]["node"]]]
        places = [positions(self.folder, channel) for channel in moved if channel["target"]["path"] == "translation"]
        self.assertTrue(places)
        for track in places:
            self.assertLess(np.abs(track - track[0]).max(), 1e-5)

    def test_the_focus_frames_what_the_camera_frames_whatever_its_sensor_and_shift(self):
        scene = new_scene(self.folder, "single")
        camera = scene.camera
        camera.data.dof.focus_distance = 5.0
        camera.data.shift_x, camera.data.shift_y, camera.data.sensor_height = 0.25, -0.5, 20.0
        for kind in ("PERSP", "ORTHO"):
            for fit in ("AUTO", "HORIZONTAL", "VERTICAL"):
                for width, height in ((60, 80), (160, 90)):
                    camera.data.type, camera.data.sensor_fit = kind, fit
                    scene.render.resolution_x, scene.render.resolution_y = width, height
                    corners = [np.array(corner) for corner in camera.data.view_frame(scene=scene)]
                    corners = [corner * (-5.0 / corner[2] if kind == "PERSP" else 1.0) for corner in corners]
                    lower, upper = np.min(corners, axis=0), np.max(corners, axis=0)
                    matrix, tall = frame.framed(camera, width / height, frame.focus_distance(camera))
                    middle = camera.matrix_world.inverted() @ matrix.translation
                    case = (kind, fit, width, height)
                    self.assertAlmostEqual(tall, upper[1] - lower[1], places=4, msg=case)
                    self.assertAlmostEqual(middle.x, 0.5 * (lower[0] + upper[0]), places=4, msg=case)
                    self.assertAlmostEqual(middle.y, 0.5 * (lower[1] + upper[1]), places=4, msg=case)
                    self.assertAlmostEqual(middle.z, -5.0, places=4, msg=case)

    def test_a_scene_without_a_camera_or_with_a_frame_of_no_size_is_refused_in_one_sentence(self):
        scene = new_scene(self.folder, "single")
        bpy.ops.lippmann.place_at_focus()
        scene.lippmann.frame.scale = (0.0, 0.0, 0.0)
        bpy.context.view_layer.update()
        self.assertIn("no size", failure(bpy.ops.render.render))
        bpy.data.objects.remove(scene.lippmann.frame)
        bpy.data.objects.remove(scene.camera)
        with self.assertRaisesRegex(tool.ToolError, "neither a light-field frame nor a camera"):
            frame.zone(scene)

    def test_buttons_that_can_do_nothing_are_greyed_with_a_reason(self):
        scene = new_scene(self.folder, "quilt")
        engine.last_folder = ""
        self.assertIn("Nothing has been rendered yet", failure(bpy.ops.lippmann.view))
        bpy.ops.object.select_all(action="DESELECT")
        self.assertIn("Select an object", failure(bpy.ops.lippmann.place_at_selected))
        scene.camera = None
        self.assertIn("no camera", failure(bpy.ops.lippmann.place_at_focus))
        scene.render.resolution_x = 7
        self.assertIn("cannot have 7 x 80 pixels", failure(bpy.ops.lippmann.render_views))
        scene.lippmann.display = "lenticular-60lpi-600dpi"
        self.assertIn("has no quilt", failure(bpy.ops.lippmann.render_views))

    def test_lengths_of_the_scene_have_its_units(self):
        scene = new_scene(self.folder, "quilt")
        display, zone = displays.chosen(scene), Fake(distance=31.0625, budget=0.608)
        self.assertEqual(panel.figures(scene, display, zone)[1:], ["Viewer at 654 mm; in the scene at 31.1 m", "Sharp \u00b1 12.8 mm; in the scene \u00b1 60.8 cm"])
        scene.unit_settings.system = "NONE"
        self.assertTrue(panel.figures(scene, display, zone)[1].endswith("at 31.1"), panel.figures(scene, display, zone))

    def test_rendering_leaves_the_data_of_blender_alone(self):
        # Blender 5 crashes at the second frame of an animation if rendering the first frame loaded and removed an image.
        makes = {"append", "load", "new", "new_from_object", "remove"}
        for module in (engine, jobs, contents, displays, exposure, film, frame, look, progress, tool):
            for function in ast.walk(ast.parse(pathlib.Path(module.__file__).read_text())):
                if not isinstance(function, ast.FunctionDef) or (module is frame and function.name == "add"):
                    continue
                called = [ast.unparse(call.func) for call in ast.walk(function) if isinstance(call, ast.Call)]
                changed = [name for name in called if name.startswith("bpy.data.") and name.rpartition(".")[2] in makes]
                self.assertEqual(changed, [], f"{module.__name__}.{function.name}")

    def test_the_size_of_a_picture_is_read_without_an_image_of_blender(self):
        scene = new_scene(self.folder, "single", samples=1)
        bpy.ops.render.render()
        picture = tool.pictures(self.folder / "still", 0)[0]
        images = list(bpy.data.images)
        self.assertEqual(engine.size_of(picture), jobs.resolution(scene))
        self.assertEqual(list(bpy.data.images), images)

    def test_a_cancelled_render_ends_its_children(self):
        scene = new_scene(self.folder, "quilt", samples=4096, size=(800, 600))
        job = jobs.Job(scene, True)
        asked = []
        with self.assertRaises(jobs.Cancelled):
            job.frame(1, stopped=lambda: asked.append(job._started) or job._started)
        self.assertFalse(job._child.running())
        self.assertFalse(tool.pictures(self.folder / "still", 0))

    def test_a_missing_texture_is_said_and_the_rest_rendered(self):
        new_scene(self.folder, "single", samples=1)
        image = bpy.data.images.new("bark", 4, 4)
        image.source, image.filepath = "FILE", "/nowhere/bark.png"
        tree = bpy.data.materials["Material"].node_tree
        node = tree.nodes.new("ShaderNodeTexImage")
        node.image = image
        tree.links.new(node.outputs["Color"], tree.nodes["Principled BSDF"].inputs["Base Color"])
        bpy.ops.render.render()
        self.assertTrue(any("bark" in warning for warning in engine.last_warnings), engine.last_warnings)
        self.assertTrue(tool.pictures(self.folder / "still", 0))

    def test_a_maker_s_animation_arrives_as_native_frames_and_a_video_and_what_is_lost_is_said(self):
        folder = self.folder / "Käfer"
        folder.mkdir()
        scene = new_scene(folder, "native", samples=1, size=(48, 64))
        (folder / "panel.toml").write_text('base = "looking-glass-portrait"\npixels = [48, 64]\n')
        scene.lippmann.calibration, scene.lippmann.video = str(folder / "panel.toml"), True
        scene.render.fps, scene.frame_start, scene.frame_end = 24, 5, 6
        add_figure(scene)
        add_missing_library(scene, folder)
        checks = bpy.data.materials["Material"].node_tree
        checks.links.new(checks.nodes.new("ShaderNodeTexChecker").outputs["Color"], checks.nodes["Principled BSDF"].inputs["Base Color"])
        scene.camera.data.dof.use_dof = True
        bpy.data.objects["Cube"].name, bpy.data.materials["Material"].name = "XKAEFERX", "XLACKX"
        scene = open_with_names_replaced(folder / "größe.blend", {b"XKAEFERX": b"XK\xc4FERXX", b"XLACKX": b"XL\xc4CKX"})
        scene.lippmann.folder = str(folder)
        bpy.ops.render.render(animation=True)
        pictures = [tool.pictures(folder / "animation", number)[0] for number in (5, 6)]
        image = bpy.data.images.load(str(pictures[0]))
        self.assertEqual(tuple(image.size), (48, 64))
        self.assertNotEqual(pictures[0].read_bytes(), pictures[1].read_bytes())
        self.assertTrue((folder / "animation" / "video.mp4").is_file())
        document = gltf(folder)
        self.assertEqual((len(document["skins"]), [len(m["primitives"][0]["targets"]) for m in document["meshes"] if "targets" in m["primitives"][0]]), (1, [1]))
        joints = set(document["skins"][0]["joints"])
        targets = [channel["target"] for motion in document["animations"] for channel in motion["channels"]]
        self.assertTrue(any(target["path"] == "rotation" and target["node"] in joints for target in targets))
        self.assertTrue(any(target["path"] == "weights" for target in targets))
        said = " ".join(engine.last_warnings)
        # Blender 4 and later repair names that are not UTF-8 when they open a file.
        for words in (*(["no UTF-8"] if bpy.app.version < (4, 0, 0) else []), "guests.blend is missing", "Checker Texture", "display's lenses blur with depth"):
            self.assertIn(words, said)

    def test_denoise_is_on_until_switched_off(self):
        scene = new_scene(self.folder, "single", samples=4)
        pictures = []
        for denoise in (True, False):
            scene.lippmann.denoise = denoise
            self.assertEqual("none" in jobs.render_flags(scene, True), not denoise)
            bpy.ops.render.render()
            pictures.append((self.folder / "still" / "frame_0000.png").read_bytes())
        self.assertNotEqual(*pictures)

    def test_new_scenes_have_sixteen_denoised_samples(self):
        bpy.ops.wm.read_factory_settings()
        settings = bpy.context.scene.lippmann
        self.assertEqual((settings.samples, settings.denoise), (16, True))

    def test_native_frames_render_with_denoise_on(self):
        scene = new_scene(self.folder, "native", samples=2)
        (self.folder / "visual.json").write_text('{"pitch":52.3,"slope":-7.2,"center":0.37,"DPI":324,"screenW":60,"screenH":80,"viewCone":40}')
        scene.lippmann.calibration = str(self.folder / "visual.json")
        scene.render.resolution_x, scene.render.resolution_y = 60, 80
        bpy.ops.render.render()
        self.assertTrue((self.folder / "still" / "frame_0000.png").is_file())

    def test_the_camera_s_lens_and_shutter_blur_what_the_tool_renders(self):
        scene = new_scene(self.folder, "quilt", samples=2, size=(336, 336))
        camera, cube = scene.camera.data, bpy.data.objects["Cube"]
        scene.lippmann.extra = "--views 2x1"
        camera.lens, camera.dof.use_dof, camera.dof.aperture_fstop, camera.dof.focus_distance = 40.0, True, 0.5, 8.0
        frame.place(frame.add(bpy.context), scene.camera.matrix_world @ mathutils.Matrix.Translation((0.0, 0.0, -10.0)), 2.0)
        scene.render.use_motion_blur, scene.render.motion_blur_shutter = True, 0.25
        scene.frame_start, scene.frame_end = 1, 2
        for number in range(4):
            cube.location.x = number
            cube.keyframe_insert("location", frame=number)
        bpy.ops.render.render(animation=True)
        document = gltf(self.folder)
        moved = next(c for c in document["animations"][0]["channels"] if document["nodes"][c["target"]["node"]]["name"].startswith("Cube") and c["target"]["path"] == "translation")
        np.testing.assert_allclose(positions(self.folder, moved)[[0, -1], 0], (0.0, 3.0), atol=1e-5)  # x of the cube; motion blur needs keys before the first and after the last frame
        self.assertEqual([words for words in engine.last_warnings if "blur" in words.lower() or "depth of field" in words.lower()], [])
        job = tomllib.loads((self.folder / "animation" / "job.toml").read_text())
        portrait = next(one for one in displays.known() if one["name"] == "looking-glass-portrait")
        per_unit = portrait["size_mm"][1] / 2.0
        self.assertAlmostEqual(job["focal-plane"], 2.0 * per_unit, delta=1e-3 * per_unit)  # the camera focuses at 8 units; the display's plane is at 10 units
        # The aperture is f / N = 0.04 / 0.5 units. The viewing distance is 10 units, which converts units to mm.
        self.assertAlmostEqual(job["aperture"], 0.04 / 0.5 * portrait["viewing_distance_mm"] / 10.0, delta=1e-3)
        self.assertEqual(job["shutter"], 0.25)
        scene.render.motion_blur_shutter, scene.lippmann.resume = 1.5, False
        bpy.ops.render.render(animation=True)
        self.assertIn("The shutter is open for longer than a frame; a whole frame is blurred.", engine.last_warnings)
        self.assertEqual(tomllib.loads((self.folder / "animation" / "job.toml").read_text())["shutter"], 1)
        bpy.ops.render.render()
        self.assertIn("Motion blur is left out: a still is of one moment.", engine.last_warnings)

    def test_what_gltf_cannot_carry_of_materials_and_lights_is_said(self):
        new_scene(self.folder, "single")
        material = bpy.data.materials["Material"]
        self.assertEqual(losses.lost_of_material(material), [])
        tree = material.node_tree
        shader, output = tree.nodes["Principled BSDF"], tree.get_output_node("ALL")
        picture = tree.nodes.new("ShaderNodeTexImage")
        tree.links.new(picture.outputs["Color"], shader.inputs["Base Color"])
        tree.links.new(tree.nodes.new("ShaderNodeNormalMap").outputs["Normal"], shader.inputs["Normal"])
        self.assertEqual(losses.lost_of_material(material), [])
        tree.links.new(tree.nodes.new("ShaderNodeTexCoord").outputs["Object"], picture.inputs["Vector"])
        tree.links.new(tree.nodes.new("ShaderNodeTexNoise").outputs["Fac"], output.inputs["Displacement"])
        self.assertEqual(losses.lost_of_material(material), ["coordinates Object", "displacement"])
        tree.links.new(tree.nodes.new("ShaderNodeMixShader").outputs[0], output.inputs["Surface"])
        self.assertEqual(losses.lost_of_material(material), ["Mix Shader", "displacement"])
        light = bpy.data.lights["Light"]
        light.use_nodes = True
        self.assertFalse(losses.has_nodes_of_its_own(light))
        emission = light.node_tree.nodes["Emission"]
        light.node_tree.links.new(light.node_tree.nodes.new("ShaderNodeTexIES").outputs["Fac"], emission.inputs["Strength"])
        self.assertTrue(losses.has_nodes_of_its_own(light))
        self.assertFalse(losses.is_animated(light))
        light.keyframe_insert("energy", frame=1)
        self.assertTrue(losses.is_animated(light))

    def test_shaders_that_are_like_a_principled_one_arrive_as_that(self):
        scene = new_scene(self.folder, "single", samples=1)
        red, blue = (0.8, 0.1, 0.1, 1.0), (0.1, 0.2, 0.8, 1.0)
        made = []
        m = Material("diffuse")
        made.append(m.shows(m.node("ShaderNodeBsdfDiffuse", Color=red)))
        m = Material("glossy")
        made.append(m.shows(m.node("ShaderNodeBsdfGlossy", Color=blue, Roughness=0.3)))
        m = Material("glass")
        made.append(m.shows(m.node("ShaderNodeBsdfGlass", Color=WHITE, Roughness=0.0, IOR=1.33)))
        m = Material("veil")
        mixture = m.node("ShaderNodeMixShader", Fac=0.25)
        m.tree.links.new(m.node("ShaderNodeBsdfTransparent").outputs[0], mixture.inputs[1])
        m.tree.links.new(m.node("ShaderNodeBsdfDiffuse", Color=red).outputs[0], mixture.inputs[2])
        made.append(m.shows(mixture))
        m = Material("lamp")
        both = m.node("ShaderNodeAddShader")
        m.tree.links.new(m.node("ShaderNodeEmission", Color=blue, Strength=2.0).outputs[0], both.inputs[0])
        m.tree.links.new(m.node("ShaderNodeBsdfDiffuse", Color=red).outputs[0], both.inputs[1])
        made.append(m.shows(both))
        m = Material("lacquer")
        coat = m.feed(m.node("ShaderNodeFresnel", IOR=1.5), m.node("ShaderNodeMixShader"), "Fac")
        m.tree.links.new(m.node("ShaderNodeBsdfDiffuse", Color=red).outputs[0], coat.inputs[1])
        m.tree.links.new(m.node("ShaderNodeBsdfGlossy", Color=WHITE, Roughness=0.1).outputs[0], coat.inputs[2])
        made.append(m.shows(coat))
        m = Material("computed")
        half = m.node("ShaderNodeMixRGB", Fac=0.5, Color1=red, Color2=blue)
        made.append(m.shows(m.feed(half, m.node("ShaderNodeBsdfPrincipled", Roughness=0.7), "Base Color")))
        arrive = arrived(scene, self.folder, made)

        def factors(name):
            return arrive[name].get("pbrMetallicRoughness", {})

        def assert_colour(name, colour):
            for got, wanted in zip(factors(name)["baseColorFactor"], colour):
                self.assertAlmostEqual(got, wanted, places=5, msg=name)

        assert_colour("diffuse", red)
        self.assertEqual((factors("diffuse")["metallicFactor"], arrive["diffuse"]["extensions"]["KHR_materials_specular"]["specularFactor"]), (0, 0))
        assert_colour("glossy", blue)
        self.assertAlmostEqual(factors("glossy")["roughnessFactor"], 0.3, places=5)
        self.assertEqual(factors("glossy").get("metallicFactor", 1), 1)
        self.assertEqual(arrive["glass"]["extensions"]["KHR_materials_transmission"]["transmissionFactor"], 1)
        self.assertAlmostEqual(arrive["glass"]["extensions"]["KHR_materials_ior"]["ior"], 1.33, places=5)
        assert_colour("veil", (*red[:3], 0.25))
        self.assertEqual(arrive["veil"]["alphaMode"], "BLEND")
        assert_colour("lamp", red)
        shines = np.array(arrive["lamp"]["emissiveFactor"]) * arrive["lamp"]["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"]
        self.assertLess(np.abs(shines - 2.0 * np.array(blue[:3])).max(), 1e-5)
        assert_colour("lacquer", red)
        self.assertAlmostEqual(factors("lacquer")["roughnessFactor"], 0.1, places=5)
        self.assertNotIn("KHR_materials_specular", arrive["lacquer"].get("extensions", {}))  # absent: the reflectance is glTF's default, 0.04
        assert_colour("computed", 0.5 * (np.array(red) + blue))
        self.assertEqual(engine.last_warnings, [])

    def test_groups_are_taken_apart_and_what_nothing_is_like_is_said(self):
        scene = new_scene(self.folder, "single", samples=1)
        group = new_group("paint", "ShaderNodeTree", {"Paint": "NodeSocketColor"}, {"Surface": "NodeSocketShader"})
        begin, end, shader = (group.nodes.new(kind) for kind in ("NodeGroupInput", "NodeGroupOutput", "ShaderNodeBsdfPrincipled"))
        group.links.new(begin.outputs[0], shader.inputs["Base Color"])
        group.links.new(shader.outputs[0], end.inputs[0])
        shader.inputs["Roughness"].default_value = 0.35
        made = []
        for name, colour in (("red", (0.8, 0.1, 0.1, 1.0)), ("blue", (0.1, 0.1, 0.8, 1.0))):
            m = Material(name)
            painted = m.node("ShaderNodeGroup")
            painted.node_tree = group
            painted.inputs[0].default_value = colour
            made.append(m.shows(painted))
        m = Material("strange")
        made.append(m.shows(m.node("ShaderNodeBsdfHair")))
        m = Material("varied")
        mixture = m.feed(m.node("ShaderNodeTexNoise"), m.node("ShaderNodeMixShader"), "Fac")
        for index, kind in ((1, "ShaderNodeBsdfDiffuse"), (2, "ShaderNodeBsdfGlossy")):
            m.tree.links.new(m.node(kind).outputs[0], mixture.inputs[index])
        made.append(m.shows(mixture))
        arrive = arrived(scene, self.folder, made)
        for name, blue in (("red", 0.1), ("blue", 0.8)):
            self.assertAlmostEqual(arrive[name]["pbrMetallicRoughness"]["baseColorFactor"][2], blue, places=5)
            self.assertAlmostEqual(arrive[name]["pbrMetallicRoughness"]["roughnessFactor"], 0.35, places=5)
        said = " ".join(engine.last_warnings)
        self.assertIn("strange loses what glTF cannot carry: Hair BSDF", said)
        self.assertIn("varied arrives without a mixture that varies", said)
        self.assertEqual(len(engine.last_warnings), 2)

    def test_what_nodes_compute_arrives_as_pictures_the_same_in_every_export(self):
        scene = new_scene(self.folder, "single", samples=4)
        self.assertEqual(scene.lippmann.bake_size, 1024)
        scene.lippmann.bake_size = 128
        m = Material("wood")
        shader = m.node("ShaderNodeBsdfPrincipled")
        m.feed(m.node("ShaderNodeTexChecker", Color1=(0.9, 0.05, 0.05, 1.0), Color2=(0.05, 0.05, 0.9, 1.0), Scale=3.0), shader, "Base Color")
        m.feed(m.node("ShaderNodeTexNoise"), shader, "Roughness")
        bump = m.feed(m.node("ShaderNodeTexNoise", Scale=20.0), m.node("ShaderNodeBump"), "Height")
        m.feed(bump, shader, "Normal")
        cube = bpy.data.objects["Cube"]
        cube.material_slots[0].material = m.shows(shader)
        cube.data.materials.append(bpy.data.materials.new("plain"))
        cube.data.polygons[0].material_index = 1
        bpy.ops.render.render()
        first = (self.folder / "scene.glb").read_bytes()
        for file in ((self.folder / "scene.json"), *(self.folder / "baked").iterdir()):
            file.unlink()
        wood = next(one for one in gltf(self.folder)["materials"] if one["name"].startswith("wood"))
        places = {wood["pbrMetallicRoughness"]["baseColorTexture"].get("texCoord", 0), wood["pbrMetallicRoughness"]["metallicRoughnessTexture"].get("texCoord", 0),
                  wood["normalTexture"].get("texCoord", 0)}
        self.assertEqual(places, {1})  # UV layer 0 is the cube's own
        self.assertEqual([words for words in engine.last_warnings if "wood" in words],
                         ["The material wood arrives with pictures of 128 x 128 pixels in place of: Checker Texture, Noise Texture, Bump."])
        image = bpy.data.images.load(str(tool.pictures(self.folder / "still", 0)[0]))
        values = np.array(image.pixels[:]).reshape(-1, 4)
        red, blue = ((values[:, one] > 0.3) & (values[:, other] < 0.5 * values[:, one]) for one, other in ((0, 2), (2, 0)))
        self.assertGreater(min(red.sum(), blue.sum()), 50)
        bpy.ops.render.render()
        self.assertEqual((self.folder / "scene.glb").read_bytes(), first)
        self.assertEqual([layer.name for layer in cube.data.uv_layers], ["UVMap"])

    def test_what_is_copied_of_a_group_is_the_same(self):
        group = new_group("pattern", "ShaderNodeTree", {}, {"Colour": "NodeSocketColor"})
        ramp, curves, noise, end = (group.nodes.new(kind) for kind in ("ShaderNodeValToRGB", "ShaderNodeRGBCurve", "ShaderNodeTexNoise", "NodeGroupOutput"))
        ramp.color_ramp.interpolation = "CONSTANT"
        ramp.color_ramp.elements.new(0.4).color = (1.0, 0.0, 0.0, 1.0)
        curves.mapping.curves[3].points.new(0.5, 0.8)
        noise.texture_mapping.scale = (2.0, 3.0, 4.0)
        noise.inputs["Scale"].default_value = 7.0
        group.links.new(noise.outputs[0], ramp.inputs[0])
        group.links.new(ramp.outputs[0], curves.inputs["Color"])
        group.links.new(curves.outputs[0], end.inputs[0])
        m = Material("patterned")
        node = m.node("ShaderNodeGroup")
        node.node_tree = group
        m.shows(m.feed(node, m.node("ShaderNodeBsdfDiffuse"), "Color"))
        materials.take_groups_apart(m.tree)
        by_kind = {node.type: node for node in m.tree.nodes}
        self.assertNotIn("GROUP", by_kind)
        copied = by_kind["VALTORGB"].color_ramp
        self.assertEqual([(round(e.position, 3), tuple(e.color)) for e in copied.elements], [(round(e.position, 3), tuple(e.color)) for e in ramp.color_ramp.elements])
        self.assertEqual(copied.interpolation, "CONSTANT")
        self.assertEqual([tuple(p.location) for p in by_kind["CURVE_RGB"].mapping.curves[3].points], [tuple(p.location) for p in curves.mapping.curves[3].points])
        self.assertEqual(tuple(by_kind["TEX_NOISE"].texture_mapping.scale), (2.0, 3.0, 4.0))
        self.assertEqual(by_kind["TEX_NOISE"].inputs["Scale"].default_value, 7.0)
        self.assertEqual(by_kind["BSDF_DIFFUSE"].inputs["Color"].links[0].from_node.type, "CURVE_RGB")
        self.assertEqual(by_kind["CURVE_RGB"].inputs["Color"].links[0].from_node.type, "VALTORGB")

    def test_text_curves_and_what_geometry_nodes_make_arrive_once_each(self):
        scene = new_scene(self.folder, "single", samples=1)
        bpy.data.objects.remove(bpy.data.objects["Cube"])
        made = {"word": lambda: bpy.ops.object.text_add(), "ring": lambda: bpy.ops.curve.primitive_bezier_circle_add(),
                "ball": lambda: bpy.ops.surface.primitive_nurbs_surface_sphere_add(), "drop": lambda: bpy.ops.object.metaball_add()}
        paint = Material("paint")
        paint = paint.shows(paint.node("ShaderNodeBsdfDiffuse", Color=(0.8, 0.1, 0.1, 1.0)))
        for name, make in made.items():
            make()
            bpy.context.object.name = name
            bpy.context.object.data.materials.append(paint)
        bpy.data.objects["ring"].data.bevel_depth = 0.1
        self.add_sprinkled_plane()
        bpy.ops.render.render()
        document = gltf(self.folder)
        shapes = {}
        for node in document["nodes"]:
            if "mesh" in node:
                mesh = document["meshes"][node["mesh"]]
                faces = sum(document["accessors"][part["indices"]]["count"] // 3 for part in mesh["primitives"])
                shapes.setdefault(faces, []).append({document["materials"][part["material"]]["name"] for part in mesh["primitives"] if "material" in part})
        counts = sorted(len(alike) for alike in shapes.values())
        self.assertEqual(counts, [1, 1, 1, 1, 4], shapes)  # four instances of an icosahedron, one per corner of the plane
        self.assertEqual(len(shapes[20]), 4)
        self.assertEqual(sum(names == [{"paint"}] for names in shapes.values()), 4)
        self.assertEqual(engine.last_warnings, [])

    def add_sprinkled_plane(self):
        bpy.ops.mesh.primitive_plane_add()
        nodes = new_group("sprinkle", "GeometryNodeTree", {"Geometry": "NodeSocketGeometry"}, {"Geometry": "NodeSocketGeometry"})
        begin, end, points, ball = (nodes.nodes.new(kind) for kind in ("NodeGroupInput", "NodeGroupOutput", "GeometryNodeInstanceOnPoints", "GeometryNodeMeshIcoSphere"))
        nodes.links.new(begin.outputs[0], points.inputs["Points"])
        nodes.links.new(ball.outputs[0], points.inputs["Instance"])
        nodes.links.new(points.outputs[0], end.inputs[0])
        bpy.context.object.modifiers.new("sprinkle", "NODES").node_group = nodes

    def test_a_hidden_parent_of_a_figure_stays_hidden_in_animations(self):
        scene = new_scene(self.folder, "single", samples=1)
        scene.frame_start, scene.frame_end = 5, 6
        add_figure(scene)
        figure, cube = bpy.data.objects["Plane"], bpy.data.objects["Cube"]
        bpy.ops.object.text_add(location=(0.0, 0.0, 2.0))
        word = bpy.context.object
        figure.parent, cube.parent = cube, word
        cube.location.x = 0.5
        for hidden in (False, True):
            cube.hide_render = word.hide_render = hidden
            scene.lippmann.resume = False
            bpy.ops.render.render(animation=True)
            document = gltf(self.folder)
            shown = [node for node in document["nodes"] if "mesh" in node]
            self.assertEqual(sum("skin" in node for node in shown), 1)
            self.assertEqual(len(shown), 1 if hidden else 3, [node["name"] for node in shown])  # the plane, and unless hidden, the cube and the text
            self.assertEqual(engine.last_warnings, [])

    def test_simulations_play_up_to_the_frame_of_a_still(self):
        scene = new_scene(self.folder, "single")
        scene.frame_start = 1
        self.assertFalse(scene_export.simulates(scene))
        bpy.context.view_layer.objects.active = bpy.data.objects["Cube"]
        bpy.ops.rigidbody.object_add()
        scene_export.play_up_to(scene, 12)
        scene.frame_set(12)
        self.assertLess(bpy.data.objects["Cube"].evaluated_get(bpy.context.evaluated_depsgraph_get()).matrix_world.translation.z, -0.5)

    def test_a_sky_of_nodes_becomes_a_panorama(self):
        scene = new_scene(self.folder, "single", samples=1)
        tree = scene.world.node_tree
        sky = tree.nodes.new("ShaderNodeTexSky")
        tree.links.new(sky.outputs["Color"], tree.nodes["Background"].inputs["Color"])
        bpy.ops.render.render()
        self.assertTrue((self.folder / "world.exr").is_file())

    def test_area_lights_have_the_radiance_of_cycles_and_particles_and_bent_meshes_arrive(self):
        scene = new_scene(self.folder, "single", samples=1)
        light = bpy.data.lights.new("area", "AREA")
        light.energy, light.size = 100.0, 2.0
        scene.collection.objects.link(bpy.data.objects.new("area", light))
        cube = bpy.data.objects["Cube"]
        bpy.ops.mesh.primitive_plane_add(size=8.0)
        plane = bpy.context.object
        plane.modifiers.new("grown", "PARTICLE_SYSTEM")
        grown = plane.particle_systems[0].settings
        grown.type, grown.render_type, grown.instance_object, grown.count, grown.use_advanced_hair = "HAIR", "OBJECT", cube, 7, True
        bpy.ops.object.armature_add()
        bone = bpy.context.object.pose.bones[0]
        bone.rotation_mode, bone.rotation_euler = "XYZ", (1.0, 0.0, 0.0)
        bpy.ops.mesh.primitive_monkey_add()
        monkey = bpy.context.object
        monkey.modifiers.new("bent", "ARMATURE").object = bpy.data.objects["Armature"]
        monkey.vertex_groups.new(name="Bone").add(range(len(monkey.data.vertices)), 1.0, "REPLACE")
        bpy.ops.render.render()
        document = gltf(self.folder)
        strengths = [m["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] for m in document["materials"] if "emissiveFactor" in m]
        self.assertEqual(len(strengths), 1)
        self.assertAlmostEqual(strengths[0], 100.0 / (4.0 * 2.0 * 2.0), places=4)
        area = next(node for node in document["nodes"] if node["name"].startswith("area"))
        self.assertEqual(area["extras"], {"visible_to_camera": 0, "casts_shadow": 0})
        self.assertFalse(any("rea light" in warning for warning in engine.last_warnings), engine.last_warnings)
        self.assertEqual(len([n for n in document["nodes"] if "mesh" in n]), 1 + 7 + 1 + 1 + 1, [n["name"] for n in document["nodes"]])
        bent = next(mesh for mesh in document["meshes"] if mesh["name"].startswith("Suzanne"))
        bounds = document["accessors"][bent["primitives"][0]["attributes"]["POSITION"]]
        straight = [max(v.co[axis] for v in monkey.data.vertices) for axis in range(3)]
        self.assertAlmostEqual(bounds["max"][0], straight[0], places=3)  # the monkey bends about x, so its x does not change
        self.assertGreater(abs(bounds["max"][2] + min(v.co.y for v in monkey.data.vertices)), 0.1)  # glTF's z is Blender's -y

    def test_ray_visibility_arrives_and_what_of_it_is_lost_is_said(self):
        scene = new_scene(self.folder, "single", samples=1)
        cube = bpy.data.objects["Cube"]
        cube.visible_camera = False
        bpy.ops.mesh.primitive_monkey_add()
        monkey = bpy.context.object
        monkey.visible_shadow = monkey.visible_glossy = False
        bpy.ops.render.render()
        extras = {node["name"].split(".")[0]: node.get("extras") for node in gltf(self.folder)["nodes"]}
        self.assertEqual(extras["Suzanne"], {"casts_shadow": 0}, extras)
        self.assertEqual(extras["Cube"], {"visible_to_camera": 0}, extras)
        self.assertEqual([w for w in engine.last_warnings if "rays that surfaces scatter" in w], [f"{monkey.name} is hidden from some of the rays that surfaces scatter; they meet it all the same."])
        self.assertNotIn("casts_shadow", monkey.keys())

    def test_meshes_with_vertices_that_are_nowhere_lose_the_faces_at_them_which_is_said(self):
        scene = new_scene(self.folder, "single", samples=1)
        scene.frame_start, scene.frame_end = 5, 6
        add_figure(scene)
        bpy.data.objects["Plane"].data.shape_keys.key_blocks["raised"].data[0].co.z = 1.0
        figure, cube = bpy.data.objects["Plane"].data, bpy.data.objects["Cube"].data
        bpy.ops.mesh.primitive_ico_sphere_add()
        said = "{} has vertices whose coordinates are no numbers; the faces at them are left out."

        def faces():
            document = gltf(self.folder)
            return {mesh["name"].split(".")[0]: sum(document["accessors"][part["indices"]]["count"] // 3 for part in mesh["primitives"]) for mesh in document["meshes"]}

        bpy.ops.render.render()
        self.assertEqual((engine.last_warnings, faces()), ([], {"Cube": 12, "Plane": 2, "Icosphere": 80}))
        cube.vertices[0].co.x = cube.vertices[1].co.y = np.nan
        bpy.ops.render.render()
        self.assertEqual((engine.last_warnings, faces()), ([said.format("Cube")], {"Cube": 4, "Plane": 2, "Icosphere": 80}))
        self.assertEqual(len(cube.vertices), 8)
        bpy.ops.object.select_all(action="DESELECT")
        figure.vertices[0].co.z = np.nan
        bpy.ops.render.render(animation=True)
        self.assertEqual(sorted(engine.last_warnings), [said.format("Cube"), said.format("Plane")])
        self.assertNotIn("Plane", faces())

    def test_a_transparent_film_arrives_where_pictures_have_alpha_and_is_said_where_not(self):
        scene = new_scene(self.folder, "single", samples=1)
        scene.render.film_transparent, scene.render.image_settings.color_mode = True, "RGBA"
        bpy.ops.render.render(write_still=True)
        self.assertEqual(engine.last_warnings, [])
        for picture in (self.folder / "still" / "frame_0000.png", self.folder / "blender_.png"):
            image = bpy.data.images.load(str(picture))
            alpha = np.array(image.pixels[:]).reshape(80, 60, 4)[..., 3]
            self.assertEqual((alpha[0, 0], alpha[40, 30]), (0.0, 1.0), picture)
        scene.lippmann.output = "quilt"
        self.assertIn("--transparent", jobs.render_flags(scene, True))
        scene.lippmann.extra = "--transparent"
        self.assertEqual(jobs.render_flags(scene, True).count("--transparent"), 1)
        scene.lippmann.extra, scene.lippmann.video = "", True
        self.assertIn("--transparent", jobs.render_flags(scene, True))
        self.assertNotIn("--transparent", jobs.render_flags(scene, False))
        self.assertIn("videos have no alpha", film.lost_of_transparency(scene, False))
        scene.lippmann.output, scene.lippmann.video = "native", False
        (self.folder / "panel.toml").write_text('base = "looking-glass-portrait"\npixels = [48, 64]\n')
        scene.lippmann.calibration = str(self.folder / "panel.toml")
        scene.render.resolution_x, scene.render.resolution_y = 48, 64
        bpy.ops.render.render()
        self.assertEqual([words for words in engine.last_warnings if "Transparent" in words], ["Transparent is left out: native frames have no alpha."])

    def test_panoramic_cameras_and_stereoscopy_are_said_to_be_lost(self):
        scene = new_scene(self.folder, "single", samples=1)
        scene.camera.data.type, scene.render.use_multiview = "PANO", True
        bpy.ops.render.render()
        panoramic = "The camera is panoramic, which no display is; it is taken as an orthographic one. A light-field frame says what is shown."
        stereo = "Stereoscopy is left out: Blender's other views stay empty. The tool's pictures have the display's views."
        self.assertEqual(engine.last_warnings, [panoramic, stereo])
        bpy.ops.lippmann.place_at_focus()
        scene.render.use_multiview = False
        self.assertFalse(losses.is_panoramic(scene))

    def test_lamps_arrive_with_their_sizes(self):
        scene = new_scene(self.folder, "single", samples=1)
        for kind, sizes in (("POINT", {"shadow_soft_size": 0.5}), ("SPOT", {"shadow_soft_size": 0.25, "spot_blend": 0.75}), ("SUN", {"angle": 0.125})):
            light = bpy.data.lights.new(f"{kind} of mine", kind)
            for name, value in sizes.items():
                setattr(light, name, value)
            scene.collection.objects.link(bpy.data.objects.new(kind, light))
        bpy.ops.render.render()
        lights = {light["name"].split()[0]: light for light in gltf(self.folder)["extensions"]["KHR_lights_punctual"]["lights"] if "of mine" in light["name"]}
        self.assertEqual(lights["POINT"]["extras"], {"radius": 0.5})
        self.assertEqual(lights["SPOT"]["extras"], {"radius": 0.25, "blend": 0.75})
        self.assertEqual(lights["SUN"]["extras"], {"angle": 0.125})
        self.assertFalse(any("size" in warning for warning in engine.last_warnings), engine.last_warnings)
        self.assertNotIn("radius", bpy.data.lights["POINT of mine"])

    def test_a_lamp_s_light_profile_arrives_and_one_that_is_missing_is_said(self):
        scene = new_scene(self.folder, "single", samples=1)
        text = bpy.data.texts.new("profile")
        text.write("IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 3 1 1 2 0 0 0\n1 1 1\n0 45 90\n0\n800 400 0\n")
        for name, internal in (("measured", True), ("lost", False)):
            light = bpy.data.lights.new(name, "POINT")
            light.use_nodes, light.energy = True, 177.83
            node = light.node_tree.nodes.new("ShaderNodeTexIES")
            light.node_tree.links.new(node.outputs["Fac"], light.node_tree.nodes["Emission"].inputs["Strength"])
            if internal:
                node.ies, node.inputs["Strength"].default_value = text, 2.0
            else:
                node.mode, node.filepath = "EXTERNAL", "/nowhere/lamp.ies"
            scene.collection.objects.link(bpy.data.objects.new(name, light))
        bpy.ops.render.render()
        document = gltf(self.folder)
        lamp, = [node["extensions"] for node in document["nodes"] if "EXT_lights_ies" in node.get("extensions", {})]
        self.assertNotIn("KHR_lights_punctual", lamp)
        self.assertAlmostEqual(lamp["EXT_lights_ies"]["multiplier"], 2.0, places=4)
        self.assertTrue(document["extensions"]["EXT_lights_ies"]["lights"][0]["name"].startswith("measured"))
        self.assertFalse(any("ies" in light["extras"] for light in document["extensions"]["KHR_lights_punctual"]["lights"]))
        said = " ".join(engine.last_warnings)
        self.assertIn("profile of lost is missing", said)
        self.assertNotIn("measured", said)
        self.assertTrue(tool.pictures(self.folder / "still", 0))

    def test_a_tool_that_is_not_there_is_said(self):
        with self.assertRaisesRegex(tool.ToolError, "not at /nowhere/lippmann"):
            tool.find("/nowhere/lippmann")

    def test_what_a_child_says_last_is_told_without_its_prefix(self):
        self.assertEqual(tool.last_message("Traceback\nerror: The scene shows nothing.\nquit"), "The scene shows nothing.")
        self.assertEqual(tool.last_message('{"frame":1}\nlippmann: --spp: is 0; accepted: 1\n'), "--spp: is 0; accepted: 1")
        self.assertIn("without a word", tool.last_message(""))

    def test_a_stopped_child_leaves_no_process(self):
        child = tool.Child(["sleep", "60"], self.folder / "log")
        child.stop()
        self.assertFalse(child.running())


class Fake:
    """Stands in for objects that only later Blender versions have."""

    def __init__(self, **attributes):
        self.__dict__.update(attributes)


class LaterVersions(unittest.TestCase):
    def test_curves_are_those_of_layered_actions_where_actions_have_none(self):
        bag = Fake(fcurves=["x", "y"])
        strip = Fake(channelbag=lambda slot: bag if slot == "mine" else None)
        layered = Fake(layers=[Fake(strips=[strip])])
        self.assertEqual(versions.curves_of(Fake(action=layered, action_slot="mine")), ["x", "y"])
        self.assertEqual(versions.curves_of(Fake(action=layered, action_slot="other")), [])
        self.assertEqual(versions.curves_of(Fake(action=Fake(fcurves=["z"]))), ["z"])

    def test_the_exporter_is_asked_only_for_what_it_knows(self):
        later = {"export_animation_mode", "export_anim_slide_to_zero", "export_animations", "export_vertex_color"}
        self.assertEqual(scene_export.gltf_options(False, False, later),
                         {"export_animation_mode": "ACTIVE_ACTIONS", "export_anim_slide_to_zero": False, "export_animations": True})

    def test_emission_has_either_name(self):
        self.assertEqual(versions.name_among({"Emission": 1, "Emission Strength": 1}, "Emission"), "Emission")
        self.assertEqual(versions.name_among({"Emission Color": 1, "Emission Strength": 1}, "Emission"), "Emission Color")

    def test_the_overlay_s_shader_has_either_name(self):
        for name in ("UNIFORM_COLOR", "3D_UNIFORM_COLOR"):
            def built_in(wanted, known=name):
                if wanted != known:
                    raise ValueError(wanted)
                return known
            with unittest.mock.patch.object(versions, "gpu", types.SimpleNamespace(shader=types.SimpleNamespace(from_builtin=built_in))):
                self.assertEqual(versions.plain_shader(), name)

    def test_compositing_is_found_with_or_without_a_group_of_its_own(self):
        self.assertTrue(versions.composites(Fake(compositing_node_group=Fake())))
        self.assertFalse(versions.composites(Fake(compositing_node_group=None, use_nodes=True)))
        self.assertTrue(versions.composites(Fake(use_nodes=True)))

    def test_the_extension_s_manifest_agrees_with_the_add_on(self):
        manifest = tomllib.loads((pathlib.Path(lippmann.__file__).parent / "blender_manifest.toml").read_text())
        self.assertEqual(manifest["version"], ".".join(map(str, lippmann.bl_info["version"])))
        self.assertEqual((manifest["id"], manifest["name"], manifest["type"]), ("lippmann", lippmann.bl_info["name"], "add-on"))
        for text in (manifest["tagline"], *manifest["permissions"].values()):  # Blender refuses longer texts and full stops
            self.assertLessEqual(len(text), 64)
            self.assertFalse(text.endswith("."))


done = unittest.main(argv=["addon_test"], exit=False, verbosity=2)
sys.exit(0 if done.result.wasSuccessful() else 1)
