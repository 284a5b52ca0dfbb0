#!/usr/bin/python3
"""run_page.py PAGE.md CONFIGS   runs each script of a page (```python name.py), in a folder with the studies. Exit code 0: all ran."""
import os
import re
import shutil
import subprocess
import sys
import tempfile

with open(sys.argv[1], encoding="utf-8") as page:
    scripts = re.findall(r"^```python (\w+\.py)\n(.*?)^```", page.read(), re.S | re.M)
assert len(scripts) >= 3, "the page has no scripts"
configs = os.path.abspath(sys.argv[2])
with tempfile.TemporaryDirectory() as folder:
    shutil.copytree(configs, folder + "/configs")
    for name, text in scripts:
        print(name, flush=True)
        subprocess.run([sys.executable, "-I", "-c", f"import sys; sys.path.insert(0, {os.environ['PYTHONPATH']!r})\n" + text],
                       cwd=folder, check=True)
