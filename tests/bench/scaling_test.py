"""Compares the formulas of docs/lab/scaling.md with a simulation of machines that each take the next group of frames
when free."""

import random
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "bench"))

import scaling  # noqa: E402  (sys.path is extended first)

SMALL = scaling.Film(frames=10, segment=4, frame_s=2.0, first_s=1.0, startup_s=3.0, spread=0.0, frame_bytes=0.0, syncs=0)


class Scaling(unittest.TestCase):
    def test_units_have_whole_segments(self):
        self.assertEqual(scaling.unit_sizes(SMALL, 2), [8, 2])
        self.assertEqual(scaling.unit_sizes(SMALL, 3), [4, 4, 2])
        self.assertEqual(scaling.unit_sizes(SMALL, 99), [4, 4, 2])
        self.assertEqual(scaling.unit_sizes(scaling.Film(frames=7), 3), [3, 2, 2])

    def test_a_units_time_adds_up(self):
        self.assertEqual(scaling.unit_seconds(SMALL, 8), 3 + 8 * 2 + 2 * 1)
        self.assertEqual(scaling.whole_seconds(SMALL), 3 + 10 * 2 + 3 * 1)

    def test_free_nodes_take_the_next_unit(self):
        self.assertEqual(scaling.scheduled_seconds([4.0, 1.0, 1.0, 5.0], 2), 7.0)
        self.assertEqual(scaling.scheduled_seconds([4.0, 1.0], 8), 4.0)
        # The three groups of frames take 12, 12 and 8 s. Two machines take the groups of 12 s, and then one machine takes the
        # group of 8 s.
        self.assertEqual(scaling.simulated_seconds(SMALL, 2, 3, seed=1), 12 + 8)

    def test_the_simulation_is_within_its_bounds(self):
        draw = random.Random(5)
        tight = 0
        for _ in range(300):
            film = scaling.Film(
                frames=draw.randint(1, 400), segment=draw.choice([1, 8, 16]), spread=draw.choice([0.0, 0.1, 0.5]), frame_bytes=0.0, syncs=0
            )
            nodes = draw.randint(1, 60)
            durations = scaling.drawn_seconds(film, nodes * draw.randint(1, 9), draw)
            even = sum(durations) / nodes
            seconds = scaling.scheduled_seconds(durations, nodes)
            self.assertGreaterEqual(seconds, even * (1 - 1e-9))
            self.assertLessEqual(seconds, (even + (1 - 1 / nodes) * max(durations)) * (1 + 1e-9))
            tight += seconds > even + 0.5 * max(durations)
        self.assertGreater(tight, 10)

    def test_the_longest_unit_matches_the_estimate(self):
        film = scaling.Film(frames=4000, startup_s=0.0)
        longest = [max(scaling.drawn_seconds(film, 4000, random.Random(seed))) for seed in range(9)]
        self.assertAlmostEqual(sorted(longest)[4] / scaling.longest_seconds(film, 4000), 1.0, delta=0.1)

    def test_the_median_is_within_the_bounds(self):
        for segment, first_s in ((1, 0.0), (16, 90.0)):
            film = scaling.Film(segment=segment, first_s=first_s)
            for nodes in (10, 100, 1000):
                least, most = scaling.bounds_seconds(film, nodes, 8 * nodes)
                median = scaling.median_seconds(film, nodes, 8 * nodes)
                self.assertGreater(median, 0.99 * least)
                self.assertLess(median, most)

    def test_the_disk_limits_the_time(self):
        film = scaling.Film(frames=100, frame_bytes=1e9, disk_bytes_s=1e8)
        self.assertEqual(scaling.disk_seconds(film), 1000.0)
        self.assertEqual(scaling.bounds_seconds(film, 1000, 100)[0], 1000.0)
        film = scaling.Film(frames=100, frame_bytes=0.0, syncs=3, disk_syncs_s=10.0)
        self.assertEqual(scaling.disk_seconds(film), 30.0)

    def test_the_documents_table_is_current(self):
        text = (Path(__file__).parents[2] / "docs" / "lab" / "scaling.md").read_text(encoding="utf-8")
        for line in scaling.table(scaling.Film(), scaling.NODES, scaling.UNITS_PER_NODE):
            self.assertIn(line, text)


if __name__ == "__main__":
    unittest.main()
