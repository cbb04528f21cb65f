"""The worst stack of every public function, out of the compiler's own call graph: at most 16 KiB, so
that a host may step on a small thread. Recursion and frames of unknown size are refused.

At -O2 and at -O3, as determinism.matrix.gcc-O2 and determinism.matrix.gcc-O3 build it; the larger number
counts. Calls out of the library count as stack-allowances.txt says; calls through pointers go
where indirect-calls.txt says."""
import re

import gate
import symbols

LIMIT = 16 * 1024


def rows(path):
    """First word -> other words, of a table with # comments."""
    table = {}
    for line in path.read_text().splitlines():
        words = line.partition("#")[0].split()
        if words:
            table[words[0]] = words[1:]
    return table


def kind_members(source):
    """Functions in the initialisers of vbss_kind tables: what kind->destroy and its like are."""
    names = ("destroy", "serialise", "serialise_description")  # the last members, in their order
    members = {name: set() for name in names}
    for path in source.rglob("*.c"):
        for body in re.findall(r"\bvbss_kind\s+\w+\s*=\s*\{([^{}]*)\}", path.read_text()):
            named = dict(re.findall(r"\.(\w+)\s*=\s*(\w+)", body))
            last = [part.strip() for part in body.rstrip().rstrip(",").split(",")][-len(names):]
            for name, function in zip(names, last):
                members[name].add(named.get(name, function))
    return members


class Graph:
    def __init__(self, g, source):
        self.frames, self.calls, self.complaints = {}, {}, []
        self.indirect = rows(g.here / "indirect-calls.txt")
        self.allowances = {name: int(words[0]) for name, words in
                           rows(g.here / "stack-allowances.txt").items()}
        self.members = kind_members(source)
        self.worst_of = {}

    def read(self, path):
        text = path.read_text()
        for title, label in re.findall(r'^node: \{ title: "([^"]+)" label: "([^"]*)"', text, flags=re.M):
            frame = re.search(r"\\n(\d+) bytes \(([\w,]+)\)", label)
            if frame:
                self.frames[title] = max(self.frames.get(title, 0), int(frame.group(1)))
                self.calls.setdefault(title, set())
                if frame.group(2) == "dynamic":
                    self.complaints.append(f"{short(title)} has a frame of unknown size (alloca or "
                                           "a variable-length array)")
        for caller, callee, place in re.findall(
                r'^edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)" label: "([^"]*)"', text, flags=re.M):
            targets = self.resolve(place) if callee == "__indirect_call" else [callee]
            self.calls.setdefault(caller, set()).update(targets)

    def resolve(self, place):
        """Where a call through a pointer goes, by the name of the member that is called."""
        path, line, column = place.rsplit(":", 2)
        with open(path) as file:
            text = file.read().split("\n", int(line) - 1)[-1][int(column) - 1:]
        text = text.removeprefix("VBSS_TRY(")  # the compiler names the place of the macro
        member = re.match(r"[^(;]*?(\w+)\s*\(", text)
        name = member.group(1) if member else text[:30]
        if name not in self.indirect:
            self.complaints.append(f"{path.rsplit('/lib/', 1)[-1]}:{line} calls through the pointer "
                                   f"'{name}', which is not in indirect-calls.txt")
            return []
        targets = []
        for target in self.indirect[name]:
            targets += sorted(self.members[name]) if target == "kinds" else [target]
        return [target for target in targets if target not in ("host", "NULL")]

    def find(self, name):
        """The titles of a function: static ones carry their file's name."""
        name = name.removeprefix("__builtin_")
        return [name] if name in self.frames else [t for t in self.frames if t.endswith(":" + name)]

    def worst(self, title, path=()):
        """Bytes and path of the worst call chain from a function."""
        if title in self.worst_of:
            return self.worst_of[title]
        if title in path:
            chain = [short(t) for t in path[path.index(title):] + (title,)]
            complaint = "recursion: " + " -> ".join(chain)
            if complaint not in self.complaints:
                self.complaints.append(complaint)
            return 0, []
        best = 0, []
        for callee in sorted(self.calls.get(title, ())):
            found = self.find(callee)
            if not found:
                below = self.allowances.get(callee.removeprefix("__builtin_")), [callee]
                if below[0] is None:
                    self.complaints.append(f"{short(title)} calls {callee}, for which "
                                           "stack-allowances.txt has no row")
                    continue
                best = max(best, below)
            for one in found:
                best = max(best, self.worst(one, path + (title,)))
        self.worst_of[title] = self.frames.get(title, 0) + best[0], [title] + best[1]
        return self.worst_of[title]


def short(title):
    return title.rsplit(":", 1)[-1]


