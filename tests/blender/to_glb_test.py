"""Tests of blender/to_glb.py. Blender runs this file."""

import contextlib
import io
import json
import os
import pathlib
import runpy
import struct
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

import bpy

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "blender/to_glb.py"


def to_glb(*words):
    done = subprocess.run([bpy.app.binary_path, "-b", "--factory-startup", "-noaudio", "--python", SCRIPT, "--", *words], capture_output=True, text=True)
    return done.returncode, lines_of(done.stdout + done.stderr)


def lines_of(text):
    return [line for line in text.splitlines() if line.startswith("to_glb: ")]


def to_glb_here(*words):
    """Runs the script in this Blender, which is faster than starting another. Replaces the current scene. Returns the exit
    code and the printed lines."""
    said, code = io.StringIO(), 0
    argv = ["blender", "--", *(str(word) for word in words)]
    with unittest.mock.patch.object(sys, "argv", argv), contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
        try:
            runpy.run_path(str(SCRIPT))
        except SystemExit as end:
            code = end.code
    return code, lines_of(said.getvalue())


class ToGlb(unittest.TestCase):
    def setUp(self):
        self.kept = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.kept.name)
        self.target = self.folder / "scene.glb"
        bpy.ops.wm.read_factory_settings()

    def tearDown(self):
        self.kept.cleanup()

    def document(self):
        data = self.target.read_bytes()
        return json.loads(data[20:20 + struct.unpack_from("<I", data, 12)[0]])

    def test_a_moving_cube_of_an_fbx_file_is_rendered(self):
        cube = bpy.data.objects["Cube"]
        for number in (1, 3):
            cube.location.x = number
            cube.keyframe_insert("location", frame=number)
        source = self.folder / "moving.fbx"
        bpy.ops.export_scene.fbx(filepath=str(source))
        self.assertEqual(to_glb(source, self.target), (0, [f"to_glb: {self.target}: 3 objects; next: lippmann render {self.target}"]))
        document = self.document()
        self.assertEqual([sorted(set(node) & {"camera", "mesh"}) for node in document["nodes"] if "mesh" in node], [["mesh"]])
        self.assertEqual(len(document["animations"]), 1)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["moving.fbx", "scene.glb"])
        done = subprocess.run([os.environ["LIPPMANN_TOOL"], "info", self.target, "--json"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_stl_is_read(self):
        source = self.folder / "shape.stl"
        source.write_text("solid one\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid one\n")
        self.assertEqual(to_glb_here(source, self.target)[0], 0)
        self.assertEqual(len(self.document()["meshes"]), 1)

    def test_what_cannot_be_read_is_one_line_and_leaves_what_was_there(self):
        self.target.write_text("mine")
        empty = self.folder / "empty.fbx"
        empty.touch()
        stage = self.folder / "stage.usda"
        stage.write_text("#usda 1.0\n")
        told = ["holds nothing that Blender has read"] if hasattr(bpy.types, "WM_OT_usd_import") else ["was built without an importer of .usda"]
        for words, expected in (((empty, self.target), ["empty.fbx"]), ((self.folder / "none.fbx", self.target), ["there is no such file"]), ((stage, self.target), told),
                                ((self.folder / "a.xyz", self.target), ["accepted: .usd"]), ((empty,), ["needs two paths after `--`"])):
            code, lines = (to_glb if words[0] == empty and len(words) == 2 else to_glb_here)(*words)
            self.assertEqual((code, len(lines)), (1, 1), lines)
            for part in expected:
                self.assertIn(part, lines[0])
        self.assertEqual(self.target.read_text(), "mine")


done = unittest.main(argv=["to_glb_test"], exit=False, verbosity=2)
sys.exit(0 if done.result.wasSuccessful() else 1)
