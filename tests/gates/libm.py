"""The library calls nothing from outside but what allowed-symbols.txt lists with a reason: libm has
other bits on other machines, and printing, exiting or starting programs is not ours to do.

The scripted hands may call what they like, but of libm only what is exact: a seed is then the same performance on
every machine."""
import re

import gate

STARTUP = {"__cxa_finalize", "__gmon_start__", "_ITM_deregisterTMCloneTable", "_ITM_registerTMCloneTable",
           "_GLOBAL_OFFSET_TABLE_"}  # the compiler's own, in every library
LIBRARIES = {"libc.so.6", "libm.so.6"}
EXACT = {"sqrt", "fabs", "floor", "ceil", "trunc", "rint", "fmod", "remainder", "frexp", "ldexp", "copysign"}
LIBM = "libm.so.6"  # which glibc's libm.so names


def allowed(g):
    rows = {}
    for line in (g.here / "allowed-symbols.txt").read_text().splitlines():
        name, _, reason = line.partition("#")
        if name.strip():
            if not reason.strip():
                raise gate.Problem(f"allowed-symbols.txt gives no reason for {name.strip()}")
            rows[name.strip()] = reason.strip()
    return set(rows)


def undefined(g, files, *options):
    names, defined = set(), set()
    for line in g.run(g.tool("nm"), *options, *files).splitlines():
        words = line.split()
        if len(words) >= 2 and words[-2] in "UwWvV" and len(words) == 2:
            names.add(words[-1].partition("@")[0])
        elif len(words) == 3:
            defined.add(words[-1].partition("@")[0])
    return names - defined - STARTUP


def check_objects(g, *files):
    names = undefined(g, files)
    g.notes.append(f"{len(names)} names from outside: {' '.join(sorted(names))}")
    return [f"calls {name}, which is not in allowed-symbols.txt" for name in sorted(names - allowed(g))]


def check_shared(g, library):
    complaints = [f"{library.name} needs {name}, which is not in allowed-symbols.txt"
                  for name in sorted(undefined(g, [library], "-D") - allowed(g))]
    needed = set(re.findall(r"NEEDED\s+(\S+)", g.run(g.tool("objdump"), "-p", library)))
    return complaints + [f"{library.name} is linked to {name}" for name in sorted(needed - LIBRARIES)]


def functions_of_libm(g):
    """What libm defines, as the compiler at hand finds it."""
    path = g.run(g.tool("cc"), f"-print-file-name={LIBM}").strip()
    lines = g.run(g.tool("nm"), "-D", "--defined-only", path).splitlines()
    names = {line.split()[-1].partition("@")[0] for line in lines}
    if "sin" not in names:
        raise gate.Problem(f"{path} defines no sin, so this gate cannot look")
    return names


def check_hands(g, *objects):
    inexact = functions_of_libm(g) - EXACT
    called = {name.partition("@")[0] for line in g.run(g.tool("nm"), "--undefined-only", *objects).splitlines()
              for name in line.split()[1:]}
    g.notes.append(f"{len(objects)} objects of hands, which call {' '.join(sorted(called & EXACT))} of libm")
    return [f"the hands call {name}, which has other bits elsewhere" for name in sorted(called & inexact)]


def inspect(g):
    hands = g.settings["hands"]
    return check_objects(g, g.library("archive")) + check_shared(g, g.library("shared")) + \
        (check_hands(g, *hands) if hands else ["there are no objects of hands"])


def calling(name, text):
    return lambda g: check_objects(g, g.library("archive"), g.compile(name, text, "-fno-builtin"))


def linked_to_another(g):
    text = "int vbss_{0}(void);\nint vbss_{0}(void) {{ return 1; }}\n"
    other = g.compile("other", text.format("other"), "-shared", "-Wl,-soname,libcanary.so")
    return check_shared(g, g.compile("user", text.format("user"), "-shared", "-Wl,--no-as-needed", other))


def hand_calling(name, call):
    text = "#include <math.h>\ndouble vbss_f(double x, double y);\n" \
           f"double vbss_f(double x, double y) {{ return {call}; }}\n"
    return lambda g: check_hands(g, *g.settings["hands"], g.compile(name, text, "-fno-builtin"))


CANARIES = [
    ("an object that calls sin",
     calling("sine", "#include <math.h>\ndouble vbss_f(double x) { return sin(x); }\n"),
     r"^calls sin, which is not"),
    ("a hand that calls atan2", hand_calling("hand_atan2", "atan2(y, x)"), r"^the hands call atan2, which has"),
    ("a hand that calls hypot", hand_calling("hand_hypot", "hypot(y, x)"), r"^the hands call hypot, which has"),
    ("a hand that calls what is exact", hand_calling("hand_exact", "fmod(y, floor(sqrt(x)))"), None),
    ("an object that prints",
     calling("print", '#include <stdio.h>\nvoid vbss_f(void) { printf("%d\\n", 1); }\n'),
     r"^calls printf, which is not"),
    ("a shared library that starts programs",
     lambda g: check_shared(g, g.compile(
         "program", "#include <stdlib.h>\nint vbss_f(const char *t);\n"
         "int vbss_f(const char *t) { return system(t); }\n",
         "-shared")), r"needs system, which is not"),
    ("a shared library linked to another one", linked_to_another, r"is linked to libcanary.so"),
]

if __name__ == "__main__":
    gate.main("libm", inspect, CANARIES)
