"""Structs, constants, callbacks and prototypes are what tests/abi/layout-lp64.txt says, and no
declaration uses a type whose size depends on compiler or machine.

The readable half of the ABI baseline; it also sees what abi-compliance-checker lets pass: a callback
with another signature, a renumbered constant. tests/abi/update-baseline.py writes the file."""
import re
import shutil

import gate
import public_headers

BASELINE = "tests/abi/layout-lp64.txt"
# Anywhere in a public declaration, behind a pointer too.
FORBIDDEN = ["_Bool", "bool", "int", "long", "short", "unsigned", "signed", "float", "enum", "size_t",
             "ssize_t", "ptrdiff_t", "intptr_t", "uintptr_t", "wchar_t", "time_t", "FILE", "va_list"]


def check_types(include):
    structs, complaints = public_headers.structs(include)
    plain = public_headers.FIXED_WIDTH | {"double"} | set(public_headers.integer_types(include))
    plain |= set(public_headers.callback_types(include))
    for name, fields in structs.items():
        for field, kind, is_pointer in fields:
            if not is_pointer and kind not in plain:
                complaints.append(f"{name}.{field} is of type {kind}: use a fixed-width integer, "
                                  "double, a pointer or a function pointer type")
    for path in public_headers.headers(include):
        text = public_headers.declarations(path)
        text = re.sub(r"\benum\s*\{[^{}]*\}\s*;", "", text)  # constants without a type of their own
        for word in FORBIDDEN:
            for line in (line for line in text.splitlines() if re.search(rf"\b{word}\b", line)):
                complaints.append(f"{path.name}: '{' '.join(line.split())}' uses {word}, "
                                  "whose size is not the same everywhere")
    return complaints


def constants(g, include):
    """Names of all enumeration constants, those out of X-macros too."""
    text = g.run(g.tool("cc"), "-E", "-P", "-I", include, include / "vblast_ss/vblast_ss.h")
    return [name for body in re.findall(r"\benum\s*\{([^{}]*)\}", text)
            for name in re.findall(r"(\w+)\s*=", body) if name.startswith("VBSS_")]


def measure(g, include):
    """Lines "name what it is", the numbers from a program compiled against the headers."""
    structs, _ = public_headers.structs(include)
    rows = [f'printf("{name} is %lld\\n", (long long){name});' for name in constants(g, include)]
    g.notes.append(f"{len(structs)} structs, {sum(map(len, structs.values()))} fields, "
                   f"{len(rows)} constants")
    for name, fields in sorted(structs.items()):
        rows.append(f'printf("{name} size %zu alignment %zu\\n", sizeof({name}), _Alignof({name}));')
        for field, _, _ in fields:
            rows.append(f'printf("{name}.{field} offset %zu size %zu\\n", '
                        f"offsetof({name}, {field}), sizeof((({name} *)0)->{field}));")
    source = g.work / "layout.c"
    source.write_text("#include <stddef.h>\n#include <stdio.h>\n#include <vblast_ss/vblast_ss.h>\n"
                      "int main(void)\n{\n    " + "\n    ".join(rows) + "\n    return 0;\n}\n")
    g.run(g.tool("cc"), "-std=c11", "-I", include, source, "-o", g.work / "layout")
    lines = g.run(g.work / "layout").splitlines()
    for kind in (public_headers.integer_types, public_headers.callback_types, public_headers.functions):
        lines += [f"{name} = {text}" for name, text in sorted(kind(include).items())]
    return lines


def rows_of(lines):
    return dict(line.split(" ", 1) for line in lines if line and not line.startswith("#"))


def check(g, include):
    complaints = check_types(include)
    if complaints:
        return complaints  # what cannot be read cannot be measured
    found = rows_of(measure(g, include))
    wanted = rows_of((g.source / BASELINE).read_text().splitlines())
    for name in sorted(set(found) | set(wanted)):
        if name not in wanted:
            complaints.append(f"{name} is not in {BASELINE} (run tests/abi/update-baseline.py)")
        elif name not in found:
            complaints.append(f"{name} stands in {BASELINE} but not in the headers")
        elif found[name] != wanted[name]:
            complaints.append(f"{name} has changed: {found[name]}, was {wanted[name]}")
    return complaints


