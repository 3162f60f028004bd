"""Runs the tool and makes small pictures for the Python tests."""

import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np

import lippmann

SOURCE = pathlib.Path(os.environ["LIPPMANN_SOURCE"])
TOOL = os.environ["LIPPMANN_TOOL"]
SMALL_PANEL = SOURCE / "tests/library/small_panel.toml"
DESK = SOURCE / "examples/desk.glb"


def tool(*words, cwd=None):
    done = subprocess.run([TOOL, *map(str, words)], cwd=cwd, capture_output=True, text=True)
    assert done.returncode == 0, f"{words}: {done.stderr}"
    return done.stdout


def small_grid(rows=2, columns=3, size=(24, 32), **more):
    return lippmann.camera_grid(rows, columns, size, **more)


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def assertSame(self, one, other):
        self.assertEqual(one.shape, other.shape)
        self.assertEqual(one.dtype, other.dtype)
        np.testing.assert_array_equal(one, other)

    def assertWrong(self, where, function, *arguments, **named):
        """Expects an Error that names the argument `where`."""
        with self.assertRaises(lippmann.Error) as caught:
            function(*arguments, **named)
        self.assertEqual(caught.exception.where, where, str(caught.exception))
        self.assertTrue(caught.exception.problem)
        return caught.exception
