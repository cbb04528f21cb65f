"""Object files: which file calls which, cycles, calls upward, what a header rebuilds."""
import collections
import itertools
import os
import pathlib
import re
import subprocess

import c_text
import layers
from figures import Section

LONGEST_CYCLE = 3           # files


def output(*command):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          errors="replace")
    if done.returncode != 0:
        raise OSError(f"{command[0]} failed: {done.stderr.strip()[-300:]}")
    return done.stdout


# ---- the graph of calls

def objects(tree, build):
    """Object -> its source relative to lib/. The plain and the wide object of a file are one file."""
    found = {}
    for path in sorted((build / "lib").glob("CMakeFiles/*.dir/**/*.o")):
        source = path.relative_to(build / "lib").as_posix().split(".dir/", 1)[1].removesuffix(".o")
        if (tree / "lib" / source).is_file():
            found[path] = source
    return found


def without_object(tree, build):
    sources = {path.relative_to(tree / "lib").as_posix() for path in c_text.sources(tree / "lib", (".c",))}
    return sorted(sources - set(objects(tree, build).values()))


def symbols(objects_of_lib, nm):
    """(file, kind, name) of every symbol that other objects see, or that an object wants."""
    by_name = {str(path): file for path, file in objects_of_lib.items()}
    for line in output(nm, "-g", "-A", *by_name).splitlines():
        path, _, symbol = line.rpartition(":")
        yield by_name[path], *symbol.split()[-2:]


def calls(tree, build, nm="nm"):
    """File -> files -> a symbol that the first takes from the second: functions and tables, by the linker's names. Without the
    tables of methods where they are chosen (layers.py)."""
    defined, wanted, of_lib = {}, [], objects(tree, build)
    if not of_lib:
        raise OSError(f"no object of lib/ in {build}")
    for source, kind, name in symbols(of_lib, nm):
        if kind in "TDRBVW":
            defined.setdefault(name, source)
        elif kind in "Uw":
            wanted.append((source, name))
    graph = collections.defaultdict(dict)
    for source, name in wanted:
        target = defined.get(name)
        if target and target != source and layers.METHOD_TABLES.get(name) != source:
            graph[source].setdefault(target, name)
    for source in set(defined.values()):
        graph[source]  # a file without calls
    return graph


def components(graph):
    """Strongly connected components, the largest first (Kosaraju's two passes)."""
    backward = collections.defaultdict(list)
    for source, targets in graph.items():
        for target in targets:
            backward[target].append(source)
    order, seen = [], set()
    for root in sorted(graph):
        visit(root, lambda node: graph.get(node, ()), seen, order)
    found, seen = [], set()
    for root in reversed(order):
        component = []
        visit(root, lambda node: backward[node], seen, component)
        if component:
            found.append(sorted(component))
    return sorted(found, key=lambda component: (-len(component), component))


def visit(root, next_of, seen, order):
    """Depth first; appends nodes when all behind them are done."""
    if root in seen:
        return
    seen.add(root)
    stack = [(root, iter(sorted(next_of(root))))]
    while stack:
        node, following = stack[-1]
        target = next((n for n in following if n not in seen), None)
        if target is None:
            order.append(node)
            stack.pop()
        else:
            seen.add(target)
            stack.append((target, iter(sorted(next_of(target)))))


def cycle_text(graph, component):
    pairs = [f"{a} and {b}" for a, b in itertools.combinations(component, 2) if b in graph[a] and a in graph[b]]
    text = f"{len(component)} files call each other in a cycle: {', '.join(component)}"
    return text + (f"; in pairs: {', '.join(pairs[:5])}" if pairs else "")


def cycles(tree, build, nm="nm"):
    section = Section("cycles", "Cycles of calls between files of lib/", ["largest", "files", "pairs"],
                      "Files in the largest cycle (1: none), files, pairs of files that call each other.")
    graph = calls(tree, build, nm)
    found = components(graph)
    folders = sorted({file.split("/")[0] for file in graph})
    for folder in ["lib", *folders]:
        inside = {file for file in graph if folder in ("lib", file.split("/")[0])}
        largest = max((len(c) for c in found if inside.issuperset(c)), default=0)
        pairs = sum(1 for a in inside for b in graph[a] if b in inside and a < b and a in graph[b])
        section.add(folder, largest, len(inside), pairs)
    section.add("files without an object", len(without_object(tree, build)), None, None)
    long = [component for component in found if len(component) > LONGEST_CYCLE]
    section.measure("cycles", len(long), (cycle_text(graph, component) for component in long))
    return section


