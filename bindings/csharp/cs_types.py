"""Types of C#: what a declaration of a header is in a struct, in a property, and in a signature."""
from __future__ import annotations

import re
import textwrap
from html import escape

import headers
import naming

SCALARS = {"double": "double", "float": "float", "char": "byte", "int8_t": "sbyte", "uint8_t": "byte", "int16_t": "short",
           "uint16_t": "ushort", "int32_t": "int", "uint32_t": "uint", "int64_t": "long", "uint64_t": "ulong"}
# Classes with another name in C#: System.Threading.Thread would hide the first.
RENAMED = {"vbss_thread": "SutureThread"}
# Three numbers that are no vector.
NO_VECTORS = {"radius", "weights", "weights_a", "weights_b"}
# Pointers to numbers that may be NULL, in signatures.
OPTIONAL = {"orientation": "Quaterniond", "velocity": "Vector3d", "angular_velocity": "Vector3d", "direction": "Vector3d",
            "point": "Vector3d", "torque": "Vector3d", "position": "Vector3d", "weights": "Doubles3"}
KEYWORDS = {"params", "ref", "out", "in", "object", "string", "event", "base", "lock", "fixed", "operator"}


def pascal(name: str) -> str:
    """segment_count -> SegmentCount, USP_10_0 -> Usp10_0."""
    parts = [part for part in name.split("_") if part]
    text = ""
    for part in parts:
        joint = "_" if text and text[-1].isdigit() and part[0].isdigit() else ""
        text += joint + part[0].upper() + part[1:].lower()
    return text


def local(name: str) -> str:
    """Name of a parameter: knot_throw -> knotThrow."""
    text = pascal(name)
    text = text[0].lower() + text[1:]
    return f"@{text}" if text in KEYWORDS else text


def class_name(struct: str) -> str:
    return RENAMED.get(struct) or naming.camel(struct)


def summary(text: str, indent: str) -> list[str]:
    """Documentation comment."""
    words = escape(" ".join(naming.plain(text.split("@", 1)[0]).split()), quote=False)
    lines = textwrap.wrap(words or "No description.", 96 - len(indent))
    if len(lines) == 1:
        return [f"{indent}/// <summary>{lines[0]}</summary>"]
    return [f"{indent}/// <summary>"] + [f"{indent}/// {line}" for line in lines] + [f"{indent}/// </summary>"]


def parameter_texts(text: str) -> dict[str, str]:
    """What the comment of a function says about each parameter."""
    found = re.findall(r"@param(?:\[\w+\])?\s+(\w+)\s+(.*?)(?=\n@|\Z)", text, re.S)
    return {name: " ".join(naming.plain(about).split()) for name, about in found}


class Types(naming.Names):
    """Which structs are inputs (classes with defaults) and which are results (structs), and arrays in structs."""

    def __init__(self, all_headers: list[headers.Header]) -> None:
        super().__init__(all_headers)
        self.structs = {s.name: s for h in all_headers for s in h.structs}
        functions = {f.name for h in all_headers for f in h.functions}
        self.inputs = {name for name in self.structs if f"{name}_init" in functions}
        self.flags = {naming.enum_name(c)[0] for h in all_headers for c in h.constants if not c.kind and min(n for _, n, _ in c.names) >= 0}
        self.arrays: set[tuple[str, int]] = set()

    def enum(self, field: headers.Declared, struct: str) -> str:
        """Enumeration of a field, if it has the field's own size."""
        name = self.enum_of(field, struct)
        wanted = "uint32_t" if name in self.flags else "int32_t"
        return name if name and self.kinds.get(field.type, field.type) == wanted else ""

    def scalar(self, d: headers.Declared) -> str:
        return self.enums.get(d.type) or SCALARS.get(self.kinds.get(d.type, d.type), "")

    def array(self, element: str, count: int) -> str:
        self.arrays.add((element, count))
        return {"Vector3d": "Vectors", "IntPtr": "Pointers", "uint": "UInts", "ulong": "ULongs",
                "Result": "Results"}.get(element, element.capitalize() + "s") + str(count)

    def vector(self, d: headers.Declared) -> str:
        """Type of an array of a struct or a signature, such as Vector3d."""
        element, dimensions = self.scalar(d), list(d.dimensions)
        if element == "double" and dimensions[-1] == 3 and d.name not in NO_VECTORS:
            element = "Vector3d"
            dimensions.pop()
        elif element == "double" and dimensions == [4] and ("orientation" in d.name or d.name == "mount"):
            return "Quaterniond"
        if not dimensions:
            return element
        if len(dimensions) > 1:
            raise headers.Refused(f"{d.name}: an array of arrays")
        return self.array(element, dimensions[0])

    def in_struct(self, d: headers.Declared, struct: str) -> str:
        """Type of a field, as the library has it in memory."""
        if d.pointers or d.type in self.callbacks:
            return self.array("IntPtr", d.dimensions[0]) if d.dimensions else "IntPtr"
        if d.dimensions:
            return self.vector(d)
        kind = self.enum(d, struct) or self.scalar(d)
        if not kind:
            raise headers.Refused(f"{struct}.{d.name}: unknown type {d.type}")
        return kind

    def data(self, struct: str) -> str:
        """The struct that the library reads or fills."""
        return class_name(struct) + ("Data" if struct in self.inputs else "")

    def native(self, d: headers.Declared) -> str:
        """Type of a parameter of an imported function."""
        if d.type in self.opaque:
            return {1: "ObjectHandle", 2: "out IntPtr"}[d.pointers]
        if d.type == "void" and not d.pointers:
            return "void"
        if d.type == "void" or d.type in self.callbacks:
            return "IntPtr" + "*" * (d.pointers - 1)
        if d.type in self.structs:
            return ("ViewData" if d.type == "vbss_view" else self.data(d.type)) + "*" * d.pointers
        return self.scalar(d) + "*" * (d.pointers + (1 if d.dimensions else 0))
