"""Tests that the options of lippmann.render agree with the tool's options."""

import inspect
import os
import re
import shutil
import subprocess
import typing

import numpy as np

import lippmann
from lippmann import _options
from support import Case, SMALL_PANEL, SOURCE, small_grid, tool

# GROUPS: headings of the tool's help whose options also exist in Python. RENAMED: names in Python. LEFT_OUT: options
# that do not exist in Python.
GROUPS = ("Scene", "Rendering", "Reuse")
RENAMED = {"aperture": "aperture_mm", "focal-plane": "focal_plane_mm", "environment-rotation": "environment_rotation_deg",
           "texture-memory": "texture_memory_mb", "fps": "frames_per_second", "scene": "name"}
LEFT_OUT = {
    "order",  # changes only the speed
    "splat", "fill", "halving", "no-z-buffer", "debug",  # variants of `--reuse interpolate` for experiments
    "job",  # reads options from a file
    "sensor-width", "focal-length", "gap", "lens-focal-length",  # parameters of lippmann.optics("plenoptic", ...)
}


def tool_options():
    """Returns the option names of each heading in the tool's help."""
    options, group = {}, ""
    for line in tool("render", "--help-all").splitlines():
        if re.match(r"\S.*:$", line) or re.match(r"[A-Z]\w+$", line):
            group = line.strip(":").split()[0]
        found = re.match(r"\s+(?:-\w,)?\s*--([a-z-]+)", line)
        if found:
            options.setdefault(group, set()).add(found[1])
    return options


