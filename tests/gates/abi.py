"""The binary interface is compatible with the checked-in baseline tests/abi/vblast_ss-<version>.dump:
abi-dumper reads a debug build, abi-compliance-checker compares. Any complaint of theirs counts.

A new baseline (tests/abi/update-baseline.py) is a decision that users must hear of: the first 12
digits of the sha256 of dump and layout file must stand in CHANGELOG.md in a line about the ABI."""
import hashlib
import html
import re

import c_text
import gate
import layout
import public_headers


def version(g):
    return public_headers.version(g.include)


def baselines(g):
    """Every earlier minor version must still fit."""
    return sorted((g.source / "tests/abi").glob(f"vblast_ss-{version(g)[0]}.*.dump"))


def recorded_headers(g):
    return sorted((g.source / "tests/abi").glob(f"vblast_ss-{version(g)[0]}.*.headers"))


def headers_text(source):
    """The headers without comments and the map of a tree, as one text: what programs of this version are built with."""
    text = f"Public headers of vblast_ss {'.'.join(public_headers.version(source / 'include'))} without comments, for " \
           "gate.hosts.\nWritten by tests/abi/update-baseline.py.\n"
    for path in sorted((source / "include/vblast_ss").glob("*.h*")) + [source / "lib/vblast_ss.map"]:
        code = c_text.TOKEN.sub(lambda token: " " if token.group()[0] == "/" else token.group(), path.read_text())
        text += f"==== {path.name}\n" + re.sub(r"\s*\n", "\n", code.lstrip())
    return text


def dump(g, source, name):
    """Types and functions of a tree. Always by gcc on x86-64: clang describes them differently."""
    if "x86_64" not in g.run(g.tool("gcc"), "-dumpmachine"):
        raise gate.Problem("the baseline is for x86-64, and this gcc is not")
    build = g.build(name, f"-DCMAKE_C_COMPILER={g.tool('gcc')}", "-DCMAKE_BUILD_TYPE=None",
                    "-DCMAKE_C_FLAGS=-g -O0 -fno-eliminate-unused-debug-types", source=source,
                    targets=["vblast_ss_shared"])
    out = g.work / f"{name}.dump"
    g.run(g.tool("abi-dumper"), build / "lib/libvblast_ss.so", "-o", out, "-lver", ".".join(version(g)),
          "-public-headers", source / "include", cwd=g.work)
    return out


def compare(g, old, new):
    report = g.work / f"{new.stem}.html"
    report.unlink(missing_ok=True)
    code, output = g.run(g.tool("abi-compliance-checker"), "-l", "vblast_ss", "-old", old, "-new", new,
                         "-report-path", report, cwd=g.work, code=None)
    if code == 0:
        return []
    # Its report is a page for reading; the sentences about changes make the complaint.
    page = report.read_text() if report.exists() else ""
    page = re.sub(r"<(style|script).*?</\1>|<[^>]+>", " ", page, flags=re.S)
    page = " ".join(html.unescape(page).replace("\xa0", " ").split())
    reported = re.findall(r"(Removed Symbols [1-9] .{0,100}?\))|((?:Type|Base type|Size|Field|Parameter|Return|"
                      r"The relative position|Value|Number)[^.]* (?:has|have) been [^.]*)", page)
    reported = list(dict.fromkeys(first or second for first, second in reported))
    return [f"not compatible with {old.name} (code {code}): " +
            ("; ".join(reported)[:400] or output.strip()[-300:])]


def digest(*paths):
    return hashlib.sha256(b"".join(path.read_bytes() for path in paths)).hexdigest()[:12]


def recorded(g, *paths):
    """A baseline counts only when the CHANGELOG tells of it."""
    changelog, sha = g.source / "CHANGELOG.md", digest(*paths)
    lines = changelog.read_text().splitlines() if changelog.is_file() else []
    if any("ABI" in line and sha in line for line in lines):
        return []
    return [f"CHANGELOG.md does not tell of the baseline {paths[0].name}: it needs a line "
            f"'- ABI ...: ..., sha256 {sha}' (tests/abi/update-baseline.py prints it)"]


def current(g):
    return g.source / f"tests/abi/vblast_ss-{'.'.join(version(g))}.dump"


def inspect(g):
    if not current(g).is_file():
        return [f"no baseline {current(g).name}: run tests/abi/update-baseline.py"]
    new = dump(g, g.source, "library")
    complaints = recorded(g, current(g), g.source / layout.BASELINE)
    for old in baselines(g):
        complaints += compare(g, old, new)
    g.notes.append(f"against {', '.join(old.name for old in baselines(g))}")
    return complaints


def refuse_break(include, changes):
    """Before its release a version may change; afterwards it may only grow."""
    if changes and '#define VBSS_VERSION_SUFFIX ""' in (include / "vblast_ss/base.h").read_text():
        raise gate.Problem("this version is released, and programs depend on what has changed: " + "; ".join(changes)[:400])


