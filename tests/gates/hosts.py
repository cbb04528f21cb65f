"""Programs that were built with the headers of any earlier 1.x version run with this library, with the same results.

tests/abi/vblast_ss-<version>.headers has the headers and the map of a version as text (tests/abi/update-baseline.py
writes it). The programs of tests/abi/hosts are compiled with them and linked with a library that has the SONAME, the
names and the version nodes of that version, and nothing behind them. They then run with the library of this build."""
import os
import re
import shutil

import abi
import gate
import public_headers
import symbols

HOSTS = [("host.c", "gcc", ["-std=c11"]), ("host.cpp", "g++", ["-std=c++17"])]


def unpack(recorded, folder):
    """The headers and the map of a version in a folder of their own."""
    (folder / "include/vblast_ss").mkdir(parents=True)
    for part in re.split(r"^==== ", recorded.read_text(), flags=re.M)[1:]:
        name, _, text = part.partition("\n")
        (folder / ("include/vblast_ss/" if name.endswith((".h", ".hpp")) else "") / name).write_text(text)
    return folder


def stub(g, folder):
    """The library that a program of that version is linked with."""
    version_map = folder / "vblast_ss.map"
    include = folder / "include"
    source = folder / "stub.c"
    source.write_text("".join(f"void {name}(void);\nvoid {name}(void) {{}}\n" for name in symbols.map_nodes(version_map)))
    g.run(g.tool("gcc"), "-shared", "-fPIC", source, "-o", folder / "libvblast_ss.so", f"-Wl,--version-script={version_map}",
          f"-Wl,-soname,libvblast_ss.so.{public_headers.version(include)[0]}")


def build(g, folder):
    """The programs of tests/abi/hosts, as they were with the headers in a folder."""
    stub(g, folder)
    programs = []
    for name, compiler, options in HOSTS:
        programs.append(folder / name.replace(".", "_"))
        g.run(g.tool(compiler), *options, "-O1", "-I", folder / "include", g.source / "tests/abi/hosts" / name, "-L", folder,
              "-lvblast_ss", "-o", programs[-1])
    return programs


def results(g, programs, library):
    """What the programs print with a library: a list of texts, and complaints."""
    texts, complaints = [], []
    for program in programs:
        code, text = g.run(program, code=None, env=dict(os.environ, LD_LIBRARY_PATH=str(library)))
        texts.append(text)
        if code != 0:
            complaints.append(f"{program.name} of {program.parent.name} ends with {code}: {text.strip()[-300:]}")
    return texts, complaints


def current(g, name="today"):
    """Headers of today, in the form of a recorded version."""
    recorded = g.work / "today.headers"
    recorded.write_text(abi.headers_text(g.source))
    shutil.rmtree(g.work / name, ignore_errors=True)
    return unpack(recorded, g.work / name)


def compare(g, folders, library):
    """Programs of each folder print with the library what those of today print with the library of this build."""
    wanted, complaints = results(g, build(g, current(g)), g.library("shared").parent)
    for folder in folders:
        found, failures = results(g, build(g, folder), library)
        complaints += failures or [f"{name} of {folder.name} prints '{a.strip()}' and not '{b.strip()}'"
                                   for (name, _, _), a, b in zip(HOSTS, found, wanted) if a != b]
    return complaints


def inspect(g):
    recorded = abi.recorded_headers(g)
    if not recorded:
        return ["no recorded headers of this major version: run tests/abi/update-baseline.py"]
    g.notes.append(f"programs of {', '.join(path.stem for path in recorded)}")
    return compare(g, [unpack(path, g.work / path.stem) for path in recorded], g.library("shared").parent)


# ---- canaries

THREAD, VIEWS = "lib/thread/thread.c", "lib/thread/views.c"
CONFIG_SIZE = "VBSS_SIZE_WITH_POINTERS(vbss_thread_config, {}u, 3u)"


