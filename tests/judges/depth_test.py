"""Tests depth and disparity of a render with scripts/judge_depth, which computes both by formulas of the HCI benchmark. Also tests that
the script finds errors just above its limits."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np

JUDGE = pathlib.Path(os.environ["LIPPMANN_SOURCE"], "scripts/judge_depth")


def change(path, changed):
    """Replaces the values of a PFM file by changed(values)."""
    content = path.read_bytes()
    header = b"\n".join(content.split(b"\n", 3)[:3]) + b"\n"
    path.write_bytes(header + changed(np.frombuffer(content[len(header) :], "<f4")).astype("<f4").tobytes())


class Depth(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.rendered = pathlib.Path(folder.name, "set")
        words = "render room --optics multiview --camera-grid --views 3x3 --size 576x576 --view-angle 4 --frames 0 --spp 1 --to hci -q -o"
        subprocess.run([os.environ["LIPPMANN_TOOL"], *words.split(), cls.rendered], check=True)

    def judged(self, folder):
        return subprocess.run([sys.executable, JUDGE, folder], capture_output=True, text=True)

    def expect_found(self, name, changed):
        """Expects that the script complains if the values of the file `name` are replaced by changed(values)."""
        with tempfile.TemporaryDirectory() as folder:
            copy = shutil.copytree(self.rendered / "frame_0000", pathlib.Path(folder, "copy"))
            change(copy / name, changed)
            found = self.judged(copy)
        self.assertEqual(found.returncode, 1)
        self.assertIn("depth or disparity is wrong", found.stderr)

    def test_render_passes(self):
        found = self.judged(self.rendered / "frame_0000")
        self.assertEqual(found.returncode, 0, found.stdout + found.stderr)
        self.assertIn("12 pairs of views", found.stdout)

    def test_scaled_depth_of_a_view_is_found(self):
        self.expect_found("gt_depth_lowres_Cam004.pfm", lambda depth: depth * 1.0002)

    def test_shifted_disparity_of_a_view_is_found(self):
        self.expect_found("gt_disp_lowres_Cam004.pfm", lambda disparity: disparity + 2e-4)


if __name__ == "__main__":
    unittest.main()
