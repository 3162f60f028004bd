"""Tests cameras of any pose: light fields of arrays, the formats nerf, colmap and llff, and cameras around a scene."""

import copy
import json
import pickle
import subprocess
import warnings

import numpy as np

import lippmann
from support import TOOL, Case, small_grid, tool

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


    def test_depth_behind_a_camera_is_refused(self):
        field, matrices, intrinsics = posed_field()

        def made(z):
            depth = field.depth.copy()
            depth[0, 2, 5, 7] = z
            return lippmann.LightField(field.views, depth, world_from_camera=matrices, intrinsics_px=intrinsics)

        for z in (2000, 0, np.inf):
            error = self.assertWrong("depth", made, z)
            self.assertIn("at (0, 2, 5, 7)", error.problem)
            self.assertIn("z in the frame of each camera in mm, below 0", error.accepted)
        self.assertEqual(made(-np.inf).depth[0, 2, 5, 7], -np.inf)


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


class UnsharedPlanes(Case):
    def test_eye_views_warn_of_the_assumption(self):
        """Refocusing and eye views need cameras in one plane. They state the assumed cameras, as `lippmann replay` does."""
        field, _, _ = posed_field(depth=False)
        field.save(self.folder / "nerf", "nerf")
        done = subprocess.run([TOOL, "replay", self.folder / "nerf", "-o", self.folder / "eye"], capture_output=True, text=True)
        again = lippmann.open(self.folder / "nerf")
        sentence = "do not share a plane and a window. Assumed: a display 100 mm high, seen from 300 mm, and 4 views 10 degrees apart"
        self.assertIn(f"The cameras of {self.folder / 'nerf'} {sentence}", done.stderr)
        for one, where in ((again, str(self.folder / "nerf")), (field, "this light field")):
            for picture in (lambda: one.refocus(1), one.eye, lambda: one.refocus(disparity=1), lambda: one.epi(row=3)):
                with self.assertWarns(lippmann.LippmannWarning) as caught:
                    picture()
                self.assertIn(f"The cameras of {where} {sentence}", str(caught.warning))

    def test_cameras_of_one_plane_do_not_warn(self):
        known = lippmann.LightField(np.zeros((1, 2, *SIZE, 3), np.uint8), distance_mm=500, baseline_mm=5, pixel_mm=1)
        (single,) = lippmann.frames("teapot", lippmann.single_view(SIZE), cameras="circle:3", spp=1)[:1]
        posed = posed_field(count=1, depth=False)[0]
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for field in (known, single, posed):
                field.refocus(1)
                field.eye()
                self.assertEqual(field.picture.ndim, 3)
            self.assertEqual(posed_field(depth=False)[0].picture.shape[2], 3)  # a quilt needs no cameras


class Splits(Case):
    def test_arrays_give_a_split_that_files_keep(self):
        field, matrices, intrinsics = posed_field(depth=False)
        split = np.array([["train", "test", "validation", "train"]])
        parts = lippmann.LightField(field.views, world_from_camera=matrices, intrinsics_px=intrinsics, split=split)
        for one in (parts, copy.deepcopy(parts), pickle.loads(pickle.dumps(parts))):
            np.testing.assert_array_equal(one.split, split)
        held_out = np.where(split == "train", "train", "test")  # colmap and llff only list the pictures held out
        for name, kept in (("nerf", split), ("colmap", held_out), ("llff", held_out)):
            with self.subTest(name):
                parts.save(self.folder / name, name)
                np.testing.assert_array_equal(lippmann.open(self.folder / name).split, kept)
        names = json.loads((self.folder / "nerf/transforms_test.json").read_text())["frames"]
        self.assertEqual([frame["file_path"] for frame in names], ["./images/001"])

    def test_the_tools_split_is_read(self):
        tool("render", "teapot", "--cameras", "circle:8", "--size", "16x12", "--spp", "1", "--to", "colmap", "-o", self.folder / "set", "-q")
        split = lippmann.open(self.folder / "set").split
        tests = lippmann.frames("teapot", lippmann.single_view(SIZE), cameras="circle:8").test_frames
        self.assertEqual(tuple(np.flatnonzero(split[0] == "test")), tests)
        self.assertEqual((split == "train").sum(), 8 - len(tests))

    def test_missing_and_wrong_splits_are_named(self):
        field, matrices, intrinsics = posed_field(depth=False)
        self.assertFalse(hasattr(field, "split"))
        def made(split):
            return lippmann.LightField(field.views, world_from_camera=matrices, intrinsics_px=intrinsics, split=split)

        self.assertIn("train, validation, test", self.assertWrong("split", made, [["train", "test", "dev", "train"]]).accepted)
        self.assertWrong("split", made, ["train", "test", "test", "train"])
        self.assertWrong("split", made, [[0, 1, 1, 0]])


class SaveOptions(Case):
    def test_binary_and_png_equal_the_tools_files(self):
        field, _, _ = posed_field(depth=False)
        field.save(self.folder / "nerf", "nerf")
        tool("convert", self.folder / "nerf", self.folder / "tool", "--to", "colmap", "--binary")
        files = lippmann.open(self.folder / "nerf").save(self.folder / "own", "colmap", binary=True)
        for name in ("cameras.bin", "images.bin", "points3D.bin"):
            self.assertIn(str(self.folder / "own/sparse/0" / name), files)
            self.assertEqual((self.folder / "own/sparse/0" / name).read_bytes(), (self.folder / "tool/sparse/0" / name).read_bytes())
        files = field.save(self.folder / "pleno", "jpeg-pleno", png=True)
        self.assertEqual({file[-4:] for file in files}, {".png"})
        self.assertSame(lippmann.open(self.folder / "pleno", format="jpeg-pleno").views, field.views)

    def test_other_formats_ignore_them_with_a_warning(self):
        field, _, _ = posed_field(depth=False)
        for argument in ("binary", "png"):
            with self.assertWarnsRegex(lippmann.LippmannWarning, argument):
                field.save(self.folder / argument, "nerf", **{argument: True})