# ---- direction

def folder_is_above(source, target):
    """Whether a file calls a folder of lib/ that stands above its own, or beside it."""
    a, b = source.split("/")[0], target.split("/")[0]
    return a != b and a in layers.LEVEL and b in layers.LEVEL and layers.LEVEL[b] >= layers.LEVEL[a]


def place(file):
    """(folder of lib/, place of the folder inside it in its order); None for a file that is in none."""
    folder, *rest = file.split("/")
    order = layers.SUBFOLDERS.get(folder, [])
    return (folder, order.index(rest[0])) if len(rest) > 1 and rest[0] in order else None


def subfolder_is_above(source, target):
    a, b = place(source), place(target)
    return a is not None and b is not None and a[0] == b[0] and b[1] > a[1]


def upward(graph, is_above):
    return [f"{source} calls {target} ({name})" for source in sorted(graph)
            for target, name in sorted(graph[source].items()) if is_above(source, target)]


def direction(tree, build, nm="nm"):
    section = Section("calls", "Calls between folders, from file to file", ["upward", "all"],
                      "The order of the folders stands in layers.py.")
    graph = calls(tree, build, nm)
    crossing = sum(a.split("/")[0] != b.split("/")[0] for a in graph for b in graph[a])
    findings = upward(graph, folder_is_above)
    section.add("folders of lib", len(findings), crossing)
    section.measure("upward calls between folders", len(findings), findings)
    inside = upward(graph, subfolder_is_above)
    for folder, order in layers.SUBFOLDERS.items():
        among = sum(1 for a in graph for b in graph[a] if place(a) and place(b) and place(a)[0] == folder == place(b)[0]
                    and place(a) != place(b))
        section.add(f"{folder}: {len(order)} sub-folders", sum(f.startswith(folder + "/") for f in inside), among)
        section.add(f"{folder}: files in no sub-folder",
                    sum(f.startswith(folder + "/") and place(f) is None for f in graph), None)
    section.measure("upward calls between sub-folders", len(inside), inside)
    return section


# ---- what a header rebuilds

def source_of(build):
    """The source folder that a build was configured for."""
    cache = (build / "CMakeCache.txt").read_text()
    return pathlib.Path(re.search(r"^CMAKE_HOME_DIRECTORY:\w+=(.*)$", cache, re.M).group(1))


def dependencies(build, ninja="ninja"):
    """Object -> files it was made from. -n: nothing is written."""
    target = None
    for line in output(ninja, "-n", "-C", build, "-t", "deps").splitlines():
        if line.startswith("    "):
            yield target, os.path.normpath(build / line.strip())
        elif ": #deps" in line:
            target = line.split(": #deps")[0]


def rebuilds(tree, build, ninja="ninja"):
    section = Section("rebuilds", "Objects that are rebuilt when a private header is touched", ["of lib", "all built"],
                      "As the build folder has them; a file with a wide object counts twice.")
    lib = source_of(build) / "lib"
    users = collections.defaultdict(set)
    objects_seen = set()
    for target, file in dependencies(build, ninja):
        objects_seen.add(target)
        users[file].add(target)
    of_lib = {target for target in objects_seen if target.startswith("lib/")}
    section.add("objects", len(of_lib), len(objects_seen))
    counts = {path.relative_to(tree / "lib").as_posix(): users[str(lib / path.relative_to(tree / "lib"))]
              for path in (tree / "lib").rglob("*.h")}
    section.add("mean over headers", *(sum(len(u & kind) for u in counts.values()) / (len(counts) or 1)
                                       for kind in (of_lib, objects_seen)))
    for header in sorted(counts, key=lambda header: (-len(counts[header] & of_lib), header)):
        section.add(header, len(counts[header] & of_lib), len(counts[header]))
    return section
