"""No object of the library has writable data: no globals, no function statics, no thread locals.
Tables are const; const tables that hold addresses are .data.rel.ro, written by the loader only."""
import re

import gate

WRITABLE = re.compile(r"\.(data|bss|tdata|tbss|tm_clone_table)(\..*)?$|COMMON$")


def check(g, *files):
    complaints, objects = [], 0
    member = ""
    for line in g.run(g.tool("objdump"), "-h", *files).splitlines():
        title = re.match(r"(.+?):\s+file format", line)
        if title:
            member, objects = title.group(1), objects + 1
        row = re.match(r"\s*\d+\s+(\S+)\s+([0-9a-f]+)\s", line)
        if row and WRITABLE.match(row.group(1)) and not row.group(1).startswith(".data.rel.ro"):
            if int(row.group(2), 16):
                complaints.append(f"{member.rsplit('/', 1)[-1]} has {int(row.group(2), 16)} bytes of "
                                  f"writable data in {row.group(1)}{names(g, files, row.group(1))}")
    for line in g.run(g.tool("nm"), *files).splitlines():
        if re.search(r"\sC\s", line):  # -fcommon keeps tentative definitions out of all sections
            complaints.append(f"writable data in COMMON: {line.split()[-1]}")
    if objects == 0:
        complaints.append("no objects seen")
    g.notes.append(f"{objects} objects")
    return complaints


def names(g, files, section):
    """The data symbols in a section, for the complaint."""
    found = re.findall(rf"^[0-9a-f]+ .{{7}} {re.escape(section)}\s+[0-9a-f]+\s+(?:\.hidden )?(\S+)$",
                       g.run(g.tool("objdump"), "-t", *files), flags=re.M)
    found = [name for name in found if name != section]
    return f": {', '.join(found)}" if found else ""


def with_object(name, text, *options):
    return lambda g: check(g, g.library("archive"), g.compile(name, text, *options))


CANARIES = [
    ("a static counter",
     with_object("counter", "int vbss_f(void); int vbss_f(void) { static int counter; return ++counter; }\n"),
     r"counter.o has 4 bytes of writable data in .bss.*counter"),
    ("an initialised global", with_object("global", "int vbss_mode = 3;\n"),
     r"global.o has 4 bytes of writable data in .data: vbss_mode"),
    ("a thread local", with_object("local", "_Thread_local int vbss_depth;\n"),
     r"local.o has 4 bytes of writable data in .tbss: vbss_depth"),
    ("a tentative definition", with_object("common", "int vbss_count;\n", "-fcommon"),
     r"COMMON: vbss_count"),
    ("a constant table of addresses",
     with_object("table", "extern int vbss_a; extern const int *const vbss_table[];\n"
                 "const int *const vbss_table[] = {&vbss_a, &vbss_a};\n"), None),
]

if __name__ == "__main__":
    gate.main("globals", lambda g: check(g, g.library("archive")), CANARIES)
