#!/usr/bin/env python3
"""Writes the low-level binding, vblast_ss/_api, from the public headers.

    bindings/python/generate.py            writes the files
    bindings/python/generate.py --check    says which differ from what it would write, and fails

Run it after every change of include/vblast_ss; what it writes depends on the headers alone."""
from __future__ import annotations

import pathlib
import re
import sys
import textwrap

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import headers  # noqa: E402
import naming  # noqa: E402
from naming import camel, enum_name, is_value, plain, short_name  # noqa: E402

INCLUDE = HERE.parent.parent / "include"
OUT = HERE / "vblast_ss" / "_api"

SCALARS = {"double": "c_double", "char": "c_char", **{f"{s}int{b}_t": f"c_{s}int{b}" for s in ("", "u")
                                                      for b in (8, 16, 32, 64)}}


def docstring(text: str, indent: str) -> list[str]:
    lines = []
    for paragraph in plain(text).split("\n\n"):
        lines += textwrap.wrap(" ".join(paragraph.split()), 96 - len(indent)) + [""]
    lines = lines[:-1] or ["."]
    if len(lines) == 1:
        return [f'{indent}"""{lines[0]}"""']
    return [f'{indent}"""{lines[0]}'] + [f"{indent}{line}".rstrip() for line in lines[1:-1]] + \
           [f'{indent}{lines[-1]}"""']


class Names(naming.Names):
    """What types are in Python."""

    def ctype(self, d: headers.Declared, parameter: bool = False) -> str:
        base = SCALARS.get(self.kinds.get(d.type, d.type), "")
        pointers = d.pointers + (1 if parameter and d.dimensions else 0)
        if d.type == "void":
            kind = "None" if not pointers else "c_void_p"
            pointers = max(0, pointers - 1)
        elif d.type == "char" and pointers and d.constant:
            kind, pointers = "c_char_p", pointers - 1
        elif base:
            kind = base
        elif d.type in self.home:
            kind = d.type
        else:
            raise headers.Refused(f"unknown type {d.type} of {d.name}")
        for _ in range(pointers):
            kind = f"POINTER({kind})"
        if not parameter:
            for dimension in reversed(d.dimensions):
                kind = f"{kind} * {dimension}" if " * " not in kind else f"({kind}) * {dimension}"
        return kind

    def annotation(self, d: headers.Declared) -> str:
        base = self.kinds.get(d.type, d.type)
        if d.pointers or d.dimensions or base not in SCALARS:
            return "Any"
        return "float" if base == "double" else "int"

    def value(self, d: headers.Declared, struct: str) -> str:
        if d.pointers:
            return "str" if self.ctype(d) == "c_char_p" else "Any"
        kind = self.enum_of(d, struct) or ("float" if self.kinds.get(d.type, d.type) == "double" else "int")
        for _ in d.dimensions:
            kind = f"tuple[{kind}, ...]"
        return kind


def enum_lines(constants: headers.Constants) -> list[str]:
    name, prefix = enum_name(constants)
    lines = ["", "", f"class {name}({'IntFlag' if name.endswith('Bits') else 'IntEnum'}):"]
    lines += docstring(constants.text, "    ")
    for constant, number, text in constants.names:
        lines += [f"    {short_name(constant, prefix)} = {number}"] + docstring(text, "    ")
    return lines


def struct_lines(struct: headers.Struct, names: Names) -> list[str]:
    lines = ["", "", f"class {struct.name}(ctypes.Structure):"]
    if not struct.fields:
        return lines + docstring(struct.text or struct.name, "    ")
    about = struct.text + "".join(f"\n\n{f.name}: {f.text}" for f in struct.fields
                                  if f.name != "struct_size" and not f.name.startswith("reserved"))
    lines += docstring(about, "    ")
    lines += [f"    {f.name}: {names.annotation(f)}" for f in struct.fields]
    kinds = {f.name: kind for f in struct.fields for kind in [names.enum_of(f, struct.name)] if kind}
    lines.append("    _kinds_: ClassVar[dict[str, Any]] = {" +
                 ", ".join(f'"{name}": {kind}' for name, kind in kinds.items()) + "}")
    lines.append("    _fields_ = [")
    lines += [f'        ("{f.name}", {names.ctype(f)}),' for f in struct.fields]
    lines.append("    ]")
    if is_value(struct):
        lines += ["", "", f"class {camel(struct.name)}(NamedTuple):"]
        lines += docstring(struct.text + f" Fields as {struct.name} says.", "    ")
        lines += [f"    {f.name}: {names.value(f, struct.name)}" for f in struct.fields
                  if f.name != "struct_size" and not f.name.startswith("reserved")]
    return lines


def callback_lines(callback: headers.Function, names: Names) -> list[str]:
    kinds = [names.ctype(callback.result)] + [names.ctype(p, True) for p in callback.parameters]
    about = " ".join(plain(callback.text).split("@")[0].split())
    return ["", "", *(f"# {line}" for line in textwrap.wrap(about, 96)),
            f"{callback.name} = CFUNCTYPE({', '.join(kinds)})"]


