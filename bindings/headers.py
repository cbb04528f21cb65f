"""Reads the public headers: types, structs, constants, functions, and what is said about them.

Not a C parser: it knows the few forms that the library uses, and refuses any other, so that nothing
public is left out of the binding because it was written differently."""
from __future__ import annotations

import dataclasses
import pathlib
import re


class Refused(Exception):
    """A header has a form that this reader does not know."""


@dataclasses.dataclass
class Declared:
    """A type with its pointers and dimensions, such as const double *positions or double axis[4][3]."""
    name: str
    type: str
    constant: bool
    pointers: int
    dimensions: tuple[int, ...]
    text: str = ""


@dataclasses.dataclass
class Struct:
    name: str
    fields: list[Declared]  # empty: opaque
    text: str


@dataclasses.dataclass
class Constants:
    kind: str  # the typedef it belongs to; empty: bits
    names: list[tuple[str, int, str]]
    text: str


@dataclasses.dataclass
class Function:
    name: str
    result: Declared
    parameters: list[Declared]
    text: str


@dataclasses.dataclass
class Header:
    name: str
    numbers: dict[str, int] = dataclasses.field(default_factory=dict)  # of #define
    kinds: dict[str, tuple[str, str]] = dataclasses.field(default_factory=dict)  # typedef -> (type, text)
    structs: list[Struct] = dataclasses.field(default_factory=list)
    constants: list[Constants] = dataclasses.field(default_factory=list)
    callbacks: list[Function] = dataclasses.field(default_factory=list)
    functions: list[Function] = dataclasses.field(default_factory=list)


def read_all(include: pathlib.Path) -> list[Header]:
    """Every header but the umbrella, those that others include first."""
    folder = include / "vblast_ss"
    left = {p.stem: p for p in sorted(folder.glob("*.h")) if p.stem != "vblast_ss"}
    done: list[Header] = []
    while left:
        names = {h.name for h in done}
        for name, path in left.items():
            wanted = set(re.findall(r"#include <vblast_ss/(\w+)\.h>", path.read_text()))
            if wanted <= names:
                done.append(read(path))
                del left[name]
                break
        else:
            raise Refused(f"headers include each other: {', '.join(left)}")
    return done


def read(path: pathlib.Path) -> Header:
    header = Header(path.stem)
    text, comments = keep_comments(path.read_text())
    text, lists = preprocess(text, header)
    at, about = 0, ""
    while True:
        at = re.compile(r"\s*").match(text, at).end()  # type: ignore[union-attr]
        if at == len(text):
            return header
        marker = re.compile(r"@(\d+)@").match(text, at)
        if marker:
            about, at = comments[int(marker.group(1))], marker.end()
            continue
        for form, take in FORMS:
            found = form.match(text, at)
            if found:
                take(header, found, about, comments, lists)
                at, about = found.end(), ""
                break
        else:
            raise Refused(f"{path.name}: cannot read '{' '.join(text[at:at + 80].split())}'")


def keep_comments(text: str) -> tuple[str, list[str]]:
    """Documentation becomes markers @n@, other comments nothing."""
    comments: list[str] = []

    def replace(found: re.Match[str]) -> str:
        body = found.group(0)
        if not body.startswith("/**"):
            return " "
        lines = (re.sub(r"^\s*\*? ?", "", line).rstrip() for line in body[3:-2].lstrip("<").split("\n"))
        comments.append("\n".join(lines).strip())
        return f" @{len(comments) - 1}@ "

    return re.sub(r"/\*.*?\*/", replace, text, flags=re.S), comments


def preprocess(text: str, header: Header) -> tuple[str, dict[str, list[tuple[str, int, str]]]]:
    """Takes numbers and X-macros out of the directives, and drops these and the extern "C" bracket."""
    lists: dict[str, list[tuple[str, int, str]]] = {}
    text = text.replace("\\\n", " ")
    for name, parameters, value in re.findall(r"^[ \t]*#[ \t]*define (\w+)(\(\w*\))?[ \t]+([^\n]*)$", text, re.M):
        rows = re.findall(r"\bX\(\s*(\w+),\s*(-?\d+),\s*\"([^\"]*)\"\)", value)
        if rows:
            lists[name] = [(row, int(number), words) for row, number, words in rows]
        elif not parameters and re.fullmatch(r"\d+", re.sub(r"@\d+@", "", value).strip()):
            header.numbers[name] = int(re.sub(r"@\d+@", "", value))
    text = re.sub(r"^[ \t]*#[^\n]*$", "", text, flags=re.M)
    for name, number in header.numbers.items():
        text = re.sub(rf"\[\s*{name}\s*\]", f"[{number}]", text)
    text, brackets = re.subn(r'extern\s+"C"\s*\{', "", text)
    if brackets:
        text = re.sub(r"\}\s*$", "", text)
    return text, lists


