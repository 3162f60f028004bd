"""Tests optics that are chosen by name, and optics that are defined by a function from pixels to rays."""

import math
import warnings

import numpy as np

import lippmann
from support import Case


class OpticsByName(Case):
    def test_optics_by_kind_equal_their_function(self):
        points = np.array([[0.5, 0.5], [20.25, 31.0], [55.5, 39.5]], np.float32)
        lenses = dict(pixel_mm=0.25, lens_pitch_mm=2.0, gap_mm=4.0)
        for named, made in (
            (lippmann.optics("single", (40, 56), pixel_mm=0.5, distance_mm=300), lippmann.single_view((40, 56), pixel_mm=0.5, distance_mm=300)),
            (
                lippmann.optics("lenticular", (40, 56), slant_deg=0, offset_mm=np.float32(1), viewing_distance_mm=math.inf, **lenses),
                lippmann.lenticular_sheet((40, 56), **lenses),
            ),
            (
                lippmann.optics("microlens", (40, 56), packing="square", offset_mm=(1, 1), viewing_distance_mm=600, **lenses),
                lippmann.microlens_array((40, 56), viewing_distance_mm=600, **lenses),
            ),
        ):
            self.assertEqual(repr(named), repr(made))
            for parts in zip(named.rays(points), made.rays(points)):
                self.assertSame(*parts)

    def test_wrong_kinds_and_values_are_named(self):
        self.assertIn("lenticular", self.assertWrong("kind", lippmann.optics, "lenticules").accepted)
        self.assertWrong("kind", lippmann.optics, 3)
        self.assertWrong("size", lippmann.optics, "single", (0, 3), distance_mm=500)
        self.assertWrong("distance_mm", lippmann.optics, "single")
        self.assertWrong("distance_mm", lippmann.optics, "single", distance_mm=-1)
        self.assertWrong("gap_mm", lippmann.optics, "lenticular", lens_pitch_mm=1, gap_mm=-1, slant_deg=0, viewing_distance_mm=500)
        self.assertWrong("distance_mm", lippmann.optics, "single", distance_mm="far")
        self.assertWrong("distance_mm", lippmann.optics, "single", distance_mm=math.nan)
        self.assertWrong("distance_mm", lippmann.optics, "single", distance_mm=object())
        self.assertIn("distance_mm", self.assertWrong("distance", lippmann.optics, "single", distance_mm=500, distance=3).problem)

    def test_all_missing_values_are_named_at_once(self):
        wrong = self.assertWrong("gap_mm, viewing_distance_mm", lippmann.optics, "lenticular", lens_pitch_mm=1, slant_deg=0)
        self.assertEqual(wrong.problem, "are missing")
        for name in ("lens_pitch_mm", "gap_mm", "slant_deg", "viewing_distance_mm"):
            self.assertIn(name, wrong.accepted)
        for kind, count in (("microlens", 4), ("multiview", 4), ("plenoptic", 6), ("slanted", 5)):
            with self.assertRaises(lippmann.Error) as caught:
                lippmann.optics(kind)
            self.assertEqual(len(caught.exception.where.split(", ")), count, caught.exception)


