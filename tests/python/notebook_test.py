"""Runs the cells of the notebook in examples/python without Jupyter."""

import ast
import json
import os
import struct

import numpy as np

import lippmann
from support import Case, SOURCE, tool

NOTEBOOK = SOURCE / "examples/python/light_field.ipynb"


class Notebook(Case):
    def run_cells(self):
        """Yields the value of each cell that ends with an expression."""
        names = {}
        for number, cell in enumerate(json.loads(NOTEBOOK.read_text())["cells"]):
            if cell["cell_type"] != "code":
                continue
            body = ast.parse("".join(cell["source"]), f"cell {number}").body
            last = body.pop() if isinstance(body[-1], ast.Expr) else None
            exec(compile(ast.Module(body, []), f"cell {number}", "exec"), names)
            if last is not None:
                yield eval(compile(ast.Expression(last.value), f"cell {number}", "eval"), names)

    def test_cells_run_and_show_pictures(self):
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        shown = list(self.run_cells())
        fields = [value for value in shown if isinstance(value, lippmann.LightField)]
        self.assertIn("<img", fields[0]._repr_html_())
        sizes = [struct.unpack(">II", value._repr_png_()[16:24]) for value in shown if hasattr(value, "_repr_png_")]
        self.assertEqual(sizes, [(640, 240), (480, 162), (480, 360)])
        shape, quilt = shown[-1]
        self.assertEqual(shape, (1, 9, 120, 160, 3))
        self.assertIn("9x1 of 160x120 pixels", tool("info", quilt, cwd=self.folder))
        tool("view", quilt, "--save", "page", cwd=self.folder)

    def test_the_file_holds_no_outputs(self):
        for cell in json.loads(NOTEBOOK.read_text())["cells"]:
            self.assertFalse(cell.get("outputs"), "clear the outputs before the notebook is committed")

    def test_pictures_are_shown_as_codes(self):
        linear = np.array([[[0, 0.5, 1.0]]])
        self.assertEqual(lippmann.show(linear).codes.tolist(), [[[0, 188, 255]]])
        self.assertSame(lippmann.show(np.uint8([[[1, 2, 3]]]), enlarge=2).codes, np.full((2, 2, 3), (1, 2, 3), np.uint8))
        grey = lippmann.show(np.array([[-np.inf, 2.0], [3.0, 4.0]])).codes
        self.assertEqual(grey[..., 0].tolist(), [[0, 0], [128, 255]])
        for wrong in (np.zeros(3), np.zeros((2, 2, 4)), np.zeros((0, 2, 3)), "text"):
            self.assertWrong("picture", lippmann.show, wrong)
