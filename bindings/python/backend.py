"""Builds wheels with the shared library inside: a build backend (PEP 517, PEP 660) of its own, as it must work
without a network and needs nothing but Python.

The library is the one that the package itself would load from this checkout: VBLAST_SS_LIBRARY, or the newest of the
build folders. Equal inputs give equal bytes."""
from __future__ import annotations

import base64
import hashlib
import os
import pathlib
import re
import sys
import sysconfig
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
PROJECT = (HERE / "pyproject.toml").read_text()


def said(key):
    return re.search(rf'^{key} = "([^"]+)"$', PROJECT, re.M).group(1)


def version():
    text = (ROOT / "include" / "vblast_ss" / "base.h").read_text()
    numbers = [re.search(rf"#define VBSS_VERSION_{part} (\d+)", text).group(1) for part in ("MAJOR", "MINOR", "PATCH")]
    suffix = re.search(r'#define VBSS_VERSION_SUFFIX "(.*)"', text).group(1)
    return ".".join(numbers) + suffix.replace("-", "")  # 1.0.0rc1 in Python, where the library has 1.0.0-rc1


NAME = said("name").replace("-", "_")
STEM = f"{NAME}-{version()}"
INFO = f"{STEM}.dist-info"
TAG = "py3-none-" + re.sub(r"[-.]", "_", sysconfig.get_platform())


def library():
    """Path of the shared library, and what it is called in the wheel."""
    sys.path.insert(0, str(HERE))
    try:
        from vblast_ss import _library  # loading it also shows that it fits
    except ImportError as error:
        raise SystemExit(f"no wheel: {error}") from error
    finally:
        del sys.path[0]
    return pathlib.Path(_library.lib.path).resolve(), _library.file_names()[0]


def metadata():
    return (f"Metadata-Version: 2.1\nName: {said('name')}\nVersion: {version()}\nSummary: {said('description')}\n"
            f"License: Apache-2.0\nRequires-Python: {said('requires-python')}\nProvides-Extra: numpy\n"
            'Requires-Dist: numpy; extra == "numpy"\n')


def write_wheel(folder, files, pure):
    """Files (name in the wheel -> bytes) with metadata and record; the wheel's name."""
    tag = "py3-none-any" if pure else TAG
    files = {**files, f"{INFO}/METADATA": metadata().encode(),
             f"{INFO}/LICENSE": (ROOT / "LICENSE").read_bytes(),
             f"{INFO}/WHEEL": (f"Wheel-Version: 1.0\nGenerator: vblast_ss\nRoot-Is-Purelib: {str(pure).lower()}\n"
                               f"Tag: {tag}\n").encode()}
    rows = []
    for name, data in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        rows.append(f"{name},sha256={digest},{len(data)}\n")
    files[f"{INFO}/RECORD"] = ("".join(rows) + f"{INFO}/RECORD,,\n").encode()
    wheel = f"{STEM}-{tag}.whl"
    with zipfile.ZipFile(pathlib.Path(folder) / wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.external_attr = (0o755 if "/lib/" in name else 0o644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, data)
    return wheel


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    files = {str(path.relative_to(HERE)).replace(os.sep, "/"): path.read_bytes()
             for path in sorted((HERE / "vblast_ss").rglob("*")) if path.suffix == ".py" or path.name == "py.typed"}
    path, name = library()
    files[f"vblast_ss/lib/{name}"] = path.read_bytes()
    return write_wheel(wheel_directory, files, pure=False)


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    return write_wheel(wheel_directory, {f"{NAME}_editable.pth": f"{HERE}\n".encode()}, pure=True)


def build_sdist(sdist_directory, config_settings=None):
    raise SystemExit("no source distribution: the library is built by CMake, in a checkout")


def get_requires_for_build_wheel(config_settings=None):
    return []


get_requires_for_build_editable = get_requires_for_build_sdist = get_requires_for_build_wheel
