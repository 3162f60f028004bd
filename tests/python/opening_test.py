"""Tests arguments of lippmann.open that state what files leave out: lens grids of raw pictures, and
cameras."""

import warnings

import numpy as np

import lippmann
from support import Case, tool

PITCH, LENSES = 10.135, 24


def raw_picture(turn=0.0, vignetting=False):
    """Returns the picture (y, x, 3) of a plenoptic camera. Below each lens, brightness is a function of the direction only: red grows
    to the right, green upwards.
    """
    side = int(PITCH * LENSES)
    y, x = np.mgrid[0:side, 0:side] + 0.5
    cosine, sine = np.cos(np.radians(turn)), np.sin(np.radians(turn))
    u, v = (cosine * x + sine * y) / PITCH, (cosine * y - sine * x) / PITCH
    right, up = u - np.floor(u) - 0.5, 0.5 - (v - np.floor(v))
    light = np.stack([0.5 + 0.5 * right, 0.5 + 0.5 * up, np.full_like(x, 0.5)], axis=2)
    if vignetting:
        light = light * np.clip(1.2 - 2.4 * (right**2 + up**2), 0.1, 1)[..., None]
    return light.astype(np.float32)


def white_picture():
    flat = raw_picture(vignetting=True) / raw_picture()
    return np.ascontiguousarray(flat, np.float32)


class RawPictures(Case):
    def write(self, name, picture):
        path = self.folder / name
        lippmann._core.write_picture(picture, path)
        return path

    def assertSlopes(self, views, tolerance):
        """Expects that red grows by 0.5 / pitch from each view to its right neighbour, and green by 0.5 / pitch from
        each view to its upper neighbour."""
        middle = views[:, :, 4:-4, 4:-4].mean(axis=(2, 3))
        np.testing.assert_allclose(np.diff(middle[..., 0], axis=1), 0.5 / PITCH, atol=tolerance)
        np.testing.assert_allclose(np.diff(middle[..., 1], axis=0), 0.5 / PITCH, atol=tolerance)

    def test_a_stated_lens_grid_gives_views(self):
        path = self.write("raw.exr", raw_picture())
        field = lippmann.open(path, format="plenoptic", lens_pitch_px=PITCH, views=(7, 7))
        self.assertEqual(field.shape, (7, 7, LENSES, LENSES, 3))
        self.assertSlopes(field.views, 2e-3)
        wrong = lippmann.open(path, format="plenoptic", lens_pitch_px=10, views=(7, 7))
        with self.assertRaises(AssertionError):
            self.assertSlopes(wrong.views, 2e-3)

    def test_views_equal_the_tools(self):
        raw, white = self.write("raw.png", raw_picture(0.2, True)), self.write("white.png", white_picture())
        stated = ("--lens-pitch-px", PITCH, "--lens-row-pitch-px", PITCH, "--lens-rotation", 0.2, "--lens-offset", "5.07,5.05",
                  "--lens-arrangement", "square", "--sampling", "lanczos", "--inverted", "--white", white)
        tool("convert", raw, self.folder / "views", "--from", "plenoptic", "--to", "views", "--views", "5x5", *stated)
        field = lippmann.open(raw, format="plenoptic", views=(5, 5), lens_pitch_px=PITCH, lens_row_pitch_px=PITCH, lens_rotation_deg=0.2,
                              lens_offset_px=(5.07, 5.05), lens_arrangement="square", sampling="lanczos", inverted=True, white=white)
        self.assertSame(field.views, lippmann.open(self.folder / "views", views=(5, 5)).views)

    def test_a_white_picture_gives_the_grid_and_removes_vignetting(self):
        raw, white = self.write("raw.exr", raw_picture(vignetting=True)), self.write("white.exr", white_picture())
        field = lippmann.open(raw, format="plenoptic", white=white, views=(5, 5))
        self.assertSlopes(field.views, 4e-3)
        self.assertLess(np.ptp(field.views[:, :, 4:-4, 4:-4, 2].mean(axis=(2, 3))), 0.03)

    def test_invalid_lenses_are_named(self):
        raw = self.write("raw.png", raw_picture())

        def opened(**lenses):
            return lippmann.open(raw, format="plenoptic", **lenses)

        self.assertWrong("lens_pitch_px", opened)
        self.assertWrong("lens_pitch_px", opened, lens_pitch_px=1)
        self.assertWrong("lens_pitch_px", opened, lens_pitch_px="wide")
        self.assertWrong("lens_row_pitch_px", opened, lens_pitch_px=10, lens_row_pitch_px=0.5)
        for name, value in (("lens_row_pitch_px", 9), ("lens_rotation_deg", 1), ("lens_offset_px", (1, 2)), ("lens_arrangement", "square")):
            self.assertIn("`lens_pitch_px`", self.assertWrong(name, opened, **{name: value}).accepted)
        self.assertWrong("lens_arrangement", opened, lens_pitch_px=10, lens_arrangement="round")
        self.assertWrong("lens_offset_px", opened, lens_pitch_px=10, lens_offset_px=3)
        self.assertWrong("sampling", opened, lens_pitch_px=10, sampling="cubic")
        self.assertWrong("white", opened, white=self.folder / "missing.png")
        self.assertWrong("white", opened, white=3)
        self.assertWrong(str(raw), opened, white=self.write("grey.png", np.full((90, 90, 3), 0.5, np.float32)), lens_pitch_px=PITCH)

    def test_other_formats_ignore_lenses_with_a_warning(self):
        field = lippmann.LightField(np.zeros((1, 2, 8, 8, 3), np.uint8))
        (quilt, *_) = field.save(self.folder / "q.png", "quilt")
        with self.assertWarnsRegex(lippmann.LippmannWarning, "lens_pitch_px"):
            lippmann.open(quilt, lens_pitch_px=10)


