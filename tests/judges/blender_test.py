"""Tests cameras of the format nerf with Blender: Cycles renders the scene through the cameras of transforms.json, and each object is
registered with our picture of it. Blender runs this file."""

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

MAX_SHIFT_PX = 0.1  # found: at most 0.023
# Three boxes without a common symmetry: middle and size in the world of the OBJ file. They shine red, green and blue.
BOXES = [((0, 0, 0), (1, 0.6, 0.4)), ((0.7, 0.5, 0.3), (0.3, 0.3, 0.9)), ((-0.6, 0.3, -0.5), (0.25, 1.1, 0.3))]
FACES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def corners(middle, size):
    return [tuple(middle[i] + size[i] * (corner >> i & 1) - size[i] / 2 for i in range(3)) for corner in range(8)]


def light_of(box):
    return [float(channel == box) for channel in range(3)]


def write_obj(folder):
    materials, lines = [], ["mtllib boxes.mtl"]
    for i, box in enumerate(BOXES):
        materials += [f"newmtl m{i}", "Kd 0 0 0", "Ke {} {} {}".format(*light_of(i)), "illum 0"]
        lines += ["v {} {} {}".format(*corner) for corner in corners(*box)] + [f"usemtl m{i}"]
        lines += ["f " + " ".join(str(8 * i + corner + 1) for corner in face) for face in FACES]
    (folder / "boxes.mtl").write_text("\n".join(materials) + "\n")
    (folder / "boxes.obj").write_text("\n".join(lines) + "\n")


def make_blender_scene():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    for i, box in enumerate(BOXES):
        mesh = bpy.data.meshes.new(f"box {i}")
        mesh.from_pydata(corners(*box), [], FACES)
        material = bpy.data.materials.new(f"light {i}")
        material.use_nodes = True
        nodes = material.node_tree.nodes
        nodes.clear()
        emission, output = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeOutputMaterial")
        emission.inputs["Color"].default_value = (*light_of(i), 1)
        material.node_tree.links.new(emission.outputs[0], output.inputs["Surface"])
        mesh.materials.append(material)
        scene.collection.objects.link(bpy.data.objects.new(f"box {i}", mesh))
    scene.render.engine = "CYCLES"
    scene.cycles.samples = 32
    scene.cycles.use_denoising = False
    scene.render.image_settings.file_format = "OPEN_EXR"
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(camera)
    scene.camera = camera


def read_linear(path):
    """Returns an array (height, width, 3) of linear values, the top row first."""
    image = bpy.data.images.load(str(path))
    width, height = image.size
    pixels = np.array(image.pixels).reshape(height, width, 4)[::-1, :, :3]
    if not image.is_float:
        pixels = np.where(pixels > 0.04045, ((pixels + 0.055) / 1.055) ** 2.4, pixels / 12.92)
    bpy.data.images.remove(image)
    return pixels


def rendered_by_blender(intrinsics, matrix, path):
    width, height = intrinsics["w"], intrinsics["h"]
    scene, camera = bpy.context.scene, bpy.context.scene.camera
    scene.render.resolution_x, scene.render.resolution_y = width, height
    camera.matrix_world = mathutils.Matrix(matrix)
    camera.data.sensor_fit = "HORIZONTAL"
    camera.data.lens = camera.data.sensor_width * intrinsics["fl_x"] / width
    camera.data.shift_x = 0.5 - intrinsics["cx"] / width
    camera.data.shift_y = (intrinsics["cy"] - height / 2) / width
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    return read_linear(path)


def shift_px(ours, theirs):
    """Returns the length of the shift between two pictures, by one step of Lucas and Kanade."""
    y, x = np.gradient((ours + theirs) / 2)
    slopes = np.stack([x.ravel(), y.ravel()], 1)
    return np.hypot(*np.linalg.lstsq(slopes, (ours - theirs).ravel(), rcond=None)[0])


class Cameras(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        write_obj(cls.folder)
        words = "render boxes.obj --cameras sphere:5 --size 160x120 --spp 32 --environment none --to nerf -q -o set"
        for command in (words, "convert set cropped --crop 90x80+45+5 -q --to nerf"):
            subprocess.run([os.environ["LIPPMANN_TOOL"], *command.split()], cwd=cls.folder, check=True)
        make_blender_scene()

    def shifts(self, name, **changes):
        """Returns the shift of each box in each view. `changes` are added to the intrinsics of the file."""
        transforms = json.loads((self.folder / name / "transforms.json").read_text())
        found = []
        for frame in transforms["frames"]:
            intrinsics = {key: frame.get(key, transforms.get(key)) for key in ("w", "h", "fl_x", "cx", "cy")}
            for key, change in changes.items():
                intrinsics[key] += change
            ours = read_linear(self.folder / name / frame["file_path"])
            theirs = rendered_by_blender(intrinsics, frame["transform_matrix"], self.folder / "cycles.exr")
            self.assertEqual(ours.shape, theirs.shape)
            for channel in range(3):
                if theirs[..., channel].sum() > 100:  # pixels
                    found.append(shift_px(ours[..., channel], theirs[..., channel]))
        return found

    def expect_registered(self, name):
        shifts = self.shifts(name)
        self.assertGreater(len(shifts), 7)
        print(f"{name}: {len(shifts)} boxes registered, shifts up to {max(shifts):.3f} px")
        self.assertLess(max(shifts), MAX_SHIFT_PX)

    def test_cameras_around_the_scene_agree(self):
        self.expect_registered("set")

    def test_cropped_cameras_agree(self):
        self.expect_registered("cropped")

    def test_another_principal_point_is_found(self):
        for key in ("cx", "cy"):
            self.assertGreater(min(self.shifts("set", **{key: 1})), 5 * MAX_SHIFT_PX)


done = unittest.main(argv=["blender_test"], exit=False, verbosity=2)
sys.exit(0 if done.result.wasSuccessful() else 1)
