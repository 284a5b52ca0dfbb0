#!/usr/bin/python3
"""doors.py DOCS CONFIGS   the doors of an installed Drystone, as their pages show them: every script of python.md, the server and the request
of serve.md. Only what is installed is on any path. Exit code 0: all opened, 1: not."""
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile


def scripts(page):
    with open(page, encoding="utf-8") as text:
        found = re.findall(r"^```python *(?:\w+\.py)?\n(.*?)^```", text.read(), re.S | re.M)
    assert found, f"{page} shows no script"
    return found


def said_by(script):
    said = subprocess.run([sys.executable, "-I", "-c", script], check=True, stdout=subprocess.PIPE, text=True, timeout=300).stdout
    assert said.strip() and "nan" not in said, f"it says: {said!r}\n{script}"
    return said


docs, configs = map(os.path.abspath, sys.argv[1:3])
with tempfile.TemporaryDirectory() as folder:
    shutil.copytree(configs, folder + "/configs")
    os.chdir(folder)
    for script in scripts(docs + "/python.md"):
        print(said_by(script).splitlines()[0], flush=True)

    (request,) = scripts(docs + "/serve.md")
    server = subprocess.Popen(["drystone", "serve", "configs/quick.ini", "--port", "4242"], stdout=subprocess.PIPE, text=True)
    try:
        assert "http://127.0.0.1:4242" in server.stdout.readline()
        peak = float(said_by(request))
    finally:
        server.send_signal(signal.SIGINT)
        server.wait(30)
    print("peak force [N], from the server:", peak)

    import drystone
    inputs = eval(re.search(r"x = (\[.*?\])", request).group(1))
    wall = drystone.Study("configs/quick.ini").push(inputs=[inputs], level=0)[0]
    assert wall.summary["vertical_stress_MPa"] == 0.5, wall.summary
    assert wall.force.max() == peak, (wall.force.max(), peak)
    os.chdir("/")
print("every door opens; the server has the bits of the module")
