"""Tests that Python and the tool write and read the same files."""

import errno
import json
import os
import pathlib
import pickle
import shutil
import warnings

import numpy as np

import lippmann
from support import Case, SMALL_PANEL, small_grid, tool


class Files(Case):
    def rendered(self, **options):
        return lippmann.render("room", small_grid(3, 3, (24, 32)), frame=9, layers=["depth"], **options)

    def test_research_formats_round_trip(self):
        field = self.rendered()
        for name in ("hci", "stanford", "jpeg-pleno", "views", "eslf", "miv", "quilt", "integral"):
            with self.subTest(name):
                path = self.folder / (name + (".png" if name in ("eslf", "quilt", "integral") else ""))
                files = field.save(path, name)
                given = {} if name == "quilt" else {"format": name, "views": (3, 3)}
                again = lippmann.open(files[0] if name == "quilt" else path, **given)
                self.assertSame(again.views, lippmann.to_codes(field.views))
                if name == "hci":
                    # The 30 files are 9 views, 9 depth maps, 9 disparity maps, two more maps of the middle view, and
                    # parameters.cfg.
                    self.assertEqual(len(files), 30)
                    # The file stores float32 distances in metres from the cameras, which are 500 mm in front of the
                    # display.
                    np.testing.assert_allclose(again.depth, field.depth, atol=1e-3)
                    np.testing.assert_allclose(again.disparity, field.disparity, atol=1e-4)
                    np.testing.assert_allclose(again.eyes_mm, field.eyes_mm, atol=1e-4)

    def test_disparity_equals_the_tools_files(self):
        field = self.rendered()
        field.save(self.folder / "hci", "hci")
        data = (self.folder / "hci/gt_disp_lowres_Cam000.pfm").read_bytes()
        # a PFM file stores the bottom row first
        values = np.frombuffer(data[-4 * 24 * 32:], "<f4").reshape(24, 32)[::-1]
        # camera 0 of the HCI format is the top left view
        np.testing.assert_allclose(field.disparity[2, 0], values, atol=1e-4)

    def test_data_that_a_format_cannot_store_are_named(self):
        field = self.rendered()
        with self.assertWarnsRegex(lippmann.LippmannWarning, "stanford cannot store them: .*the depth of 9 views"):
            field.save(self.folder / "stanford", "stanford")
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            field.save(self.folder / "hci", "hci")

    def test_the_tool_converts_saved_files(self):
        field = self.rendered()
        field.save(self.folder / "hci", "hci")
        tool("convert", self.folder / "hci", self.folder / "stanford", "--to", "stanford")
        self.assertSame(lippmann.open(self.folder / "stanford").views, lippmann.to_codes(field.views))

    def test_renders_open_with_optics_and_depth(self):
        for optics in (["--optics", "multiview", "--camera-grid", "--views", "3x2", "--size", "96x64"],
                       ["--optics", "microlens", "--size", "64x64", "--lenses", "16x16", "--lens-pixels", "4"]):
            with self.subTest(optics[1]):
                folder = self.folder / optics[1]
                tool("render", "room", "--frames", "8-9", *optics, "--aov", "depth", "-o", folder)
                field = lippmann.open(folder, frame=1)
                self.assertTrue(field.path.endswith("frame_0009.png"), field.path)
                self.assertEqual(field.views.dtype, np.uint8)
                self.assertEqual(field.depth.shape, field.views.shape[:4])
                tool("replay", folder / "frame_0009.png", "--refocus", "3", "-o", folder / "replay")
                lippmann._core.write_picture(field.refocus(3), str(folder / "own.png"))
                self.assertEqual((folder / "own.png").read_bytes(), (folder / "replay/refocus_0009.png").read_bytes())
        self.assertWrong("frame", lippmann.open, folder, frame=2)

    def test_missing_files_raise_file_not_found(self):
        missing = self.folder / "missing.glb"
        for read in (
            lambda: lippmann.load(missing),
            lambda: lippmann.open(self.folder / "missing.png"),
            lambda: lippmann.open(self.folder / "missing"),
            lambda: lippmann.display(self.folder / "missing.toml"),
            lambda: lippmann.render(missing),
            lambda: lippmann.render("room", environment=self.folder / "missing.exr"),
        ):
            with self.assertRaises(FileNotFoundError) as caught:
                read()
            error = caught.exception
            self.assertIsInstance(error, lippmann.Error)
            self.assertEqual(error.errno, errno.ENOENT)
            self.assertIn("missing", error.filename)
            same = pickle.loads(pickle.dumps(error))
            self.assertEqual((type(same), str(same), same.filename), (type(error), str(error), error.filename))
        damaged = self.folder / "damaged.glb"
        damaged.write_bytes(b"glTF")
        with self.assertRaises(lippmann.Error) as caught:
            lippmann.load(damaged)
        self.assertNotIsInstance(caught.exception, FileNotFoundError)
        field = lippmann.LightField(np.zeros((1, 2, 4, 4, 3), np.uint8))
        with self.assertRaises(lippmann.Error) as caught:
            field.save(damaged / "quilt.png", "quilt")
        self.assertNotIsInstance(caught.exception, FileNotFoundError)

    def test_16_bits_and_floats_are_kept(self):
        field = self.rendered()
        field.save(self.folder / "deep", "views", bits=16)
        self.assertEqual(lippmann.open(self.folder / "deep", views=(3, 3)).views.dtype, np.uint16)
        field.save(self.folder / "floats", "views", bits=32)
        again = lippmann.open(self.folder / "floats", views=(3, 3))
        self.assertEqual(again.views.dtype, np.float32)
        # EXR files store half floats, which have 11 significant bits
        np.testing.assert_allclose(again.views, field.views, rtol=1e-3, atol=1e-3)

    def test_native_frames_convert_from_and_to_views(self):
        panel = self.folder / "panel.toml"
        panel.write_text(SMALL_PANEL.read_text().replace("[1440, 2560]", "[90, 160]").replace("dpi = 491", "dpi = 60"))
        field = lippmann.render("room", panel, frame=9)
        field.save(self.folder / "native.png", "native", display=panel)
        field.save(self.folder / "quilt.png", "quilt")
        (quilt,) = self.folder.glob("quilt_*.png")
        tool("convert", quilt, self.folder / "tool.png", "--to", "native", "--display", panel)
        self.assertEqual((self.folder / "native.png").read_bytes(), (self.folder / "tool.png").read_bytes())
        views = lippmann.open(self.folder / "native.png", format="native", display=panel)
        self.assertEqual(views.shape, field.shape)

    def test_a_missing_folder_is_created(self):
        field = lippmann.render("room", small_grid(1, 2, (24, 32)), layers=["depth"])
        for format in ("quilt", "stereo", "eslf", "integral", "views", "hci", None):
            where = self.folder / f"made {format}/deep"
            files = field.save(where / "a.png", format)
            self.assertTrue(files)
            for file in files:
                self.assertTrue(os.path.isfile(file), file)
                self.assertTrue(file.startswith(str(where)), file)
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(self.folder)
        self.assertEqual(field.save("here.png"), ["here.png"])
        self.assertEqual(field.save("below/here.png"), ["below/here.png"])
        with self.assertRaises(lippmann.Error):
            field.save(self.folder / "gone/deep/a.gif")
        self.assertFalse((self.folder / "gone").exists())
        (self.folder / "file").touch()
        wrong = self.assertWrong(str(self.folder / "file"), field.save, self.folder / "file/deep/a.png", "quilt")
        self.assertIn("cannot be created", wrong.problem)

    def test_quilts_keep_their_grid(self):
        views = np.random.default_rng(1).integers(0, 256, (5, 4, 8, 12, 3), dtype=np.uint8)
        field = lippmann.LightField(views)
        for tiles in (None, (2, 10)):
            (quilt, side) = field.save(self.folder / "q.png", "quilt", tiles=tiles)
            self.assertSame(lippmann.open(quilt).views, views)
            self.assertEqual(json.loads(pathlib.Path(side).read_text())["grid"], {"columns": 4, "rows": 5})
            tool("convert", quilt, self.folder / "stanford", "--to", "stanford")
            self.assertSame(lippmann.open(self.folder / "stanford").views, views)
            shutil.rmtree(self.folder / "stanford")
        os.remove(side)
        self.assertEqual(lippmann.open(quilt).shape, (1, 20, 8, 12, 3))  # the file name states only the tiles

    def test_pictures_of_arrays_are_quilts(self):
        views = np.random.default_rng(1).integers(0, 256, (1, 3, 8, 8, 3), dtype=np.uint8)
        lippmann.LightField(views).save(self.folder / "panel.png")
        again = lippmann.open(self.folder / "panel.png", format="quilt", views=(1, 3), tiles=(1, 3))
        self.assertSame(again.views, views)
