"""Tests transparency, environment light, cameras, texture memory and crosstalk."""

import warnings

import numpy as np

import lippmann
from support import Case, DESK, SMALL_PANEL, small_grid, tool

QUAD = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]
FACES = [[0, 1, 2], [0, 2, 3]]


def ball(color=(0.5, 0.25, 1.0), **more):
    scene = lippmann.Scene()
    scene.add_sphere((0, 0, 0), 0.5, material=lippmann.Material(color, unlit=True, **more))
    scene.place_display(height=2, viewing_distance=20)
    return scene


def write_splats(path):
    names = "x y z f_dc_0 f_dc_1 f_dc_2 opacity scale_0 scale_1 scale_2 rot_0 rot_1 rot_2 rot_3".split()
    header = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n" + "".join(f"property float {n}\n" for n in names)
    rows = [[x, 0, 0, 1, x, 0, 2, -1, -1, -1, 1, 0, 0, 0] for x in (-0.5, 0, 0.5)]
    path.write_bytes(header.encode() + b"end_header\n" + np.array(rows, "<f4").tobytes())


class Splats(Case):
    def test_files_of_splats_are_rendered_without_paths(self):
        write_splats(self.folder / "cloud.ply")
        scene = lippmann.load(self.folder / "cloud.ply")
        default = lippmann.render(scene, small_grid(1, 2), fit_depth=False).codes
        self.assertSame(default, lippmann.render(scene, small_grid(1, 2), fit_depth=False, integrator="whitted", spp=4).codes)
        self.assertFalse(np.array_equal(default, lippmann.render(scene, small_grid(1, 2), fit_depth=False, integrator="whitted").codes))
        self.assertGreater(int(default.max()), 100)
        tool("render", "cloud.ply", "--optics", "single", "--size", "32x32", "--frames", "0", "-o", "out", "-q", cwd=self.folder)
        self.assertIn("spp = 4", (self.folder / "out/job.toml").read_text())


class Transparency(Case):
    def rendered(self, scene=None, **options):
        options.setdefault("spp", 4)
        grid = small_grid(1, 2, (32, 32), baseline_mm=2)
        return lippmann.render(scene or ball(), grid, transparent=True, light="none", fit_depth=False, **options)

    def test_alpha_is_0_outside_objects(self):
        field = self.rendered(environment=(3, 3, 3))
        self.assertEqual(field.alpha.shape, (1, 2, 32, 32))
        self.assertEqual(field.alpha.dtype, np.float32)
        self.assertEqual((field.alpha[0, 0, 16, 16], field.alpha[0, 0, 0, 0]), (1, 0))
        self.assertEqual(field.views[0, 0, 0, 0].max(), 0)
        # The ball with the radius 0.5 covers the area pi * 0.5^2. The view covers 2 * 2 = 4.
        self.assertAlmostEqual(float(field.alpha.mean()), np.pi * 0.5**2 / 4, delta=0.01)

    def test_alpha_one_half_covers_one_half(self):
        scene = lippmann.Scene()
        scene.add_mesh(QUAD, FACES, material=lippmann.Material(alpha=0.5, unlit=True))
        scene.place_display(height=4, viewing_distance=20)
        field = self.rendered(scene, integrator="path", spp=256)
        self.assertAlmostEqual(float(field.alpha[0, 0, 12:20, 12:20].mean()), 0.5, delta=0.02)

    def test_composited_views_equal_rendered_backgrounds(self):
        field = self.rendered()
        scene = ball()
        scene.set_background((0.25, 0.5, 0.75))
        grid = small_grid(1, 2, (32, 32), baseline_mm=2)
        before = lippmann.render(scene, grid, light="none", fit_depth=False, spp=4).views
        over = field.views + (1 - field.alpha[..., None]) * np.float32((0.25, 0.5, 0.75))
        np.testing.assert_allclose(over, before, atol=1e-5)

    def test_rgba_has_straight_colours(self):
        field = self.rendered()
        self.assertEqual(field.rgba.shape, (1, 2, 32, 32, 4))
        # The sRGB codes 188, 137 and 255 stand for the linear values 0.5, 0.25 and 1.
        self.assertEqual(field.rgba[0, 0, 16, 16].tolist(), [188, 137, 255, 255])
        edge = (field.alpha > 0.1) & (field.alpha < 0.9)
        self.assertGreater(edge.sum(), 10)
        np.testing.assert_allclose(field.rgba[edge][:, :3] - [188.0, 137.0, 255.0], 0, atol=1)
        self.assertSame(field.codes, np.concatenate(list(field.rgba[0]), axis=1))

    def test_the_picture_file_is_the_tools(self):
        tool("render", DESK, "--display", SMALL_PANEL, "--frames", "3", "--spp", "4", "--transparent", "-o", self.folder / "tool")
        (picture,) = (self.folder / "tool").glob("*.png")
        lippmann.render(DESK, SMALL_PANEL, frame=3, spp=4, transparent=True).save(self.folder / "own.png")
        self.assertEqual(picture.read_bytes()[25], 6)  # byte 25 of a PNG file is its colour type; 6 is RGBA
        self.assertEqual((self.folder / "own.png").read_bytes(), picture.read_bytes())

    def test_outputs_without_alpha_are_refused(self):
        field = self.rendered()
        self.assertWrong("format", field.save, self.folder / "hci", "hci")
        self.assertWrong("path", field.save, self.folder / "picture.exr")
        self.assertWrong("alpha", lambda: lippmann.render("room", small_grid()).alpha)
        self.assertWrong("alpha", lambda: lippmann.LightField(np.zeros((1, 2, 4, 4, 3))).rgba)
        self.assertWrong("transparent", lippmann.render, "room", SMALL_PANEL, layout="native", transparent=True)


