"""Tests skins and morph targets. The expected positions of vertices are computed by hand."""

import json

import numpy as np

import lippmann
from support import Case

QUAD = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]
FACES = [[0, 1, 2], [0, 2, 3]]
HALF_TURN = [0, 0, 1, 0]  # quaternion of a half turn about z


def bounds(scene, frame=0):
    return scene.bounds(frame).tolist()


class Deformation(Case):
    def test_morph_targets_are_added_by_their_weights(self):
        scene = lippmann.Scene(frames=2)
        targets = [[[4, 0, 0]] * 4, [[0, 0, 0], [0, 0, 0], [0, 2, 0], [0, 2, 0]]]
        mesh = scene.add_mesh(QUAD, FACES, targets=targets, weights=[0.5, 0])
        self.assertEqual(bounds(scene), [[1, -1, 0], [3, 1, 0]])
        mesh.animate(weights=[[0, 0], [0.25, 1]])
        self.assertEqual(bounds(scene, 0), [[-1, -1, 0], [1, 1, 0]])
        self.assertEqual(bounds(scene, 1), [[0, -1, 0], [2, 3, 0]])

    def test_target_normals_change_the_shading(self):
        def brightness(**more):
            scene = lippmann.Scene()
            white = lippmann.Material((1, 1, 1), roughness=1)
            scene.add_mesh(QUAD, FACES, normals=[[0, 0, 1]] * 4, targets=np.zeros((1, 4, 3)), material=white, **more)
            scene.add_light("directional", direction=(0, 0, -1))
            scene.place_display(height=2, viewing_distance=20)
            grid = lippmann.camera_grid(1, 1, (8, 8))
            return float(lippmann.render(scene, grid, light="none", integrator="path", spp=1, max_depth=2).views.mean())

        # The vertex normal (0, 0, 1) plus the morph target (0, 2, 0) is (0, 2, 1). The cosine between this normal and
        # the direction of the lamp, (0, 0, 1), is 1 / sqrt(5).
        ratio = brightness(target_normals=[[[0, 2, 0]] * 4], weights=[1]) / brightness()
        self.assertAlmostEqual(ratio, 5**-0.5, delta=0.05)

    def test_a_skin_follows_its_joints(self):
        scene = lippmann.Scene(frames=2)
        hip = scene.add_joint((10, 0, 0), name="hip")
        knee = scene.add_joint((0, 1, 0), parent=hip)
        skin = lippmann.Skin([hip, knee], [[0], [0], [1], [1]], np.full((4, 1), 3))
        scene.add_mesh(QUAD, FACES, translation=(10, 0, 0), skin=skin)
        self.assertEqual(bounds(scene), [[9, -1, 0], [11, 1, 0]])
        knee.animate(translation=[[0, 1, 0], [0, 4, 0]])
        self.assertEqual(bounds(scene, 1), [[9, -1, 0], [11, 4, 0]])
        hip.animate(rotation=[[0, 0, 0, 1], HALF_TURN])
        # the hip rotates by 180 degrees about (10, 0, 0)
        np.testing.assert_allclose(bounds(scene, 1), [[9, -4, 0], [11, 1, 0]], atol=1e-5)

    def test_a_vertex_blends_two_joints(self):
        scene = lippmann.Scene(frames=2)
        still, moved = scene.add_joint(), scene.add_joint()
        skin = lippmann.Skin([still, moved], np.tile([0, 1], (4, 1)), np.tile([3, 1], (4, 1)))
        scene.add_mesh(QUAD, FACES, skin=skin)
        moved.animate(translation=[[0, 0, 0], [8, 0, 0]])
        self.assertEqual(bounds(scene, 1), [[1, -1, 0], [3, 1, 0]])

    def test_errors_leave_the_scene_unchanged(self):
        scene, other = lippmann.Scene(frames=2), lippmann.Scene()
        joint, strange = scene.add_joint(), other.add_joint()

        def skin(joints=(joint,), indices=np.zeros((4, 1), int), weights=np.ones((4, 1))):
            return lippmann.Skin(joints, indices, weights)

        for where, named in (
            ("targets", {"targets": np.zeros((1, 3, 3))}),
            ("targets", {"targets": np.full((1, 4, 3), np.nan)}),
            ("weights", {"targets": np.zeros((2, 4, 3)), "weights": [1]}),
            ("weights", {"weights": [1]}),
            ("target_normals", {"targets": np.zeros((1, 4, 3)), "target_normals": np.zeros((1, 4, 3))}),
            ("skin", {"skin": "bones"}),
            ("skin.joints", {"skin": skin(joints=[])}),
            ("skin.joints", {"skin": skin(joints=[strange])}),
            ("skin.indices", {"skin": skin(indices=np.ones((4, 1), int))}),
            ("skin.indices", {"skin": skin(indices=np.zeros((3, 1), int))}),
            ("skin.weights", {"skin": skin(weights=np.zeros((4, 1)))}),
            ("skin.weights", {"skin": skin(weights=np.ones((3, 1)))}),
        ):
            with self.subTest(where=where, named=named):
                self.assertWrong(where, scene.add_mesh, QUAD, FACES, **named)
        self.assertEqual(scene.objects, ())
        self.assertWrong("parent", scene.add_joint, parent=strange)
        self.assertWrong("scale", scene.add_joint, scale=(1, 0, 1))
        carried = scene.add_mesh(QUAD, FACES, skin=skin())
        self.assertWrong("translation", carried.animate, translation=np.zeros((2, 3)))
        self.assertWrong("weights", carried.animate, weights=np.zeros((2, 1)))

    def test_a_file_with_skin_and_target_moves(self):
        path = self.folder / "flag.gltf"
        path.write_text(json.dumps(moving_quad(self.folder)))
        scene = lippmann.load(path, frames_per_second=2)
        self.assertEqual(bounds(scene, 0), [[-1, -1, 0], [1, 1, 0]])
        # After half of the animation, the joint has moved by 3 / 2 to the right, and the morph target by 2 / 2 upwards.
        self.assertEqual(bounds(scene, 1), [[0.5, 0, 0], [2.5, 2, 0]])


