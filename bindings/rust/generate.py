#!/usr/bin/env python3
"""Writes the generated parts of the Rust binding from the public headers: the crate vblast-ss-sys, a module for each header, and
the configurations of the crate vblast-ss.

    bindings/rust/generate.py            writes the files
    bindings/rust/generate.py --check    says which differ from what it would write, and fails

Run it after every change of include/vblast_ss; what it writes depends on the headers alone."""
from __future__ import annotations

import pathlib
import re
import sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import headers  # noqa: E402
import naming  # noqa: E402

INCLUDE = HERE.parent.parent / "include"
FIRST = "// Written by bindings/rust/generate.py from the public headers: do not edit."
SCALARS = {"double": "f64", "float": "f32", "char": "c_char", "void": "c_void",
           **{f"{sign}int{bits}_t": f"{sign or 'i'}{bits}" for sign in ("", "u") for bits in (8, 16, 32, 64)}}
KEYWORDS = {"type", "ref", "in", "move", "loop", "match", "use", "self", "box", "final", "fn", "mod", "where"}
# Inputs that the safe crate has. Fields with pointers are set by hand-written code or not at all.
CONFIGS = ("vbss_scene_config", "vbss_thread_config", "vbss_thread_attachment", "vbss_drain_config", "vbss_needle_config",
           "vbss_grasper_config", "vbss_session_config")
# Those that borrow arrays, and the type that has them.
ARRAYS = {"vbss_thread_config": "ThreadArrays"}


def identifier(name: str) -> str:
    return f"r#{name}" if name in KEYWORDS else name


def documented(text: str, indent: str = "") -> list[str]:
    """A comment of Rust, where brackets would be links, and indented lines programs."""
    body = re.sub(r"([\[\]])", r"\\\1", naming.plain(text).replace("@param[out]", "@param"))
    lines = body.split("\n") if body else []
    return [f"{indent}/// {line.strip()}".rstrip() for line in lines]


def rust_type(declared: headers.Declared, parameter: bool = False) -> str:
    kind = SCALARS.get(declared.type, declared.type)
    dimensions = list(declared.dimensions)
    pointers = declared.pointers
    if parameter and dimensions:  # an array as a parameter is a pointer to its first item
        dimensions.pop(0)
        pointers += 1
    for size in reversed(dimensions if not pointers or parameter else []):
        kind = f"[{kind}; {size}]"
    for level in range(pointers):
        kind = f"*{'const' if declared.constant and level == 0 else 'mut'} {kind}"
    if pointers and not parameter:
        for size in reversed(dimensions):
            kind = f"[{kind}; {size}]"
    return kind


def signature(function: headers.Function) -> str:
    parameters = ", ".join(f"{identifier(p.name) if p.name else '_'}: {rust_type(p, True)}" for p in function.parameters)
    void = function.result.type == "void" and not function.result.pointers
    return f"({parameters})" + ("" if void else f" -> {rust_type(function.result)}")


def struct_lines(struct: headers.Struct) -> list[str]:
    if not struct.fields:
        return ["", *documented(struct.text), "#[repr(C)]", f"pub struct {struct.name} {{", "    _private: [u8; 0],",
                "    _neither_send_nor_sync: core::marker::PhantomData<*mut u8>,", "}"]
    lines = ["", *documented(struct.text), "#[repr(C)]", "#[derive(Debug, Clone, Copy)]", f"pub struct {struct.name} {{"]
    for field in struct.fields:
        lines += [*documented(field.text, "    "), f"    pub {identifier(field.name)}: {rust_type(field)},"]
    return lines + ["}"]


