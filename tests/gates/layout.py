"""Structs, constants, callbacks and prototypes are what tests/abi/layout-lp64.txt says, and no
declaration uses a type whose size depends on compiler or machine. Where pointers have 32 bits, structs are what
tests/abi/layout-ilp32.txt and layout-i386.txt say.

The readable half of the ABI baseline; it also sees what abi-compliance-checker lets pass: a callback
with another signature, a renumbered constant. tests/abi/update-baseline.py writes the files; nothing runs that is
compiled for another machine."""
import re
import shutil

import gate
import public_headers

BASELINE = "tests/abi/layout-lp64.txt"
# Structs where pointers have 32 bits: the file, what it says at its head, compilers that must agree with it.
BASELINES_32 = [
    ("tests/abi/layout-ilp32.txt", "where pointers have 32 bits and double is aligned to 8 bytes (armhf, wasm32, Windows)",
     [("clang", f"--target={target}") for target in ("arm-linux-gnueabihf", "wasm32-wasi", "i686-w64-mingw32")]),
    ("tests/abi/layout-i386.txt", "where pointers have 32 bits and double is aligned to 4 bytes (i386 except Windows)",
     [("clang", "--target=i686-linux-gnu")]),
]
# Other machines with 64 bits must agree with BASELINE.
COMPILERS_64 = [("clang", f"--target={target}") for target in ("aarch64-linux-gnu", "x86_64-w64-mingw32")]
MARK, DIGITS = b"VBSS layout:", 6
# The table of the structs whose size is not the same everywhere, and the lines around it.
TABLE = "docs/reference/abi.md"
TABLE_FROM, TABLE_TO = "| struct | 64 bits | armhf, wasm32 | i386 |\n|---|---|---|---|\n", "\nThe files "
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


def measure_structs(g, include, structs, compiler, *options):
    """Lines "name what it is", the numbers as digits in an object file: nothing is run, so any target will do."""
    names, numbers = [], []
    for name, fields in sorted(structs.items()):
        names.append(name + " size {} alignment {}")
        numbers += [f"sizeof({name})", f"_Alignof({name})"]
        for field, _, _ in fields:
            names.append(f"{name}.{field} offset {{}} size {{}}")
            numbers += [f"offsetof({name}, {field})", f"sizeof((({name} *)0)->{field})"]
    digits = ",\n    ".join(f"DIGITS({number})" for number in numbers)
    form = ", ".join(f"'0' + (n) / {10 ** k} % 10" for k in reversed(range(DIGITS)))
    mark = ", ".join(f"'{chr(byte)}'" for byte in MARK)
    source = g.work / "layout.c"
    source.write_text("#include <stddef.h>\n#include <vblast_ss/vblast_ss.h>\n"
                      f"#define DIGITS(n) {form}\nextern const char layout[];\n"
                      f"const char layout[] = {{{mark},\n    {digits}}};\n")
    made = g.work / "layout.o"
    g.run(g.tool(compiler), *options, "-std=c11", "-ffreestanding", "-c", "-I", include, source, "-o", made)
    text = made.read_bytes().split(MARK)[1]
    values = [int(text[DIGITS * i:DIGITS * (i + 1)]) for i in range(len(numbers))]
    return [name.format(*values[2 * i:2 * i + 2]) for i, name in enumerate(names)]


def measure(g, include):
    """Lines "name what it is" for all that is public."""
    structs, _ = public_headers.structs(include)
    rows = [f'printf("{name} is %lld\\n", (long long){name});' for name in constants(g, include)]
    g.notes.append(f"{len(structs)} structs, {sum(map(len, structs.values()))} fields, "
                   f"{len(rows)} constants")
    source = g.work / "constants.c"
    source.write_text("#include <stdio.h>\n#include <vblast_ss/vblast_ss.h>\n"
                      "int main(void)\n{\n    " + "\n    ".join(rows) + "\n    return 0;\n}\n")
    g.run(g.tool("cc"), "-std=c11", "-I", include, source, "-o", g.work / "constants")
    lines = g.run(g.work / "constants").splitlines()
    lines += measure_structs(g, include, structs, "cc")
    for kind in (public_headers.integer_types, public_headers.callback_types, public_headers.functions):
        lines += [f"{name} = {text}" for name, text in sorted(kind(include).items())]
    return lines