def moving_quad(folder):
    """Writes a glTF file of a quad with one joint and one morph target. Both move from second 0 to second 1."""
    parts = [
        (np.array(QUAD, "<f4"), "VEC3", 5126),
        (np.array(FACES, "<u2").ravel(), "SCALAR", 5123),
        (np.full((4, 3), (0, 2, 0), "<f4"), "VEC3", 5126),
        (np.zeros((4, 4), "u1"), "VEC4", 5121),
        (np.full((4, 4), (1, 0, 0, 0), "<f4"), "VEC4", 5126),
        (np.array([0, 1], "<f4"), "SCALAR", 5126),
        (np.array([[0, 0, 0], [3, 0, 0]], "<f4"), "VEC3", 5126),
        (np.array([0, 1], "<f4"), "SCALAR", 5126),
    ]
    data, views, accessors = b"", [], []
    for values, kind, component in parts:
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": values.nbytes})
        rows = np.atleast_2d(values.T).T
        limits = {"min": rows.min(axis=0).tolist(), "max": rows.max(axis=0).tolist()}
        accessors.append(
            {"bufferView": len(views) - 1, "componentType": component, "count": len(values), "type": kind, **limits}
        )
        data += values.tobytes() + b"\0" * (-values.nbytes % 4)
    (folder / "flag.bin").write_bytes(data)
    attributes = {"POSITION": 0, "JOINTS_0": 3, "WEIGHTS_0": 4}
    return {
        "asset": {"version": "2.0"},
        "buffers": [{"uri": "flag.bin", "byteLength": len(data)}],
        "bufferViews": views,
        "accessors": accessors,
        "meshes": [{"primitives": [{"attributes": attributes, "indices": 1, "targets": [{"POSITION": 2}]}], "weights": [0]}],
        "skins": [{"joints": [1]}],
        "nodes": [{"mesh": 0, "skin": 0}, {"name": "joint"}],
        "scenes": [{"nodes": [0, 1]}],
        "scene": 0,
        "animations": [
            {
                "samplers": [{"input": 5, "output": 6}, {"input": 5, "output": 7}],
                "channels": [
                    {"sampler": 0, "target": {"node": 1, "path": "translation"}},
                    {"sampler": 1, "target": {"node": 0, "path": "weights"}},
                ],
            }
        ],
    }
