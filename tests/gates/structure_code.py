"""Declarations: constants without an origin, fields of the scene's main struct."""
import collections
import re
from typing import NamedTuple

import c_text
from figures import Section

# ---- tuned constants
#
# A constant is, in any file of lib/, a #define of a number or of an expression with a number, a `static const` number, a
# numbered constant of an enum without a name, or in tuning.h the number of a field. It is tuned unless one of these rules
# leaves it out:
#   layouts     lib/base and lib/record hold elementary functions, hashes and formats; device/nidaqmx.h and
#               device/openhaptics.h repeat the numbers of vendors
#   bits        hexadecimal integers, shifts, sizeof, casts, UINT32_MAX and its like
#   kinds       0, 1 and lists that count on from there, by one or by doubling
#   capacities  integers that are the size of an array, or stand with other names in an expression, or are 1024 or more, or
#               have ARRAYS, BITS, BYTES, DIGITS or TAGS in their name
#   guards      magnitudes of 1e6 or more, or of 1e-20 or less: limits of input, never reached by a sound scene
#   mathematics more than nine digits, multiples of DBL_EPSILON and of 2^-53, units (names with MILLI or MICRO)
LAYOUT_FOLDERS = {"base", "record"}
LAYOUT_FILES = {"device/nidaqmx.h", "device/openhaptics.h"}
SIZE_WORDS = {"ARRAYS", "BITS", "BYTES", "DIGITS", "TAGS"}
ORIGIN = re.compile(r"\b(?:derived|fitted|chosen|published)\b", re.I)
NUMBER = re.compile(r"(?<![\w.])(?:0x[0-9a-f.]+(?:p[-+]?\d+)?|(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)[uUlLfF]*(?![\w.])", re.I)
NUMERIC = re.compile(r"[-+*/().\s\w<>&]+")
DEFINE = re.compile(r"^[ \t]*#[ \t]*define[ \t]+(\w+)[ \t]+(?:\\\n[ \t]*)?(\S[^\n]*)$", re.M)
TUNED = re.compile(r"VBSS_TUNE\(\w+, (.*)\)")  # lib/base/tune.h: in tuning.h of each folder
STATIC = re.compile(r"\bstatic const (?:double|float|int|unsigned|u?int\d+_t|size_t) (\w+)\s*=\s*([^;{]*);")
ENUM = re.compile(r"\benum\s*\{([^{}]*)\}")
FIELD = re.compile(r"\.(\w+)\s*=\s*([^,{}]+)")
HEADING = re.compile(r"^\s*(?:typedef\s+)?(?:enum|static const struct)\b.*\{\s*$")


class Constant(NamedTuple):
    where: str
    line: int
    name: str
    value: str
    rule: str  # that leaves it out; "" for a tuned one


def is_count(values):
    """0 or 1 and on, by one or by doubling."""
    if any(not re.fullmatch(r"\d+", value) for value in values):
        return False
    numbers = [int(value) for value in values]
    return (numbers[0] in (0, 1) and
            (all(b == a + 1 for a, b in zip(numbers, numbers[1:])) or
             all(b == 2 * a for a, b in zip(numbers, numbers[1:]) if a)))


def enum_constants(text):
    """(position, name, value) of enums without a name whose constants all have their number."""
    for enum in ENUM.finditer(text):
        entries = [entry for entry in enum.group(1).split(",") if entry.strip()]
        values = [entry.partition("=")[2].strip() for entry in entries]
        if all(values) and not is_count(values):
            for match in re.finditer(r"(\w+)\s*=\s*([^,]+)", enum.group(1)):
                yield enum.start(1) + match.start(), match.group(1), match.group(2).strip()


def candidates(text, is_tuning_file):
    for pattern in (DEFINE, STATIC, *([FIELD] if is_tuning_file else [])):
        for match in pattern.finditer(text):
            value = match.group(2).strip()
            tuned = TUNED.fullmatch(value)
            yield match.start(1), match.group(1), tuned.group(1) if tuned else value
    yield from enum_constants(text)