class StatedCameras(Case):
    """The cameras have a focal length of 100 mm, are 100 mm apart and focused at 8 m. The sensor is 35 mm or 512
    pixels wide. Points at 4 m, 8 m and infinity have the disparities +18.2857, 0 and -18.2857 pixels.
    """

    CAMERAS = {"baseline_mm": 100, "focal_length_mm": 100, "sensor_width_mm": 35, "focus_distance_mm": 8000}

    def saved(self, format):
        path = self.folder / ("eslf.png" if format == "eslf" else format)
        lippmann.LightField(np.zeros((2, 3, 8, 512, 3), np.uint8)).save(path, format)
        return path

    def test_stated_cameras_have_the_known_disparities(self):
        for format in ("stanford", "eslf", "views"):
            with self.subTest(format):
                field = lippmann.open(self.saved(format), format=format, views=(2, 3), **self.CAMERAS)
                distance, pixel, step = field.distance_mm, field.pixel_mm[1], np.diff(field.eyes_mm[0, :, 0])
                np.testing.assert_allclose(step, 100, rtol=1e-12)
                disparities = [step[0] / pixel * (distance / z - 1) for z in (4000, 8000, np.inf)]
                np.testing.assert_allclose(disparities, (18.285714285714285, 0, -18.285714285714285), rtol=1e-12)
                pose = field.world_from_camera[0, 2] - field.world_from_camera[0, 0]
                np.testing.assert_allclose(pose[:3, 3], (200, 0, 0), atol=1e-9)

    def test_incomplete_and_useless_cameras_are_named(self):
        path = self.saved("views")
        without = {name: value for name, value in self.CAMERAS.items() if name != "focal_length_mm"}
        self.assertWrong("focal_length_mm", lippmann.open, path, views=(2, 3), **without)
        self.assertWrong("baseline_mm", lippmann.open, path, views=(2, 3), sensor_width_mm=36)
        self.assertWrong("focus_distance_mm", lippmann.open, path, views=(2, 3), **{**self.CAMERAS, "focus_distance_mm": 0})
        known = lippmann.LightField(np.zeros((2, 3, 8, 8, 3), np.uint8), distance_mm=500, baseline_mm=5, pixel_mm=1)
        known.save(self.folder / "hci", "hci")
        self.assertIn("states its cameras", self.assertWrong("baseline_mm", lippmann.open, self.folder / "hci", **self.CAMERAS).problem)


class Refocusing(Case):
    def test_a_disparity_focuses_on_its_points(self):
        """A point that moves 2 pixels to the left per view is sharp at the disparity 2."""
        views = np.zeros((1, 5, 9, 33, 3), np.float32)
        for view in range(5):
            views[0, view, 4, 20 - 2 * view] = 1
        for cameras in ({}, {"distance_mm": 300, "baseline_mm": 7, "pixel_mm": 0.3}, {"distance_mm": 900, "baseline_mm": 2, "pixel_mm": 1}):
            field = lippmann.LightField(views, **cameras)
            sharp = field.refocus(disparity=2, size=(9, 33))
            self.assertGreater(sharp.max(), 0.7)
            self.assertLess(field.refocus(disparity=0, size=(9, 33)).max(), 0.3)
        np.testing.assert_allclose(field.refocus(disparity=0), field.refocus(0), atol=1e-6)

    def test_disparities_equal_the_tools(self):
        tool("render", "room", "--optics", "multiview", "--camera-grid", "--views", "3x3", "--size", "96x72", "--frames", "9", "-o",
             self.folder / "room", "-q")
        tool("replay", self.folder / "room", "--refocus", "0.5px", "-o", self.folder / "replay")
        field = lippmann.open(self.folder / "room")
        lippmann._core.write_picture(field.refocus(disparity=0.5), self.folder / "own.png")
        (made,) = (self.folder / "replay").glob("refocus_*.png")
        self.assertEqual((self.folder / "own.png").read_bytes(), made.read_bytes())

    def test_impossible_disparities_are_named(self):
        field = lippmann.LightField(np.zeros((1, 3, 8, 8, 3)), distance_mm=300, baseline_mm=3, pixel_mm=1)
        self.assertWrong("disparity", field.refocus, disparity=-3)  # points at infinity
        self.assertWrong("disparity", field.refocus, 5, disparity=1)
        self.assertWrong("disparity", field.refocus, disparity="near")
        one = lippmann.LightField(np.zeros((1, 1, 8, 8, 3)), distance_mm=300, baseline_mm=3, pixel_mm=1)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            self.assertWrong("disparity", one.refocus, disparity=1)
