"""The shared library exports exactly what the map lists and the headers declare, under its version
node, which is that of their @since; the static library, which cannot hide anything, defines only names with our
prefix."""
import re
import shutil

import gate
import public_headers


def map_nodes(path):
    """Function -> version node of a version script with explicit names."""
    text = re.sub(r"#[^\n]*|/\*.*?\*/", "", path.read_text(), flags=re.S)
    found = {}
    for node, body in re.findall(r"(\w[\w.]*)\s*\{(.*?)\}", text, flags=re.S):
        visible = re.search(r"global:(.*?)(?:local:|$)", body, flags=re.S)
        for name in re.findall(r"([^\s;]+)\s*;", visible.group(1) if visible else ""):
            found[name] = node
    return found


def soname(g):
    return f"libvblast_ss.so.{public_headers.version(g.include)[0]}"


def check_since(include, nodes):
    """Each function stands under the node of the version that its comment names, and no version is to come."""
    complaints = []
    for name, since in sorted(public_headers.since(include).items()):
        if since is None:
            complaints.append(f"{name} has no @since")
        elif name in nodes and nodes[name] != f"VBSS_{since}":
            complaints.append(f"{name} has @since {since}, but stands under {nodes[name]}")
        elif [int(part) for part in since.split(".")] > [int(part) for part in public_headers.version(include)]:
            complaints.append(f"{name} has @since {since}, which is later than these headers")
    return complaints


def check_shared(g, library, version_map):
    complaints = []
    nodes = map_nodes(version_map)
    declared = set(public_headers.functions(g.include))
    exported = {}
    for line in g.run(g.tool("nm"), "-D", "--defined-only", "--with-symbol-versions",
                      library).splitlines():
        kind, symbol = line.split()[-2:]
        name, _, node = symbol.partition("@")
        if kind != "A":  # the version nodes themselves
            exported[name] = node.lstrip("@")
    for name in sorted(declared - set(nodes)):
        complaints.append(f"declared in a header but not in {version_map.name}: {name}")
    for name in sorted(set(nodes) - declared):
        complaints.append(f"in {version_map.name} but not declared in a header: {name}")
    for name in sorted(set(nodes) - set(exported)):
        complaints.append(f"in {version_map.name} but not exported: {name}")
    for name in sorted(set(exported) - set(nodes)):
        complaints.append(f"exported but not in {version_map.name}: {name}")
    for name in sorted(set(exported) & set(nodes)):
        if exported[name] != nodes[name]:
            complaints.append(f"{name} has the version node '{exported[name]}', not {nodes[name]}")
    found = re.search(r"SONAME\s+(\S+)", g.run(g.tool("objdump"), "-p", library))
    if not found or found.group(1) != soname(g):
        complaints.append(f"SONAME is {found.group(1) if found else 'missing'}, not {soname(g)}")
    g.notes.append(f"{len(exported)} functions, {soname(g)}")
    return complaints


def check_static(g, *objects):
    complaints = []
    names = set()
    for line in g.run(g.tool("nm"), "--defined-only", "--extern-only", *objects).splitlines():
        words = line.split()
        if len(words) == 3:
            names.add(words[2])
    for name in sorted(n for n in names if not n.startswith("vbss_")):
        complaints.append(f"the static library shows a name without the prefix vbss_: {name}")
    g.notes.append(f"{len(names)} names in the static library")
    return complaints


def inspect(g):
    return (check_shared(g, g.library("shared"), g.source / "lib/vblast_ss.map") +
            check_since(g.include, map_nodes(g.source / "lib/vblast_ss.map")) +
            check_static(g, g.library("archive")))


# ---- canaries: the objects of the static library, linked again in a wrong way

EXTRA = '__attribute__((visibility("default"))) void {0}(void); void {0}(void) {{}}\n'


def linked(g, name, map_change, soname_option=None):
    version_map = g.work / "vblast_ss.map"
    version_map.write_text(map_change((g.source / "lib/vblast_ss.map").read_text()))
    script = [f"-Wl,--version-script={version_map}"] if version_map.read_text() else []
    library = g.compile(name, EXTRA.format("vbss_extra"), "-shared", *script,
                        f"-Wl,-soname,{soname_option or soname(g)}", "-Wl,--whole-archive",
                        g.library("archive"), "-Wl,--no-whole-archive", "-lm")
    return check_shared(g, library, g.source / "lib/vblast_ss.map")


def undeclared(g, change):
    """The right library, against another map."""
    version_map = g.work / "vblast_ss.map"
    version_map.write_text(change((g.source / "lib/vblast_ss.map").read_text()))
    return check_shared(g, g.library("shared"), version_map)


def introduced(g, version):
    """The map against headers in which a function says another version."""
    include = g.work / "include"
    shutil.rmtree(include, ignore_errors=True)
    shutil.copytree(g.include, include)
    base = include / "vblast_ss/base.h"
    function = "VBSS_API uint32_t vbss_version(void);"
    before, after = base.read_text().split(function)
    head, _, tail = before.rpartition(" * @since 1.0\n")
    base.write_text(head + version + tail + function + after)
    return check_since(include, {**map_nodes(g.source / "lib/vblast_ss.map"), "vbss_version": "VBSS_99.0"}
                       if "99" in version else map_nodes(g.source / "lib/vblast_ss.map"))


CANARIES = [
    ("a function of a later version in the node of an earlier one", lambda g: introduced(g, " * @since 1.1\n"),
     r"^vbss_version has @since 1.1, but stands under VBSS_1.0$"),
    ("a function of a version that is to come", lambda g: introduced(g, " * @since 99.0\n"),
     r"^vbss_version has @since 99.0, which is later than these headers$"),
    ("a function without @since", lambda g: introduced(g, ""), r"^vbss_version has no @since$"),
    ("a function of the headers that the map forgot",
     lambda g: undeclared(g, lambda m: m.replace("vbss_version;", "")),
     r"^(declared in a header but not in|exported but not in) vblast_ss.map: vbss_version$"),
    ("a name in the map that no header declares",
     lambda g: undeclared(g, lambda m: m.replace("vbss_version;", "vbss_version; vbss_ghost;")),
     r"^in vblast_ss.map but not (declared in a header|exported): vbss_ghost$"),
    ("a function let through by the linker",
     lambda g: linked(g, "leak", lambda m: m.replace("local:", "vbss_extra; local:")),
     r"^exported but not in vblast_ss.map: vbss_extra$"),
    ("a library linked without the map", lambda g: linked(g, "bare", lambda m: ""),
     r"^exported but not in vblast_ss.map: vbss_extra$|has the version node '', not VBSS_"),
    ("a function that is missing",
     lambda g: linked(g, "missing", lambda m: m.replace("vbss_version;", "")),
     r"^in vblast_ss.map but not exported: vbss_version$"),
    ("another SONAME", lambda g: linked(g, "soname", lambda m: m, "libvblast_ss.so.7"),
     r"^SONAME is libvblast_ss.so.7, not"),
    ("a name without prefix in the static library",
     lambda g: check_static(g, g.library("archive"), g.compile("helper", EXTRA.format("helper"))),
     r"without the prefix vbss_: helper$"),
]

if __name__ == "__main__":
    gate.main("symbols", inspect, CANARIES)
