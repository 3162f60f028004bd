"""Runs the commands of docs/guide/blender.md in a temporary home folder. Blender runs this file."""

import json
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile
import unittest

import bpy

DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs/guide/blender.md"
ARCHIVE = "build/release/lippmann-blender.zip"
HAS_EXTENSIONS = bpy.app.version >= (4, 2)


def documented_command(part):
    command, = (line for line in DOCS.read_text().splitlines() if line.startswith("blender ") and part in line)
    return command


class Install(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.addCleanup(self._folder.cleanup)
        self.folder = pathlib.Path(self._folder.name)
        archive = self.folder / ARCHIVE
        archive.parent.mkdir(parents=True)
        archive.symlink_to(os.environ["LIPPMANN_ADDON"])
        home = {"HOME": str(self.folder), "XDG_CONFIG_HOME": str(self.folder / "config")}
        self.environment = {**os.environ, **home, "PWD": str(self.folder)}  # Blender resolves relative paths against PWD

    def run_blender(self, command, code=0):
        words = shlex.split(command)
        done = subprocess.run([bpy.app.binary_path, *words[1:]], cwd=self.folder, env=self.environment, capture_output=True, text=True)
        self.assertEqual(done.returncode, code, f"{command}\n{done.stdout}{done.stderr}")

    def write_scene(self):
        bpy.ops.wm.read_factory_settings()
        scene = bpy.context.scene
        scene.frame_start, scene.frame_end = 1, 2
        scene.render.resolution_x, scene.render.resolution_y = 160, 120
        scene.render.filepath = "//blender_"
        cube = bpy.data.objects["Cube"]
        for number in (1, 2):
            cube.location.x = number
            cube.keyframe_insert("location", frame=number)
        bpy.ops.wm.save_as_mainfile(filepath=str(self.folder / "scene.blend"))

    @unittest.skipUnless(HAS_EXTENSIONS, "Blender has extensions from version 4.2 on")
    def test_archive_is_a_valid_extension(self):
        self.run_blender(f"blender --command extension validate {ARCHIVE}")

    def test_farm_command_fails_without_the_addon(self):
        self.write_scene()
        self.run_blender(documented_command("-E LIPPMANN"), code=1)

    def test_farm_command_renders_an_animation(self):
        self.write_scene()
        self.run_blender(documented_command("extension install-file" if HAS_EXTENSIONS else "addon_install"))
        self.run_blender(documented_command("-E LIPPMANN"))
        animation = self.folder / "lippmann/animation"
        quilts = sorted(path.name for path in animation.glob("*.png"))
        self.assertEqual([name[:13] for name in quilts], ["frame_0001_qs", "frame_0002_qs"])
        self.assertEqual(sorted(path.name for path in self.folder.glob("*.png")), [f"blender_000{number}{name[10:]}" for number, name in zip((1, 2), quilts)])
        self.assertEqual(json.loads((animation / "report.json").read_text())["settings"]["spp"], 64)


done = unittest.main(argv=["install_test"], exit=False, verbosity=2)
sys.exit(0 if done.result.wasSuccessful() else 1)