def update(g):
    """Writes dump, layout and headers; returns the line for the CHANGELOG."""
    new = dump(g, g.source, "library")
    text = new.read_text()
    for folder in (str(g.source), str(g.work)):
        if folder in text:
            raise gate.Problem(f"the dump holds a path of this machine: {folder}")
    before = (g.source / layout.BASELINE).read_text() if (g.source / layout.BASELINE).is_file() else ""
    known = baselines(g)  # the last one is of this version, or of the one before
    changes = compare(g, known[-1], new) if known else ["the first baseline of this major version"]
    changes += layout.changes(g)
    refuse_break(g.include, changes if known else [])
    layout.update(g)
    if not changes and (g.source / layout.BASELINE).read_text() == before:
        return "The interface is as it was: the baseline stays."  # line numbers are no reason
    current(g).write_text(text)
    current(g).with_suffix(".headers").write_text(headers_text(g.source))
    for other in set((g.source / "tests/abi").glob("vblast_ss-*.dump")) - set(baselines(g)):
        other.unlink()  # of another major version, which promises nothing to this one
    for change in changes:
        print("  " + change)
    what = "ABI changed" if changes else "ABI extended"
    return (f"- {what}: <what>; baseline {'.'.join(version(g))}, "
            f"sha256 {digest(current(g), g.source / layout.BASELINE)}")


# ---- canaries: changed trees

HEADER, MAP = "include/vblast_ss/base.h", "lib/vblast_ss.map"
CONTEXT, RESULT = "lib/base/context.c", "lib/base/result.c"


def changed(*changes):
    def canary(g):
        g.dumps = getattr(g, "dumps", {})
        if "old" not in g.dumps:
            g.dumps["old"] = dump(g, g.copy_base("old"), "old-build")
        # The same folder each time: nothing but the change may differ.
        copy = g.copy_base("new")
        for file, old, new in changes:
            gate.replace_once(copy / file, old, new)
        return compare(g, g.dumps["old"], dump(g, copy, "new-build"))
    return canary


def released(g):
    include = g.work / "include/vblast_ss"
    include.mkdir(parents=True)
    (include / "base.h").write_text('#define VBSS_VERSION_SUFFIX ""\n')
    refuse_break(g.work / "include", ["Removed Symbols 1"])
    return []


def unrecorded(g):
    path = g.work / "vblast_ss-1.0.dump"
    path.write_text("a baseline nobody told of\n")
    return recorded(g, path)


USER, LOG_USER = "    void *allocator_user; ", "    void *log_user; "
ERROR = "_get_last_error(const vbss_context *context, {} *result"
NEW = "VBSS_API uint32_t vbss_added(uint32_t x);\n"
VERSION = "VBSS_API uint32_t vbss_version(void);\n"
REFUSED = r"^not compatible with .* \(code [1-9]"
CANARIES = [
    ("(d) config fields in another order",
     changed((HEADER, USER, "    void *swap; "), (HEADER, LOG_USER, USER), (HEADER, "    void *swap; ", LOG_USER)),
     REFUSED + r".*(allocator_user|log_user|vbss_context_config)"),
    ("(e) an out-parameter of another type",
     changed(*((f, ERROR.format("vbss_result"), ERROR.format("int64_t")) for f in (HEADER, CONTEXT))),
     REFUSED + r".*result"),
    ("a parameter of another size",
     changed(*((f, "vbss_result_name(vbss_result result)", "vbss_result_name(int64_t result)")
               for f in (HEADER, RESULT))), REFUSED + r".*result"),
    ("a removed function", changed((MAP, "    vbss_version;\n", "")), REFUSED + r".*(Removed|vbss_version)"),
    ("a baseline nobody told of", unrecorded, r"^CHANGELOG.md does not tell"),
    ("a new baseline that breaks a released version", released, r"^this version is released"),
    ("a grown enumeration", changed((HEADER, "X(VBSS_OK, 0,", 'X(VBSS_ERROR_MORE, -99, "one more") X(VBSS_OK, 0,')), None),
    ("(b) an opaque struct grown, a function added",
     changed(("lib/base/context.h", "bool in_callback;", "bool in_callback, grown;"),
             (HEADER, VERSION, VERSION + NEW), (MAP, "    vbss_version;\n", "    vbss_version;\n    vbss_added;\n"),
             (RESULT, "uint32_t vbss_version(void)\n",
              "uint32_t vbss_added(uint32_t x)\n{\n    return x;\n}\n\nuint32_t vbss_version(void)\n")), None),
    ("(c) a config field appended, fine by the size protocol",
     changed((HEADER, "} vbss_context_config;", "    uint64_t more;\n} vbss_context_config;"),
             (CONTEXT, "== 8 + 5 * sizeof(void *)", "== 16 + 5 * sizeof(void *)")), None),
]

if __name__ == "__main__":
    gate.main("abi", inspect, CANARIES)