def array_sizes(text):
    """Names between brackets."""
    return {name for size in re.findall(r"\[([^\[\]]*)\]", text) for name in re.findall(r"[A-Z]\w*", size)}


def is_integer(value):
    return not re.search(r"\d\.|\.\d|\de[-+]?\d|\dp[-+]?\d", value)


def rule_for_integer(name, value, sizes):
    if re.fullmatch(r"\(?-?[01]u?\)?", value):
        return "kinds"
    digits = re.fullmatch(r"\(?-?(\d+)[uUlL]*\)?", value)
    if name in sizes or not digits or int(digits.group(1)) >= 1024 or SIZE_WORDS & set(name.split("_")):
        return "capacities"
    return ""


def rule_for_real(name, value):
    if re.search(r"DBL_EPSILON|0x1p-53", value) or re.search(r"MILLI|MICRO", name):
        return "mathematics"
    for number in NUMBER.findall(value):
        size = abs(float.fromhex(number) if number[:2].lower() == "0x" else float(number.rstrip("fFlLuU")))
        if size >= 1e6 or 0 < size <= 1e-20:
            return "guards"
        if len(re.sub(r"e.*|^0*\.?0*|\.", "", number)) > 9:
            return "mathematics"
    return ""


def rule_for(path, name, value, sizes):
    if path.parts[0] in LAYOUT_FOLDERS or path.as_posix() in LAYOUT_FILES:
        return "layouts"
    if re.search(r"<<|sizeof|U?INT\d+_MAX|\(\w+_t\)|\b0x[0-9a-f]+u?\b(?!p)", value, re.I) and "0x1p" not in value:
        return "bits"
    return rule_for_integer(name, value, sizes) if is_integer(value) else rule_for_real(name, value)


def constants(tree):
    lib = tree / "lib"
    texts = {path: c_text.code(c_text.read(path)) for path in c_text.sources(lib)}
    of_all = set().union(*map(array_sizes, texts.values()))
    for path, text in texts.items():
        lines = c_text.Lines(text)
        sizes = of_all if path.suffix == ".h" else array_sizes(text)
        for position, name, value in candidates(text, path.name == "tuning.h"):
            if NUMERIC.fullmatch(value) and NUMBER.search(value) and not re.search(r"\b[a-z_]\w*\(", value):
                rule = rule_for(path.relative_to(lib), name, value, sizes)
                yield Constant(str(path.relative_to(tree)), lines.number(position), name, value, rule)


class Origins:
    """The comments that a constant of a file may have its origin in: on its line, or above its group of lines."""
    def __init__(self, text, constant_lines):
        self.code = [""] + c_text.code(text).splitlines()
        self.starting = collections.defaultdict(str)
        self.ending = {}
        for comment in c_text.comments(text):
            self.starting[comment.line] += comment.text
            self.ending[comment.last] = comment.text
        self.group = constant_lines | {n for n, line in enumerate(self.code) if HEADING.match(line)}

    def of(self, line):
        above = line - 1
        while above in self.group:
            above -= 1
        headline = self.ending.get(above, "") if not self.code[above].strip() else ""
        return self.starting[line] + headline


def without_origin(tree, found):
    by_file = collections.defaultdict(list)
    for constant in found:
        by_file[constant.where].append(constant)
    for where, constants_of_file in by_file.items():
        origins = Origins(c_text.read(tree / where), {constant.line for constant in constants_of_file})
        for constant in constants_of_file:
            if not constant.rule and not ORIGIN.search(origins.of(constant.line)):
                yield constant


def number_of(value):
    """A number that is written in two ways is one number."""
    try:
        return float(value.strip("()").rstrip("uUlL"))
    except ValueError:
        return value


