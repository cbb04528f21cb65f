"""clang-tidy finds nothing in our C, with the checks of .clang-tidy."""
import concurrent.futures
import json
import os
import re

import gate

CHUNK = 8  # files a process: small enough that all workers end at about the same time


def findings_in(g, database, files):
    # The flags in the database may be gcc's, some of which clang does not know or finds contradictory.
    code, said = g.run(g.tool("clang-tidy"), "-p", database, "--quiet",
                       "--extra-arg=-Wno-overriding-t-option",
                       "--extra-arg=-Wno-ignored-optimization-argument",
                       f"--config-file={g.source / '.clang-tidy'}", *files, code=None)
    findings = [line for line in said.splitlines() if re.search(r"\b(error|warning): ", line)]
    if code != 0 and not findings:
        findings = [said.strip()]
    return [finding.replace(str(g.source) + "/", "") for finding in findings]


def check(g, database, files):
    chunks = [files[i:i + CHUNK] for i in range(0, len(files), CHUNK)]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        told = pool.map(lambda chunk: findings_in(g, database, chunk), chunks)  # in their order
        findings = dict.fromkeys(finding for of_chunk in told for finding in of_chunk)
    g.notes.append(f"{len(files)} files")
    return list(findings)  # what stands in a header once, though several processes have told it


def look(g):
    database = g.library("archive").parent.parent / "compile_commands.json"
    if not database.is_file():
        raise gate.Problem("no compile_commands.json: configure with a preset")
    text = database.read_text()
    units = {unit["file"] for unit in json.loads(text)}
    # clang ignores most flags of gcc's optimiser, and stops at these.
    for flag in (" -fno-tree-loop-distribute-patterns", " -fcallgraph-info=su"):
        text = text.replace(flag, "")
    (g.work / "compile_commands.json").write_text(text)
    files = sorted(f for f in units if f.endswith(".c") and f.startswith(str(g.source / "")))
    # What CMake made (the mains of the test executables) stands in the build folder.
    made = str(g.source / "build") + "/"
    return check(g, g.work, [f for f in files if not f.startswith(made)])


def canary(g):
    path = g.work / "canary.c"
    path.write_text("int half(int n);\nint half(int n)\n{\n    if (n)\n        return n / 2;\n"
                    "    return n == n;\n}\n")
    database = [{"directory": str(g.work), "file": str(path), "arguments": ["cc", "-c", str(path)]}]
    (g.work / "compile_commands.json").write_text(json.dumps(database))
    return check(g, g.work, [path])


if __name__ == "__main__":
    gate.main("tidy", look, [("a comparison with itself, an if without braces", canary,
                              "misc-redundant-expression|readability-braces")])
