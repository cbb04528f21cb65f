"""Every public header compiles alone, twice in a row, in every language version we promise, without
a warning; nothing in it is laid out with hidden padding; C++ sees C functions."""
import itertools
import re
import shutil

import gate
import public_headers

WARNINGS = ["-pedantic", "-Wall", "-Wextra", "-Wpadded", "-Wundef", "-Werror"]
LANGUAGES = [("c", ["gcc", "clang"], ["c99", "c11", "c17"], ["-Wc++-compat"]),
             ("c++", ["g++", "clang++"], ["c++11", "c++17", "c++20"], [])]


def check(g, include, headers):
    complaints, compiled = [], 0
    for header in headers:
        source = g.work / f"{header.stem}-twice.c"
        # -I and not -isystem: warnings of system headers are not shown.
        source.write_text(f"#include <vblast_ss/{header.name}>\n" * 2)
        for language, compilers, standards, extra in LANGUAGES:
            for compiler, standard in itertools.product(compilers, standards):
                code, output = g.run(g.tool(compiler), f"-std={standard}", *WARNINGS, *extra,
                                     "-I", include, "-fsyntax-only", "-x", language, source,
                                     code=None)
                compiled += 1
                if code:
                    first = next((line for line in output.splitlines() if "error" in line), output)
                    complaints.append(f"{header.name}, {compiler} {standard}: {first.strip()}")
    g.notes.append(f"{compiled} compilations")
    return complaints + check_umbrella(include) + ([] if complaints else check_linkage(g, include))


def check_umbrella(include):
    text = (include / "vblast_ss/vblast_ss.h").read_text()
    return [f"vblast_ss.h does not include {h.name}" for h in public_headers.headers(include)
            if h.name != "vblast_ss.h" and f"<vblast_ss/{h.name}>" not in text]


def check_linkage(g, include):
    """Takes the address of every function in C++; a mangled name means a missing extern "C"."""
    names = sorted(public_headers.functions(include))
    source = g.work / "linkage.cpp"
    source.write_text("#include <vblast_ss/vblast_ss.h>\nextern void (*const use[])(void);\n"
                      "void (*const use[])(void) = {\n" +
                      "".join(f"  (void (*)(void))&{name},\n" for name in names) + "};\n")
    target = g.work / "linkage.o"
    g.run(g.tool("g++"), "-std=c++11", "-I", include, "-c", source, "-o", target)
    seen = set(re.findall(r"\bU (\S+)", g.run(g.tool("nm"), target)))
    return [f'{name} has no C linkage in C++: is it inside extern "C"?'
            for name in names if name not in seen]


def check_deprecation(g, include):
    """A function that is marked makes a call warn with the text, and only there; VBSS_NO_DEPRECATED is silent."""
    source = g.work / "deprecated.c"
    text = ('#include <vblast_ss/base.h>\n#ifdef __cplusplus\nextern "C"\n#endif\n'
            'VBSS_DEPRECATED("use vbss_other") VBSS_API vbss_result vbss_old(void);\nint call(void);\n'
            "int call(void) {{ return {}; }}\n")
    complaints = []
    for (language, compilers, standards, _), silent, call in itertools.product(LANGUAGES, (False, True), (False, True)):
        for compiler in compilers:
            source.write_text(text.format("vbss_old()" if call else "0"))
            code, output = g.run(g.tool(compiler), f"-std={standards[0]}", *WARNINGS, "-I", include, "-fsyntax-only",
                                 *(["-DVBSS_NO_DEPRECATED"] if silent else []), "-x", language, source, code=None)
            warned = code != 0 and "use vbss_other" in output
            if code and not warned or warned != (call and not silent):
                complaints.append(f"VBSS_DEPRECATED, {compiler}: {output.strip() or 'no warning'}")
    return complaints


# ---- canaries: the headers with one more, or with one changed

def with_header(text):
    def add(include):
        (include / "vblast_ss/canary.h").write_text(text)
        base = "#include <vblast_ss/base.h>"
        gate.replace_once(include / "vblast_ss/vblast_ss.h", base,
                          base + "\n#include <vblast_ss/canary.h>")
    return changed("canary.h", add)


def changed(name, change):
    """All headers with one changed, which alone is compiled."""
    def inspect(g):
        include = g.work / "include"
        shutil.rmtree(include, ignore_errors=True)
        shutil.copytree(g.include, include)
        change(include)
        return check(g, include, [include / "vblast_ss" / name])
    return inspect


def strip_linkage(include):
    path = include / "vblast_ss/base.h"
    path.write_text(re.sub(r'#ifdef __cplusplus\s+(extern "C" \{|\})\s+#endif', "", path.read_text()))


def without_deprecation(g):
    include = g.work / "include"
    shutil.rmtree(include, ignore_errors=True)
    shutil.copytree(g.include, include)
    gate.replace_once(include / "vblast_ss/base.h", "__attribute__((deprecated(text)))", "")
    return check_deprecation(g, include)


GUARD = "#ifndef CANARY_H\n#define CANARY_H\n#include <stdint.h>\n{}\n#endif\n"
CANARIES = [
    ("a hole in a struct",
     with_header(GUARD.format("typedef struct vbss_canary { uint32_t a; double b; } vbss_canary;")),
     r"padd?ing"),
    ("a header that needs another one",
     with_header("#ifndef CANARY_H\n#define CANARY_H\ntypedef uint32_t vbss_canary;\n#endif\n"),
     r"canary.h, .*(unknown type name|does not name a type)"),
    ("a header without a guard", with_header("typedef struct vbss_canary { int a; } vbss_canary;\n"),
     r"redefinition of|typedef-redefinition"),
    ("a word of C++ as a name",
     with_header(GUARD.format("typedef struct vbss_canary { int32_t new; } vbss_canary;")),
     r"expected|keyword|cannot combine|C\+\+"),
    ("an undefined macro in an #if", with_header(GUARD.format("#if VBSS_CANARY\n#endif")),
     r"VBSS_CANARY.* is not defined"),
    ("a deprecation without a warning", without_deprecation, r"^VBSS_DEPRECATED, .*no warning$"),
    ('a header without extern "C"', changed("base.h", strip_linkage), r"has no C linkage in C\+\+"),
]

if __name__ == "__main__":
    gate.main("headers", lambda g: check(g, g.include, public_headers.headers(g.include)) +
              check_deprecation(g, g.include), CANARIES)
