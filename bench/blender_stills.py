"""Measures how long the Blender add-on takes from F12 to the start of `lippmann render`: for the first still, and for a second
still of the unchanged scene with and without Persistent Data.

  blender -b --factory-startup --python bench/blender_stills.py -- [FILE.glb ...]

Measures the default cube, 60 monkeys with a subdivision modifier, and the given files. CPU seconds include Blender's child
processes. Needs `lippmann` in PATH, or in the environment variable LIPPMANN_TOOL.
"""

import pathlib
import resource
import sys
import tempfile
import time

import bpy
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "blender"))
import lippmann  # noqa: E402
from lippmann import tool  # noqa: E402

np.bool = bool  # the importer of Blender 3.4 uses this name, which some versions of numpy do not have


def add_monkeys():
    bpy.data.objects.remove(bpy.data.objects["Cube"])
    for index in range(60):
        bpy.ops.mesh.primitive_monkey_add(location=(index % 10 - 4.5, index // 10 - 2.5, 0.0), size=0.8)
        bpy.context.object.modifiers.new("smooth", "SUBSURF").render_levels = 2


def import_file(file):
    bpy.data.objects.remove(bpy.data.objects["Cube"])
    bpy.ops.import_scene.gltf(filepath=file)


def cpu_seconds():
    return sum(used.ru_utime + used.ru_stime for used in map(resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)))


class Clock:
    """Measures the time from start() until the add-on starts `lippmann render`."""

    def __init__(self):
        own = tool.Child.__init__

        def begin(child, words, *arguments):
            self.passed = time.monotonic() - self._now, cpu_seconds() - self._cpu  # the last child is `lippmann render`
            own(child, words, *arguments)

        tool.Child.__init__ = begin

    def start(self):
        self._now, self._cpu = time.monotonic(), cpu_seconds()


def measure(name, make, clock):
    bpy.ops.wm.read_factory_settings()
    make()
    scene = bpy.context.scene
    scene.render.engine, scene.lippmann.output, scene.lippmann.samples = "LIPPMANN", "camera", 1
    scene.render.resolution_x, scene.render.resolution_y = 64, 48
    figures = []
    with tempfile.TemporaryDirectory() as folder:
        scene.lippmann.folder = folder
        for keeps in (False, False, True, True):
            scene.lippmann.keep_scene = keeps
            clock.start()
            bpy.ops.render.render()
            figures.append("{:.2f} s, {:.2f} CPU s".format(*clock.passed))
    print(f"| {name} | {figures[0]} | {figures[1]} | {figures[3]} |", flush=True)


def main():
    lippmann.register()
    print(f"Blender {bpy.app.version_string}\n\n| scene | first still | second still | second still, Persistent Data |\n|---|---|---|---|")
    clock = Clock()
    measure("default cube", lambda: None, clock)
    measure("60 monkeys, subdivided twice", add_monkeys, clock)
    for file in sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []:
        measure(pathlib.Path(file).name, lambda file=file: import_file(file), clock)


main()
