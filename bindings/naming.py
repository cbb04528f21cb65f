"""What the generators of all languages have in common: names, enumerations, and where each comes from."""
from __future__ import annotations

import re

import headers

# Structs that the library fills become values; these do too, which go both ways.
BOTH_WAYS = {"vbss_device_sample", "vbss_device_capabilities"}
NO_VALUES = {"vbss_view"}  # becomes an array
# Constants without a type are called after what they begin with, but for these, by their first one.
CALLED = {"VBSS_METRICS_HAS_LDJ": "MetricsMotionBits", "VBSS_METRICS_PHASE_ALL": "MetricsTask"}


def camel(name: str) -> str:
    """vbss_thread_field, VBSS_DEVICE_HAS_ -> ThreadField, DeviceHas."""
    return "".join(part.capitalize() for part in name.strip("_").split("_")[1:])


def plain(text: str) -> str:
    """Text of a comment without the marks of the documentation tool."""
    return re.sub(r"#(vbss_|VBSS_)", r"\1", text).replace("\\", "")


def enum_name(constants: headers.Constants) -> tuple[str, str]:
    """Class of the constants and what their names begin with."""
    names = [name for name, _, _ in constants.names]
    prefix = names[0].rsplit("_", 1)[0] + "_"
    while not all(name.startswith(prefix) for name in names):
        prefix = prefix[:-1].rsplit("_", 1)[0] + "_"
    return CALLED.get(names[0]) or (camel(constants.kind) if constants.kind else camel(prefix) + "Bits"), prefix


def short_name(constant: str, prefix: str) -> str:
    """A constant without what all constants of its enumeration begin with, as far as it stays an identifier."""
    short = constant[len(prefix):]
    return short if short.isidentifier() else constant[prefix[:-1].rindex("_") + 1:]


def is_value(struct: headers.Struct) -> bool:
    first = struct.fields[0] if struct.fields else None
    filled = first is not None and first.name == "struct_size" and "filled" in first.text
    return (filled or struct.name in BOTH_WAYS) and struct.name not in NO_VALUES


class Names:
    """Where each name comes from, and which enumeration a field has."""

    def __init__(self, all_headers: list[headers.Header]) -> None:
        self.home: dict[str, str] = {}
        self.kinds: dict[str, str] = {}
        self.enums: dict[str, str] = {}  # kind -> class
        self.bits: dict[str, str] = {}  # prefix -> class
        self.opaque: set[str] = set()
        self.callbacks: set[str] = set()
        for header in all_headers:
            self.kinds.update({name: base for name, (base, _) in header.kinds.items()})
            for struct in header.structs:
                self.home[struct.name] = header.name
                if not struct.fields:
                    self.opaque.add(struct.name)
            for callback in header.callbacks:
                self.home[callback.name] = header.name
                self.callbacks.add(callback.name)
            for constants in header.constants:
                name, prefix = enum_name(constants)
                if name in self.home:
                    raise headers.Refused(f"two enumerations would be called {name}")
                self.home[name] = header.name
                if constants.kind:
                    self.enums[constants.kind] = name
                else:
                    self.bits.setdefault(prefix, name)

    def enum_of(self, field: headers.Declared, struct: str) -> str:
        """The enumeration that a field's values are of, or "". Bits that are called after a struct are its own."""
        if field.pointers or field.dimensions:
            return ""
        said = re.search(r"(VBSS_\w+_) bits", field.text)
        if said:
            own = f"{camel(struct)}Bits"
            return own if own in self.home else self.bits.get(said.group(1), "")
        return self.enums.get(field.type, "")
