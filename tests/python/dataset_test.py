"""Tests `lippmann dataset`: its arrays, their geometry, division into units of work, and continuing after the
process was killed."""

import json
import pathlib
import signal
import subprocess
import unittest

import numpy as np

from support import TOOL, Case, tool

SMALL = ("dataset", "teapot", "--views", "3x2", "--size", 32, "--spp", 2, "--seed", 5)


class Samples:
    """The PyTorch data set of docs/guide/python.md, but without PyTorch."""

    def __init__(self, folder):
        self.folders = sorted(pathlib.Path(folder).glob("sample_*"))

    def __len__(self):
        return len(self.folders)

    def __getitem__(self, i):
        return {file.stem: np.load(file, mmap_mode="r") for file in self.folders[i].glob("*.npy")}


class Dataset(Case):
    def files(self, folder):
        return {str(f.relative_to(folder)): f.read_bytes() for f in sorted(folder.rglob("*")) if f.is_file()}

    def test_arrays_have_the_documented_shapes(self):
        tool(*SMALL, "-o", self.folder / "d", "--count", 3)
        samples = Samples(self.folder / "d")
        self.assertEqual(len(samples), 3)
        for i in range(3):
            sample = samples[i]
            self.assertEqual(sample["views"].shape, (6, 32, 32, 3))
            self.assertEqual(sample["views"].dtype, np.uint8)
            for name, channels in (("depth", ()), ("disparity", ()), ("id", ()), ("normal", (3,)), ("motion", (2,))):
                self.assertEqual(sample[name].shape, (6, 32, 32, *channels))
            hit = sample["id"] >= 0
            self.assertGreater(hit.mean(), 0.99)
            np.testing.assert_allclose(np.linalg.norm(sample["normal"], axis=-1)[hit], 1, atol=2e-3)
            self.assertGreater(len(np.unique(sample["id"])), 2)
            self.assertGreater(np.abs(sample["motion"]).max(), 0)
        self.assertFalse(np.array_equal(samples[0]["depth"], samples[1]["depth"]))

    def test_disparity_finds_objects_in_the_next_view(self):
        tool(*SMALL, "-o", self.folder / "d", "--count", 2)
        for i in range(2):
            sample = Samples(self.folder / "d")[i]
            ids, disparity = sample["id"][:2], sample["disparity"][0]
            y, x = np.mgrid[:32, :32]
            there = np.round(x - disparity).astype(int)
            inside = (there >= 0) & (there < 32)
            same = ids[1][y, np.clip(there, 0, 31)] == ids[0]
            # The threshold allows for pixels at silhouettes. The next view may not show the surface
            # there, or rounding may move it to a neighbouring pixel.
            self.assertGreater(same[inside].mean(), 0.9)

    def test_units_equal_one_run(self):
        tool(*SMALL, "-o", self.folder / "one", "--count", 3)
        for unit in ("2/2", "1/2"):
            self.assertFalse((self.folder / "two/manifest.json").exists())
            tool(*SMALL, "-o", self.folder / "two", "--count", 3, "--unit", unit)
        self.assertEqual(self.files(self.folder / "one"), self.files(self.folder / "two"))

    def test_a_killed_run_continues(self):
        folder = self.folder / "killed"
        words = [TOOL, *map(str, SMALL), "-o", str(folder), "--count", "6"]
        with subprocess.Popen(words, stderr=subprocess.PIPE) as run:
            run.stderr.readline()  # waits for the line about the first sample
            run.send_signal(signal.SIGKILL)
        self.assertFalse((folder / "manifest.json").exists())
        again = json.loads(tool(*SMALL, "-o", folder, "--count", 6, "--json"))
        self.assertTrue(again["complete"])
        self.assertGreaterEqual(again["kept"], 1)
        self.assertEqual(again["kept"] + again["made"], 6)
        tool(*SMALL, "-o", self.folder / "whole", "--count", 6)
        self.assertEqual(self.files(folder), self.files(self.folder / "whole"))

    def test_changes_are_refused_and_damage_is_repaired(self):
        folder = self.folder / "d"
        tool(*SMALL, "-o", folder, "--count", 1)
        done = subprocess.run([TOOL, *map(str, SMALL), "-o", folder, "--count", "2"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("other parameters", done.stderr)
        before = self.files(folder)
        (folder / "sample_000000/depth.npy").write_bytes(b"short")
        self.assertEqual(json.loads(tool(*SMALL, "-o", folder, "--count", 1, "--json"))["made"], 1)
        self.assertEqual(self.files(folder), before)


if __name__ == "__main__":
    unittest.main()
