"""Finds the compiled part of the module, and says what is missing where it cannot be loaded."""
import importlib
import pathlib
import re
import sys
import sysconfig

_PACKAGE = pathlib.Path(__file__).parent


def _flags():
    """What this processor can do."""
    try:
        with open("/proc/cpuinfo", encoding="ascii", errors="replace") as cpu:
            for line in cpu:
                if line.startswith("flags"):
                    return set(line.split())
    except OSError:
        pass
    return set()


def _instruction_sets():
    """Folders with a compiled part, the fastest first; "" is that of a build from source. All give the same bits."""
    flags = _flags()
    v3 = {"avx2", "fma", "bmi2"}
    v4 = v3 | {"avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl"}
    wanted = [("", set()), ("v4", v4), ("v3", v3), ("v1", set())]
    return [name for name, needs in wanted if needs <= flags]


def _other_pythons():
    """Versions of Python for which there is a compiled part: ["3.11"]."""
    found = {re.search(r"cpython-(\d)(\d+)", file.name) for file in _PACKAGE.rglob("_core.*.so")}
    return sorted(f"{version.group(1)}.{version.group(2)}" for version in found if version)


def _load():
    try:
        import numpy  # noqa: F401
    except ImportError as missing:
        raise ImportError(f"drystone needs numpy, which {sys.executable} does not have; on Debian: "
                          "apt-get install python3-numpy, and run /usr/bin/python3") from missing
    suffix = sysconfig.get_config_var("EXT_SUFFIX")
    for name in _instruction_sets():
        if (_PACKAGE / name / f"_core{suffix}").exists():
            return importlib.import_module(".".join(filter(None, ["drystone", name, "_core"])))
    here = f"{sys.version_info.major}.{sys.version_info.minor}"
    built = _other_pythons()
    raise ImportError(f"drystone was compiled for Python {' and '.join(built)}, and {sys.executable} is Python {here}; "
                      f"run python{built[0]}, or compile it with -DPython_EXECUTABLE={sys.executable}" if built else
                      f"drystone: {_PACKAGE} has no compiled part; see docs/python.md")


core = _load()
sys.modules["drystone._core"] = core
