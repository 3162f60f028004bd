"""Tests the parts of bench/gltf_fidelity.py."""

import base64
import json
import math
import struct
import sys
import tempfile
import unittest
import zlib
from pathlib import Path

import numpy as np

BENCH = Path(__file__).parents[2] / "bench"
sys.path += [str(BENCH), str(BENCH / "cycles"), str(BENCH / "fidelity")]

import flip  # noqa: E402  (sys.path is extended first)
import gltf_fidelity  # noqa: E402
import judge  # noqa: E402
import lamps  # noqa: E402
import one_file  # noqa: E402
import page  # noqa: E402
import peers  # noqa: E402
import pictures  # noqa: E402
import reads  # noqa: E402
import scenarios  # noqa: E402

RED, GREEN, BLUE, BLACK, WHITE = ((255, 0, 0), (0, 255, 0), (0, 0, 255), (0, 0, 0), (255, 255, 255))


def plain(color, size=40, alpha=255):
    return np.tile(np.array((*color, alpha), np.uint8), (size, size, 1))


def flip_of(a, b):
    return flip.difference(plain(a)[..., :3], plain(b)[..., :3])


class Flip(unittest.TestCase):
    def test_equal_pictures_have_no_difference(self):
        noise = np.random.default_rng(1).integers(0, 256, (40, 30, 3)).astype(np.uint8)
        self.assertEqual(flip.difference(noise, noise).max(), 0.0)

    def test_green_and_blue_differ_most(self):
        # FLIP scales colour errors so that the error of green against blue is 1
        np.testing.assert_allclose(flip_of(GREEN, BLUE), 1.0, atol=1e-6)

    def test_black_and_white_differ_in_lightness(self):
        most = float(flip.hyab(*flip.hunt_lab(np.array([[0.0, 1, 0], [0, 0, 1]])))**0.7)
        split = 0.4 * most
        # FLIP maps colour errors from `split` to `most`, the largest one, linearly to 0.95 .. 1. Black and white differ
        # in lightness by 100, so their error is 100^0.7.
        expected = 0.95 + 0.05 * (100**0.7 - split) / (most - split)
        np.testing.assert_allclose(flip_of(BLACK, WHITE), expected, atol=1e-5)
        self.assertAlmostEqual(most, 41.277, delta=0.05)

    def test_lightness_of_half_the_light_is_cies(self):
        self.assertAlmostEqual(flip.hunt_lab(np.full((1, 1, 3), 0.5))[0, 0, 0], 116 * 0.5**(1 / 3) - 16, places=6)

    def test_opponent_colours_round_trip(self):
        rgb = np.random.default_rng(2).random((5, 5, 3))
        np.testing.assert_allclose(flip.from_opponent(flip.opponent(rgb)), rgb, atol=1e-9)

    def test_missing_lines_count_more_than_lightness(self):
        lined = plain((128, 128, 128))[..., :3]
        lined[:, 20] = 255
        grey = plain((128, 128, 128))[..., :3]
        seen = flip.color_difference(*[flip.opponent(flip.linear(p / 255.0)) for p in (lined, grey)])
        self.assertGreater(flip.difference(lined, grey)[20, 20], 1.2 * seen[20, 20])

    def test_flip_is_symmetric(self):
        a, b = (np.random.default_rng(seed).integers(0, 256, (33, 37, 3)).astype(np.uint8) for seed in (3, 4))
        np.testing.assert_allclose(flip.difference(a, b), flip.difference(b, a), atol=1e-12)


def filtered(codes, kinds):
    height, width, step = codes.shape
    above, out = [0] * (width * step), b""
    for row, kind in zip(codes.reshape(height, -1).tolist(), kinds):
        left, corner = [0] * step + row[:-step], [0] * step + above[:-step]
        guess = {0: lambda i: 0, 1: lambda i: left[i], 2: lambda i: above[i], 3: lambda i: (left[i] + above[i]) // 2,
                 4: lambda i: pictures.paeth(left[i], above[i], corner[i])}[kind]
        out += bytes([kind]) + bytes((value - guess(i)) & 255 for i, value in enumerate(row))
        above = row
    chunk = lambda name, data: struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    header = struct.pack(">IIBBBBB", width, height, 8, {3: 2, 4: 6}[step], 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(out)) + chunk(b"IEND", b"")


