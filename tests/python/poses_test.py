"""Tests cameras of any pose: light fields of arrays, the formats nerf, colmap and llff, and cameras around a scene."""

import copy
import json
import pickle

import numpy as np

import lippmann
from support import Case, small_grid, tool

SIZE = (24, 32)


def turned(angle, axis):
    """Returns the rotation (3, 3) by an angle about an axis, by the formula of Rodrigues."""
    x, y, z = np.asarray(axis) / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def posed_field(principal=(16.0, 12.0), count=4, depth=True):
    """Returns views of cameras with different rotations and positions. A wall is 2 m from each camera."""
    matrices = np.tile(np.eye(4), (1, count, 1, 1))
    for i in range(count):
        matrices[0, i, :3, :3] = turned(0.4 * i, (1, 2 - i, 0.5))
        matrices[0, i, :3, 3] = (100.25 * i, -30 + i, 1000 / 3)
    intrinsics = np.tile([40.5, 40.5, *principal], (1, count, 1))
    views = np.random.default_rng(3).integers(0, 256, (1, count, *SIZE, 3), dtype=np.uint8)
    z = np.full((1, count, *SIZE), -2000, np.float32) if depth else None
    return lippmann.LightField(views, z, world_from_camera=matrices, intrinsics_px=intrinsics), matrices, intrinsics


class Poses(Case):
    def test_poses_of_arrays_are_kept(self):
        field, matrices, intrinsics = posed_field()
        for one in (field, copy.deepcopy(field), pickle.loads(pickle.dumps(field))):
            np.testing.assert_allclose(one.world_from_camera, matrices, atol=1e-12)
            np.testing.assert_array_equal(one.intrinsics_px, intrinsics)
        self.assertFalse(hasattr(field, "eyes_mm"))
        self.assertIn("do not share", self.assertWrong("cameras", lambda: field.eyes_mm).problem)

    def test_files_keep_poses(self):
        for name in ("nerf", "colmap", "llff"):
            with self.subTest(name):
                field, matrices, intrinsics = posed_field((16.0, 12.0) if name == "llff" else (15.25, 12.5))
                field.save(self.folder / name, name)
                again = lippmann.open(self.folder / name)
                self.assertSame(again.views, field.views)
                np.testing.assert_allclose(again.world_from_camera, matrices, atol=1e-6)
                np.testing.assert_allclose(again.intrinsics_px, intrinsics, atol=1e-6)
                if name == "nerf":
                    np.testing.assert_allclose(again.depth, field.depth, rtol=1e-6)

    def test_files_keep_poses_of_grids(self):
        field = lippmann.render("room", small_grid(2, 3, SIZE, baseline_mm=7), layers=["depth"])
        for name in ("nerf", "colmap"):
            with self.subTest(name):
                field.save(self.folder / name, name)
                again = lippmann.open(self.folder / name)
                np.testing.assert_allclose(again.world_from_camera[..., :3, 3] - again.world_from_camera[0, 0, :3, 3],
                                           field.world_from_camera[..., :3, 3] - field.world_from_camera[0, 0, :3, 3], atol=1e-6)
                np.testing.assert_allclose(again.world_from_camera, field.world_from_camera, atol=1e-4)
                np.testing.assert_allclose(again.intrinsics_px, field.intrinsics_px, atol=1e-4)

    def test_the_file_has_the_documented_axes(self):
        """The first camera is at x = 1 m and looks in the direction -x. Its right is the world's -z."""
        matrix = np.array([[0, 0, 1, 1000], [0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 0, 1.0]])
        views = np.zeros((1, 2, *SIZE, 3), np.uint8)
        matrices, intrinsics = np.tile(matrix, (1, 2, 1, 1)), np.tile([40.0, 40, 16, 12], (1, 2, 1))
        matrices[0, 1, 0, 3] = 2000
        field = lippmann.LightField(views, world_from_camera=matrices, intrinsics_px=intrinsics)
        field.save(self.folder / "nerf", "nerf")
        written = json.loads((self.folder / "nerf/transforms.json").read_text())
        expected = matrix.copy()
        expected[0, 3] = 1  # metres
        np.testing.assert_allclose(written["frames"][0]["transform_matrix"], expected, atol=1e-12)
        seen = np.linalg.inv(field.world_from_camera[0, 0]) @ (0, 100, -250, 1)  # 1 m ahead, 250 mm at the right, 100 mm up
        fx, fy, cx, cy = field.intrinsics_px[0, 0]
        np.testing.assert_allclose((cx - fx * seen[0] / seen[2], cy + fy * seen[1] / seen[2]), (26, 8), atol=1e-9)

    def test_invalid_poses_are_named(self):
        field, matrices, intrinsics = posed_field(depth=False)

        def made(**changed):
            arguments = {"world_from_camera": matrices, "intrinsics_px": intrinsics, **changed}
            return lippmann.LightField(field.views, **arguments)

        mirrored, sheared, tilted, nan, flat = (matrices.copy() for _ in range(5))
        mirrored[0, 1, :3, 0] *= -1
        sheared[0, 2, 0, 1] += 0.1
        tilted[0, 2, 3, 0] = 1
        nan[0, 0, 0, 0] = np.nan
        self.assertIn("left-handed", self.assertWrong("world_from_camera: (0, 1)", made, world_from_camera=mirrored).problem)
        self.assertWrong("world_from_camera: (0, 2)", made, world_from_camera=sheared)
        self.assertWrong("world_from_camera", made, world_from_camera=tilted)
        self.assertWrong("world_from_camera", made, world_from_camera=nan)
        self.assertWrong("world_from_camera", made, world_from_camera=flat[0])
        self.assertWrong("world_from_camera", made, world_from_camera=None)
        self.assertWrong("intrinsics_px", made, intrinsics_px=-intrinsics)
        self.assertWrong("intrinsics_px", made, intrinsics_px=None)
        self.assertWrong("world_from_camera", made, distance_mm=3, baseline_mm=1, pixel_mm=1)