def check(g, source, builds, public):
    """Complaints about what was compiled from these sources, and the table of the public functions. builds: level ->
    folder of objects with gcc's call graphs beside them."""
    table, complaints = {}, []
    exceptions = rows(g.here / "stack-exceptions.txt")
    for level, build in builds.items():
        graph = Graph(g, source / "lib")
        for path in sorted(build.rglob("*.ci")):
            graph.read(path)
        for function in public:
            if function not in graph.frames:
                complaints.append(f"{function} is not in the call graph")
                continue
            size, path = graph.worst(function)
            table[function] = max(table.get(function, (0, [], "")), (size, path, level))
        complaints += [c for c in graph.complaints if c not in complaints]
    for function, (size, path, level) in table.items():
        limit = int(exceptions[function][0]) if function in exceptions else LIMIT
        if size > limit:
            complaints.append(f"{function} needs {size} bytes of stack, more than {limit}: " +
                              " -> ".join(short(t) for t in path))
    return complaints, table


def inspect(g):
    # Objects, not libraries: others than this gate have built them.
    builds = {level: g.row("gcc" + level) / "vblast_ss/lib" for level in ("-O2", "-O3")}
    complaints, table = check(g, g.source, builds, sorted(symbols.map_nodes(g.source / "lib/vblast_ss.map")))
    for function, (size, path, level) in sorted(table.items(), key=lambda row: -row[1][0]):
        print(f"  {size:6} {level} {' -> '.join(short(t) for t in path)}")
    worst = max(table.items(), key=lambda row: row[1][0]) if table else ("nothing", (0,))
    g.notes.append(f"{len(table)} functions, worst {worst[0]} {worst[1][0]} of {LIMIT} bytes")
    return complaints


# ---- canaries: the library with vbss_version, or a new kind of object, doing what it must not

def version_doing(before, body, public="vbss_version"):
    def canary(g):
        copy = g.copy_base("changed")
        gate.replace_once(copy / "lib/base/result.c", "uint32_t vbss_version(void)\n{\n",
                          before + "uint32_t vbss_version(void)\n{\n" + body)
        build = g.build("changed-build", f"-DCMAKE_C_COMPILER={g.tool('gcc')}", "-DCMAKE_BUILD_TYPE=None",
                        "-DCMAKE_C_FLAGS=-O2 -fcallgraph-info=su", source=copy, targets=["vblast_ss_static"])
        return check(g, copy, {"-O2": build}, [public])[0]
    return canary


KEEP = "static void keep(volatile char *p) { *p = 1; }\n"
CANARIES = [
    ("a function that calls itself",
     version_doing("uint32_t vbss_deep(uint32_t n);\nuint32_t vbss_deep(uint32_t n)\n{\n    volatile char b[64];\n"
                   "    b[n & 63] = 1;\n    return n ? b[0] + vbss_deep(n / 2) * vbss_deep(n / 3) : 0;\n}\n",
                   "    if (vbss_deep(9) == 77) return 1;\n"), r"^recursion: vbss_deep\S* -> "),
    ("64 KiB on the stack", version_doing(KEEP, "    char big[65536];\n    keep(big + 7);\n"),
     r"^vbss_version needs 65\d\d\d bytes of stack"),
    ("alloca", version_doing(KEEP, "    keep(__builtin_alloca(vbss_arithmetic_check() + 99u));\n"),
     r"^vbss_version has a frame of unknown size"),
    ("a pointer nobody listed",
     version_doing("", "    struct { uint32_t (*volatile odd)(void); } v = {vbss_version};\n    v.odd();\n"),
     r"calls through the pointer 'odd'"),
    ("64 KiB in the destroy function of a kind",
     version_doing('#include "base/slot.h"\n#include "base/stream.h"\n' + KEEP + "static void fat(vbss_context *c, void *o)\n{\n    char big[65536];\n    (void)c;\n"
                   "    keep(big + *(int *)o);\n}\nstatic void thin(vbss_stream *s, void *o)\n{\n    (void)s;\n"
                   "    keep(o);\n}\nextern const vbss_kind vbss_odd;\n"
                   "const vbss_kind vbss_odd = {\"odd\", VBSS_CODE('O', 'D', 'D', ' '), 1, fat, thin, NULL};\n",
                   "", "vbss_context_destroy"),
     r"^vbss_context_destroy needs 65\d\d\d bytes of stack.*vbss_slots_release -> fat$"),
    ("a call out of the library nobody listed",
     version_doing("#include <stdlib.h>\n", "    if (getenv(\"X\")) return 1;\n"), r"calls getenv, for which"),
]

if __name__ == "__main__":
    gate.main("stack", inspect, CANARIES)