def rows_of(lines):
    return dict(line.split(" ", 1) for line in lines if line and not line.startswith("#"))


def check(g, include):
    complaints = check_types(include)
    if complaints:
        return complaints  # what cannot be read cannot be measured
    return differences(rows_of(measure(g, include)), rows_of_file(g, BASELINE), BASELINE)


def check_machines(g, include):
    """Complaints about structs of other machines; nothing of them is run."""
    structs, _ = public_headers.structs(include)
    lp64 = {name: text for name, text in rows_of_file(g, BASELINE).items() if name.split(".")[0] in structs}
    cases = [(compiler, lp64, BASELINE) for compiler in COMPILERS_64]
    cases += [(compiler, rows_of_file(g, file), file) for file, _, compilers in BASELINES_32 for compiler in compilers]
    complaints = []
    for compiler, wanted, file in cases:
        found = rows_of(measure_structs(g, include, structs, *compiler))
        complaints += [f"{complaint} ({' '.join(compiler)})" for complaint in differences(found, wanted, file)]
    return complaints


def rows_of_file(g, file):
    return rows_of((g.source / file).read_text().splitlines())


def differences(found, wanted, file):
    complaints = []
    for name in sorted(set(found) | set(wanted)):
        if name not in wanted:
            complaints.append(f"{name} is not in {file} (run tests/abi/update-baseline.py)")
        elif name not in found:
            complaints.append(f"{name} stands in {file} but not in the headers")
        elif found[name] != wanted[name]:
            complaints.append(f"{name} has changed: {found[name]}, was {wanted[name]}")
    return complaints


def size_table(g):
    """Rows of TABLE, from the files."""
    files = [rows_of_file(g, file) for file in (BASELINE, *(file for file, _, _ in BASELINES_32))]
    sizes = {name: [file[name].split()[1] for file in files] for name, text in files[1].items() if "alignment" in text}
    return "".join(f"| `{name}` | {' | '.join(row)} |\n" for name, row in sizes.items() if len(set(row)) > 1)


def page_around_table(g):
    text = (g.source / TABLE).read_text()
    before, rest = text.split(TABLE_FROM)
    rows, after = rest.split(TABLE_TO)
    return before + TABLE_FROM, rows, TABLE_TO + after


def check_table(g):
    return [] if page_around_table(g)[1] == size_table(g) else [
        f"the table of sizes in {TABLE} is not that of the files (run tests/abi/update-baseline.py)"]


def update_machines(g):
    """Writes the files of BASELINES_32, and the table that compares them with BASELINE."""
    structs, _ = public_headers.structs(g.include)
    for file, where, compilers in BASELINES_32:
        (g.source / file).write_text(f"# The public structs {where}; sizes in bytes.\n"
                                     "# Written by tests/abi/update-baseline.py.\n" +
                                     "\n".join(measure_structs(g, g.include, structs, *compilers[0])) + "\n")
    before, _, after = page_around_table(g)
    (g.source / TABLE).write_text(before + size_table(g) + after)


def update(g):
    """Writes the files."""
    (g.source / BASELINE).write_text("# The public interface where pointers have 64 bits; sizes in bytes.\n"
                                     "# Written by tests/abi/update-baseline.py.\n" +
                                     "\n".join(measure(g, g.include)) + "\n")
    update_machines(g)


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

def changed(*replacements, check=check):
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
    ("an integer in place of a pointer, which only 32 bits show",
     changed(("void *allocator_user; ", "uint64_t allocator_user; "),
             check=lambda g, include: check(g, include) + check_machines(g, include)),
     r"^vbss_context_config.* has changed: .*\(clang --target=(arm|wasm32|i686)"),
    ("a struct with a tag only", changed((END, END + "struct vbss_loose { double x; };\n")),
     r"is not of the form"),
]

if __name__ == "__main__":
    gate.main("layout", lambda g: check(g, g.include) + check_machines(g, g.include) + check_table(g), CANARIES)
