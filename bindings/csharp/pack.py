#!/usr/bin/env python3
"""Makes a folder in the shape of a NuGet package, and a Unity package, with the native libraries.

    bindings/csharp/pack.py OUT [RID=LIBRARY ...]     such as linux-x64=build/release/lib/libvblast_ss.so

Without an argument RID=LIBRARY the newest library of build/release and build/default is taken for this machine.
The assembly is built by dotnet where it is installed, otherwise by Mono's compiler mcs; then it runs on Mono only, and
other runtimes build it from the sources that lie beside it."""
from __future__ import annotations

import json
import pathlib
import platform
import shutil
import subprocess
import sys
import tempfile
from html import escape

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
SOURCES = HERE / "VblastSs"
DESCRIPTION = "Simulation of surgical suturing: threads, needles, graspers and tissue at haptic rates."
# Runtime identifier -> name that DllImport("vblast_ss") finds, folder of a Unity package.
FILES = {"linux-x64": ("libvblast_ss.so", "Linux/x86_64"), "linux-arm64": ("libvblast_ss.so", "Linux/arm64"),
         "win-x64": ("vblast_ss.dll", "Windows/x86_64"), "osx-x64": ("libvblast_ss.dylib", "macOS/x86_64"),
         "osx-arm64": ("libvblast_ss.dylib", "macOS/arm64")}


def version() -> str:
    """As NuGet and Unity write it: major.minor.patch and the suffix."""
    base = (ROOT / "include" / "vblast_ss" / "base.h").read_text()
    words = {line.split()[1]: line.split()[2] for line in base.splitlines() if line.startswith("#define VBSS_VERSION_")
             and len(line.split()) == 3}
    return ".".join(words[f"VBSS_VERSION_{part}"] for part in ("MAJOR", "MINOR", "PATCH")) + words["VBSS_VERSION_SUFFIX"].strip('"')


def this_machine() -> str:
    system = {"linux": "linux", "win32": "win", "darwin": "osx"}.get(sys.platform, sys.platform)
    machine = {"x86_64": "x64", "amd64": "x64", "aarch64": "arm64", "arm64": "arm64"}.get(platform.machine().lower(), "")
    return f"{system}-{machine}"


def built_library() -> pathlib.Path:
    name = FILES[this_machine()][0]
    found = [path for preset in ("release", "default") for path in [ROOT / "build" / preset / "lib" / name] if path.exists()]
    if not found:
        sys.exit("pack.py: no library in build/release or build/default: build it, or name it as RID=LIBRARY")
    return max(found, key=lambda path: path.stat().st_mtime)


def compile_assembly(folder: pathlib.Path) -> pathlib.Path:
    """Builds into the package; returns the folder with the assembly."""
    if shutil.which("dotnet"):
        target = folder / "lib" / "netstandard2.1"
        with tempfile.TemporaryDirectory() as work:
            copy = pathlib.Path(work) / "VblastSs"
            shutil.copytree(SOURCES, copy)
            subprocess.run(["dotnet", "build", "-c", "Release", "-o", target, copy / "VblastSs.csproj"], check=True)
        return target
    if shutil.which("mcs"):
        target = folder / "mono"
        target.mkdir(parents=True)
        files = sorted(str(path) for path in SOURCES.rglob("*.cs"))
        subprocess.run(["mcs", "-langversion:latest", "-unsafe", "-optimize", "-target:library", "-nowarn:0649,0169,1591",
                        f"-doc:{target / 'VblastSs.xml'}", f"-out:{target / 'VblastSs.dll'}", *files], check=True)
        return target
    sys.exit("pack.py: neither dotnet nor mcs is there: apt-get install mono-mcs")


def nuget(folder: pathlib.Path, libraries: dict[str, pathlib.Path]) -> None:
    folder.mkdir(parents=True)
    compile_assembly(folder)
    shutil.copytree(SOURCES, folder / "src", ignore=shutil.ignore_patterns("*.asmdef"))
    for rid, library in libraries.items():
        target = folder / "runtimes" / rid / "native"
        target.mkdir(parents=True)
        shutil.copy(library, target / FILES[rid][0])
    for name in ("README.md", "LICENSE"):
        shutil.copy(ROOT / name, folder / name)
    (folder / "VblastSs.nuspec").write_text(f"""<?xml version="1.0" encoding="utf-8"?>
<package xmlns="http://schemas.microsoft.com/packaging/2013/05/nuspec.xsd">
  <metadata>
    <id>VblastSs</id>
    <version>{version()}</version>
    <authors>libvblast_ss</authors>
    <description>{escape(DESCRIPTION)}</description>
    <license type="expression">Apache-2.0</license>
    <readme>README.md</readme>
    <dependencies>
      <group targetFramework=".NETStandard2.1" />
    </dependencies>
  </metadata>
</package>
""")


def unity(folder: pathlib.Path, libraries: dict[str, pathlib.Path]) -> None:
    """A package from sources, so that IL2CPP compiles it too."""
    runtime = folder / "Runtime"
    shutil.copytree(SOURCES, runtime, ignore=shutil.ignore_patterns("*.csproj"))
    for rid, library in libraries.items():
        target = folder / "Plugins" / FILES[rid][1]
        target.mkdir(parents=True)
        shutil.copy(library, target / FILES[rid][0])
    shutil.copytree(HERE / "unity", folder / "Samples~" / "HangingThread")
    shutil.copy(ROOT / "LICENSE", folder / "LICENSE.md")
    (folder / "package.json").write_text(json.dumps({
        "name": "org.vblast-ss", "version": version(), "displayName": "vblast_ss", "description": DESCRIPTION, "unity": "2021.2",
        "samples": [{"displayName": "Hanging thread", "description": "A thread drawn by a LineRenderer.",
                     "path": "Samples~/HangingThread"}]}, indent=2) + "\n")


def main() -> int:
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        print(__doc__, file=sys.stderr)
        return 2
    out = pathlib.Path(sys.argv[1])
    libraries: dict[str, pathlib.Path] = {}
    for one in sys.argv[2:]:
        rid, _, library = one.partition("=")
        if rid not in FILES:
            sys.exit(f"pack.py: {rid} is none of {', '.join(FILES)}")
        libraries[rid] = pathlib.Path(library)
    if not libraries:
        libraries[this_machine()] = built_library()
    folder = out / f"VblastSs.{version()}"
    for made in (folder, out / "org.vblast-ss"):
        if made.exists():
            sys.exit(f"pack.py: {made} exists already")
    nuget(folder, libraries)
    unity(out / "org.vblast-ss", libraries)
    print(f"{folder}\n{out / 'org.vblast-ss'}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
