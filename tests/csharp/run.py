#!/usr/bin/env python3
"""Tests of the C# binding.

    run.py generated    the committed files are what the headers give, and every function has a wrapper
    run.py runtime      layout of all structs, and the tests in C#, on Mono
    run.py unity        the sample compiles against stubs of UnityEngine, and runs
    run.py package      pack.py makes the packages, and a program finds the library in one of them

VBLAST_SS_LIBRARY is the shared library, VBSS_CC a C compiler, VBSS_WORK a folder to work in."""
from __future__ import annotations

import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
BINDING = ROOT / "bindings" / "csharp"
sys.path.insert(0, str(BINDING))
import generate  # noqa: E402
import headers  # noqa: E402
from cs_types import Types  # noqa: E402

# The C locale's decimal point stands in what the programs print and in what they compare.
CLEAN = {**os.environ, "LC_ALL": "C"}


def run(*command: object, env: dict[str, str] = CLEAN) -> str:
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, env=env)
    if done.returncode:
        sys.exit(f"{pathlib.Path(str(command[0])).name} failed:\n{done.stdout}{done.stderr}")
    return done.stdout


def work(name: str) -> pathlib.Path:
    folder = pathlib.Path(os.environ["VBSS_WORK"]) / name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


def need_mono(what: str) -> None:
    for tool in ("mcs", "mono"):
        if not shutil.which(tool):
            print(f"{tool} is not there for {what}: apt-get install mono-mcs mono-runtime libmono-system-core4.0-cil")
            sys.exit(0)


def compile_library(folder: pathlib.Path) -> pathlib.Path:
    out = folder / "VblastSs.dll"
    run("mcs", "-langversion:latest", "-unsafe", "-debug", "-target:library", "-warnaserror", "-nowarn:0649,0169", f"-out:{out}",
        *sorted((BINDING / "VblastSs").rglob("*.cs")))
    return out


def with_library(folder: pathlib.Path) -> dict[str, str]:
    """Mono finds libvblast_ss.so in a folder of the loader's path."""
    shutil.copy(os.environ["VBLAST_SS_LIBRARY"], folder / "libvblast_ss.so")
    return {**CLEAN, "LD_LIBRARY_PATH": str(folder)}


def c_layout(folder: pathlib.Path) -> dict[str, list[int]]:
    """Size and offsets of every struct with fields, as the C compiler has them, by their name in C#."""
    all_headers = headers.read_all(ROOT / "include")
    types = Types(all_headers)
    rows = []
    for struct in (s for h in all_headers for s in h.structs if s.fields):
        name = "ViewData" if struct.name == "vbss_view" else types.data(struct.name)
        offsets = ", ".join(f"(unsigned)offsetof({struct.name}, {field.name})" for field in struct.fields)
        rows.append(f'    {{ const unsigned o[] = {{ {offsets} }}; printf("{name} %u", (unsigned)sizeof({struct.name}));\n'
                    '      for (unsigned i = 0; i < sizeof o / sizeof *o; i++) printf(" %u", o[i]); printf("\\n"); }')
    source = folder / "layout.c"
    source.write_text("#include <stddef.h>\n#include <stdio.h>\n#include <vblast_ss/vblast_ss.h>\nint main(void)\n{\n" +
                      "\n".join(rows) + "\n    return 0;\n}\n")
    run(os.environ["VBSS_CC"], "-std=c11", f"-I{ROOT / 'include'}", source, "-o", folder / "layout")
    return table(run(folder / "layout"))


def table(text: str) -> dict[str, list[int]]:
    return {line.split()[0]: [int(word) for word in line.split()[1:]] for line in text.splitlines()}


def check_layout(folder: pathlib.Path, printed: str) -> None:
    wanted, found = c_layout(folder), table(printed)
    differ = [f"{name}: C# has {found.get(name)}, C has {numbers}" for name, numbers in wanted.items() if found.get(name) != numbers]
    if differ:
        sys.exit("layouts differ:\n" + "\n".join(differ))
    print(f"{len(wanted)} structs have the layout of C")


def python_hash() -> str:
    """State of SceneTests.HashOfAHangingThread, computed by the Python binding."""
    program = ("from vblast_ss import Context, Scene, Thread\n"
               "c = Context(); s = Scene(c); t = Thread(c, segment_count=20, length=0.1)\n"
               "t.attach('pin', 0, position=(0, 0, 0)); s.add(t)\n"
               "for _ in range(50): s.step(1e-3)\n"
               "print(s.state_hash)")
    return run(sys.executable, "-B", "-c", program, env={**CLEAN, "PYTHONPATH": str(ROOT / "bindings" / "python")}).strip()


