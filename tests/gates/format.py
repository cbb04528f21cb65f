"""All C and C++ is laid out by .clang-format."""
import pathlib

import gate

FOLDERS = ("include", "lib", "tests", "bench", "examples")


def sources(root):
    return sorted(path for folder in FOLDERS for path in (root / folder).rglob("*")
                  if path.suffix in (".c", ".h", ".cpp"))


# To start a process may take longer than to look at a file.
FILES_AT_ONCE = 50


def check_some(g, files):
    """One complaint a file: the first place of it that is told."""
    style = f"--style=file:{g.source / '.clang-format'}"
    code, said = g.run(g.tool("clang-format"), style, "--dry-run", "--Werror", *files, code=None)
    if code == 0:
        return []
    firsts = {}
    for line in said.splitlines():
        if "error:" in line:
            firsts.setdefault(line.partition(":")[0], line)
    return [f"{pathlib.Path(path).name} is laid out otherwise: {line}"
            for path, line in firsts.items()] or [f"clang-format: {said.strip()}"]


def check(g, files):
    complaints = []
    for begin in range(0, len(files), FILES_AT_ONCE):
        complaints += check_some(g, files[begin:begin + FILES_AT_ONCE])
    g.notes.append(f"{len(files)} files")
    return complaints


def inspect(g):
    return check(g, sources(g.source))


def canary(g):
    path = g.work / "canary.c"
    path.write_text("int main(void) {\n  return 0; }\n")
    return check(g, [path])


if __name__ == "__main__":
    gate.main("format", inspect, [("braces and indentation of another style", canary, "laid out")])
