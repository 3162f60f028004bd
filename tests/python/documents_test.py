"""Tests docstrings, type stubs, and the code in docs/guide/python.md."""

import ast
import doctest
import inspect
import re
import subprocess
import sys

import lippmann
from support import Case, SOURCE, TOOL

PACKAGE = SOURCE / "python/lippmann"


class Documents(Case):
    def test_everything_public_has_a_docstring(self):
        for name in lippmann.__all__:
            thing = getattr(lippmann, name)
            self.assertTrue(inspect.getdoc(thing), name)
            for member, value in vars(thing).items() if inspect.isclass(thing) else ():
                if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                    self.assertTrue(inspect.getdoc(value), f"{name}.{member}")

    def test_everything_public_is_typed(self):
        for name in lippmann.__all__:
            thing = getattr(lippmann, name)
            if thing.__module__ == "lippmann._core":
                continue
            for function in [thing] if inspect.isfunction(thing) else vars(thing).values():
                if not inspect.isfunction(function) or function.__name__ in ("__eq__", "__repr__", "_replace"):
                    continue
                hints = {k for k in inspect.signature(function).parameters if k not in ("self", "cls")}
                self.assertLessEqual(hints, set(function.__annotations__), f"{name}: {function.__qualname__}")

    def test_the_stubs_match_the_module(self):
        stubs = {}
        for node in ast.parse((PACKAGE / "_core.pyi").read_text()).body:
            if isinstance(node, ast.ClassDef):
                stubs[node.name] = {n.name for n in node.body if isinstance(n, ast.FunctionDef)}
                stubs[node.name] |= {n.target.id for n in node.body if isinstance(n, ast.AnnAssign)}
            elif isinstance(node, ast.FunctionDef):
                stubs[node.name] = None
            elif isinstance(node, ast.AnnAssign):
                stubs[node.target.id] = None
        has = {name for name in vars(lippmann._core) if not name.startswith("_")}
        self.assertEqual(set(stubs), has)
        for name, members in stubs.items():
            if members is None:
                continue
            own = {m for m in vars(getattr(lippmann._core, name)) if not m.startswith("_")}
            self.assertEqual({m for m in members if not m.startswith("_")}, own, name)

    def test_the_package_docstring_runs(self):
        self.assertEqual(doctest.testmod(lippmann).failed, 0)
        self.assertGreater(doctest.testmod(lippmann).attempted, 0)

    def test_the_version_is_the_tools(self):
        output = subprocess.run([TOOL, "--version"], capture_output=True, text=True).stdout
        self.assertIn(lippmann.__version__, output)

    def test_the_code_of_python_md_runs(self):
        text = (SOURCE / "docs/guide/python.md").read_text()
        blocks = re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
        self.assertGreaterEqual(len(blocks), 5)
        (self.folder / "examples").symlink_to(SOURCE / "examples")
        program = "\n".join(blocks)
        done = subprocess.run([sys.executable, "-c", program], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_calls_in_the_text_of_python_md_run(self):
        text = (SOURCE / "docs/guide/python.md").read_text()
        calls = re.findall(r"`(lippmann\.optics\([^`]*\))`", text)
        self.assertTrue(calls)
        for call in calls:
            with self.subTest(call):
                self.assertIsInstance(eval(call, {"lippmann": lippmann}), lippmann.Optics)

    def test_python_md_names_formats_and_examples(self):
        text = (SOURCE / "docs/guide/python.md").read_text()
        for example in (SOURCE / "examples/python").glob("*.py"):
            self.assertIn(f"examples/python/{example.name}", text)
        for name in lippmann.formats():
            self.assertIn(name, text)