class Pictures(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.file = Path(self.folder.name) / "picture.png"
        self.addCleanup(self.folder.cleanup)

    def test_every_filter_is_undone(self):
        codes = np.random.default_rng(5).integers(0, 256, (10, 9, 4)).astype(np.uint8)
        self.file.write_bytes(filtered(codes, [0, 1, 2, 3, 4] * 2))
        np.testing.assert_array_equal(pictures.read(self.file), codes)

    def test_without_alpha_everything_is_covered(self):
        self.file.write_bytes(filtered(plain(RED, 3)[..., :3], [4, 4, 4]))
        np.testing.assert_array_equal(pictures.read(self.file), plain(RED, 3))

    def test_pictures_round_trip(self):
        codes = np.random.default_rng(6).integers(0, 256, (4, 5, 4)).astype(np.uint8)
        self.file.write_bytes(pictures.png(codes))
        np.testing.assert_array_equal(pictures.read(self.file), codes)

    def test_other_files_are_refused(self):
        self.file.write_bytes(b"P6 1 1 255 abc")
        with self.assertRaisesRegex(SystemExit, "not a PNG"):
            pictures.read(self.file)

    def test_halves_average_the_covered_light(self):
        picture = plain(WHITE, 2)
        picture[0] = (*BLACK, 0)
        np.testing.assert_array_equal(pictures.shrunk(picture, 1, 1), [[[255, 255, 255, 128]]])
        self.assertIsNone(pictures.shrunk(plain(WHITE, 3), 2, 2))


class Judge(unittest.TestCase):
    def test_outliers_are_far_from_the_median(self):
        judged = judge.judged({"a": plain((100, 100, 100)), "b": plain((102, 102, 102)), "c": plain((101, 101, 101)), "odd": plain((200, 100, 100))})
        self.assertGreater(judged["a"]["psnr_db"], 44)
        self.assertLess(judged["odd"]["psnr_db"], 14)
        self.assertGreater(judged["odd"]["flip"], 10 * judged["a"]["flip"])

    def test_two_others_compare_with_each_other(self):
        named = {"ours": plain(RED), "a": plain((100, 100, 100)), "b": plain((110, 110, 110))}
        self.assertAlmostEqual(judge.among_others(named, "ours"), 20 * math.log10(25.5), places=9)
        self.assertIsNone(judge.among_others({"ours": plain(RED), "a": plain(RED)}, "ours"))

    def test_three_others_compare_with_medians(self):
        named = {"ours": plain(RED), "a": plain((100,) * 3), "b": plain((100,) * 3), "c": plain((110,) * 3)}
        self.assertAlmostEqual(judge.among_others(named, "ours"), judge.decibels((5**2 + 5**2 + 10**2) / 3), places=9)

    def test_empty_background_does_not_count(self):
        a, b = plain(BLACK, 40, 0), plain(BLACK, 40, 0)
        a[:20], b[:20] = plain(WHITE)[:20], plain((245, 245, 245))[:20]
        self.assertAlmostEqual(judge.judged({"a": a, "b": b})["a"]["psnr_db"], 20 * math.log10(25.5), places=9)

    def test_empty_pictures_are_refused(self):
        with self.assertRaisesRegex(SystemExit, "background"):
            judge.judged({"a": plain(BLACK, 20, 0), "b": plain(BLACK, 20, 0)})

    def test_noise_follows_from_the_difference(self):
        random = np.random.default_rng(7)
        grey = lambda sigma: np.clip(np.round(128 + sigma * random.standard_normal((200, 200, 1))), 0, 255).astype(np.uint8)
        few, many = [np.concatenate([np.repeat(grey(sigma), 3, 2), plain(WHITE, 200)[..., :1]], axis=2) for sigma in (10.0, 10.0 / 8**0.5)]
        self.assertAlmostEqual(judge.noise(few, many, 8), 100 / 8, delta=0.5)


class Scenarios(unittest.TestCase):
    def read(self, config):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "config.json").write_text(json.dumps(config))
            golden = Path(folder) / "goldens" / "one"
            golden.mkdir(parents=True)
            for name in ("a", "b"):
                (golden / f"{name}-golden.png").touch()
            return scenarios.read(Path(folder))

    def test_defaults_match_render_fidelity(self):
        one, = self.read({"scenarios": [{"name": "one", "model": "m.glb", "orbit": {"theta": 90}, "target": {"y": 2}}]})
        self.assertEqual((one.width, one.height, one.vertical_fov_deg, one.skybox), (768, 768, 45.0, False))
        self.assertEqual((one.orbit, one.target), (scenarios.Orbit(90, 90.0, 1.0), (0.0, 2, 0.0)))
        self.assertEqual(sorted(one.references), ["a", "b"])

    def test_excluded_renderers_have_no_reference(self):
        one, = self.read({"scenarios": [{"name": "one", "model": "m.glb", "exclude": ["a"]}]})
        self.assertEqual(list(one.references), ["b"])

    def test_bad_configurations_are_refused(self):
        for config in ({}, {"scenarios": []}, {"scenarios": [{"name": "x"}]}, {"scenarios": [{"name": "x", "model": "m", "orbit": {"tilt": 1}}]}):
            with self.assertRaises(SystemExit):
                self.read(config)

    def test_the_longer_side_is_limited(self):
        self.assertEqual(scenarios.Scenario("x", None, width=1024, height=512).size(256), (256, 128))
        self.assertEqual(scenarios.Scenario("x", None, width=100, height=50).size(256), (100, 50))

    def test_an_orbits_camera_looks_at_its_target(self):
        for theta, phi in ((0, 90), (30, 60), (-90, 45), (200, 120)):
            place, (x, y, z, w) = scenarios.camera_place(scenarios.Orbit(theta, phi, 5.0), (1.0, 2.0, 3.0))
            forward = np.array([-2 * (x * z + w * y), -2 * (y * z - w * x), 2 * (x * x + y * y) - 1])
            np.testing.assert_allclose(np.array(place) + 5.0 * forward, (1, 2, 3), atol=1e-9)

    def test_default_orbit_is_in_front(self):
        np.testing.assert_allclose(scenarios.camera_place(scenarios.Orbit(), (0, 0, 0))[0], (0, 0, 1), atol=1e-12)
        np.testing.assert_allclose(scenarios.camera_place(scenarios.Orbit(90, 90, 2), (0, 0, 0))[0], (2, 0, 0), atol=1e-12)
        np.testing.assert_allclose(scenarios.camera_place(scenarios.Orbit(0, 0, 2), (0, 0, 0))[0], (0, 2, 0), atol=1e-12)


