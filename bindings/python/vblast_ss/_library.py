"""Finds the shared library, loads it, and gives its functions their types."""
from __future__ import annotations

import ctypes
import os
import pathlib
import sys
from typing import Any

from ._api import FUNCTIONS
from ._api.base import VBSS_VERSION_MAJOR, VBSS_VERSION_MINOR, VBSS_VERSION_PATCH

HEADER_VERSION = 10000 * VBSS_VERSION_MAJOR + 100 * VBSS_VERSION_MINOR + VBSS_VERSION_PATCH
PACKAGE = pathlib.Path(__file__).resolve().parent
VARIABLE = "VBLAST_SS_LIBRARY"


def file_names() -> tuple[str, ...]:
    if sys.platform == "win32":
        return ("vblast_ss.dll",)
    if sys.platform == "darwin":
        return ("libvblast_ss.dylib",)
    return (f"libvblast_ss.so.{VBSS_VERSION_MAJOR}", "libvblast_ss.so")


def find() -> str:
    """The library's path: what VBLAST_SS_LIBRARY says, else the one in the package (a wheel's), else
    the newest in the build folders of the checkout that the package lies in, else the system's."""
    said = os.environ.get(VARIABLE)
    if said:
        path = pathlib.Path(said)
        if path.is_dir():
            for name in file_names():
                if (path / name).exists():
                    return str(path / name)
        if not path.is_file():
            raise ImportError(f"{VARIABLE} is '{said}', where no shared library of vblast_ss is")
        return str(path)
    for name in file_names():
        if (PACKAGE / "lib" / name).exists():
            return str(PACKAGE / "lib" / name)
    checkout = PACKAGE.parents[2]
    if (checkout / "lib" / "vblast_ss.map").exists():
        built = [path for name in file_names() for preset in ("default", "release")
                 for path in [checkout / "build" / preset / "lib" / name] if path.exists()]
        if built:
            return str(max(built, key=lambda path: path.stat().st_mtime))
    import ctypes.util  # slow to load, and seldom wanted
    system = ctypes.util.find_library("vblast_ss")
    if system:
        return system
    raise ImportError("no shared library of vblast_ss: build it (cmake --preset release && cmake --build --preset "
                      f"release), or name it in the environment variable {VARIABLE}")


class Library:
    """The functions of the loaded library, as attributes."""

    def __init__(self) -> None:
        self.path = find()
        # Every call lets other Python threads run.
        loaded: Any = ctypes.CDLL(self.path)
        missing = [name for name in FUNCTIONS if not hasattr(loaded, name)]
        if missing:
            raise ImportError(f"{self.path} is not the library that this package was made for: it has no "
                              f"{', '.join(missing[:3])}" + (f" and {len(missing) - 3} more" if missing[3:] else ""))
        for name, (result, parameters) in FUNCTIONS.items():
            function = getattr(loaded, name)
            function.restype, function.argtypes = result, parameters
            setattr(self, name, function)
        version = loaded.vbss_version()
        # A later minor version has all that this package uses.
        if version // 10000 != VBSS_VERSION_MAJOR or version // 100 < HEADER_VERSION // 100:
            raise ImportError(f"{self.path} has version {version}, this package was made for {HEADER_VERSION}")

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(f"vblast_ss has no function {name}")


lib = Library()
