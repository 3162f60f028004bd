"""Tests that bad input raises an exception that names the argument."""

import os
import subprocess
import threading
import warnings

import numpy as np

import lippmann
from support import Case, SMALL_PANEL, TOOL, small_grid

QUAD = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]
FACES = [[0, 1, 2], [0, 2, 3]]


class Errors(Case):
    def test_errors_are_value_errors_with_parts(self):
        with self.assertRaises(ValueError) as caught:
            lippmann.display("portrat")
        error = caught.exception
        self.assertIsInstance(error, lippmann.Error)
        self.assertIn("portrat", error.problem + error.where)
        self.assertIn(error.problem, str(error))
        self.assertWrong("spp", lippmann.render, "room", small_grid(), spp=-1)

    def test_wrong_arrays_are_named(self):
        scene = lippmann.Scene(frames=3)
        self.assertWrong("positions", scene.add_mesh, [[0, 0], [1, 1], [2, 2]], FACES)
        self.assertWrong("positions", scene.add_mesh, [], FACES)
        self.assertWrong("positions", scene.add_mesh, "mesh", FACES)
        self.assertWrong("positions", scene.add_mesh, [[0, 0, 0], [1, 1]], FACES)
        self.assertWrong("positions", scene.add_mesh, np.zeros((4, 3), complex), FACES)
        self.assertWrong("positions", scene.add_mesh, np.zeros((4, 3), object), FACES)
        nan = np.array(QUAD, float)
        nan[2, 1] = np.nan
        error = self.assertWrong("positions", scene.add_mesh, nan, FACES)
        self.assertIn("(2, 1)", error.problem)
        self.assertWrong("positions", scene.add_mesh, np.array(QUAD) * 1e300, FACES)
        self.assertWrong("triangles", scene.add_mesh, QUAD, [[0, 1, 4]])
        self.assertWrong("triangles", scene.add_mesh, QUAD, [[0, 1, -1]])
        self.assertWrong("triangles", scene.add_mesh, QUAD, [[0.0, 1.0, 2.0]])
        self.assertWrong("triangles", scene.add_mesh, QUAD, [[0, 1]])
        self.assertWrong("normals", scene.add_mesh, QUAD, FACES, normals=np.zeros((4, 3)))
        self.assertWrong("uvs", scene.add_mesh, QUAD, FACES, uvs=np.zeros((3, 2)))
        self.assertWrong("colors", scene.add_mesh, QUAD, FACES, colors=np.zeros((4, 4)))
        self.assertEqual(scene.objects, ())
        ball = scene.add_sphere()
        self.assertWrong("matrices", ball.animate, np.zeros((2, 4, 4)))
        self.assertWrong("matrices", ball.animate, np.zeros((3, 4, 4)))
        self.assertWrong("matrices", ball.animate, np.tile(np.eye(4) + np.eye(4, k=1), (3, 1, 1)))
        self.assertWrong("matrices", ball.animate, np.tile(np.eye(4), (3, 1, 1)), translation=np.zeros((3, 3)))
        self.assertWrong("rotation", ball.animate, rotation=np.zeros((3, 4)))
        self.assertWrong("material.color", scene.add_sphere, material=lippmann.Material((1, 2, 0)))
        self.assertWrong("material.ior", scene.add_sphere, material=lippmann.Material(ior=float("nan")))
        self.assertWrong("material.texture", scene.add_sphere, material=lippmann.Material(texture=np.zeros((2, 2, 3))))
        self.assertWrong("material", scene.add_sphere, material="red")
        self.assertWrong("radiance", scene.set_environment, np.full((2, 4, 3), -1.0))
        self.assertWrong("views", lippmann.LightField, np.zeros((2, 2, 3)))
        self.assertWrong("views", lippmann.LightField, np.zeros((2, 2, 4, 4, 3), bool))
        self.assertWrong("views", lippmann.LightField, np.zeros((2, 2, 0, 4, 3)))
        views = np.zeros((2, 2, 4, 4, 3))
        self.assertWrong("depth", lippmann.LightField, views, np.zeros((2, 2, 4, 5)))
        self.assertWrong("baseline_mm", lippmann.LightField, views, distance_mm=3, pixel_mm=1)
        self.assertWrong("picture", lippmann.to_codes, np.zeros(3))

    def test_arguments_outside_their_range_are_named(self):
        grid = small_grid()
        for name, value in {
            "display": 3,
            "frame": 480,
            "layers": ["deph"],
            "spp": 1.5,
            "seed": -1,
            "integrator": "paths",
            "reuse": "all",
            "layout": "quilt",
            "light": "on",
            "zoom": float("nan"),
            "orbit": 3,
            "progress": "bar",
            "threads": -1,
            "min_psnr": "high",
            "focus": 3,
        }.items():
            options = {"display": grid, "frame": 0, name: value}
            self.assertWrong(name, lippmann.render, "room", **options)
        self.assertWrong("frames", lippmann.frames, "room", grid, frames=[480])
        self.assertWrong("size", lippmann.camera_grid, size=(0, 3))
        self.assertWrong("size", lippmann.camera_grid, size=(3, 3, 3))
        self.assertWrong("size", lippmann.camera_grid, size=(30000, 30000))
        self.assertWrong("rows", lippmann.camera_grid, rows=0)
        self.assertWrong("baseline_mm", lippmann.camera_grid, baseline_mm=0)
        self.assertWrong("gap_mm", lippmann.lenticular_sheet, gap_mm=float("inf"))
        self.assertWrong("center", lippmann.Scene().add_sphere, (0, 0))
        self.assertWrong("radius", lippmann.Scene().add_sphere, radius=0)
        self.assertWrong("upper", lippmann.Scene().add_box, (0, 0, 0), (1, 0, 1))
        self.assertWrong("apex", lippmann.Scene().add_cylinder, (0, 0, 0), (0, 0, 0), 1)
        self.assertWrong("kind", lippmann.Scene().add_light, "area")
        self.assertWrong("radius", lippmann.Scene().add_light, "directional", radius=1)
        self.assertWrong("radius", lippmann.Scene().add_light, "point", radius=-1)
        self.assertWrong("angular_diameter_deg", lippmann.Scene().add_light, "spot", angular_diameter_deg=1)
        self.assertWrong("target", lippmann.Scene().add_camera, (0, 0, 0), (0, 0, 0))
        self.assertWrong("name", lippmann.Scene, "a\udc80b")
        self.assertWrong("name", lippmann.Scene().add_sphere, name=3)
        self.assertWrong("frames", lippmann.Scene, frames=0)

    def test_missing_data_of_light_fields_is_named(self):
        field = lippmann.render("room", small_grid())
        self.assertWrong("depth", lambda: field.depth)
        self.assertWrong("layers", lambda: field.normals)
        self.assertWrong("z_mm", field.refocus, float("nan"))
        self.assertWrong("size", field.refocus, 0, (0, 5))
        self.assertWrong("size", field.eye, size=(100000, 5))
        self.assertWrong("x", field.eye, x="left")
        self.assertWrong("z", field.eye, z=-5)
        with self.assertRaises(lippmann.Error):
            field.refocus(z_mm=1000)  # this plane is behind the viewer
        self.assertWrong("row", field.epi)
        self.assertWrong("row", field.epi, row=5000)
        self.assertWrong("format", field.save, self.folder / "x", "hcj")
        self.assertWrong("bits", field.save, self.folder / "x", "views", bits=9)
        self.assertWrong("path", field.save, "a\0b")
        with self.assertRaises(lippmann.Error):
            field.save(self.folder / "x.gif")
        (self.folder / "file").touch()
        with self.assertRaises(lippmann.Error):
            field.save(self.folder / "file/x.png")
        bare = lippmann.LightField(np.zeros((2, 2, 4, 4, 3), np.uint8))
        self.assertWrong("cameras", lambda: bare.eyes_mm)
        self.assertWrong("layer", lambda: bare.normals)
        self.assertWrong("layer", bare.panel_layer, "depth")
        self.assertWrong("name", bare.layer, "deph")
        self.assertWrong("name", bare.panel_layer, "deph")
        self.assertWrong("depth", bare.layer, "depth")
        for property_name in ("world_from_display", "units_per_mm"):
            self.assertWrong("scene", getattr, bare, property_name)

    def test_opened_light_fields_have_only_depth(self):
        depth = np.random.default_rng(1).random((2, 2, 4, 4), np.float32)
        field = lippmann.LightField(np.zeros((2, 2, 4, 4, 3), np.uint8), depth)
        self.assertSame(field.layer("depth"), depth[..., None])
        self.assertNotIn("depth", self.assertWrong("layer", field.layer, "normal").accepted)
        self.assertNotIn("depth", self.assertWrong("layer", field.panel_layer, "depth").accepted)
        rendered = lippmann.render("room", small_grid(), layers=["depth"])
        self.assertSame(rendered.layer("depth"), rendered.depth[..., None])

    def test_invalid_files_are_named(self):
        self.assertWrong("name", lippmann.load, 3)
        self.assertWrong("scene", lippmann.render, 3)
        for name in ("rom", "nowhere.glb", "", "a\0b.glb"):
            with self.assertRaises(lippmann.Error):
                lippmann.load(name)
        broken = self.folder / "broken.glb"
        broken.write_bytes(b"glTF" + bytes(40))
        with self.assertRaises(lippmann.Error) as caught:
            lippmann.load(broken)
        self.assertIn("broken.glb", str(caught.exception))
        odd = self.folder / os.fsdecode(b"\xff\xfe.glb")
        odd.write_bytes(b"glTF")
        with self.assertRaises(lippmann.Error):
            lippmann.load(odd)
        for path in (self.folder / "nothing", self.folder, broken):
            with self.assertRaises(lippmann.Error):
                lippmann.open(path)
        (self.folder / "p.json").write_text("{")
        with self.assertRaises(lippmann.Error):
            lippmann.render("room", self.folder / "p.json")
        with self.assertRaises(lippmann.Error):
            lippmann.display_from_toml("kind = 3")

    def test_empty_scenes_are_refused_flat_ones_warn(self):
        self.assertWrong("scene", lippmann.render, lippmann.Scene(), small_grid(1, 1, (8, 8)), spp=1)
        lamp = lippmann.Scene()
        lamp.add_light()
        self.assertWrong("scene", lippmann.render, lamp.copy(), small_grid(1, 1, (8, 8)), spp=1)
        lamp.set_background((1, 1, 1))
        self.assertEqual(lippmann.render(lamp, small_grid(1, 1, (8, 8)), spp=1).views.max(), 1)
        around = lippmann.render(lippmann.Scene(), small_grid(1, 1, (8, 8)), spp=1, environment=(0.5, 0.5, 0.5))
        self.assertEqual(around.views.max(), 0.5)
        point = lippmann.Scene()
        point.set_background((1, 1, 1))
        point.add_mesh(np.ones((3, 3)), [[0, 1, 2]])
        with self.assertWarnsRegex(lippmann.LippmannWarning, "all triangles of the scene have area 0"):
            lippmann.render(point, small_grid(1, 1, (8, 8)), spp=1)
        opened = lippmann.Scene()
        opened.add_mesh(np.zeros((3, 3)), [[0, 1, 2]], targets=[[[0, 0, 0], [1, 0, 0], [0, 1, 0]]], weights=[1])
        opened.place_display(height=2, viewing_distance=20)
        self.assertGreater(lippmann.render(opened, small_grid(1, 1, (8, 8)), layers=["depth"], spp=1).depth.max(), -np.inf)
        sky = self.folder / "sky.dat"
        sky.write_text("BEGIN_SCENE\nRESOLUTION 8 8\nBACKGROUND 0.5 0.5 0.5\nEND_SCENE\n")
        self.assertTrue(np.isfinite(lippmann.render(sky, small_grid(1, 1, (8, 8)), spp=1).views).all())
        scene = lippmann.Scene()
        scene.add_mesh(np.zeros((3, 3)), [[0, 1, 2]], scale=(0, 0, 0))
        try:
            self.assertTrue(np.isfinite(lippmann.render(scene, small_grid(1, 1, (8, 8)), spp=1).views).all())
        except lippmann.Error as error:
            self.assertTrue(error.problem)

    def test_exceptions_of_callbacks_stop_the_render(self):
        class Own(Exception):
            pass

        calls = []

        def stop(frame, share):
            calls.append(share)
            raise Own("enough")

        animation = lippmann.frames("room", small_grid(3, 3, (400, 400)), spp=16, progress=stop)
        with self.assertRaisesRegex(Own, "enough"):
            animation[0]
        self.assertEqual(len(calls), 1)
        self.assertWrong("frames", lambda: animation[1])
        self.assertEqual(lippmann.render("room", small_grid()).shape[0], 2)

    def test_threads_cannot_share_an_animation(self):
        started, errors = threading.Event(), []
        animation = lippmann.frames(
            "room", small_grid(3, 3, (200, 200)), spp=16, progress=lambda frame, share: started.set()
        )

        def render():
            animation[0]

        thread = threading.Thread(target=render)
        thread.start()
        started.wait()
        try:
            animation[1]
        except lippmann.Error as error:
            errors.append(error.where)
        thread.join()
        self.assertEqual(errors, ["thread"])

    def test_negative_background_colours_are_refused(self):
        scene = lippmann.Scene()
        self.assertWrong("horizon", scene.set_background, (-1, -1, -1))
        self.assertWrong("horizon", scene.set_background, (0, -1e-9, 0), (1, 1, 1))
        self.assertWrong("zenith", scene.set_background, (0, 0, 0), (1, 1, -1))
        scene.set_background((0, 0, 0), (4, 4, 4))

    def test_invalid_layers_are_named(self):
        for layers in (3, None, 2.5):
            self.assertWrong("layers", lippmann.render, "room", small_grid(), layers=layers)
        self.assertWrong("layers", lippmann.render, "room", small_grid(), layers=[3])

    def test_textures_without_uvs_warn(self):
        material = lippmann.Material(texture=np.zeros((2, 2, 3), np.uint8))
        scene = lippmann.Scene()
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            scene.add_mesh(QUAD, FACES, uvs=np.zeros((4, 2)), material=material)
            scene.add_mesh(QUAD, FACES, material=lippmann.Material())
            lippmann.random_scene(1, objects=40)
        for add in (lambda: scene.add_mesh(QUAD, FACES, material=material), lambda: scene.add_sphere(material=material)):
            with self.assertWarnsRegex(lippmann.LippmannWarning, "texture") as caught:
                add()
            self.assertEqual(caught.filename, __file__)

    def test_errors_use_python_argument_names(self):
        grid, lenses = small_grid(), lippmann.lenticular_sheet((16, 32))

        def refused(name, display=grid, **options):
            options.setdefault("spp", 4)
            return self.assertWrong(name, lippmann.render, "room", display, **options).accepted

        self.assertIn("`spp`", refused("aperture_mm", spp=1, aperture_mm=4))
        self.assertIn("camera_grid()", refused("aperture_mm", lenses, aperture_mm=4))
        self.assertIn("quilt()", refused("f_number", lenses, f_number=4))
        refused("f_number", f_number=4, aperture_mm=4)
        self.assertIn("`aperture_mm` or `f_number`", refused("focal_plane_mm", focal_plane_mm=4))
        refused("layers", layers=["direct"], integrator="whitted")
        refused("layers", layers=["depth"], reuse="interpolate")
        refused("fit_to", fit_to="nobody")
        refused("focus", focus="nobody")
        refused("display", "portrat")
        self.assertIn("displays()", self.assertWrong("name", lippmann.display, "portrat").accepted)
        self.assertWrong("toml: kind", lippmann.display_from_toml, "kind = 3")
        self.assertWrong("camera_path", lippmann.load, "room", camera_path="room.cam")
        self.assertWrong("lens_pitch_mm", lippmann.lenticular_sheet, lens_pitch_mm=0.01)
        self.assertWrong("gap_mm", lippmann.microlens_array, gap_mm=1e-9)
        self.assertWrong("baseline_mm", lippmann.camera_grid, baseline_mm=1e-9)
        self.assertWrong("pixel_mm", lippmann.single_view, pixel_mm=1e-9)

        field = lippmann.render("room", small_grid(2, 3, (8, 8)))
        self.assertWrong("focus_mm", field.eye, pupil_mm=4, focus_mm=1000)
        self.assertWrong("x", field.eye, x=1e10)
        self.assertWrong("column", field.epi, column=8)
        row = lippmann.render("room", small_grid(1, 3, (8, 8)))
        self.assertIn("`row`", self.assertWrong("column", row.epi, column=3).accepted)

    def test_file_errors_use_python_names_and_order(self):
        def path(name):
            return self.folder / name

        field = lippmann.render("room", small_grid(2, 3, (8, 8)))
        error = self.assertWrong("tiles", field.save, path("q.png"), "quilt", tiles=(4, 5))
        self.assertIn("(4, 5) tiles", error.problem)
        error = self.assertWrong("format", field.save, path("s.png"), "stereo")
        self.assertIn("(2, 3)", error.problem)
        self.assertNotIn("keep", error.accepted)
        self.assertWrong("format", field.save, path("n.png"), "native", display=SMALL_PANEL)
        self.assertWrong("display", field.save, path("n.png"), "native")
        self.assertWrong("format", lippmann.LightField(np.zeros((1, 2, 4, 4, 3))).save, path("r.png"), "rgbd")

        os.rename(field.save(path("q.png"), "quilt")[0], path("q.png"))
        self.assertWrong("format", lippmann.open, path("q.png"))
        self.assertIn("such as (6, 8)", self.assertWrong("tiles", lippmann.open, path("q.png"), format="quilt").accepted)
        self.assertWrong("path", lippmann.open, path("q.png"), format="stereo")
        native = {"format": "native", "display": SMALL_PANEL, "views": (2, 3)}
        self.assertEqual(self.assertWrong("views", lippmann.open, path("q.png"), **native).accepted, "(1, N)")
        field.save(path("2x3"), "hci")
        os.remove(path("2x3") / "parameters.cfg")
        error = self.assertWrong("views", lippmann.open, path("2x3"))
        self.assertEqual(error.accepted, "(rows, columns), such as (1, 9)")
        error = self.assertWrong(str(path("2x3")), lippmann.open, path("2x3"), format="hci", views=(4, 1))
        self.assertIn("not (4, 1)", error.problem)
        self.assertEqual(lippmann.open(path("2x3"), views=(2, 3)).shape, (2, 3, 8, 8, 3))

    def test_file_names_like_arguments_are_kept(self):
        here = os.getcwd()
        self.addCleanup(os.chdir, here)
        os.chdir(self.folder)
        for name in ("quilt", "to", "aperture", "2x3"):
            self.assertWrong(name, lippmann.open, name)
            self.assertWrong(name, lippmann.load, name)
            os.mkdir(name)
            self.assertWrong(name, lippmann.open, name, format="hci")
        lippmann.LightField(np.zeros((2, 3, 4, 4, 3))).save("2x3", "views")
        error = self.assertWrong("views", lippmann.open, "2x3", views=(4, 1))
        self.assertTrue(error.problem.startswith("(4, 1)") and error.problem.endswith(" in 2x3"), error.problem)

    def assertIgnored(self, names, function, *arguments, **named):
        """Expects one LippmannWarning for each argument in `names`, with the caller's file as its source."""
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            function(*arguments, **named)
        self.assertEqual([str(w.message).split(" is ignored: ")[0] for w in caught], [f"`{name}`" for name in names])
        for warning in caught:
            self.assertEqual((warning.category, warning.filename), (lippmann.LippmannWarning, __file__))

    def test_ignored_arguments_warn(self):
        def render(**options):
            return lippmann.render("room", small_grid(1, 1, (8, 8)), **options)

        self.assertIgnored(["environment_strength"], render, environment_strength=2)
        self.assertIgnored(["environment_rotation_deg"], render, environment_rotation_deg=90)
        self.assertIgnored([], render, environment=(1, 1, 1), environment_strength=2, environment_rotation_deg=90)
        self.assertIgnored(["keyframes"], render, keyframes=4, integrator="path")
        self.assertIgnored(["keyframes"], render, keyframes=4, layers=["depth"])
        self.assertIgnored([], render, keyframes=4, min_psnr=30)
        add = lippmann.Scene().add_light
        self.assertIgnored(["target"], add, "point", target=(0, 0, 1))
        self.assertIgnored(["direction", "outer_cone_deg"], add, "point", direction=(0, 0, 1), outer_cone_deg=30)
        self.assertIgnored(["inner_cone_deg", "range"], add, "directional", inner_cone_deg=3, range=4)
        self.assertIgnored([], add, "spot", target=(0, 0, 1), inner_cone_deg=3, outer_cone_deg=30, range=4)
        field = lippmann.render("room", small_grid(1, 2, (8, 8)), layers=["depth"])
        self.assertIgnored(["focus_mm"], field.eye, focus_mm=10)
        self.assertIgnored([], field.eye, focus_mm=10, pupil_mm=4)
        plain = lippmann.render("room", small_grid(1, 2, (8, 8)))
        self.assertIgnored(["tiles"], plain.save, self.folder / "views", "views", tiles=(1, 2))
        self.assertIgnored(["display"], field.save, self.folder / "hci", "hci", display=SMALL_PANEL)
        self.assertIgnored(["bits", "tiles"], field.save, self.folder / "x.png", bits=16, tiles=(1, 2))
        self.assertIgnored([], plain.save, self.folder / "quilt.png", "quilt", tiles=(2, 1), bits=16)
        self.assertIgnored(["tiles", "display"], lippmann.open, self.folder / "views", tiles=(1, 2), display=SMALL_PANEL)

    def test_ignored_arguments_are_checked(self):
        nan = float("nan")
        for name in ("environment_strength", "environment_rotation_deg", "keyframes", "min_psnr"):
            self.assertWrong(name, lippmann.render, "room", small_grid(), **{name: nan})
        self.assertWrong("target", lippmann.Scene().add_light, "point", target=(0, nan, 0))
        field = lippmann.render("room", small_grid(1, 1, (8, 8)))
        self.assertWrong("tiles", field.save, self.folder / "x.png", tiles=(nan, 1))
        self.assertWrong("focus_mm", field.eye, focus_mm=nan)

    def test_unused_keyframes_and_min_psnr_are_refused(self):
        for name, value, reuse, more in (
            ("keyframes", 4, "none", {}),
            ("keyframes", 4, "none", {"integrator": "path"}),
            ("min_psnr", 40, "none", {}),
            ("min_psnr", 40, "none", {"integrator": "path"}),
            ("min_psnr", 40, "auto", {"integrator": "path"}),
        ):
            self.assertWrong(name, lippmann.render, "room", small_grid(), reuse=reuse, **{name: value}, **more)
            words = [f"--{option}={text}" for option, text in more.items()]
            done = subprocess.run(
                [TOOL, "render", "room", f"--reuse={reuse}", "--" + name.replace("_", "-"), str(value), *words, "-o", "out"],
                cwd=self.folder, capture_output=True, text=True)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(name.replace("_", "-"), done.stderr)

    def test_removed_arguments_name_their_replacement(self):
        error = self.assertWrong("reuse", lippmann.render, "room", small_grid(), reuse="light", integrator="path")
        self.assertIn("denoise='auto'", error.accepted)
        error = self.assertWrong("min_psnr", lippmann.render, "room", small_grid(), min_psnr=40, integrator="path")
        self.assertIn("spp", error.accepted)

    def test_explicit_denoising_needs_paths(self):
        self.assertWrong("denoise", lippmann.render, "room", small_grid(), denoise=True)
        self.assertWrong("denoise", lippmann.render, "room", small_grid(), denoise="some")

    def test_invalid_utf_8_becomes_replacement_characters(self):
        where = os.fsencode(self.folder) + b"/d\xff"
        os.mkdir(where)
        with open(where + b"/m\xfe.obj", "wb") as file:
            file.write(b"o o\xfd\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        scene = lippmann.load(where + b"/m\xfe.obj")
        self.assertEqual(scene.name, "m\ufffd")
        self.assertIn("m\ufffd", repr(scene))
        self.assertIn("m\ufffd", str(scene.copy()))
        self.assertEqual(lippmann.render(scene, small_grid(1, 1, (8, 8)), spp=1).shape, (1, 1, 8, 8, 3))
        with open(where + b"/dd\xfe.toml", "wb") as file:
            file.write(SMALL_PANEL.read_bytes())
        display = lippmann.display(where + b"/dd\xfe.toml")
        self.assertEqual(display.name, "dd\ufffd")
        self.assertIn("dd\ufffd", repr(display))

    def test_displays_optics_and_animations_have_a_repr(self):
        text = repr(lippmann.display("looking-glass-portrait"))
        self.assertEqual(text, "<lippmann.Display 'looking-glass-portrait': slanted-panel, 1536x2048 pixels>")
        text = repr(lippmann.camera_grid(2, 3, (24, 32)))
        self.assertEqual(text, "<lippmann.Optics: 2 x 3 views (rows x columns), 96x48 pixels>")
        for optics, words in (
            (lippmann.lenticular_sheet((24, 32)), "a lenticular sheet, 32x24 pixels"),
            (lippmann.microlens_array((24, 32)), "a microlens array, 32x24 pixels"),
            (lippmann.single_view((24, 32)), "a single view, 32x24 pixels"),
            (lippmann.quilt(2, 3, (24, 32)), "6 views, 96x48 pixels"),
            (lippmann.own_optics(lippmann.single_view((24, 32)).rays, (24, 32)), "custom rays, 32x24 pixels"),
        ):
            self.assertEqual(repr(optics), f"<lippmann.Optics: {words}>")
        self.assertEqual(repr(lippmann.frames("room", small_grid(), frames=range(3))), "<lippmann.Animation: 3 frames>")
        self.assertEqual(repr(lippmann.frames("room", small_grid(), frames=[7])), "<lippmann.Animation: 1 frame>")

    def test_warnings_can_become_errors(self):
        # the OBJ file names a missing material library
        scene = self.folder / "scene.obj"
        scene.write_text("mtllib nowhere.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            lippmann.load(scene)
        self.assertTrue(caught, "there was no warning")
        self.assertTrue(issubclass(caught[0].category, lippmann.LippmannWarning))
        self.assertIn("nowhere.mtl", str(caught[0].message))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with self.assertRaises(lippmann.LippmannWarning):
                lippmann.load(scene)

    def test_core_functions_called_with_nonsense_raise(self):
        core = lippmann._core
        for function in (core.load_scene, core.place, core.Frames, core.open_light_field, core.views, core.Views):
            with self.assertRaises(TypeError):
                function()
        with self.assertRaises(lippmann.Error):
            core.Views(np.zeros((2, 2)), None)
        scene = core.Scene("x", 1, 25.0)
        scene.add_instance("i", 7, 9, 3)
        with self.assertRaises(lippmann.Error):
            scene.check()
        with self.assertRaises(lippmann.Error):
            core.Scene("x", 1, 25.0).add_mesh(np.zeros((3, 2)), np.zeros((1, 3), np.uint32), None, None, None)

    def test_unknown_formats_name_arguments_of_python(self):
        field = lippmann.LightField(np.zeros((1, 2, 4, 4, 3), np.float32))
        for name, accepted in (
            ("plain.png", "a format, such as format='integral', views=(1, 8) or format='native', display='portrait', or a name such as room_qs8x6a0.75.png"),
            ("room_qs2x1.png", "format='quilt', tiles=(1, 2), or a name such as room_qs8x6a0.75.png"),
        ):
            (picture,) = field.save(self.folder / name)
            with self.assertRaises(lippmann.Error) as raised:
                lippmann.open(picture)
            self.assertEqual(raised.exception.accepted, accepted)
