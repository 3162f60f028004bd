"""Tests of the Render Views operator in a Blender with windows.

If the environment variable SCREENSHOTS names a folder, the quilts are saved there.
"""

import os
import pathlib
import shutil
import sys
import tempfile
import time
import traceback
import types

import bpy
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "blender"))
import lippmann  # noqa: E402
from lippmann import panel, render_views, versions  # noqa: E402

EEVEE = versions.eevee()
TICK, PATIENCE = 0.02, 240.0  # seconds between two steps of the test, and time limit of the test

lippmann.register()
bpy.context.preferences.view.show_splash = False


def shining(shade):
    material = bpy.data.materials.new("shining")
    material.use_nodes = True
    light = material.node_tree.nodes.new("ShaderNodeEmission")
    light.inputs["Color"].default_value = (shade, shade, shade, 1.0)
    material.node_tree.links.new(light.outputs[0], material.node_tree.get_output_node("ALL").inputs["Surface"])
    return material


def set_up(folder):
    scene = bpy.context.scene
    scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value = 0.0
    cube = bpy.data.objects["Cube"]
    cube.data.materials[0] = shining(1.0)
    for place in ((1.5, -1.5, 1.0), (-3.0, 2.5, 0.0)):
        other = bpy.data.objects.new("other", cube.data)
        other.location, other.scale = place, (0.5, 0.7, 0.3)
        scene.collection.objects.link(other)
    scene.render.engine, scene.view_settings.view_transform = "LIPPMANN", "Standard"
    scene.eevee.taa_render_samples, scene.cycles.samples, scene.cycles.use_denoising, scene.cycles.device = 8, 8, False, "CPU"
    (folder / "small.toml").write_text('base = "looking-glass-portrait"\n[quilt]\ntiles = [4, 1]\nsize = [480, 120]\naspect = 0.75\n')
    scene.lippmann.calibration, scene.lippmann.folder = str(folder / "small.toml"), str(folder)
    scene.render.resolution_x, scene.render.resolution_y = 480, 120


def codes(picture):
    image = bpy.data.images.load(str(picture))
    return np.array(image.pixels[:]).reshape(image.size[1], image.size[0], -1)[..., 0]


def start(engine):
    """Opens the dialog and presses Enter until Render Views runs. Yields while Blender must handle events."""
    window = bpy.context.window_manager.windows[0]
    with bpy.context.temp_override(window=window):
        assert bpy.ops.lippmann.render_views("INVOKE_DEFAULT", engine=engine) == {"RUNNING_MODAL"}
    while not render_views.is_running():
        window.event_simulate(type="RET", value="PRESS")
        yield
    assert not bpy.ops.lippmann.render_views.poll()


def state(scene):
    return scene.render.engine, scene.camera.name, scene.render.resolution_x, scene.render.filepath, scene.render.use_lock_interface, sorted(bpy.data.objects.keys())


def check(folder):
    """Runs the test. Yields while Blender must handle events."""
    scene = bpy.context.scene
    before, display_type = state(scene), bpy.context.preferences.view.render_display_type
    lines = set()

    yield from start(EEVEE)
    while render_views.is_running():
        lines.add(render_views.status())
        assert panel.LIPPMANN_PT_light_field.poll(types.SimpleNamespace(engine=scene.render.engine))
        yield
    assert any("rendering the views of frame 1, " in line and "(Esc stops)" in line for line in lines), lines
    eevee, = folder.joinpath(EEVEE.lower(), "quilt").glob("*.png")
    assert eevee.name == "frame_0001_qs4x1a0.75.png", eevee
    assert state(scene) == before, state(scene)
    assert bpy.context.preferences.view.render_display_type == display_type

    yield from start("CYCLES")
    bpy.context.window_manager.windows[0].event_simulate(type="ESC", value="PRESS")
    while render_views.is_running():
        yield
    assert not list(folder.joinpath("cycles").rglob("*.png"))

    yield from start("CYCLES")
    first = folder / "cycles/views/frame_0001/view_000.png"
    while not first.is_file():
        yield
    render_views.run_in_window().cancel()  # Blender calls cancel() after Esc; simulated key presses do not reach its renderer
    while render_views.is_running():
        yield
    complete = sorted(folder.joinpath("cycles").rglob("*.png"))
    assert first in complete and len(complete) < 4 and all(path.parent == first.parent for path in complete), complete
    assert codes(first).shape == (120, 120)
    assert state(scene) == before, state(scene)

    rendered = first.stat().st_mtime_ns
    yield from start("CYCLES")
    while render_views.is_running():
        yield
    assert first.stat().st_mtime_ns == rendered
    cycles, = folder.joinpath("cycles", "quilt").glob("*.png")
    shown = {editor.image.filepath for editor in render_views.image_editors()}
    assert shown == {str(cycles)}, shown

    shapes = [codes(quilt) > 0.5 for quilt in (eevee, cycles)]
    share, differ = shapes[0].mean(), (shapes[0] != shapes[1]).mean()
    print(f"silhouettes: {share:.4f} of the quilt, {differ:.5f} of it differ between Eevee and Cycles")
    assert 0.05 < share < 0.9 and differ < 0.005
    tiles = np.split(shapes[0], 4, axis=1)
    assert (tiles[0] != tiles[3]).mean() > 10 * differ  # the first and the last view differ by parallax
    if "SCREENSHOTS" in os.environ:
        for quilt in (eevee, cycles):
            shutil.copy(quilt, pathlib.Path(os.environ["SCREENSHOTS"]) / f"{quilt.parents[1].name}.png")


class Test:
    """Runs one step of check() each time Blender's timer calls it."""

    def __init__(self):
        self._folder = tempfile.TemporaryDirectory()
        folder = pathlib.Path(self._folder.name)
        self._end = time.monotonic() + PATIENCE
        set_up(folder)
        self._steps = check(folder)

    def __call__(self):
        try:
            assert time.monotonic() < self._end, "takes too long"
            next(self._steps)
        except StopIteration:
            self._exit(0)
        except Exception:
            traceback.print_exc()
            self._exit(1)
        return TICK

    def _exit(self, code):
        self._folder.cleanup()
        sys.stdout.flush(), sys.stderr.flush()
        os._exit(code)  # sys.exit() would end only the timer


bpy.app.timers.register(lambda test=[]: (test or test.append(Test()) or test)[0](), first_interval=0.5)  # after the window has opened
