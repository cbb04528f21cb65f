"""What is shipped holds no path of the machine it was built on: the install tree can be moved, and
builds in different folders give the same bytes."""
import pathlib

import gate

TEXT = {".pc", ".cmake", ".h"}


def suspects(g, build):
    """Every folder that could have leaked: of the source, of the build, of whoever builds."""
    found = {str(g.source), str(build), str(g.work), str(pathlib.Path.home()) + "/"}
    return sorted(path.encode() for path in found if path != "//")


def check(g, stage, build):
    complaints, texts, binaries = [], 0, 0
    for path in sorted(stage.rglob("*")):
        if path.is_symlink() or not path.is_file():
            continue
        binary = path.suffix not in TEXT
        texts, binaries = texts + (not binary), binaries + binary
        content = path.read_bytes()
        for suspect in suspects(g, build):
            place = content.find(suspect)
            if place >= 0:
                end = min(i for i in (content.find(b"\0", place), content.find(b"\n", place),
                                      len(content)) if i >= 0)
                complaints.append(f"{path.relative_to(stage)} holds a path of this machine: "
                                  f"{content[place:end].decode(errors='replace')[:120]}")
                break
    if texts == 0 or binaries == 0:
        complaints.append(f"nothing to look at: {texts} text files, {binaries} binaries")
    g.notes.append(f"{texts} text files, {binaries} binaries")
    return complaints


def release(g, folder):
    """A copy of the sources in a folder of its own, built as shipped."""
    return g.build(f"{folder}-build", "-DCMAKE_BUILD_TYPE=Release",
                   f"-DCMAKE_C_COMPILER={g.tool('cc')}", source=g.copy_source(folder))


def shared_bytes(build):
    files = (build / "lib").glob("libvblast_ss.so.*")
    return next(path for path in files if not path.is_symlink()).read_bytes()


def inspect(g):
    build, other = release(g, "here"), release(g, "somewhere-else")
    stage = g.work / "stage"
    g.run(g.tool("cmake"), "--install", build, "--prefix", stage)
    complaints = check(g, stage, build)
    if shared_bytes(build) != shared_bytes(other):
        complaints.append("the shared library built in another folder has other bytes")
    return complaints


# ---- canaries: a small install tree

def staged(text="prefix=${pcfiledir}/../..\n", code=""):
    def canary(g):
        stage = g.work / "stage/lib"
        stage.mkdir(parents=True, exist_ok=True)
        (stage / "canary.pc").write_text(text.format(source=g.source) if "{source}" in text else text)
        library = g.compile("canary", "const char *vbss_text(void);\n"
                            "const char *vbss_text(void) { return \"\" " + code + "; }\n", "-shared")
        library.rename(stage / "canary.so")
        return check(g, stage.parent, g.work / "build")
    return canary


CANARIES = [
    ("a .pc file with a folder of this machine", staged(text="libdir={source}/lib\n"),
     r"canary.pc holds a path of this machine"),
    ("a library with __FILE__ inside", staged(code="__FILE__"), r"canary.so holds a path of this machine"),
    ("a clean tree", staged(), None),
]

if __name__ == "__main__":
    gate.main("paths", inspect, CANARIES)
