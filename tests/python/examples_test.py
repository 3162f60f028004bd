"""Tests that the programs in examples/python are short and run unchanged."""

import ast
import subprocess
import sys

import lippmann
from support import Case, DESK, SMALL_PANEL, SOURCE, small_grid

EXAMPLES = SOURCE / "examples/python"


class Examples(Case):
    def run_example(self, name, *arguments):
        done = subprocess.run(
            [sys.executable, EXAMPLES / name, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_examples_have_at_most_15_lines(self):
        examples = sorted(EXAMPLES.glob("*.py"))
        self.assertGreaterEqual(len(examples), 5)
        for example in examples:
            text = example.read_text()
            document = ast.get_docstring(ast.parse(text))
            self.assertTrue(document, example)
            lines = [line for line in text.replace(f'"""{document}"""', "").splitlines() if line.strip()]
            lines = [line for line in lines if not line.startswith("#")]
            self.assertLessEqual(len(lines), 15, example)
            self.assertTrue(hasattr(self, f"test_{example.stem}"), f"{example.name} has no test")

    def test_missing_arguments_print_usage(self):
        for name in ("convert_refocus", "native_frame", "render_layers"):
            done = subprocess.run([sys.executable, EXAMPLES / f"{name}.py"], capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stderr.split()[:2]), (1, ["usage:", f"{name}.py"]))

    def test_render_layers(self):
        output = self.run_example("render_layers.py", "room", "out")
        self.assertIn("(5, 5, 120, 160, 3) float32", output)
        self.assertIn("motion: (5, 5, 120, 160, 2)", output)
        self.assertTrue((self.folder / "out/gt_disp_lowres.pfm").exists())

    def test_own_scene(self):
        lines = self.run_example("own_scene.py").splitlines()
        self.assertEqual([line.split()[0] for line in lines], [str(i) for i in range(12)])
        self.assertEqual(len({line.split()[1] for line in lines}), 12)

    def test_convert_refocus(self):
        lippmann.render("room", small_grid(3, 3, (48, 64)), frame=9, layers=["depth"]).save(self.folder / "hci", "hci")
        output = self.run_example("convert_refocus.py", "hci", "stanford")
        self.assertIn("3 x 3 views (rows x columns), 64x48 pixels, uint8", output)
        self.assertEqual(len(list((self.folder / "stanford").glob("out_*"))), 9)

    def test_native_frame(self):
        panel = self.folder / "panel.toml"
        panel.write_text(SMALL_PANEL.read_text().replace("[1440, 2560]", "[90, 160]").replace("dpi = 491", "dpi = 60"))
        self.assertIn("(160, 90, 3) uint8", self.run_example("native_frame.py", DESK, panel, "native.png"))
        self.assertTrue((self.folder / "native.png").exists())

    def test_own_optics(self):
        self.run_example("own_optics.py")
        header = (self.folder / "barrel.png").read_bytes()[16:24]
        self.assertEqual(header, (240).to_bytes(4, "big") * 2)

    def test_training(self):
        output = self.run_example("training.py")
        self.assertEqual(output.count("(3, 3, 64, 64, 3) (3, 3, 64, 64)"), 3)
        self.assertIn("(96, 128, 3)", output)
