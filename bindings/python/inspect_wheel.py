#!/usr/bin/env python3
"""Inspects wheels: the library fits the platform that the wheel's tag promises, and exports every function.

    bindings/python/inspect_wheel.py PYTHON WHEEL ...     PYTHON: an interpreter that has auditwheel

auditwheel judges Linux. For Windows and macOS, which it does not know, the headers of the library are read here: machine,
libraries that it needs, and for macOS the minimum version.
"""
import pathlib
import re
import struct
import subprocess
import sys
import zipfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
ALLOWED_DLLS = re.compile(r"(kernel32|api-ms-win-crt-[a-z]+-l1-1-0|ntdll|msvcrt|ucrtbase)\.dll$", re.I)
ALLOWED_DYLIBS = {"/usr/lib/libSystem.B.dylib"}
MADE_BY_THE_LINKER = {"__dso_handle", "_mh_dylib_header"}


# Run by the interpreter that has auditwheel, and so pyelftools.
ELF_EXPORTS = """
import io, sys
from elftools.elf.elffile import ELFFile
symbols = ELFFile(io.BytesIO(sys.stdin.buffer.read())).get_section_by_name(".dynsym").iter_symbols()
print(*(symbol.name for symbol in symbols if symbol["st_shndx"] not in ("SHN_UNDEF", "SHN_ABS") and symbol.name))
"""


class Wrong(Exception):
    """A wheel that does not hold what its name promises."""


def functions():
    return set(re.findall(r"^\s+(vbss_\w+);", (ROOT / "lib/vblast_ss.map").read_text(), re.M))


def text_at(data, offset):
    return data[offset:data.index(b"\0", offset)].decode()


def read_pe(data):
    """Machine, needed libraries and exported names of a library for 64-bit Windows."""
    header = struct.unpack_from("<I", data, 0x3c)[0]
    if data[:2] != b"MZ" or data[header:header + 4] != b"PE\0\0":
        raise Wrong("no library for Windows")
    machine, sections = struct.unpack_from("<HH", data, header + 4)
    optional_size = struct.unpack_from("<H", data, header + 20)[0]
    optional = header + 24
    if struct.unpack_from("<H", data, optional)[0] != 0x20b:
        raise Wrong("not of 64 bits")
    table = [struct.unpack_from("<IIII", data, optional + optional_size + 40 * i + 8) for i in range(sections)]

    def place(address):
        for size, begin, raw_size, raw in table:
            if begin <= address < begin + max(size, raw_size):
                return raw + address - begin
        raise Wrong(f"address {address:#x} lies in no section")

    exports, imports = (struct.unpack_from("<I", data, optional + 112 + 8 * i)[0] for i in range(2))
    needed, entry = [], place(imports)
    while name := struct.unpack_from("<I", data, entry + 12)[0]:
        needed.append(text_at(data, place(name)))
        entry += 20
    count, _, names = struct.unpack_from("<III", data, place(exports) + 24)
    exported = {text_at(data, place(address)) for address in struct.unpack_from(f"<{count}I", data, place(names))}
    return machine, needed, exported


def read_macho(data):
    """Machine, minimum version of macOS, needed libraries and exported names of a library for macOS."""
    if struct.unpack_from("<I", data)[0] != 0xfeedfacf:
        raise Wrong("no library for macOS of 64 bits")
    machine, _, kind, commands = struct.unpack_from("<IIII", data, 4)
    if kind != 6:
        raise Wrong(f"Mach-O of type {kind}, not a dynamic library")
    minimum, needed, exported, at = None, [], set(), 32
    for _ in range(commands):
        command, size = struct.unpack_from("<II", data, at)
        if command == 0x32:  # LC_BUILD_VERSION
            system, minimum = struct.unpack_from("<II", data, at + 8)
            if system != 1:
                raise Wrong(f"for system {system}, not macOS")
        elif command == 0x24:  # LC_VERSION_MIN_MACOSX
            minimum = struct.unpack_from("<I", data, at + 8)[0]
        elif command == 0xc:  # LC_LOAD_DYLIB
            needed.append(text_at(data, at + struct.unpack_from("<I", data, at + 8)[0]))
        elif command == 2:  # LC_SYMTAB
            first, count, strings, _ = struct.unpack_from("<IIII", data, at + 8)
            for i in range(count):
                name, kind, section, _, _ = struct.unpack_from("<IBBHQ", data, first + 16 * i)
                if kind & 0x1f == 0xf and section:  # external, defined in a section
                    exported.add(text_at(data, strings + name)[1:])
        at += size
    if minimum is None:
        raise Wrong("no minimum version of macOS")
    return machine, (minimum >> 16, minimum >> 8 & 255), needed, exported - MADE_BY_THE_LINKER