class OwnOptics(Case):
    def test_rays_of_a_model_match_the_model(self):
        sheet = dict(pixel_mm=0.25, lens_pitch_mm=2.0, gap_mm=4.0)
        for known, pixel_mm in (
            (lippmann.single_view((40, 56), pixel_mm=0.5), 0.5),
            (lippmann.lenticular_sheet((40, 56), **sheet), 0.25),
        ):
            own = lippmann.own_optics(known.rays, (40, 56), pixel_mm=pixel_mm)
            pictures = [
                lippmann.render("small-balls", optics, frame=40, integrator="whitted", fit_depth=False).picture
                for optics in (known, own)
            ]
            self.assertEqual(pictures[0].shape, (40, 56, 3))
            self.assertGreater(pictures[0].std(), 0.05)
            # Rounding changes a few pixels at edges.
            differ = np.abs(pictures[0] - pictures[1]).max(axis=2) > 2e-3
            self.assertLess(differ.mean(), 0.02)

    def test_rays_are_called_once_row_by_row(self):
        asked = []

        def rays(points):
            asked.append(points)
            return np.zeros((len(points), 3)), np.tile([0.0, 0.0, -2.0], (len(points), 1))

        optics = lippmann.own_optics(rays, (2, 3), samples_per_side=2)
        self.assertEqual(optics.size, [2, 3])
        self.assertEqual(len(asked), 1)
        self.assertEqual(asked[0].shape, (24, 2))
        self.assertSame(asked[0][:2], np.array([[0.25, 0.25], [0.75, 0.25]], np.float32))
        self.assertSame(asked[0][-1], np.array([2.75, 1.75], np.float32))
        origin, direction = optics.rays(np.array([[1.25, 0.25]], np.float32))
        self.assertSame(direction, np.array([[0, 0, -1]], np.float32))
        self.assertSame(origin, np.zeros((1, 3), np.float32))

    def test_directions_have_any_length(self):
        at, ahead = np.zeros((4, 3)), np.array([[0.3, -0.4, -1.2], [0, 0, -1], [1, 1, -1], [0, 2, -1]])
        unit = (ahead / np.linalg.norm(ahead, axis=1, keepdims=True)).astype(np.float32)
        points = np.array([[0.5, 0.5], [1.5, 0.5], [0.5, 1.5], [1.5, 1.5]], np.float32)
        for length, kind in ((1e-30, np.float32), (1e30, np.float32), (1e-200, np.float64), (1e300, np.float64), (1, np.float16)):
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                optics = lippmann.own_optics(lambda points: (at, (ahead * length).astype(kind)), (2, 2))
            np.testing.assert_allclose(optics.rays(points)[1], unit, rtol=1e-3 if kind is np.float16 else 1e-6)

    def test_wrong_rays_are_named(self):
        def with_rays(function):
            return lambda: lippmann.own_optics(function, (2, 2))

        ahead = np.tile([0.0, 0.0, -1.0], (4, 1))
        self.assertWrong("rays", with_rays(lambda points: ahead))
        self.assertWrong("rays", with_rays(lambda points: None))
        self.assertWrong("rays", with_rays(lambda points: (ahead, ahead, ahead)))
        self.assertWrong("rays", with_rays(lambda points: np.float64(3)))
        self.assertWrong("rays", with_rays(3))
        self.assertWrong("rays: origins", with_rays(lambda points: (ahead[:3], ahead)))
        self.assertWrong("rays: origins", with_rays(lambda points: (ahead * np.nan, ahead)))
        self.assertWrong("rays: directions", with_rays(lambda points: (ahead, -ahead)))
        for direction in ((0, 0, 0), (1, 0, 0), (1, 0, -1e-300), (np.inf, 0, -1)):
            self.assertWrong("rays: directions", with_rays(lambda points: (ahead, np.tile(direction, (4, 1)))))
        self.assertWrong("size", lambda: lippmann.own_optics(lambda points: (ahead, ahead), (0, 2)))

    def test_exceptions_of_rays_are_passed_on(self):
        def lazy(points):
            yield np.zeros((len(points), 3))
            int("x")

        for function, kind in (
            (lambda points: 1 // 0, ZeroDivisionError),
            (lambda points: int("x"), ValueError),
            (lambda points: len(3), TypeError),
            (lambda: None, TypeError),
            (lazy, ValueError),
        ):
            with self.assertRaises(kind) as caught:
                lippmann.own_optics(function, (2, 2))
            self.assertIs(type(caught.exception), kind)
        with self.assertRaises(lippmann.Error) as caught:
            lippmann.own_optics(lambda points: lippmann.camera_grid(rows=0), (2, 2))
        self.assertEqual(caught.exception.where, "rows")

    def test_missing_views_are_named(self):
        def parallel(points):
            at = (points - 8) * [1.0, -1.0]
            return np.column_stack([at, np.full(len(at), 50.0)]), np.tile([0.0, 0.0, -1.0], (len(at), 1))

        field = lippmann.render("room", lippmann.own_optics(parallel, (16, 16)), frame=40, integrator="whitted")
        self.assertEqual(field.picture.shape, (16, 16, 3))
        with self.assertRaises(lippmann.Error):
            field.views
        with self.assertRaises(lippmann.Error):
            field.eye()
