#!/usr/bin/env python3
"""Builds the wheels of all platforms on one Linux machine. zig, from the Python package index, is the C compiler.

    bindings/python/wheels.py [FOLDER] [--only PLATFORM ...]     FOLDER: default build/wheels/dist
    bindings/python/wheels.py --list

Compilers, caches and objects stay in build/wheels. Needs Python, pip with access to the package index, CMake and Ninja.
Every wheel is inspected (inspect_wheel.py) before it is written to FOLDER.
"""
import argparse
import dataclasses
import os
import pathlib
import shutil
import subprocess
import sys

import backend
import inspect_wheel

ROOT = backend.ROOT
WORK = ROOT / "build/wheels"
TOOLS = ["ziglang==0.17.1", "auditwheel==6.8.2"]
NO_INDEX = "the package index cannot be reached"


@dataclasses.dataclass(frozen=True)
class Platform:
    """A wheel: zig's name of the machine, CMake's names, the wheel's platform tags, the library's name in the wheel."""
    target: str
    system: str
    processor: str
    tags: str
    library: str


def linux(machine, target, tags):
    return Platform(target, "Linux", machine, tags, "libvblast_ss.so.1")


PLATFORMS = {
    # Both names of the same promise: pip before 20.3 knows the second only.
    f"manylinux-{machine}": linux(machine, f"{machine}-linux-gnu.2.17", f"manylinux_2_17_{machine}.manylinux2014_{machine}")
    for machine in ("x86_64", "aarch64")}
PLATFORMS |= {f"musllinux-{machine}": linux(machine, f"{machine}-linux-musl", f"musllinux_1_2_{machine}")
              for machine in ("x86_64", "aarch64")}
PLATFORMS |= {
    "win-amd64": Platform("x86_64-windows-gnu", "Windows", "AMD64", "win_amd64", "vblast_ss.dll"),
    "macos-x86_64": Platform("x86_64-macos.10.13-none", "Darwin", "x86_64", "macosx_10_13_x86_64", "libvblast_ss.dylib"),
    "macos-arm64": Platform("aarch64-macos.11.0-none", "Darwin", "arm64", "macosx_11_0_arm64", "libvblast_ss.dylib")}


def run(*command):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          cwd=ROOT, env={**os.environ, "ZIG_GLOBAL_CACHE_DIR": str(WORK / "zig-cache"),
                                         "ZIG_LOCAL_CACHE_DIR": str(WORK / "zig-cache")})
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout[-4000:]}")
    return done.stdout


def tools():
    """The interpreter of a virtual environment with zig and auditwheel."""
    python, mark = WORK / "tools/bin/python", WORK / "tools/installed"
    if not mark.is_file() or mark.read_text().split() != TOOLS:
        run(sys.executable, "-m", "venv", WORK / "tools")
        done = subprocess.run([python, "-m", "pip", "install", "-q", *TOOLS], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"{NO_INDEX}:\n{done.stderr[-2000:]}")
        mark.write_text("\n".join(TOOLS))
    return python


def compiler(name):
    """A C compiler for a platform, which CMake takes for a clang."""
    path, python = WORK / f"cc/{name}", tools()
    path.parent.mkdir(parents=True, exist_ok=True)
    text = (f"#!/bin/sh\nexport ZIG_GLOBAL_CACHE_DIR='{WORK}/zig-cache' ZIG_LOCAL_CACHE_DIR='{WORK}/zig-cache'\n"
            f"exec '{python}' -m ziglang cc -target {PLATFORMS[name].target} \"$@\"\n")
    if not path.is_file() or path.read_text() != text:  # a newer file is another compiler for ccache
        path.write_text(text)
        path.chmod(0o755)
    return path


def configured(name):
    """CMake's options that name compiler and system."""
    platform = PLATFORMS[name]
    options = [f"-DCMAKE_C_COMPILER={compiler(name)}", f"-DCMAKE_SYSTEM_NAME={platform.system}",
               f"-DCMAKE_SYSTEM_PROCESSOR={platform.processor}", "-DCMAKE_BUILD_TYPE=Release"]
    if platform.system == "Windows":
        options.append("-DCMAKE_RC_COMPILER=/bin/false")  # asked for, but never called
    if platform.system == "Darwin":
        options += ["-DCMAKE_OSX_SYSROOT=", "-DCMAKE_OSX_ARCHITECTURES=", "-DCMAKE_OSX_DEPLOYMENT_TARGET=",
                    "-DCMAKE_INSTALL_NAME_TOOL=/bin/false"]
    return options


def compile_library(name):
    """The shared library of a platform."""
    folder = WORK / name
    run("cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", *configured(name), "-DCMAKE_SHARED_LINKER_FLAGS=-s",
        "-DVBSS_BUILD_TESTS=OFF", "-DVBSS_BUILD_EXAMPLES=OFF", "-DVBSS_BUILD_STATIC=OFF", "-DVBSS_INSTALL=OFF")
    run("cmake", "--build", folder, "--target", "vblast_ss_shared")
    found = {path.resolve() for pattern in ("libvblast_ss.so", "libvblast_ss.dylib", "libvblast_ss.dll")
             for path in folder.rglob(pattern)}
    if len(found) != 1:
        sys.exit(f"{folder} has {len(found)} shared libraries")
    return found.pop()


def make(name, folder):
    platform = PLATFORMS[name]
    staged = WORK / "staged"
    shutil.rmtree(staged, ignore_errors=True)
    staged.mkdir(parents=True)
    files = backend.package_files()
    files[f"vblast_ss/lib/{platform.library}"] = compile_library(name).read_bytes()
    wheel = staged / backend.write_wheel(staged, files, f"py3-none-{platform.tags}")
    print(f"{wheel.name}: {wheel.stat().st_size} bytes; {inspect_wheel.inspect(wheel, tools())}", flush=True)
    shutil.move(wheel, folder / wheel.name)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path, nargs="?", default=WORK / "dist")
    parser.add_argument("--only", nargs="+", choices=PLATFORMS, default=list(PLATFORMS))
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    if options.list:
        print("\n".join(PLATFORMS))
        return
    options.folder.mkdir(parents=True, exist_ok=True)
    for name in options.only:
        make(name, options.folder)


if __name__ == "__main__":
    main()