class CameraSets(Case):
    def frames(self, **options):
        view = lippmann.single_view(SIZE, pixel_mm=64 / SIZE[1])
        return lippmann.frames("teapot", view, cameras="sphere:5", seed=3, layers=["depth"], **options)

    def test_frames_equal_the_tools_data_set(self):
        tool("render", "teapot", "--cameras", "sphere:5", "--size", "32x24", "--seed", "3", "-o", self.folder / "tool", "-q")
        written = lippmann.open(self.folder / "tool")
        animation = self.frames()
        self.assertEqual(len(animation), 5)
        for frame, field in enumerate(animation):
            self.assertSame(lippmann.to_codes(field.views[0, 0]), written[0, frame])
            np.testing.assert_allclose(field.world_from_camera[0, 0], written.world_from_camera[0, frame], atol=1e-6)
            np.testing.assert_allclose(field.intrinsics_px[0, 0], written.intrinsics_px[0, frame], atol=1e-6)
            np.testing.assert_allclose(field.depth[0, 0], written.depth[0, frame], rtol=1e-6)
        tests = json.loads((self.folder / "tool/transforms.json").read_text())["test_filenames"]
        self.assertEqual([f"images/{frame:03}.png" for frame in animation.test_frames], tests)

    def test_cameras_look_at_one_point_from_one_distance(self):
        poses = np.array([field.world_from_camera[0, 0] for field in self.frames()])
        positions, backwards = poses[:, :3, 3], poses[:, :3, 2]
        # `middle` is the point with the smallest sum of squared distances from the cameras' axes.
        across = np.eye(3) - backwards[:, :, None] * backwards[:, None, :]
        middle = np.linalg.solve(across.sum(axis=0), (across @ positions[..., None]).sum(axis=0)[:, 0])
        distances = np.linalg.norm(positions - middle, axis=1)
        np.testing.assert_allclose(positions, middle + distances[0] * backwards, atol=1e-4 * distances[0])
        self.assertGreater(np.ptp(positions[:, 1]), distances[0])  # some cameras are above the middle, some below

    def test_the_seed_chooses_test_frames(self):
        of_seeds = {lippmann.frames("teapot", cameras="circle:16", seed=seed).test_frames for seed in range(6)}
        self.assertTrue(all(len(frames) == 2 for frames in of_seeds))
        self.assertGreater(len(of_seeds), 1)
        animation = self.frames()
        (test,) = animation.test_frames
        self.assertEqual(animation[test : test + 1].test_frames, (test,))
        self.assertEqual(animation[test + 1 :].test_frames, ())
        self.assertEqual(pickle.loads(pickle.dumps(animation)).test_frames, (test,))
        self.assertEqual(lippmann.frames("teapot", small_grid()).test_frames, ())

    def test_views_become_one_light_field(self):
        fields = list(self.frames())
        parts = [np.concatenate([getattr(field, name) for field in fields], axis=1)
                 for name in ("views", "depth", "world_from_camera", "intrinsics_px")]
        whole = lippmann.LightField(*parts[:2], world_from_camera=parts[2], intrinsics_px=parts[3])
        whole.save(self.folder / "nerf", "nerf")
        np.testing.assert_allclose(lippmann.open(self.folder / "nerf").world_from_camera, parts[2], atol=1e-6)

    def test_unsupported_cameras_are_refused(self):
        for cameras in ("sphere", "sphere:0", "cube:3", 3, ""):
            self.assertWrong("cameras", lippmann.frames, "teapot", cameras=cameras)
        self.assertWrong("display", lippmann.frames, "teapot", small_grid(), cameras="sphere:3")
        self.assertWrong("display", lippmann.frames, "teapot", "portrait", cameras="sphere:3")
        self.assertWrong("frame", lippmann.render, "teapot", cameras="sphere:3", frame=3)