class Blur(Case):
    def alpha(self, **options):
        options.setdefault("spp", 64)
        grid = small_grid(1, 2, (32, 32), baseline_mm=2)
        return lippmann.render(ball(), grid, transparent=True, light="none", fit_depth=False, **options).alpha

    def test_a_lens_blurs_edges_and_keeps_coverage(self):
        def soft(alpha):
            return int(((alpha > 0.02) & (alpha < 0.98)).sum())

        sharp, focused = self.alpha(), self.alpha(aperture_mm=40)
        blurred = self.alpha(aperture_mm=40, focal_plane_mm=100)
        # the ball is in the focal plane
        self.assertLess(soft(focused), 1.5 * soft(sharp))
        self.assertGreater(soft(blurred), 2 * soft(sharp))
        self.assertAlmostEqual(float(blurred.mean()), float(sharp.mean()), delta=0.01)

    def test_unsupported_blur_is_refused(self):
        for name, value in (("aperture_mm", -1), ("f_number", -1), ("shutter", 1.5)):
            with self.assertRaisesRegex(lippmann.Error, name):
                self.alpha(**{name: value})
        with self.assertRaisesRegex(lippmann.Error, "spp"):
            self.alpha(aperture_mm=4, spp=1)


class Surroundings(Case):
    def seen(self, **options):
        return lippmann.render(ball(), small_grid(1, 1, (16, 16)), spp=1, **options).views[0, 0, 0, 0]

    def test_arrays_and_colours_are_backgrounds(self):
        np.testing.assert_allclose(self.seen(environment=(0.25, 0.5, 1), environment_strength=2), (0.5, 1, 2), rtol=1e-6)
        np.testing.assert_allclose(self.seen(environment=np.full((4, 8, 3), 0.25)), 0.25, rtol=1e-6)

    def test_files_equal_their_arrays(self):
        panorama = np.random.default_rng(2).random((8, 16, 3)).astype(np.float16).astype(np.float32)
        path = self.folder / "Himmel über Köln.exr"
        lippmann._core.write_picture(panorama, path)
        grid = small_grid(1, 1, (16, 16))
        scene = lippmann.Scene()
        scene.set_environment(path, rotation_deg=30)
        scene.place_display(height=2)
        turned = {"environment_rotation_deg": 30, "spp": 1}
        fields = [lippmann.render(ball(), grid, environment=light, **turned) for light in (path, panorama)]
        self.assertSame(fields[0].views, fields[1].views)
        self.assertFalse(np.array_equal(lippmann.render(ball(), grid, environment=path, spp=1).views, fields[0].views))
        self.assertTrue(np.isfinite(lippmann.render(scene, grid, spp=1).views).all())

    def test_invalid_panoramas_are_named(self):
        self.assertWrong("environment", self.seen, environment=self.folder / "missing.exr")
        self.assertWrong("environment", self.seen, environment=np.zeros((4, 8)))
        self.assertWrong("environment", self.seen, environment=np.full((4, 8, 3), -1.0))
        self.assertWrong("environment", self.seen, environment=(1, float("nan"), 0))
        self.assertWrong("environment_strength", self.seen, environment=(1, 1, 1), environment_strength=-1)
        codes = self.folder / "codes.png"
        lippmann._core.write_picture(np.zeros((4, 8, 3), np.float32), codes)
        with self.assertRaisesRegex(lippmann.Error, "linear light"):
            self.seen(environment=codes)


