"""Tests random scenes, displays and light fields."""

import itertools

import numpy as np

import lippmann
from support import Case


class RandomData(Case):
    def test_seeds_decide_all_bits(self):
        def data(seed):
            return next(lippmann.training_data(seed, rows=1, columns=2, size=(32, 32), spp=1))

        one, same, other = data(3), data(3), data(4)
        self.assertSame(one.views, same.views)
        self.assertSame(one.disparity, same.disparity)
        self.assertFalse(np.array_equal(one.views, other.views))

    def test_it_is_endless_and_independent_per_seed(self):
        options = dict(rows=1, columns=2, size=(16, 16), spp=1)
        three = list(itertools.islice(lippmann.training_data(5, **options), 3))
        self.assertSame(three[2].views, next(lippmann.training_data(7, **options)).views)
        self.assertEqual(len(list(lippmann.training_data(5, 2, **options))), 2)

    def test_disparity_locates_pixels_in_other_views(self):
        # Warps the last of 9 views to the first view by the first view's disparity. The result must be closer to the
        # first view than the last view is.
        better = []
        for field in lippmann.training_data(11, 3, rows=1, columns=9, size=(96, 96), spp=16):
            left, right, shift = field.views[0, 0], field.views[0, -1], 8 * field.disparity[0, 0]
            y, x = np.mgrid[:96, :96]
            at = np.rint(x - shift).astype(int)
            inside = (at >= 0) & (at < 96)
            with_it = np.median(np.abs(right[y, at.clip(0, 95)] - left)[inside])
            without = np.median(np.abs(right - left)[inside])
            better.append(with_it < 0.6 * without)
            self.assertTrue(np.isfinite(shift).all())
        self.assertTrue(all(better), better)

    def test_random_displays_are_displays(self):
        sizes = set()
        for seed in range(20):
            display = lippmann.random_display(seed, size=(60, 80))
            self.assertEqual(tuple(display.size), (60, 80))
            sizes.add(round(display.view_cone_deg, 3))
        self.assertEqual(len(sizes), 20)
        field = lippmann.render(lippmann.random_scene(1), display, layout="native", spp=1)
        self.assertEqual(field.picture.shape, (60, 80, 3))

    def test_animated_scenes_move(self):
        scene = lippmann.random_scene(2, frames=3)
        fields = list(lippmann.frames(scene, lippmann.random_camera_grid(2, rows=1, columns=1, size=(32, 32)),
                                      layers=["motion"], spp=1))
        self.assertEqual(len(fields), 3)
        self.assertGreater(np.abs(fields[1].motion).max(), 0.1)