def differing(found):
    """Names with more than one value, each in a file of its own."""
    uses = collections.defaultdict(dict)
    for constant in found:
        if constant.rule in ("", "mathematics"):
            uses[constant.name].setdefault(number_of(constant.value), []).append(f"{constant.where} {constant.value}")
    return [f"{name}: " + ", ".join(use for group in values.values() for use in group)
            for name, values in sorted(uses.items())
            if len(values) > 1 and len({use.split()[0] for group in values.values() for use in group}) > 1]


def constants_section(tree):
    section = Section("constants", "Numbers with a name in lib/", ["tuned, no origin", "tuned", "with a name"])
    found = list(constants(tree))
    bare = list(without_origin(tree, found))
    folders = sorted({constant.where.split("/")[1] for constant in found})
    for folder in ["lib", *folders]:
        def in_folder(constant, folder=folder):
            return folder == "lib" or constant.where.split("/")[1] == folder
        section.add(folder, sum(map(in_folder, bare)), sum(in_folder(c) and not c.rule for c in found),
                    sum(map(in_folder, found)))
    names = differing(found)
    section.add("names with several values", len(names), None, None)
    section.measure("constants without origin", len(bare), (f"{c.where}:{c.line}: {c.name} {c.value}" for c in bare))
    section.measure("names with several values", len(names), names)
    return section


# ---- the main struct

STRUCTS = ["scene_object"]  # state of a scene that outlives a step
MANY_FILES = 10


def body_of(text, struct):
    """What stands between the braces of a struct, without what stands in inner braces."""
    match = re.search(rf"\bstruct\s+{struct}\s*\{{", text)
    if not match:
        return None
    depth, kept = 1, []
    for character in text[match.end():]:
        depth += {"{": 1, "}": -1}.get(character, 0)
        if depth == 0:
            break
        if depth == 1 and character != "}":
            kept.append(character)
    return "".join(kept)


def field_names(body):
    for member in body.split(";"):
        pointer = re.search(r"\(\s*\*\s*(\w+)\s*\)", member)
        if pointer:
            yield pointer.group(1)
            continue
        for declarator in member.split(","):
            name = re.search(r"(\w+)\s*(?:\[[^\]]*\]\s*)*$", declarator)
            if name:
                yield name.group(1)


def variables_of(text, struct):
    """Names that a file declares as the struct or as a pointer to it."""
    return set(re.findall(rf"\b{struct}\s*(?:const\s*)?\*?\s*(?:const\s*)?(\w+)\b", text)) - {"const"}


def members_of(text, struct):
    """Names of members of other structs that point to the struct."""
    return set(re.findall(rf"\b{struct}\s*(?:const\s*)?\*\s*(\w+)\s*;", text))


def files_with_fields(texts, struct, fields):
    """Field -> files that use it through a variable of the struct, or a member that points to it."""
    shared = set().union(*(members_of(text, struct) for path, text in texts.items() if path.suffix == ".h"))
    found = {field: set() for field in fields}
    for path, text in texts.items():
        names = shared | variables_of(text, struct)
        if not names:
            continue
        for field in re.findall(rf"\b(?:{'|'.join(sorted(names))})(?:->|\.)(\w+)", text):
            if field in found:
                found[field].add(path)
    return found


def fields(tree):
    section = Section("fields", "Fields of the scene's main struct", ["number"],
                      "Files that use a field, counted from the text: variable->field, where the variable is declared as "
                      "the struct in that file, or is a member of a struct in a header.")
    texts = {path: c_text.code(c_text.read(path)) for path in c_text.sources(tree / "lib")}
    for struct in STRUCTS:
        bodies = filter(None, (body_of(text, struct) for text in texts.values()))
        names = list(field_names(next(bodies, "")))
        uses = files_with_fields(texts, struct, names)
        section.add(f"{struct}: fields", len(names))
        section.add(f"{struct}: used in {MANY_FILES} files or more", sum(len(u) >= MANY_FILES for u in uses.values()))
        section.add(f"{struct}: used in one file", sum(len(u) == 1 for u in uses.values()))
        for name in sorted(uses, key=lambda name: (-len(uses[name]), name)):
            section.add(f"{struct}.{name}: files", len(uses[name]))
    return section
