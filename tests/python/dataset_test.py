"""Tests `lippmann dataset` and lippmann.dataset."""

import inspect
import json
import pathlib
import re
import signal
import subprocess
import unittest

import numpy as np

import lippmann
from support import TOOL, Case, tool

SMALL = ("dataset", "teapot", "--views", "3x2", "--size", 32, "--spp", 2, "--seed", 5)
SMALL_OPTIONS = dict(rows=2, columns=3, size=32, spp=2, seed=5)


class Samples:
    """Imitates the PyTorch data set of docs/guide/python.md."""

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
            # At silhouettes, another object may hide the surface in the next view.
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
            run.stderr.readline()
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

    def test_flipped_bits_are_repaired(self):
        folder = self.folder / "d"
        tool(*SMALL, "-o", folder, "--count", 3)
        before = self.files(folder)
        for name in ("sample_000001/views.npy", "sample_000002/sample.json"):
            data = bytearray((folder / name).read_bytes())
            data[0 if name.endswith("json") else 200] ^= 1
            (folder / name).write_bytes(data)
        again = json.loads(tool(*SMALL, "-o", folder, "--count", 3, "--json"))
        self.assertEqual({key: again[key] for key in ("kept", "made", "remade")}, {"kept": 1, "made": 2, "remade": 2})
        self.assertEqual(self.files(folder), before)
        (folder / "sample_000000/id.npy").unlink()
        self.assertIn(" (1 to replace damaged samples), 2 kept", tool(*SMALL, "-o", folder, "--count", 3))
        self.assertNotIn("damaged", tool(*SMALL, "-o", folder, "--count", 3))
        (folder / "sample_000000/id.npy").write_bytes(b"")
        self.assertEqual(lippmann.dataset("teapot", folder, 3, **SMALL_OPTIONS).remade, 1)

    def test_python_writes_the_tools_files(self):
        tool(*SMALL, "-o", self.folder / "tool", "--count", 2)
        for unit, made in (("2/2", 1), ("1/2", 1), (None, 0)):
            report = lippmann.dataset("teapot", self.folder / "own", 2, unit=unit, **SMALL_OPTIONS)
            self.assertEqual((report.made, report.complete), (made, unit != "2/2"))
            self.assertEqual(report.samples, report.made + report.kept)
        self.assertEqual(self.files(self.folder / "tool"), self.files(self.folder / "own"))

    def test_python_has_the_tools_options_and_defaults(self):
        has = dict(inspect.signature(lippmann.dataset).parameters)
        options = dict(re.findall(r"^  (?:-\w,)?--([a-z]+) .*?((?:default: \d+)?)$", tool("dataset", "--help"), re.MULTILINE))
        for name in ("help", "json", "quiet"):
            options.pop(name, None)
        self.assertIn("default: 9x9", tool("dataset", "--help"))
        options.pop("views"), options.pop("output")
        self.assertEqual((has["rows"].default, has["columns"].default), (9, 9))
        self.assertEqual(set(options) - set(has), set())
        self.assertEqual(set(has) - set(options), {"scenes", "folder", "rows", "columns", "progress"})
        for name, default in options.items():
            if default:
                self.assertEqual(f"default: {has[name].default}", default, name)

    def test_progress_counts_samples_and_stops(self):
        class Stop(Exception):
            pass

        calls = []

        def progress(made, share):
            calls.append((made, share))
            if made >= 2:
                raise Stop

        with self.assertRaises(Stop):
            lippmann.dataset(["teapot"], self.folder / "d", 200, progress=progress, **SMALL_OPTIONS)
        self.assertFalse((self.folder / "d/manifest.json").exists())
        self.assertEqual([made for made, _ in calls], sorted(made for made, _ in calls))
        self.assertTrue(all(0 <= share <= 1 for _, share in calls))
        self.assertEqual({path.name for path in (self.folder / "d").glob(".*")}, set())
        again = lippmann.dataset("teapot", self.folder / "d", 200, unit="1/50", **SMALL_OPTIONS)
        self.assertGreaterEqual(again.kept, 2)

    def test_python_refuses_bad_input(self):
        folder = self.folder / "d"
        self.assertWrong("scenes", lippmann.dataset, [], folder, 1)
        self.assertWrong("scenes", lippmann.dataset, [7], folder, 1)
        self.assertWrong("nowhere.glb", lippmann.dataset, "nowhere.glb", folder, 1)
        for name, value in dict(count=0, size=7, spp=0, rows=0, columns=2000, seed=-1, threads=-1, progress=3, unit="3/2").items():
            self.assertWrong(name, lippmann.dataset, "teapot", folder, **{"count": 1, name: value})
        self.assertFalse(folder.exists())
        lippmann.dataset("teapot", folder, 1, **SMALL_OPTIONS)
        self.assertIn("other parameters", self.assertWrong(str(folder), lippmann.dataset, "teapot", folder, 2, **SMALL_OPTIONS).problem)


if __name__ == "__main__":
    unittest.main()