def grow_headers(include):
    """A field at the end of a configuration and of results, a function, a status."""
    gate.replace_once(include / "thread.h", "} vbss_thread_config;", "    double more;\n} vbss_thread_config;")
    gate.replace_once(include / "thread.h", "} vbss_thread_statistics;", "    double more;\n} vbss_thread_statistics;")
    base = include / "base.h"
    gate.replace_once(base, "X(VBSS_OK, 0,", 'X(VBSS_ERROR_MORE, -99, "one more") X(VBSS_OK, 0,')
    gate.replace_once(base, "VBSS_API uint32_t vbss_version(void);", "VBSS_API uint32_t vbss_version(void);\n"
                      "VBSS_API uint32_t vbss_added(void);")


def grown_library(g):
    """A later minor version, built as debug builds are: bits do not depend on that."""
    copy = g.copy_source("later")
    grow_headers(copy / "include/vblast_ss")
    last = CONFIG_SIZE.format(304) + ", "
    gate.replace_once(copy / THREAD, last + "0};", last + CONFIG_SIZE.format(312) + ", 0};")
    for path in (copy / THREAD, copy / "lib/thread/config_fields.c"):
        gate.replace_once(path, "sizeof(vbss_thread_config) == " + CONFIG_SIZE.format(304),
                          "sizeof(vbss_thread_config) == " + CONFIG_SIZE.format(312))
    gate.replace_once(copy / VIEWS, "sizeof(vbss_thread_statistics) == 160", "sizeof(vbss_thread_statistics) == 168")
    gate.replace_once(copy / VIEWS, "{160, 0}", "{160, 168, 0}")
    result = copy / "lib/base/result.c"
    result.write_text(result.read_text() + "\nuint32_t vbss_added(void)\n{\n    return 1;\n}\n")
    version_map = copy / "lib/vblast_ss.map"
    version_map.write_text(version_map.read_text() + "VBSS_1.1 {\n  global:\n    vbss_added;\n} VBSS_1.0;\n")
    return g.build("later-build", "-DCMAKE_BUILD_TYPE=Debug", f"-DCMAKE_C_COMPILER={g.tool('gcc')}", source=copy,
                   targets=["vblast_ss_shared"]) / "lib"


def later_host(g):
    folder = current(g, "later-host")
    grow_headers(folder / "include/vblast_ss")
    return compare(g, [folder], g.library("shared").parent)


def reordered_host(g):
    folder = current(g, "reordered-host")
    header = folder / "include/vblast_ss/thread.h"
    for old, new in (("double length;", "double swap;"), ("double radius;", "double length;"), ("double swap;", "double radius;")):
        text = header.read_text()
        header.write_text(text.replace(old, new, 1))
    return compare(g, [folder], g.library("shared").parent)


def without_function(g):
    folder = g.work / "without"
    folder.mkdir()
    version_map = folder / "vblast_ss.map"
    version_map.write_text((g.source / "lib/vblast_ss.map").read_text().replace("    vbss_knot_detector_judge;\n", ""))
    g.run(g.tool("gcc"), "-shared", "-o", folder / "libvblast_ss.so.1", f"-Wl,--version-script={version_map}",
          "-Wl,-soname,libvblast_ss.so.1", "-Wl,--whole-archive", g.library("archive"), "-Wl,--no-whole-archive", "-lm")
    return compare(g, [current(g, "host")], folder)


CANARIES = [
    ("a library with a field, a function and a status more",
     lambda g: compare(g, [current(g, "host-of-before")], grown_library(g)), None),
    ("a program that knows a field, a function and a status that the library does not", later_host, None),
    ("a library without a function", without_function, r"host_c of host ends with 127: .*vbss_knot_detector_judge"),
    ("a program to which two fields changed places", reordered_host, r"of reordered-host (ends with|prints)"),
]

if __name__ == "__main__":
    gate.main("hosts", inspect, CANARIES)