def update(g):
    (g.source / BASELINE).write_text("# The public interface where pointers have 64 bits; sizes in bytes.\n"
                                     "# Written by tests/abi/update-baseline.py.\n" +
                                     "\n".join(measure(g, g.include)) + "\n")


def changes(g):
    """What is no longer as the file says, apart from growth."""
    path = g.source / BASELINE
    before = rows_of(path.read_text().splitlines()) if path.exists() else {}
    now = rows_of(measure(g, g.include))
    return [f"{name} {now.get(name, 'is gone')}" for name in before
            if now.get(name) != before[name] and not grown(name, before, now)]


def grown(name, before, now):
    """A config or result struct may grow at its end: callers tell the size they know."""
    form = r"size (\d+) (alignment \d+)"
    old, new = re.fullmatch(form, before[name]), re.fullmatch(form, now.get(name, ""))
    return (f"{name}.struct_size" in now and old and new and old.group(2) == new.group(2) and
            int(old.group(1)) < int(new.group(1)))


# ---- canaries: changed headers

def changed(*replacements):
    def inspect(g):
        include = g.work / "include"
        shutil.rmtree(include, ignore_errors=True)
        shutil.copytree(g.include, include)
        for old, new in replacements:
            gate.replace_once(include / "vblast_ss/base.h", old, new)
        return check(g, include)
    return inspect


PEAK = "uint64_t bytes_peak; "
COUNT = "uint64_t allocation_count; "
END = "} vbss_context_statistics;\n"
CANARIES = [
    ("two fields in another order",
     changed((PEAK, "uint64_t swap; "), (COUNT, PEAK), ("uint64_t swap; ", COUNT)),
     r"^vbss_context_statistics.(bytes_peak|allocation_count) has changed"),
    ("a field appended without a new baseline",
     changed((END, "uint64_t more;\n" + END)),
     r"^vbss_context_statistics has changed|^vbss_context_statistics.more is not in"),
    ("a new struct", changed((END, END + "typedef struct vbss_new { double x; } vbss_new;\n")),
     r"^vbss_new(.x)? is not in"),
    ("a bool field", changed(("uint32_t reserved;  ", "bool reserved[4];  ")),
     r"reserved is of type bool|uses bool"),
    ("a field of an enum type",
     changed(("uint32_t reserved;  ", "enum vbss_kinds reserved;  ")), r"is of type enum|uses enum"),
    ("a bit-field", changed(("uint32_t reserved;  ", "uint32_t reserved : 32;  ")), r"bit-field"),
    ("a struct within a struct",
     changed((PEAK, "vbss_context_config inner; ")), r"is of type vbss_context_config"),
    ("a size_t behind a pointer", changed(("vbss_context **context);", "vbss_context **context, size_t *n);")),
     r"uses size_t"),
    ("a callback with another signature",
     changed(("vbss_log_level level, const char", "int64_t level, const char")), r"^vbss_log_fn has changed"),
    ("a renumbered status", changed(("STRUCT_SIZE, -4,", "STRUCT_SIZE, -40,")),
     r"^VBSS_ERROR_STRUCT_SIZE has changed: is -40"),
    ("a new function without a new baseline",
     changed(("VBSS_API uint32_t vbss_version(void);",
              "VBSS_API uint32_t vbss_version(void);\nVBSS_API uint32_t vbss_added(void);")),
     r"^vbss_added is not in"),
    ("a struct with a tag only", changed((END, END + "struct vbss_loose { double x; };\n")),
     r"is not of the form"),
]

if __name__ == "__main__":
    gate.main("layout", lambda g: check(g, g.include), CANARIES)
