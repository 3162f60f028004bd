"""Tests of bench/cycles/gltf_in_blender.py, which imports glTF for the reference renders of bench/gltf_fidelity.py. Run with:
blender -b --factory-startup --python peer_test.py"""

import math
import pathlib
import sys
import tempfile
import unittest

import bpy
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "bench" / "cycles"))
import fixtures  # noqa: E402
import gltf_in_blender  # noqa: E402


def scene():
    """Returns three quads with two materials. The image names are in reverse order, so that sorting by name would swap the
    textures."""
    g = fixtures.Gltf()
    red, blue = (g.texture(2, lambda x, y, c=c: (*c, 255)) for c in ((255, 0, 0), (0, 0, 255)))
    g.doc["images"][0]["name"], g.doc["images"][1]["name"] = "z", "a"
    g.material((1, 1, 1), baseColorTexture=red, name="same name")
    g.material((1, 1, 1), baseColorTexture=blue, name="same name")
    for material in (0, 1, 1):
        g.quad(material, (0, 0, 0), (1, 0, 0), (0, 1, 0))
    colors = g._accessor([(0.25, 0.5, 1.0)] * 4, "VEC3")
    g.doc["meshes"][2]["primitives"][0]["attributes"]["COLOR_0"] = colors
    return g


def surface_of(thing):
    return thing.data.materials[0].node_tree


def reaches(node, kind):
    found, todo = set(), [node]
    while todo:
        at = todo.pop()
        if at in found:
            continue
        found.add(at)
        todo += [link.from_node for socket in at.inputs for link in socket.links]
    return [n for n in found if n.type == kind]


class Peer(unittest.TestCase):
    def load(self, g, **asset):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "scene.gltf"
            g.doc["asset"].update(asset)
            g.write(file)
            gltf_in_blender.load(str(file))

    def output(self, thing):
        return next(n for n in surface_of(thing).nodes if n.type == "OUTPUT_MATERIAL")

    def meshes(self):
        return sorted((o for o in bpy.data.objects if o.type == "MESH"), key=lambda o: o.data.name)

    def test_every_material_has_its_own_picture(self):
        self.load(scene())
        for thing, expected in zip(self.meshes(), ((1, 0, 0), (0, 0, 1), (0, 0, 1))):
            picture, = reaches(self.output(thing), "TEX_IMAGE")
            self.assertEqual(tuple(picture.image.pixels)[:3], expected)

    def test_vertex_colours_reach_the_surface_of_the_mesh_that_has_them(self):
        self.load(scene())
        self.assertEqual([len(reaches(self.output(thing), "VERTEX_COLOR")) for thing in self.meshes()], [0, 0, 1])

    def test_the_importers_surface_is_replaced(self):
        self.load(scene())
        for thing in self.meshes():
            self.assertTrue(reaches(self.output(thing), "BSDF_DIFFUSE"))

    def test_lamps_of_files_that_blender_wrote_are_as_bright_as_there(self):
        for generator, watts in (("Khronos glTF Blender I/O v3.4.50", 4 * math.pi), ("other", 683 * 4 * math.pi)):
            g = scene()
            g.light((0, 1, 0), type="point", intensity=683.0, name="lamp")
            self.load(g, generator=generator)
            self.assertAlmostEqual(bpy.data.lights[0].energy / watts, 1.0, places=5)

    def test_absorption_is_beers(self):
        g = scene()
        g.doc["materials"][0]["extensions"] = {"KHR_materials_transmission": {"transmissionFactor": 1.0}, "KHR_materials_volume": {
            "thicknessFactor": 1.0, "attenuationDistance": 2.0, "attenuationColor": [0.25, 0.5, 1.0]}}
        self.load(g)
        node, = reaches(self.output(self.meshes()[0]), "VOLUME_ABSORPTION")
        density = node.inputs["Density"].default_value
        absorbed = [density * (1 - c) for c in tuple(node.inputs["Color"].default_value)[:3]]
        np.testing.assert_allclose(np.exp(-2.0 * np.array(absorbed)), (0.25, 0.5, 1.0), atol=1e-5)

    def test_masks_cut_at_their_own_cutoff(self):
        g = scene()
        g.doc["materials"][0].update(alphaMode="MASK", alphaCutoff=0.3)
        self.load(g)
        cuts = [n for n in reaches(self.output(self.meshes()[0]), "MATH") if n.operation == "LESS_THAN"]
        self.assertEqual({round(n.inputs[1].default_value, 6) for n in cuts}, {0.3})  # Blender 4 and later import a second, equal node


done = unittest.main(argv=["peer_test"], exit=False, verbosity=2)
sys.exit(0 if done.result.wasSuccessful() else 1)
