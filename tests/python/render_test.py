"""Tests that frames equal the tool's files, and tests sequences and layers."""

import threading

import numpy as np

import lippmann
from support import Case, DESK, SMALL_PANEL, small_grid, tool


class Render(Case):
    def assertSameFile(self, one, other):
        self.assertEqual(one.read_bytes(), other.read_bytes())

    def test_a_quilt_equals_the_tools(self):
        tool("render", DESK, "--display", SMALL_PANEL, "--frames", "3", "--spp", "4", "-o", self.folder / "tool")
        field = lippmann.render(DESK, SMALL_PANEL, frame=3, spp=4)
        field.save(self.folder / "own.png")
        self.assertSameFile(self.folder / "own.png", self.folder / "tool/frame_0003_qs4x2a0.5625.png")
        self.assertEqual(field.views.shape, (1, 8, 112, 64, 3))

    def test_whitted_frames_equal_the_tools(self):
        tool("render", "gears", "--display", SMALL_PANEL, "--frames", "4-7", "-o", self.folder / "tool")
        for field in lippmann.frames("gears", SMALL_PANEL, frames=range(4, 8)):
            field.save(self.folder / "own.png")
            name = f"frame_{field.report['frame']:04}_qs4x2a0.5625.png"
            self.assertSameFile(self.folder / "own.png", self.folder / "tool" / name)

    def test_a_native_frame_equals_the_tools(self):
        panel = self.folder / "panel.toml"
        panel.write_text(SMALL_PANEL.read_text().replace("[1440, 2560]", "[90, 160]").replace("dpi = 491", "dpi = 60"))
        tool("render", "room", "--display", panel, "--layout", "native", "--frames", "9", "-o", self.folder / "tool")
        field = lippmann.render("room", panel, frame=9, layout="native", layers=["depth"])
        self.assertEqual(field.codes.shape, (160, 90, 3))
        self.assertEqual(field.panel_layer("depth").shape, (160, 90, 1))
        field.save(self.folder / "own.png")
        self.assertSameFile(self.folder / "own.png", self.folder / "tool/frame_0009.png")
        # lenses that are not a whole number of pixels wide have no views
        self.assertWrong("optics", lambda: field.views)
        self.assertIn("160", repr(field))
        self.assertEqual(field.eye(size=(16, 9)).shape, (16, 9, 3))

    def test_eyes_and_refocused_pictures_equal_replay(self):
        tool("render", "room", "--display", SMALL_PANEL, "--frames", "9", "--format", "exr", "--exr-pixels", "float",
             "-o", self.folder / "tool")
        tool("replay", self.folder / "tool", "--eye", "20,0,400", "-o", self.folder / "eyes")
        tool("replay", self.folder / "tool", "--refocus", "5", "-o", self.folder / "eyes")
        field = lippmann.render("room", SMALL_PANEL, frame=9)
        for picture, name in ((field.eye(20, 0, 400), "eye_0009.png"), (field.refocus(5), "refocus_0009.png")):
            own = self.folder / name
            lippmann._core.write_picture(picture, str(own))
            self.assertSameFile(own, self.folder / "eyes" / name)

    def test_frames_render_in_any_order(self):
        animation = lippmann.frames("gears", small_grid())
        self.assertEqual(len(animation), 480)
        late, early = animation[6], animation[2]
        again = [field.picture for field in lippmann.frames("gears", small_grid(), frames=[2, 6])]
        self.assertSame(early.picture, again[0])
        self.assertSame(late.picture, again[1])
        self.assertSame(animation[-1].picture, animation[479].picture)
        with self.assertRaises(IndexError):
            animation[480]

    def test_slices_are_animations(self):
        calls = []
        animation = lippmann.frames("gears", small_grid(), progress=lambda frame, share: calls.append(frame))
        some = animation[2:7:4]
        self.assertEqual((len(some), calls), (2, []))
        self.assertEqual([field.report["frame"] for field in some], [2, 6])
        self.assertEqual(some[-1].report["frame"], 6)
        self.assertEqual([field.report["frame"] for field in animation[::-1][:2]], [479, 478])
        self.assertEqual(len(animation[480:]), 0)
        picked = lippmann.frames("gears", small_grid(), frames=[9, 4, 5])
        self.assertEqual([field.report["frame"] for field in picked[1:]], [4, 5])
        with self.assertRaises(TypeError):
            animation["2"]

    def test_auto_reuse_takes_key_frames(self):
        kinds = [field.report["kind"] for field in lippmann.frames("gears", small_grid(), frames=range(4), keyframes=2)]
        self.assertEqual(kinds, ["key", "in-between"] * 2)

    def test_path_traced_frames_are_denoised_by_default(self):
        def render(**options):
            return lippmann.render("room", small_grid(), **{"integrator": "path", "spp": 4, **options})

        plain, denoised = render(denoise="none").picture, render().picture
        reference = render(denoise="none", spp=256).picture
        self.assertLess(np.square(denoised - reference).mean(), 0.5 * np.square(plain - reference).mean())
        self.assertSame(denoised, render(denoise=True, reuse="none").picture)
        self.assertSame(plain, render(denoise=False).picture)

    def test_single_samples_are_not_denoised(self):
        pictures = [lippmann.render(DESK, small_grid(), spp=1, denoise=denoise).picture for denoise in ("auto", "none")]
        self.assertSame(*pictures)

    def test_sixteen_paths_per_pixel_are_the_default(self):
        self.assertSame(lippmann.render(DESK, small_grid()).picture, lippmann.render(DESK, small_grid(), spp=16).picture)
        paths = {"integrator": "path", "denoise": "none"}
        self.assertSame(lippmann.render("room", small_grid(), **paths).picture,
                        lippmann.render("room", small_grid(), spp=16, **paths).picture)

    def test_reports_have_an_error_interval(self):
        report = lippmann.render(DESK, small_grid(4, 4, (96, 96)), spp=4).report
        self.assertLessEqual(report["psnr_at_least_db"], report["estimated_psnr_db"])
        self.assertLessEqual(report["estimated_psnr_db"], report["psnr_at_most_db"])

    def test_threads_do_not_change_bits(self):
        one = lippmann.render(DESK, small_grid(), spp=4, threads=1)
        self.assertSame(one.picture, lippmann.render(DESK, small_grid(), spp=4, threads=3).picture)
        other = lippmann.render(DESK, small_grid(), spp=4, threads=1, seed=1)
        self.assertFalse(np.array_equal(one.picture, other.picture))

    def test_layers_describe_every_pixel(self):
        scene = lippmann.Scene("two")
        red = lippmann.Material((0.5, 0.0, 0.0))
        scene.add_plane((0, 0, -1), (0, 0, 1), name="wall")
        scene.add_box((-1, -1, -1), (1, 1, 1), material=red, name="cube")
        scene.place_display(height=4, viewing_distance=20)
        grid = small_grid(1, 2, (32, 32), distance_mm=500, pixel_mm=100 / 32)
        field = lippmann.render(scene, grid, layers=["id", "normal", "albedo", "depth"], spp=1)
        middle = (0, 0, 16, 16)
        self.assertEqual(scene.objects[int(field.layer("id")[middle][0])], "cube")
        np.testing.assert_allclose(field.normals[middle], (0, 0, 1), atol=1e-6)
        np.testing.assert_allclose(field.layer("albedo")[middle], (0.5, 0, 0), atol=1e-6)
        # The display is 4 units or 100 mm high, so a unit is 25 mm. The surface is 1 unit in front of the display.
        self.assertAlmostEqual(float(field.depth[middle]), 25, places=3)
        self.assertAlmostEqual(float(field.depth[0, 0, 0, 0]), -25, places=3)
        world = field.world_from_display @ np.array([0, 0, 25, 1])
        np.testing.assert_allclose(world, (0, 0, 1, 1), atol=1e-5)

    def test_progress_is_reported_while_threads_run(self):
        shares, ticks, done = [], [], threading.Event()

        def tick():
            while not done.wait(0.01):
                ticks.append(1)

        ticker = threading.Thread(target=tick)
        ticker.start()
        lippmann.render("room", small_grid(3, 3, (100, 100)), spp=16, progress=lambda frame, share: shares.append((frame, share)))
        done.set()
        ticker.join()
        self.assertGreater(len(ticks), 5)
        self.assertGreater(len(shares), 1)
        self.assertEqual({frame for frame, _ in shares}, {0})
        self.assertEqual(shares, sorted(shares))
        self.assertLessEqual(shares[-1][1], 1)

    def test_several_animations_render_at_the_same_time(self):
        pictures = [None, None]

        def render(i):
            pictures[i] = lippmann.render("room", small_grid(), frame=9).picture

        threads = [threading.Thread(target=render, args=(i,)) for i in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertSame(pictures[0], pictures[1])
