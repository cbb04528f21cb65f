"""All C and C++ is laid out by .clang-format."""
import gate

FOLDERS = ("include", "lib", "tests", "bench", "examples")


def sources(root):
    return sorted(path for folder in FOLDERS for path in (root / folder).rglob("*")
                  if path.suffix in (".c", ".h", ".cpp"))


def check(g, files):
    complaints = []
    for path in files:
        style = f"--style=file:{g.source / '.clang-format'}"
        code, said = g.run(g.tool("clang-format"), style, "--dry-run", "--Werror", path, code=None)
        if code != 0:
            first = next((line for line in said.splitlines() if "error:" in line), said.strip())
            complaints.append(f"{path.name} is laid out otherwise: {first}")
    g.notes.append(f"{len(files)} files")
    return complaints


def look(g):
    return check(g, sources(g.source))


def canary(g):
    path = g.work / "canary.c"
    path.write_text("int main(void) {\n  return 0; }\n")
    return check(g, [path])


if __name__ == "__main__":
    gate.main("format", look, [("braces and indentation of another style", canary, "laid out")])