def module(header: headers.Header, names: Names) -> str:
    body: list[str] = []
    for name, number in header.numbers.items():
        body.append(f"{name} = {number}")
    for constants in header.constants:
        body += enum_lines(constants)
    # In the order of the header: a callback may take a struct, and a struct hold a callback.
    written = {s.name for s in header.structs if not s.fields}
    for struct in header.structs:
        if not struct.fields:
            body += struct_lines(struct, names)
    waiting: list = [*header.callbacks, *(s for s in header.structs if s.fields)]
    while waiting:
        for one in waiting:
            used = {d.type for d in (one.fields if isinstance(one, headers.Struct) else one.parameters)}
            if not used & {w.name for w in waiting} - {one.name}:
                body += struct_lines(one, names) if isinstance(one, headers.Struct) else callback_lines(one, names)
                written.add(one.name)
                waiting.remove(one)
                break
        else:
            raise headers.Refused(f"{header.name}: types need each other")
    body += ["", "", "FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {"]
    for function in header.functions:
        parameters = [names.ctype(p, True) for p in function.parameters]
        row = f'    "{function.name}": ({names.ctype(function.result)}, (' + \
              ", ".join(parameters) + ("," if len(parameters) == 1 else "") + ")),"
        body += textwrap.wrap(row, 100, subsequent_indent="        ", break_long_words=False)
    body += ["}"]
    return head(header, names, body) + "\n".join(body) + "\n"


def head(header: headers.Header, names: Names, body: list[str]) -> str:
    code = re.sub(r'""".*?"""|^#[^\n]*$', "", "\n".join(body), flags=re.S | re.M)
    words = set(re.findall(r"\w+", code))
    lines = [f'"""{header.name}.h, as ctypes sees it. Written by bindings/python/generate.py: do not edit."""',
             "from __future__ import annotations", "", "import ctypes"]
    kinds = sorted(w for w in words if w in ("CFUNCTYPE", "POINTER") or
                   (w.startswith("c_") and hasattr(__import__("ctypes"), w)))
    lines.append(f"from ctypes import {', '.join(kinds)}")
    enums = sorted({"IntEnum", "IntFlag"} & words)
    if enums:
        lines.append(f"from enum import {', '.join(enums)}")
    lines.append(f"from typing import {', '.join(sorted({'Any', 'ClassVar', 'NamedTuple'} & words))}")
    own = {name for name, home in names.home.items() if home == header.name}
    wanted: dict[str, list[str]] = {}
    for word in sorted(words & set(names.home) - own):
        wanted.setdefault(names.home[word], []).append(word)
    lines.append("")
    for home, some in sorted(wanted.items()):
        text = f"from .{home} import {', '.join(some)}"
        lines += [text] if len(text) <= 100 else \
            [f"from .{home} import ("] + textwrap.wrap(", ".join(some), 94, initial_indent="    ",
                                                       subsequent_indent="    ") + [")"]
    text = "\n".join(lines).rstrip() + "\n"
    return text + ("\n" if body and body[0] else "")


def generate(include: pathlib.Path = INCLUDE) -> dict[str, str]:
    """File name -> text."""
    all_headers = headers.read_all(include)
    names = Names(all_headers)
    files = {f"{header.name}.py": module(header, names) for header in all_headers}
    lines = ['"""The C interface as ctypes sees it. Written by bindings/python/generate.py: do not edit."""',
             "from __future__ import annotations", "", "from typing import Any", ""]
    stems = sorted(header.name for header in all_headers)
    lines += [f"from . import {', '.join(stems)}", "",
              "FUNCTIONS: dict[str, tuple[Any, tuple[Any, ...]]] = {}",
              f"for _header in ({', '.join(stems)}):", "    FUNCTIONS.update(_header.FUNCTIONS)", "",
              f'__all__ = [{", ".join(repr(s) for s in stems)}, "FUNCTIONS"]'.replace("'", '"')]
    files["__init__.py"] = "\n".join(lines) + "\n"
    return files


def differences(include: pathlib.Path = INCLUDE, out: pathlib.Path = OUT) -> list[str]:
    """Files that are not what the headers say."""
    wanted = generate(include)
    there = {path.name: path.read_text() for path in out.glob("*.py")} if out.is_dir() else {}
    return sorted(name for name in set(wanted) | set(there) if wanted.get(name) != there.get(name))


def main() -> int:
    if sys.argv[1:] == ["--check"]:
        differ = differences()
        for name in differ:
            print(f"{OUT.name}/{name} is not what the headers say: run bindings/python/generate.py", file=sys.stderr)
        return 1 if differ else 0
    if len(sys.argv) > 1:
        print(__doc__, file=sys.stderr)
        return 2
    OUT.mkdir(exist_ok=True)
    files = generate()
    for path in OUT.glob("*.py"):
        if path.name not in files:
            path.unlink()
    for name, text in files.items():
        (OUT / name).write_text(text)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except headers.Refused as refused:
        sys.exit(f"generate.py: {refused}")