class Options(Case):
    def test_options_equal_the_tools(self):
        options = tool_options()
        self.assertLessEqual(set(GROUPS), set(options))
        # LightField.save has the options that convert linear light to codes.
        functions = (lippmann.load, lippmann.render, lippmann.frames, lippmann.LightField.save)
        has = {name for function in functions for name in inspect.signature(function).parameters}
        for group in GROUPS:
            for name in sorted(options[group] - LEFT_OUT):
                self.assertIn(RENAMED.get(name, name.replace("-", "_")), has, f"--{name} of {group}")
        self.assertEqual(LEFT_OUT - set().union(*options.values()), set(), "these are left out, but the tool has no such options")

    def test_points_have_the_stated_diameter(self):
        cloud = self.folder / "cloud.ply"
        corners = "".join(f"{x} {y} 0\n" for x in (0, 10) for y in (0, 10))
        header = "".join(f"property float {axis}\n" for axis in "xyz")
        cloud.write_text(f"ply\nformat ascii 1.0\nelement vertex 4\n{header}end_header\n{corners}")
        np.testing.assert_allclose(lippmann.load(cloud, points=2).bounds(), [[-1, -1, -1], [11, 11, 1]], atol=1e-5)
        self.assertWrong("points", lippmann.load, cloud, points=0)
        self.assertWrong("points", lippmann.load, cloud, points="big")

    def test_render_and_frames_take_the_same(self):
        of_render = dict(inspect.signature(lippmann.render).parameters)
        of_frames = dict(inspect.signature(lippmann.frames).parameters)
        self.assertTrue(of_render.pop("frame") and of_frames.pop("frames"))
        self.assertEqual(list(of_render.values()), list(of_frames.values()))

    def test_types_list_the_accepted_names(self):
        layers = {name for name in lippmann._core.layer_names if name != "alpha"} | {"disparity"}
        self.assertEqual(set(typing.get_args(_options.Layer)), layers)
        self.assertEqual(set(typing.get_args(_options.Integrator)), set(lippmann._core.integrator_names()))
        self.assertEqual(typing.get_args(_options.Tone), lippmann._core.tone_names)

    def test_mypy_finds_misspelt_options(self):
        mypy = shutil.which("mypy")
        if not mypy:
            self.skipTest("mypy is not installed")
        program = self.folder / "program.py"
        program.write_text(
            'import lippmann\nlippmann.render("room", spq=3)\nlippmann.render("room", layers=["dpeth"])\n'
            'for field in lippmann.frames("room", layers=["depth"], spp=4, environment="studio", fit_to="all"):\n'
            "    print(field.views.mean(), field[0, 0].shape)\n"
            'lippmann.dataset(["teapot"], "d", 1, sed=3)\nprint(lippmann.dataset("teapot", "d", 1, seed=3, rows=2, unit="1/2").made + 1)\n'
            'lippmann.render("room", fit_to="floor")\nlippmann.render("room", fit_to=3)\n'
        )
        environment = {**os.environ, "MYPYPATH": str(SOURCE / "python"), "MYPY_CACHE_DIR": str(self.folder / "cache")}
        environment.pop("PYTHONPATH")
        command = [mypy, "--strict", "--follow-imports=silent", "--no-error-summary", "--hide-error-codes", "program.py"]
        output = subprocess.run(command, cwd=self.folder, env=environment, capture_output=True, text=True).stdout
        errors = [line for line in output.splitlines() if "error:" in line]
        self.assertEqual([line.split(":")[1] for line in errors], ["2", "3", "6", "9"], output)
        self.assertIn('"spq"', errors[0])
        self.assertIn("dpeth", errors[1])
        self.assertIn('"sed"', errors[2])
        self.assertIn('"fit_to"', errors[3])
        clean = subprocess.run([mypy, "-p", "lippmann"], cwd=self.folder, env=environment, capture_output=True, text=True)
        self.assertEqual(clean.returncode, 0, clean.stdout)

    def test_the_studio_is_the_tools(self):
        turned = ("--environment", "studio", "--environment-rotation", "30", "--environment-strength", "0.5")
        tool("render", SOURCE / "examples/desk.glb", "--display", SOURCE / "tests/library/small_panel.toml", "--frames", "3", "--spp", "2",
             *turned, "-o", self.folder / "tool", "-q")
        (picture,) = (self.folder / "tool").glob("*.png")
        field = lippmann.render(SOURCE / "examples/desk.glb", SOURCE / "tests/library/small_panel.toml", frame=3, spp=2,
                                environment="studio", environment_rotation_deg=30, environment_strength=0.5)
        field.save(self.folder / "own.png")
        self.assertEqual((self.folder / "own.png").read_bytes(), picture.read_bytes())

    def test_tone_and_precompensation_are_the_tools(self):
        panel = self.folder / "panel.toml"
        text = SMALL_PANEL.read_text().replace("[1440, 2560]", "[360, 640]").replace("dpi = 491", "dpi = 122.75\ncrosstalk = 0.12")
        panel.write_text(text)
        for layout, options, flags in (
            ("native", {"exposure": 1.5, "tone": "agx", "precompensate": True, "crosstalk": 0.5},
             ("--exposure", "1.5", "--tone", "agx", "--precompensate", "--crosstalk", "0.5")),
            ("views", {"exposure": -1, "precompensate": True, "crosstalk": "10%"}, ("--exposure", "-1", "--precompensate", "--crosstalk", "10%")),
            ("views", {"tone": "neutral", "precompensate": True}, ("--tone", "neutral", "--precompensate")),
        ):
            with self.subTest(layout, **options):
                folder = self.folder / f"{layout} {len(options)}"
                tool("render", "room", "--display", panel, "--frames", "9", "--layout", "native" if layout == "native" else "quilt", *flags,
                     "-o", folder, "-q")
                (picture,) = folder.glob("*.png")
                field = lippmann.render("room", panel, frame=9, layout=layout)
                field.save(self.folder / "own.png", **options)
                self.assertEqual((self.folder / "own.png").read_bytes(), picture.read_bytes())
                field.save(self.folder / "plain.png", **{**options, "precompensate": False, "crosstalk": None})
                self.assertNotEqual((self.folder / "plain.png").read_bytes(), picture.read_bytes())

    def test_tone_applies_to_codes(self):
        views = np.random.default_rng(4).random((1, 2, 4, 4, 3), np.float32)
        field = lippmann.LightField(views)
        brighter = lippmann.to_codes(2 * views)
        self.assertSame(lippmann.to_codes(views, exposure=1), brighter)
        field.save(self.folder / "views", "views", exposure=1)
        self.assertSame(lippmann.open(self.folder / "views", views=(1, 2)).views, brighter)
        field.save(self.folder / "panel.png", exposure=1)
        again = lippmann.open(self.folder / "panel.png", format="quilt", tiles=(1, 2))
        self.assertSame(again.views, brighter)
        self.assertLess(lippmann.to_codes(views, tone="neutral").max(), lippmann.to_codes(views).max())
        with self.assertWarnsRegex(lippmann.LippmannWarning, "tone"):
            field.save(self.folder / "linear.exr", tone="agx")
        with self.assertWarnsRegex(lippmann.LippmannWarning, "precompensate"):
            field.save(self.folder / "more", "views", precompensate=True)
        with self.assertWarnsRegex(lippmann.LippmannWarning, "crosstalk"):
            field.save(self.folder / "panel.png", crosstalk=0.3)
        self.assertWrong("exposure", again.save, self.folder / "codes", "views", exposure=1)
        self.assertWrong("tone", field.save, self.folder / "x.png", tone="film")
        self.assertWrong("exposure", lippmann.to_codes, views, exposure=float("nan"))
        self.assertIn("unknown", self.assertWrong("precompensate", field.save, self.folder / "x.png", precompensate=True).problem)
        self.assertWrong("precompensate", field.save, self.folder / "x.png", precompensate=True, crosstalk=2)

    def test_no_environment_is_no_added_light(self):
        scene = lippmann.Scene()
        scene.add_sphere((0, 0, 0), 0.5)
        scene.place_display(height=2, viewing_distance=20)
        dark = lippmann.render(scene, small_grid(1, 1), environment="none", spp=2)
        self.assertEqual(dark.views.max(), 0)
        self.assertSame(dark.views, lippmann.render(scene, small_grid(1, 1), light="none", spp=2).views)

    def test_fit_to_all_shows_everything(self):
        def covered(**options):
            scene = lippmann.Scene()
            for x in (-10, 0, 10):
                scene.add_sphere((x, 0, 0), 1, material=lippmann.Material((1, 1, 1), unlit=True))
            scene.add_camera((0, 0, 8), target=(0, 0, 0), vertical_fov_deg=20)
            options.update(light="none", spp=1, fit_depth=False)
            return lippmann.render(scene, small_grid(1, 1, (64, 64)), **options).views[0, 0, :, :, 0] > 0

        self.assertEqual(np.diff(covered().any(axis=0).astype(int)).tolist().count(1), 1)
        self.assertEqual(np.diff(covered(fit_to="all").any(axis=0).astype(int)).tolist().count(1), 3)

    def test_angular_filter_and_clamp_reach_the_renderer(self):
        def rendered(**options):
            return lippmann.render("room", lippmann.quilt(1, 3, (32, 32)), spp=4, integrator="path", denoise="none", **options).views

        plain = rendered()
        self.assertSame(plain, rendered(angular_filter="none", clamp_indirect=0))
        self.assertFalse(np.array_equal(plain, rendered(angular_filter="box")))
        self.assertLess(rendered(clamp_indirect=1e-3).mean(), plain.mean())
        self.assertWrong("angular_filter", rendered, angular_filter="bok")

    def test_files_turn_upright_and_lamps_scale(self):
        desk = SOURCE / "examples/desk.glb"
        upright, turned = lippmann.load(desk).bounds(), lippmann.load(desk, up="z").bounds()
        np.testing.assert_allclose(turned[:, 1], upright[:, 2], rtol=1e-5)
        self.assertWrong("up", lippmann.load, desk, up="w")
        self.assertWrong("light_scale", lippmann.load, desk, light_scale=-1)
        def lit(factor):
            return lippmann.render(lippmann.load("room", light_scale=factor), small_grid(1, 1), spp=1).views.mean()

        self.assertLess(lit(0.5), lit(1))
