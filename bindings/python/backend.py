"""Builds wheels with the shared library inside, and source distributions: a build backend (PEP 517, PEP 660) of its own,
as it must work without a network and needs nothing but Python.

In a checkout the library is the one that the package itself would load: VBLAST_SS_LIBRARY, or the newest of the build
folders. In an unpacked source distribution CMake builds it. Equal inputs give equal bytes."""
from __future__ import annotations

import base64
import gzip
import hashlib
import io
import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
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


def write_wheel(folder, files, tag):
    """Files (name in the wheel -> bytes) with metadata and record; the wheel's name. Platforms in the tag are joined by dots."""
    before, platforms = tag.rsplit("-", 1)
    tags = "".join(f"Tag: {before}-{platform}\n" for platform in platforms.split("."))
    files = {**files, f"{INFO}/METADATA": metadata().encode(),
             f"{INFO}/LICENSE": (ROOT / "LICENSE").read_bytes(),
             f"{INFO}/WHEEL": (f"Wheel-Version: 1.0\nGenerator: vblast_ss\nRoot-Is-Purelib: {str(platforms == 'any').lower()}\n"
                               f"{tags}").encode()}
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


def package_files():
    """The Python files of the package: name in the wheel -> bytes."""
    return {str(path.relative_to(HERE)).replace(os.sep, "/"): path.read_bytes()
            for path in sorted((HERE / "vblast_ss").rglob("*")) if path.suffix == ".py" or path.name == "py.typed"}


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    files = package_files()
    with tempfile.TemporaryDirectory() as folder:
        if is_source_distribution() and not os.environ.get("VBLAST_SS_LIBRARY"):
            os.environ["VBLAST_SS_LIBRARY"] = str(compiled(folder))  # front ends start a process for each hook
        path, name = library()
        files[f"vblast_ss/lib/{name}"] = path.read_bytes()
    return write_wheel(wheel_directory, files, TAG)


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    return write_wheel(wheel_directory, {f"{NAME}_editable.pth": f"{HERE}\n".encode()}, "py3-none-any")


def build_sdist(sdist_directory, config_settings=None):
    """The sources of library and package; pip takes the build requirements from the project file at the top."""
    files = {"PKG-INFO": metadata().encode(),
             "pyproject.toml": PROJECT.replace('backend-path = ["."]', 'backend-path = ["bindings/python"]').encode()}
    paths = [ROOT / "CMakeLists.txt", ROOT / "LICENSE", ROOT / "README.md", HERE / "backend.py", HERE / "pyproject.toml"]
    paths += [path for folder in (ROOT / "include", ROOT / "lib", HERE / "vblast_ss") for path in folder.rglob("*")
              if path.is_file() and path.suffix != ".pyc"]
    files |= {path.relative_to(ROOT).as_posix(): path.read_bytes() for path in paths}
    data = io.BytesIO()
    with tarfile.open(fileobj=data, mode="w", format=tarfile.PAX_FORMAT) as tar:
        for name, content in sorted(files.items()):
            entry = tarfile.TarInfo(f"{STEM}/{name}")
            entry.size, entry.mode = len(content), 0o644
            tar.addfile(entry, io.BytesIO(content))
    name = f"{STEM}.tar.gz"
    (pathlib.Path(sdist_directory) / name).write_bytes(gzip.compress(data.getvalue(), mtime=0))
    return name


def is_source_distribution():
    return (ROOT / "PKG-INFO").is_file()


def compiled(folder):
    """The shared library, built in a folder out of a source distribution."""
    ninja = ["-G", "Ninja"] if shutil.which("ninja") else []
    for command in (["-S", ROOT, "-B", folder, *ninja, "-DCMAKE_BUILD_TYPE=Release", "-DVBSS_BUILD_TESTS=OFF",
                     "-DVBSS_BUILD_EXAMPLES=OFF", "-DVBSS_BUILD_STATIC=OFF", "-DVBSS_INSTALL=OFF"],
                    ["--build", folder, "--config", "Release", "--parallel"]):
        subprocess.run(["cmake", *command], check=True)
    endings = ("so", "dylib", "dll")
    return next(path.resolve() for ending in endings for path in pathlib.Path(folder).rglob(f"*vblast_ss.{ending}"))


def get_requires_for_build_wheel(config_settings=None):
    if not is_source_distribution() or os.environ.get("VBLAST_SS_LIBRARY"):
        return []
    return [tool for tool in ("cmake", "ninja") if not shutil.which(tool)]


def get_requires_for_build_sdist(config_settings=None):
    return []


get_requires_for_build_editable = get_requires_for_build_sdist
