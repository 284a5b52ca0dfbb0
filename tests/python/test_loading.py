#!/usr/bin/python3
"""What the Python module is made of, and what it says where it cannot be loaded."""
import ast
import inspect
import os
import pathlib
import shutil
import subprocess
import sys
import sysconfig
import unittest.mock

import drystone

from scene import InFolder, run, sets


class ModuleSaysWhatItIs(InFolder):
    PACKAGE = pathlib.Path(drystone.__file__).parent

    def python(self, code, path):
        environment = {**os.environ, "PYTHONPATH": str(path)}
        return subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True)

    def test_without_numpy(self):
        said = self.python("import sys; sys.modules['numpy'] = None; import drystone", self.PACKAGE.parent)
        self.assertIn("drystone needs numpy, which", said.stderr)
        self.assertIn("apt-get install python3-numpy", said.stderr)

    def test_other_python(self):
        copy = self.folder / "drystone"
        copy.mkdir()
        for file in self.PACKAGE.glob("*.py"):
            shutil.copy(file, copy)
        said = self.python("import drystone", self.folder)
        self.assertIn("has no compiled part", said.stderr)
        (copy / "_core.cpython-39-x86_64-linux-gnu.so").touch()
        said = self.python("import drystone", self.folder)
        here = f"{sys.version_info.major}.{sys.version_info.minor}"
        self.assertIn("compiled for Python 3.9, and", said.stderr)
        self.assertIn(f"is Python {here}; run python3.9", said.stderr)

    def test_instruction_sets(self):
        """Of the package's three the fastest that this processor has."""
        from drystone import _load
        v3 = {"avx2", "fma", "bmi2"}
        v4 = v3 | {"avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl"}
        for flags, sets in ((set(), ["", "v1"]), ({"avx2", "fma"}, ["", "v1"]), (v3, ["", "v3", "v1"]),
                            (v4 - {"avx512vl"}, ["", "v3", "v1"]), (v4 | {"sse"}, ["", "v4", "v3", "v1"])):
            with unittest.mock.patch.object(_load, "_flags", lambda: flags):
                self.assertEqual(_load._instruction_sets(), sets)
        self.assertIn("fpu", _load._flags())
        copy = self.folder / "drystone"
        (copy / "v1").mkdir(parents=True)
        for file in self.PACKAGE.glob("*.py"):
            shutil.copy(file, copy)
        shutil.copy(self.PACKAGE / f"_core{sysconfig.get_config_var('EXT_SUFFIX')}", copy / "v1")
        said = self.python("import drystone; print(drystone.fragility.fit([1, 2, 3]))", self.folder)
        self.assertIn("lognormal fit of 3 walls", said.stdout, said.stderr)

    def test_stubs(self):
        """The stub names what the compiled part has, and every public function says what it does."""
        core = sys.modules["drystone._core"]
        tree = ast.parse((self.PACKAGE / "_core.pyi").read_text())
        names = {node.name for node in tree.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
        self.assertEqual(names, {name for name in dir(core) if not name.startswith("_")})
        for node in tree.body:
            if isinstance(node, ast.ClassDef) and not node.name.endswith(("Error", "NoFit")):
                listed = {m.target.id if isinstance(m, ast.AnnAssign) else m.name for m in node.body
                          if isinstance(m, (ast.AnnAssign, ast.FunctionDef))}
                there = {name for name in dir(getattr(core, node.name)) if not name.startswith("_")}
                self.assertEqual(listed - {"__init__"}, there, node.name)
        for module in (drystone, drystone.fragility, drystone.uq):
            for name in module.__all__ if hasattr(module, "__all__") else ["sample"]:
                thing = getattr(module, name)
                self.assertTrue(inspect.getdoc(thing), name)
                for member, value in vars(thing).items() if inspect.isclass(thing) else ():
                    if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                        self.assertTrue(inspect.getdoc(value), f"{name}.{member}")
        self.assertEqual("drystone " + drystone.__version__, run("version").stdout.splitlines()[0])
        self.assertIn(f"solver revision {drystone.__solver_revision__}", run("version").stdout)


unittest.main()