def require_exports(exported):
    if exported != functions():
        missing, more = functions() - exported, exported - functions()
        raise Wrong(f"exports differ from lib/vblast_ss.map: missing {sorted(missing)[:3]}, more {sorted(more)[:3]}")


def inspect_windows(data):
    machine, needed, exported = read_pe(data)
    if machine != 0x8664:
        raise Wrong(f"machine {machine:#x}, not x86-64")
    if others := [name for name in needed if not ALLOWED_DLLS.match(name)]:
        raise Wrong(f"needs {', '.join(others)}")
    require_exports(exported)
    return f"PE x86-64, needs {len(needed)} libraries of the system"


def inspect_macos(tag, data):
    major, minor, name = re.fullmatch(r"macosx_(\d+)_(\d+)_(\w+)", tag).groups()
    machine, minimum, needed, exported = read_macho(data)
    if machine != {"x86_64": 0x1000007, "arm64": 0x100000c}[name]:
        raise Wrong(f"machine {machine:#x}, not {name}")
    if minimum != (int(major), int(minor)):
        raise Wrong(f"minimum macOS {minimum}, but the tag is {tag}")
    if set(needed) - ALLOWED_DYLIBS:
        raise Wrong(f"needs {', '.join(needed)}")
    if name == "arm64" and b"\xfa\xde\x0c\xc0" not in data:
        raise Wrong("without a code signature, which macOS on arm64 asks for")
    require_exports(exported)
    return f"Mach-O {name}, macOS {minimum[0]}.{minimum[1]}"


def inspect_linux(wheel, tag, data, python):
    done = subprocess.run([python, "-m", "auditwheel", "show", wheel], capture_output=True, text=True)
    said = " ".join((done.stdout + done.stderr).split())
    found = re.search(r'consistent with the following platform tag: "(\w+)"', said)
    if done.returncode != 0 or found is None:
        raise Wrong(f"auditwheel: {said[-800:]}")

    def policy(text):
        return re.fullmatch(r"(\D+)_(\d+)_(\d+)_(\w+)", text).groups()

    family, major, minor, machine = policy(tag)
    if (found_policy := policy(found[1]))[::3] != (family, machine) or \
            tuple(map(int, found_policy[1:3])) > (int(major), int(minor)):
        raise Wrong(f"the tag is {tag}, auditwheel finds {found[1]}")
    done = subprocess.run([python, "-c", ELF_EXPORTS], input=data, capture_output=True, check=True)
    require_exports(set(done.stdout.decode().split()))
    return f"auditwheel: {found[1]}"


def inspect(wheel, python):
    """What was found, in a few words. Raises Wrong."""
    tag = wheel.name.removesuffix(".whl").split("-")[-1].split(".")[0]
    with zipfile.ZipFile(wheel) as archive:
        names = [name for name in archive.namelist() if name.startswith("vblast_ss/lib/")]
        if len(names) != 1:
            raise Wrong(f"{len(names)} libraries")
        said = archive.read(next(name for name in archive.namelist() if name.endswith(".dist-info/WHEEL"))).decode()
        data = archive.read(names[0])
    interpreter, abi, platforms = wheel.name.removesuffix(".whl").split("-")[-3:]
    if re.findall(r"^Tag: (.+)$", said, re.M) != [f"{interpreter}-{abi}-{each}" for each in platforms.split(".")]:
        raise Wrong("the tags in WHEEL are not those of the file's name")
    if tag == "win_amd64":
        return inspect_windows(data)
    if tag.startswith("macosx"):
        return inspect_macos(tag, data)
    return inspect_linux(wheel, tag, data, python)


if __name__ == "__main__":
    for path in map(pathlib.Path, sys.argv[2:]):
        print(f"{path.name}: {inspect(path, sys.argv[1])}")
