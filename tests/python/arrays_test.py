"""Tests the arrays of a light field."""

import gc
import sys
import types
import unittest.mock
import weakref

import numpy as np

import lippmann
from support import Case, small_grid


class Arrays(Case):
    def test_axes_are_rows_columns_y_x_channel(self):
        field = lippmann.render("room", small_grid(2, 3, (24, 32)), layers=["depth", "normal", "motion", "id"])
        self.assertEqual(field.views.shape, (2, 3, 24, 32, 3))
        self.assertEqual(field.shape, field.views.shape)
        self.assertEqual(field.views.dtype, np.float32)
        self.assertEqual(field.depth.shape, (2, 3, 24, 32))
        self.assertEqual(field.disparity.shape, (2, 3, 24, 32))
        self.assertEqual(field.normals.shape, (2, 3, 24, 32, 3))
        self.assertEqual(field.motion.shape, (2, 3, 24, 32, 2))
        self.assertEqual(field.layer("id").shape, (2, 3, 24, 32, 1))

    def test_row_0_is_lowest_column_0_leftmost(self):
        # A ball is in front of the display. A lower eye sees the ball higher on the display. An eye further to the left
        # sees the ball further to the right.
        scene = lippmann.Scene()
        scene.add_sphere((0, 0, 2), 0.5, material=lippmann.Material((0, 0, 0), emission=(1, 1, 1)))
        scene.place_display(height=10, viewing_distance=10)
        grid = small_grid(3, 3, (64, 64), baseline_mm=10, distance_mm=100, pixel_mm=100 / 64)
        field = lippmann.render(scene, grid, integrator="whitted", light="none", fit_depth=False)
        ball = field.views[..., 0] > 0.5
        x = np.array([[np.argwhere(ball[r, c])[:, 1].mean() for c in range(3)] for r in range(3)])
        y = np.array([[np.argwhere(ball[r, c])[:, 0].mean() for c in range(3)] for r in range(3)])
        self.assertTrue((np.diff(x, axis=1) < -1).all(), x)
        # y is counted from the top. A higher eye sees the ball lower on the display.
        self.assertTrue((np.diff(y, axis=0) > 1).all(), y)
        eyes = field.eyes_mm
        np.testing.assert_allclose(eyes[0, :, 0], [-10, 0, 10])
        np.testing.assert_allclose(eyes[:, 0, 1], [-10, 0, 10])

    def test_a_light_field_is_its_array(self):
        field = lippmann.render("room", small_grid(2, 3, (24, 32)), layers=["depth"])
        self.assertSame(np.asarray(field), field.views)
        self.assertTrue(np.shares_memory(np.asarray(field), field.views))
        self.assertEqual(np.asarray(field, dtype=np.float64).dtype, np.float64)
        self.assertEqual((len(field), field[1, 2].shape), (2, (24, 32, 3)))
        self.assertSame(field[1, 2], field.views[1, 2])
        self.assertSame(field[::-1], field.views[::-1])
        self.assertEqual(len(list(field)), 2)
        self.assertSame(np.mean(field, axis=(0, 1)), field.views.mean(axis=(0, 1)))

    def test_disparity_is_the_motion_between_views(self):
        scene = lippmann.Scene()
        scene.add_plane((0, 0, 2), (0, 0, 1))
        scene.place_display(height=10, viewing_distance=10)
        grid = small_grid(2, 2, (32, 32), baseline_mm=5, distance_mm=100, pixel_mm=100 / 32)
        field = lippmann.render(scene, grid, layers=["disparity"], spp=1, fit_depth=False)
        # The display is 10 units or 100 mm high, so a unit is 10 mm. The wall is 2 units in front of the display.
        np.testing.assert_allclose(field.depth, 20, rtol=1e-4)
        # The eye moves by 5 mm. By similar triangles, a point at depth z = 20 mm, seen from 100 mm, moves by 5 z / (100
        # - z) mm in the plane of the display. A pixel is 100 / 32 = 3.125 mm wide.
        np.testing.assert_allclose(field.disparity, 5 * 20 / 80 / 3.125, rtol=1e-3)

    def test_empty_pixels_have_infinite_depth_and_disparity(self):
        scene = lippmann.Scene()
        scene.add_sphere((0, 0, 0), 1)
        scene.add_sphere((0, 0, -1e6), 3e5)
        scene.place_display(height=10, viewing_distance=10)
        grid = small_grid(1, 2, (32, 32), baseline_mm=5, distance_mm=100, pixel_mm=100 / 32)
        field = lippmann.render(scene, grid, layers=["depth"], integrator="whitted", fit_depth=False)
        nothing = field.depth == -np.inf
        self.assertTrue(nothing.any())
        np.testing.assert_array_equal(field.disparity == -np.inf, nothing)
        self.assertTrue(np.isfinite(field.disparity[~nothing]).all())
        self.assertAlmostEqual(field.disparity[~nothing].min(), -5 / (100 / 32), places=4)
        field.save(self.folder / "hci", "hci")
        again = lippmann.open(self.folder / "hci")
        np.testing.assert_array_equal(again.disparity == -np.inf, nothing)
        header, _, _, values = (self.folder / "hci/gt_disp_lowres_Cam000.pfm").read_bytes().split(b"\n", 3)
        stored = np.frombuffer(values, "<f4").reshape(32, 32)[::-1]
        self.assertEqual(header, b"Pf")
        np.testing.assert_array_equal(stored == -np.inf, nothing[0, 0])
        text = (self.folder / "hci/parameters.cfg").read_text()
        self.assertRegex(text, r"(?m)^disp_min = -1\.\d+$")

    def test_views_and_picture_share_and_keep_memory(self):
        field = lippmann.render("room", small_grid(), layers=["depth"])
        self.assertTrue(np.shares_memory(field.views, field.views))
        self.assertTrue(np.shares_memory(field.depth, field.depth))
        self.assertTrue(np.shares_memory(field.picture, field.picture))
        self.assertTrue(field.views.flags.c_contiguous)
        views, depth, picture = field.views, field.depth, field.picture
        sums = views.sum(), picture.sum()
        gone = weakref.ref(field)
        del field
        gc.collect()
        self.assertIsNone(gone())
        others = [np.zeros_like(views) for _ in range(20)]  # would overwrite `views` if its memory were freed
        self.assertEqual((views.sum(), picture.sum()), sums)
        self.assertEqual(len(others), 20)
        self.assertEqual(depth.shape, views.shape[:4])

    def test_shared_memory_is_read_only(self):
        field = lippmann.render("room", small_grid())
        with self.assertRaises(ValueError):
            field.views[0, 0] = 0
        copy = field.views.copy()
        copy[0, 0] = 0
        self.assertEqual(copy[0, 0].max(), 0)

    def test_the_picture_is_the_views_quilt(self):
        field = lippmann.render("room", small_grid(2, 3, (24, 32)))
        rows = [np.concatenate(list(row), axis=1) for row in field.views]
        # the first row of views is the lowest
        self.assertSame(field.picture, np.concatenate(rows[::-1], axis=0))

    def test_a_light_field_keeps_its_arrays(self):
        rng = np.random.default_rng(1)
        for samples in (
            rng.integers(0, 256, (2, 3, 8, 9, 3), dtype=np.uint8),
            rng.integers(0, 65536, (2, 3, 8, 9, 3), dtype=np.uint16),
            rng.random((2, 3, 8, 9, 3), dtype=np.float32),
        ):
            depth = rng.random((2, 3, 8, 9), dtype=np.float32)
            field = lippmann.LightField(samples, depth, distance_mm=300, baseline_mm=4, pixel_mm=1)
            self.assertSame(field.views, samples)
            self.assertSame(field.depth, depth)
            self.assertEqual(field.distance_mm, 300)
        strided = rng.random((2, 3, 16, 9, 6))[:, ::-1, ::2, :, ::2]
        self.assertSame(lippmann.LightField(strided).views, strided.astype(np.float32))

    def test_refocusing_averages_shifted_views(self):
        # Each view shows a bright column, one pixel further left than in the previous view.
        views = np.zeros((1, 5, 8, 40, 3), np.float32)
        for column in range(5):
            views[0, column, :, 20 - (column - 2)] = 1
        field = lippmann.LightField(views, distance_mm=100, baseline_mm=2, pixel_mm=1)
        z = 100 / 3  # the disparity baseline * z / (distance - z) = 2 z / (100 - z) is one pixel
        sharp = field.refocus(z)
        self.assertGreater(sharp[4].max(), 0.95)
        self.assertLess(field.refocus(0)[4].max(), 0.25)

    def test_codes_are_those_of_srgb(self):
        linear = np.array([[[0.0, 0.5, 1.0], [0.25, 2.0, -1.0]]], np.float32)
        self.assertSame(lippmann.to_codes(linear), np.array([[[0, 188, 255], [137, 255, 0]]], np.uint8))

    def test_xarray_has_the_same_axes(self):
        field = lippmann.render("room", small_grid(), layers=["depth"])
        try:
            import xarray
        except ImportError:
            with self.assertRaisesRegex(ImportError, "xarray"):
                field.to_xarray()
            self.skipTest("xarray is not installed: only the error was tested")
        data = field.to_xarray()
        self.assertIsInstance(data, xarray.Dataset)
        self.assertEqual(data.views.dims, ("row", "column", "y", "x", "channel"))
        self.assertSame(data.depth.values, field.depth)
        self.assertSame(data.views.sel(channel="green").values, field.views[..., 1])
        self.assertSame(data.eye_x_mm.values, field.eyes_mm[..., 0])
        self.assertEqual((data.depth.units, data.eye_y_mm.units, data.views.long_name), ("mm", "mm", "linear radiance"))
        self.assertEqual(data.mean(("row", "column")).views.dims, ("y", "x", "channel"))
        codes = lippmann.LightField(np.zeros((1, 2, 4, 4, 3), np.uint8)).to_xarray()
        self.assertEqual(codes.views.long_name, "sRGB codes")

    def test_xarray_gets_an_axis_per_dimension(self):
        class Dataset:  # imitates xarray.Dataset
            def __init__(self, data, places, attributes):
                self.data, self.places = data, places
                for name, (axes, values, *_) in {**data, **{k: v for k, v in places.items() if k != "channel"}}.items():
                    assert len(axes) == values.ndim, name

        stand_in = types.ModuleType("xarray")
        stand_in.Dataset = Dataset
        with unittest.mock.patch.dict(sys.modules, xarray=stand_in):
            data = lippmann.render("room", small_grid(), layers=["depth"]).to_xarray()
        self.assertEqual(data.data["views"][0], ("row", "column", "y", "x", "channel"))
        self.assertEqual(set(data.data), {"views", "depth"})
        self.assertEqual(set(data.places), {"channel", "eye_x_mm", "eye_y_mm"})

    def test_a_notebook_shows_every_view_and_sliders(self):
        field = lippmann.render("room", small_grid(2, 3, (24, 32)))
        html = field._repr_html_()
        self.assertEqual(html.count("<img"), 6)
        self.assertEqual(html.count('type="range"'), 2)
        self.assertNotIn("http", html)
        self.assertEqual(html.count("display:inline;"), 1)
        self.assertEqual(html.count("width:320px;height:240px"), 6)
