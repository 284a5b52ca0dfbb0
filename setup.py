"""The compiled part of the module, by CMake. DRYSTONE_CMAKE_ARGS: further arguments, between blanks."""
import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).parent.resolve()
VERSION = re.search(r"project\(drystone VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")).group(1)


class CMakeModule(build_ext):
    def build_extension(self, ext):
        build = pathlib.Path(self.build_temp).resolve()
        # Solvers for each instruction set beside each other, as in the Debian package.
        sets = "ON" if platform.machine() == "x86_64" else "OFF"
        subprocess.run(["cmake", "-S", str(ROOT), "-B", str(build), "-G", "Ninja" if shutil.which("ninja") else "Unix Makefiles",
                        "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON", f"-DDRYSTONE_PACKAGE={sets}", "-DDRYSTONE_BUILD_TESTS=OFF",
                        "-DDRYSTONE_BUILD_BENCH=OFF", "-DDRYSTONE_PYTHON=ON", "-DDRYSTONE_WERROR=OFF", f"-DPython_EXECUTABLE={sys.executable}",
                        *os.environ.get("DRYSTONE_CMAKE_ARGS", "").split()], check=True)
        subprocess.run(["cmake", "--build", str(build), "--target", "drystone-python", "--parallel"], check=True)
        folder = pathlib.Path(self.get_ext_fullpath(ext.name)).resolve().parent
        folder.mkdir(parents=True, exist_ok=True)
        made = list((build / "python/drystone").rglob("_core*.so"))
        if not made:
            raise RuntimeError("the Python module needs pybind11-dev and the headers of this Python")
        for file in made:
            to = folder / file.relative_to(build / "python/drystone")
            to.parent.mkdir(exist_ok=True)
            shutil.copy2(file, to)

    def get_outputs(self):
        folder = pathlib.Path(self.get_ext_fullpath(self.extensions[0].name)).resolve().parent
        return [str(file) for file in folder.rglob("_core*.so")]


setup(version=VERSION, packages=["drystone"], package_dir={"": "python"}, package_data={"drystone": ["py.typed", "*.pyi"]},
      ext_modules=[Extension("drystone._core", [])], cmdclass={"build_ext": CMakeModule})