class Cameras(Case):
    def scene(self):
        scene = lippmann.Scene()
        for x, color in ((0, (1, 0, 0)), (100, (0, 1, 0))):
            scene.add_sphere((x, 0, 0), 1, material=lippmann.Material(color, unlit=True))
        scene.add_camera((0, 0, 10), target=(0, 0, 0), name="1")
        scene.add_camera((100, 0, 10), target=(100, 0, 0), name="side")
        return scene

    def color(self, scene, **options):
        field = lippmann.render(scene, small_grid(1, 1, (16, 16)), light="none", spp=1, **options)
        return field.views[0, 0, 8, 8].tolist()

    def test_cameras_have_names_and_indices(self):
        scene = self.scene()
        self.assertEqual(scene.cameras, ("1", "side"))
        self.assertEqual(self.color(scene), [1, 0, 0])
        self.assertEqual(self.color(scene, camera="side"), [0, 1, 0])
        self.assertEqual(self.color(scene, camera=1), [0, 1, 0])
        self.assertEqual(self.color(scene, camera="1"), [1, 0, 0])  # a name takes precedence over an index
        self.assertEqual(scene.cameras, ("1", "side"))
        scene.choose_camera("side")
        self.assertEqual((scene.cameras, self.color(scene)), (("side", "1"), [0, 1, 0]))

    def test_unknown_cameras_are_refused_with_the_list(self):
        error = self.assertWrong("camera", self.color, self.scene(), camera="sied")
        self.assertIn("side (1)", error.accepted)
        self.assertWrong("camera", self.color, self.scene(), camera=2)
        self.assertWrong("camera", self.color, self.scene(), camera=1.5)
        self.assertWrong("camera", self.color, ball(), camera=0)


class Textures(Case):
    def test_textures_are_halved_until_they_fit(self):
        for name in ("white", "black"):
            lippmann._core.write_picture(np.full((512, 512, 3), name == "white", np.float32), self.folder / f"{name}.png")
        (self.folder / "quad.mtl").write_text("newmtl white\nmap_Kd white.png\nnewmtl black\nmap_Kd black.png\n")
        vertices = "".join("v %g %g %g\n" % tuple(p) for p in QUAD)
        obj = self.folder / "quad.obj"
        obj.write_text(f"mtllib quad.mtl\n{vertices}vt 0 0\nvt 1 0\nvt 1 1\nusemtl white\nf 1/1 2/2 3/3\nusemtl black\nf 1/1 3/3 2/2\n")
        with self.assertWarnsRegex(lippmann.LippmannWarning, "resolution"):
            lippmann.load(obj, texture_memory_mb=1)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            lippmann.load(obj, texture_memory_mb=2)
        self.assertWrong("texture_memory_mb", lippmann.load, obj, texture_memory_mb=0)


class Crosstalk(Case):
    def field(self):
        views = np.zeros((1, 5, 8, 8, 3), np.float32)
        views[0, 2] = 1
        return lippmann.LightField(views, distance_mm=100, baseline_mm=2, pixel_mm=1)

    def test_each_neighbour_has_its_share(self):
        field = self.field()
        # The middle view is white, the others are black. An eye sees 80 % of its view and 10 % of each neighbour.
        self.assertAlmostEqual(float(field.eye(x=0)[4, 4, 0]), 1, places=5)
        self.assertAlmostEqual(float(field.eye(x=0, crosstalk="10%")[4, 4, 0]), 0.8, delta=0.01)
        self.assertAlmostEqual(float(field.eye(x=2, crosstalk="10%")[4, 4, 0]), 0.1, delta=0.005)
        self.assertSame(field.eye(x=0, crosstalk=0.0), field.eye(x=0))

    def test_crosstalk_equals_the_tools(self):
        tool("render", "room", "--display", SMALL_PANEL, "--frames", "9", "--format", "exr", "--exr-pixels", "float",
             "-o", self.folder / "tool")
        tool("replay", self.folder / "tool", "--eye", "20,0,400", "--crosstalk", "0.5", "-o", self.folder / "eyes")
        field = lippmann.render("room", SMALL_PANEL, frame=9)
        lippmann._core.write_picture(field.eye(20, 0, 400, crosstalk=0.5), self.folder / "own.png")
        self.assertEqual((self.folder / "own.png").read_bytes(), (self.folder / "eyes/eye_0009.png").read_bytes())

    def test_invalid_values_are_named(self):
        for crosstalk in (-1, 9, float("nan"), "30%", "much"):
            self.assertWrong("crosstalk", self.field().eye, crosstalk=crosstalk)

    def test_displays_have_a_crosstalk(self):
        panel = self.folder / "panel.toml"
        text = SMALL_PANEL.read_text()
        panel.write_text(text.replace("dpi = 491", "dpi = 491\ncrosstalk = 0.4"))
        self.assertEqual(lippmann.display(panel).crosstalk_px, 0.4)
        self.assertIsNone(lippmann.display(SMALL_PANEL).crosstalk_px)