def generated() -> None:
    differ = generate.differences()
    if differ:
        sys.exit(f"run bindings/csharp/generate.py: {', '.join(differ)}")
    functions = {f.name for h in headers.read_all(ROOT / "include") for f in h.functions}
    wrappers = "".join(path.read_text() for path in (BINDING / "VblastSs").rglob("*.cs") if not path.name.endswith("Native.cs"))
    called = set(re.findall(r"Native\.(vbss_\w+)", wrappers))
    if functions != called:
        sys.exit(f"without a wrapper: {sorted(functions - called)}; not in the headers: {sorted(called - functions)}")
    print(f"{len(functions)} functions have a wrapper")


def runtime() -> None:
    need_mono("the C# tests")
    folder = work("runtime")
    library = compile_library(folder)
    env = with_library(folder)
    program = folder / "tests.exe"
    run("mcs", "-langversion:latest", "-debug", f"-r:{library}", f"-out:{program}", *sorted(HERE.glob("*.cs")))
    check_layout(folder, run("mono", program, "layout", env=env))
    found, wanted = run("mono", program, "hash", env=env).strip(), python_hash()
    if found != wanted:
        sys.exit(f"a hanging thread has the hash {found} in C#, {wanted} in Python")
    print(run("mono", "--debug", program, env=env), end="")
    ten_minutes(folder, library, env)


def ten_minutes(folder: pathlib.Path, library: pathlib.Path, env: dict[str, str]) -> None:
    """The program of docs/start/csharp.md."""
    page = (ROOT / "docs" / "start" / "csharp.md").read_text()
    source = folder / "Program.cs"
    source.write_text(re.findall(r"```csharp\n(.*?)```", page, re.S)[0])
    run("mcs", f"-r:{library}", f"-out:{folder / 'Program.exe'}", source)
    said = run("mono", folder / "Program.exe", env=env)
    if not re.fullmatch(r"the last node is at \(.*\)\nErrorOutOfRange: .+\n", said):
        sys.exit(f"the program of docs/start/csharp.md said {said}")
    print(said, end="")


def unity() -> None:
    need_mono("the Unity sample")
    folder = work("unity")
    library = compile_library(folder)
    program = folder / "drive.exe"
    run("mcs", "-langversion:latest", "-warnaserror", "-nowarn:1591", f"-r:{library}", f"-out:{program}",
        *sorted((BINDING / "unity").glob("*.cs")), *sorted((HERE / "unity_stubs").glob("*.cs")))
    print(run("mono", program, env=with_library(folder)), end="")


def package() -> None:
    need_mono("the package")
    folder = work("package")
    machine = run(sys.executable, "-B", "-c", f"import sys; sys.path.insert(0, {str(BINDING)!r}); import pack; print(pack.this_machine())").strip()
    made = run(sys.executable, "-B", BINDING / "pack.py", folder, f"{machine}={os.environ['VBLAST_SS_LIBRARY']}").split()
    assembly = next(pathlib.Path(made[0]).glob("*/**/VblastSs.dll"))
    program = folder / "version.exe"
    source = folder / "Version.cs"
    source.write_text("public static class Program { public static void Main() { new VblastSs.Context().Dispose(); "
                      "System.Console.WriteLine(VblastSs.Vblast.Version()); } }\n")
    run("mcs", f"-r:{assembly}", f"-out:{program}", source)
    shutil.copy(assembly, folder)
    native = pathlib.Path(made[0]) / "runtimes" / machine / "native"
    version = run("mono", program, env={**CLEAN, "LD_LIBRARY_PATH": str(native)}).strip()
    run("mcs", "-langversion:latest", "-unsafe", "-target:library", f"-out:{folder / 'Runtime.dll'}",
        *sorted((pathlib.Path(made[1]) / "Runtime").rglob("*.cs")))
    print(f"version {version} from {native.relative_to(folder)}")


if __name__ == "__main__":
    parts = {"generated": generated, "runtime": runtime, "unity": unity, "package": package}
    if len(sys.argv) != 2 or sys.argv[1] not in parts:
        sys.exit(__doc__)
    parts[sys.argv[1]]()