def declared(text: str, about: str = "") -> Declared:
    form = r"(const\s+)?(\w+)\s*((?:\*\s*(?:const\s*)?)*)(\w+)?\s*((?:\[\s*\d+\s*\]\s*)*)"
    found = re.fullmatch(form, text.strip())
    if not found:
        raise Refused(f"cannot read '{text}'")
    constant, kind, stars, name, dimensions = found.groups()
    return Declared(name or "", kind, bool(constant), stars.count("*"),
                    tuple(int(d) for d in re.findall(r"\d+", dimensions)), about)


def declared_parameters(text: str) -> list[Declared]:
    return [] if text.strip() == "void" else [declared(part) for part in text.split(",")]


def take_opaque(header: Header, found, about, comments, lists) -> None:
    header.structs.append(Struct(found.group(1), [], about))


def take_struct(header: Header, found, about, comments, lists) -> None:
    name, body, alias = found.groups()
    if name != alias:
        raise Refused(f"struct {name} and its typedef {alias} differ")
    fields, at = [], 0
    form = re.compile(r"\s*(?:@(\d+)@\s*)?([^;@]+?)\s*;[ \t]*\n?[ \t]*(?:@(\d+)@)?")
    while body[at:].strip():
        one = form.match(body, at)
        if not one:
            raise Refused(f"{name}: cannot read '{' '.join(body[at:at + 60].split())}'")
        before, text, after = one.groups()
        end = one.end()
        if before is not None and after is not None:  # the second is the next field's
            end, after = body.index(";", one.start(2)) + 1, None
        number = before if before is not None else after
        fields.append(declared(text, comments[int(number)] if number is not None else ""))
        at = end
    header.structs.append(Struct(name, fields, about))


def take_callback(header: Header, found, about, comments, lists) -> None:
    result, name, parameters = found.groups()
    header.callbacks.append(Function(name, declared(result), declared_parameters(parameters), about))


def take_kind(header: Header, found, about, comments, lists) -> None:
    header.kinds[found.group(2)] = (found.group(1), about)


def take_constants(header: Header, found, about, comments, lists) -> None:
    names: list[tuple[str, int, str]] = []
    body, at, before = found.group(1), 0, ""
    form = re.compile(r"\s*(?:@(?P<comment>\d+)@|(?P<list>\w+)\(\w+\)|(?P<name>\w+)\s*=\s*\(?"
                      r"(?P<value>-?(?:0x[\da-fA-F]+|\d+))u?(?:\s*<<\s*(?P<shift>\d+))?\)?"
                      r"\s*,?[ \t]*\n?[ \t]*(?:@(?P<after>\d+)@)?)")
    while body[at:].strip():
        one = form.match(body, at)
        if not one:
            raise Refused(f"{header.name}: cannot read constant '{' '.join(body[at:at + 60].split())}'")
        at = one.end()
        if one["comment"]:
            before = comments[int(one["comment"])]
        elif one["list"]:
            if one["list"] not in lists:
                raise Refused(f"{header.name}: no list {one['list']}")
            names += lists[one["list"]]
        else:
            after = one["after"]
            if before and after:
                at, after = one.start("after") - 1, None
            names.append((one["name"], int(one["value"], 0) << int(one["shift"] or 0), before or (comments[int(after)] if after else "")))
            before = ""
    of = re.search(r"constants of #(vbss_\w+)", about)
    header.constants.append(Constants(of.group(1) if of else "", names, about))


def take_function(header: Header, found, about, comments, lists) -> None:
    result, name, parameters = found.groups()
    header.functions.append(Function(name, declared(result), declared_parameters(parameters), about))


def take_inline(header: Header, found, about, comments, lists) -> None:
    """Functions that a header defines are not in the library."""


FORMS = [
    (re.compile(r"typedef\s+struct\s+(vbss_\w+)\s+\1\s*;"), take_opaque),
    (re.compile(r"typedef\s+struct\s+(vbss_\w+)\s*\{([^{}]*)\}\s*(vbss_\w+)\s*;"), take_struct),
    (re.compile(r"typedef\s+([\w\s*]+?)\(\s*\*\s*(vbss_\w+)\s*\)\s*\(([^()]*)\)\s*;"), take_callback),
    (re.compile(r"typedef\s+(\w+)\s+(vbss_\w+)\s*;"), take_kind),
    (re.compile(r"enum\s*\{([^{}]*)\}\s*;"), take_constants),
    (re.compile(r"static\s+inline\s+\w+\s+vbss_\w+\([^()]*\)\s*\{[^{}]*\}"), take_inline),
    (re.compile(r"VBSS_API\s+([\w\s*]+?)\b(vbss_\w+)\s*\(([^()]*)\)\s*;"), take_function),
]