def module(header: headers.Header) -> str:
    lines: list[str] = []
    for name, number in header.numbers.items():
        lines.append(f"pub const {name}: u32 = {number};")
    for name, (base, text) in header.kinds.items():
        lines += ["", *documented(text), f"pub type {name} = {SCALARS[base]};"]
    for constants in header.constants:
        kind = constants.kind or ("i32" if any(number < 0 for _, number, _ in constants.names) else "u32")
        lines += ["", *(f"// {line.strip()}".rstrip() for line in naming.plain(constants.text).split("\n"))]
        for name, number, text in constants.names:
            lines += [*documented(text), f"pub const {name}: {kind} = {number};"]
    for callback in header.callbacks:
        lines += ["", *documented(callback.text), f"pub type {callback.name} = Option<unsafe extern \"C\" fn{signature(callback)}>;"]
    for struct in header.structs:
        lines += struct_lines(struct)
    if header.functions:
        lines += ["", 'extern "C" {']
        for function in header.functions:
            lines += [*documented(function.text, "    "), f"    pub fn {function.name}{signature(function)};"]
        lines += ["}"]
    used = [name for name in ("c_char", "c_void") if any(re.search(rf"\b{name}\b", line) for line in lines)]
    used_lines = ([f"use std::os::raw::{{{', '.join(used)}}};"] if used else []) + ["#[allow(unused_imports)]", "use crate::*;", ""]
    return "\n".join([FIRST, *used_lines, *lines]) + "\n"


def setters(struct: headers.Struct) -> list[str]:
    """A configuration of the safe crate, whose fields without pointers are set one after another."""
    name = naming.camel(struct.name)
    arrays = ARRAYS.get(struct.name)
    borrowed, elided = ("<'a>", "<'_>") if arrays else ("", "")
    lines = ["", *documented(struct.text), "#[derive(Debug, Clone)]", f"pub struct {name}{borrowed} {{",
             f"    pub(crate) raw: sys::{struct.name},", *([f"    pub(crate) arrays: {arrays}<'a>,"] if arrays else []), "}", "",
             f"impl Default for {name}{elided} {{", "    fn default() -> Self {",
             f"        {name} {{ raw: defaults(sys::{struct.name}_init){', arrays: Default::default()' if arrays else ''} }}",
             "    }", "}", "", f"impl {name}{elided} {{", "    /// The defaults of the library.", "    pub fn new() -> Self {",
             "        Self::default()", "    }"]
    for field in struct.fields:
        plain = not field.pointers and (field.type in SCALARS or field.type.startswith("vbss_"))
        if field.name in ("struct_size",) or field.name.startswith("reserved") or not plain or field.type.endswith("_fn"):
            continue
        kind = rust_type(field)
        kind = re.sub(r"\b(vbss_\w+)", r"sys::\1", kind)
        lines += ["", *documented(field.text, "    "), f"    pub fn {identifier(field.name)}(mut self, value: {kind}) -> Self {{",
                  f"        self.raw.{identifier(field.name)} = value;", "        self", "    }"]
    return lines + ["}"]


def files() -> dict[pathlib.Path, str]:
    all_headers = headers.read_all(INCLUDE)
    sources = HERE / "vblast-ss-sys" / "src"
    made = {sources / f"{header.name}.rs": module(header) for header in all_headers}
    names = [header.name for header in all_headers]
    made[sources / "lib.rs"] = "\n".join([
        FIRST, "//! The C interface of libvblast_ss, as its headers declare it. Each function's documentation is that of the header.",
        "//! The crate vblast-ss has owners and lifetimes for a part of it.",
        "#![allow(non_camel_case_types, rustdoc::all)]", "",
        *(f"mod {name};" for name in names), "", *(f"pub use {name}::*;" for name in names)]) + "\n"
    by_name = {struct.name: struct for header in all_headers for struct in header.structs}
    configs = HERE / "vblast-ss" / "src" / "configs"
    for name in CONFIGS:
        uses = ["use super::defaults;", *([f"use super::{ARRAYS[name]};"] if name in ARRAYS else []), "use crate::sys;"]
        made[configs / f"{name.removeprefix('vbss_')}.rs"] = "\n".join([FIRST, *uses, *setters(by_name[name])]) + "\n"
    return made


def differences() -> list[str]:
    return [str(path.relative_to(HERE)) for path, text in files().items() if not path.is_file() or path.read_text() != text]


def main() -> None:
    if sys.argv[1:] == ["--check"]:
        if differ := differences():
            sys.exit(f"run bindings/rust/generate.py: {', '.join(differ)}")
        return
    for path, text in files().items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


if __name__ == "__main__":
    main()
