#!/usr/bin/python3
"""run_example.py SCRIPT.py   runs an example in a folder of its own. Exit code 0: it ran and said something, 1: not, 77: skipped, a
package is not installed."""
import contextlib
import io
import os
import runpy
import sys
import tempfile

script = os.path.abspath(sys.argv[1])
said = io.StringIO()
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    try:
        with contextlib.redirect_stdout(said):
            runpy.run_path(script, run_name="__main__")
    except ModuleNotFoundError as missing:
        if missing.name not in ("matplotlib", "openturns"):
            raise
        print(f"skipped: {missing.name} is not installed")
        sys.exit(77)
    print(said.getvalue(), end="")
    for picture in os.listdir("."):
        print(picture, os.path.getsize(picture))
    assert said.getvalue(), "it says nothing"
    assert "nan" not in said.getvalue(), "not a number"
    if "savefig" in open(script, encoding="utf-8").read():
        assert os.listdir("."), "no picture"
    os.chdir("/")