class OneFile(unittest.TestCase):
    def test_all_buffers_and_images_are_embedded(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            (folder / "a b.bin").write_bytes(b"first")
            (folder / "i.png").write_bytes(b"\x89PNG image")
            uri = "data:application/octet-stream;base64," + base64.b64encode(b"..second").decode()
            doc = {"asset": {"version": "2.0"}, "buffers": [{"byteLength": 5, "uri": "a%20b.bin"}, {"byteLength": 8, "uri": uri}],
                   "bufferViews": [{"buffer": 0, "byteLength": 5}, {"buffer": 1, "byteOffset": 2, "byteLength": 6}], "images": [{"uri": "i.png"}]}
            (folder / "f.gltf").write_text(json.dumps(doc))
            copy = one_file.OneFile(folder / "f.gltf")
            copy.add_camera([0, 0, 1], [0, 0, 0, 1], 0.8, 1.0, 1.0)
            copy.write(folder / "f.glb")
            back = one_file.OneFile(folder / "f.glb")
        views = [bytes(back.blob[v["byteOffset"]:v["byteOffset"] + v["byteLength"]]) for v in back.doc["bufferViews"]]
        self.assertEqual(views, [b"first", b"second", b"\x89PNG image"])
        self.assertEqual(back.doc["images"], [{"bufferView": 2, "mimeType": "image/png"}])
        self.assertEqual(back.doc["nodes"][back.doc["scenes"][0]["nodes"][0]]["name"], one_file.CAMERA)


    def test_own_camera_is_the_first_perspective_one(self):
        with tempfile.TemporaryDirectory() as name:
            file = Path(name) / "f.gltf"
            flat, deep = {"type": "orthographic", "orthographic": {}}, {"type": "perspective", "perspective": {"yfov": 0.5, "aspectRatio": 2.0}}
            file.write_text(json.dumps({"cameras": [flat, deep], "nodes": [{"camera": 0}, {"camera": 1}]}))
            copy = one_file.OneFile(file)
        self.assertTrue(copy.name_own_camera(1.0))
        self.assertEqual([node.get("name") for node in copy.doc["nodes"]], [None, one_file.CAMERA])
        self.assertEqual(copy.doc["cameras"][1]["perspective"], {"yfov": 0.5, "aspectRatio": 1.0})
        copy.doc["nodes"] = [{"camera": 0}]
        self.assertFalse(copy.name_own_camera(1.0))


class Lamps(unittest.TestCase):
    def test_units_depend_on_the_exporter(self):
        self.assertEqual(lamps.scale("Khronos glTF", "point"), 1.0)
        self.assertAlmostEqual(lamps.scale("Khronos glTF Blender I/O v3.4.50", "point"), 1 / 683)
        self.assertAlmostEqual(lamps.scale("Khronos glTF Blender I/O v3.4.38", "spot"), 1 / (4 * math.pi))
        self.assertEqual(lamps.scale("Khronos Blender glTF 2.0 I/O", "directional"), 1.0)


class Reads(unittest.TestCase):
    def document(self, specular):
        return {"extensionsUsed": ["KHR_never_there"], "extensions": {"EXT_lights_ies": {}}, "nodes": [{"extras": {"extensions": {"EXT_of_somebody": {}}}}],
                "materials": [{"extensions": {"KHR_materials_iridescence": {}, "KHR_materials_specular": specular, "KHR_xmp": {}}}]}

    def test_extensions_are_those_in_use(self):
        self.assertEqual(reads.extensions_of(self.document({"specularFactor": 0.5, "specularColorFactor": [1, 1, 1]})),
                         {"EXT_lights_ies", "KHR_materials_iridescence", "KHR_materials_specular", "KHR_xmp"})

    def test_unread_features_depend_on_blenders_version(self):
        names = reads.extensions_of(self.document({"specularColorFactor": [1, 0.5, 1]}))
        old, new = {"KHR_materials_specular"}, {"KHR_materials_specular", "KHR_materials_iridescence"}
        self.assertEqual(reads.unread(names, old, (3, 4, 1)), ["EXT_lights_ies", "KHR_materials_iridescence", reads.COLOURED_GLOSS])
        self.assertEqual(reads.unread(names, new, (4, 3, 0)), ["EXT_lights_ies"])


class Failures(unittest.TestCase):
    def test_the_reason_is_the_line_of_the_error(self):
        text = "Blender 3.4.1\nTraceback (most recent call last):\n  File x\nValueError: no camera\nError: Python: Traceback (most recent call last):\nError: script failed, file: 'x'\nBlender quit\n"
        self.assertEqual(peers.reason(text), "ValueError: no camera")
        self.assertEqual(peers.reason("lippmann: a.glb: is damaged\n"), "lippmann: a.glb: is damaged")
        self.assertEqual(peers.reason(""), "no message")

    def test_uncaught_failures_end_a_script(self):
        self.assertTrue(issubclass(peers.Failed, SystemExit))

    def test_rows_name_failed_renderers(self):
        row, judged = gltf_fidelity.row_of(scenarios.Scenario("car", None), {"lippmann": plain(RED, 20)}, {"lippmann_speed": 1.0}, (), {"cycles": "ValueError: no"}, {})
        self.assertEqual((row["renderers"], judged), ({}, {}))
        self.assertIn("cycles has no picture: ValueError: no", gltf_fidelity.line(row))
        self.assertEqual(gltf_fidelity.sentence([row]), "")
        self.assertEqual(gltf_fidelity.reservations([row]), ["1 of 1 scenarios lack a renderer's picture: car"])
        out = page.Page()
        out.add(row, judged, {"lippmann": plain(RED, 20)})
        self.assertIn("<td>cycles<td>", page.table(out.rows))
        self.assertEqual(out.sections[0].count("data:image/png;base64,"), 1)

    def test_unread_features_are_named(self):
        named = {"lippmann": plain(RED, 20), "cycles": plain(BLUE, 20)}
        row, _ = gltf_fidelity.row_of(scenarios.Scenario("soap", None), named, unread={"cycles": ["KHR_materials_iridescence"]})
        self.assertIn("cycles does not show KHR_materials_iridescence, which the file uses", gltf_fidelity.line(row))
        self.assertEqual(gltf_fidelity.reservations([row]), ["1 of 1 scenarios have something that a renderer does not read: soap"])

    def test_unreadable_files_are_failures(self):
        with tempfile.TemporaryDirectory() as name:
            file = Path(name) / "f.gltf"
            for text in ("{", json.dumps({"buffers": [{"byteLength": 3, "uri": "there-is-none.bin"}]})):
                file.write_text(text)
                with self.assertRaisesRegex(peers.Failed, "f.gltf"):
                    gltf_fidelity.one_copy(file)


class Page(unittest.TestCase):
    def test_the_page_is_self_contained(self):
        named = {"lippmann": plain(RED, 20), "<other>": plain(BLUE, 20)}
        judged = judge.judged(named)
        out = page.Page()
        out.add({"scenario": "a&b", "notes": ["left <out>"], "among_others_db": None, "renderers": judged, "failed": {}, "unread": {"<other>": ["EXT_<x>"]}}, judged, named)
        with tempfile.TemporaryDirectory() as folder:
            out.write(Path(folder) / "p.html")
            text = (Path(folder) / "p.html").read_text()
        self.assertIn("a&amp;b", text)
        self.assertIn("left &lt;out&gt;", text)
        self.assertIn("<td>&lt;other&gt;: EXT_&lt;x&gt;", text)
        self.assertEqual(text.count("data:image/png;base64,"), 4)
        self.assertNotIn("http", text)


if __name__ == "__main__":
    unittest.main()
