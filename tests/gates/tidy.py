"""clang-tidy finds nothing in our C, with the checks of .clang-tidy.

With VBSS_TIDY_COMMITS=N in the environment it looks only at files that the last N commits or the working tree changed, and
at no more than VBSS_TIDY_MOST of them (default: all), those that changed last."""
import concurrent.futures
import json
import os
import pathlib
import re

import gate

def newest_first(g, commits):
    """Paths that differ from HEAD, then those that the last commits changed, the newest first."""
    text = g.run("git", "-C", g.source, "diff", "--name-only", "HEAD")
    text += g.run("git", "-C", g.source, "log", f"-{commits}", "--name-only", "--format=")
    return list(dict.fromkeys(text.split()))


def changed_only(g, files, commits, max_files):
    """Those files that the last commits changed, at most so many; for a changed header, one file that includes it."""
    of_path = {str(pathlib.Path(file).relative_to(g.source)): file for file in files}
    includes = {file: set(re.findall(r'#include [<"]([^">]+)[">]', pathlib.Path(file).read_text())) for file in files}
    chosen = {}
    for path in newest_first(g, commits):
        if path in of_path:
            chosen[of_path[path]] = None
        elif path.endswith(".h"):
            name = "/".join(path.split("/")[-2:])
            users = [file for file in files if name in includes[file]]
            if users and not any(file in chosen for file in users):
                chosen[users[0]] = None
    if len(chosen) > max_files:
        g.notes.append(f"the {max_files} changed last of {len(chosen)} changed files")
    return list(chosen)[:max_files]


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
        results = pool.map(lambda chunk: findings_in(g, database, chunk), chunks)  # in their order
        findings = dict.fromkeys(finding for of_chunk in results for finding in of_chunk)
    g.notes.append(f"{len(files)} files")
    return list(findings)  # what stands in a header once, though several processes have told it


def inspect(g):
    database = g.library("archive").parent.parent / "compile_commands.json"
    if not database.is_file():
        raise gate.Problem("no compile_commands.json: configure with a preset")
    text = database.read_text()
    units = {unit["file"] for unit in json.loads(text)}
    # clang ignores most flags of gcc's optimiser, and stops at this one.
    text = text.replace(" -fno-tree-loop-distribute-patterns", "")
    (g.work / "compile_commands.json").write_text(text)
    files = sorted(f for f in units if f.endswith(".c") and f.startswith(str(g.source / "")))
    # What CMake made (the mains of the test executables) stands in the build folder.
    made = str(g.source / "build") + "/"
    files = [f for f in files if not f.startswith(made)]
    commits = os.environ.get("VBSS_TIDY_COMMITS")
    if commits:
        files = changed_only(g, files, int(commits), int(os.environ.get("VBSS_TIDY_MOST", len(files))))
    return check(g, g.work, files)


def canary(g):
    path = g.work / "canary.c"
    path.write_text("int half(int n);\nint half(int n)\n{\n    if (n)\n        return n / 2;\n"
                    "    return n == n;\n}\n")
    database = [{"directory": str(g.work), "file": str(path), "arguments": ["cc", "-c", str(path)]}]
    (g.work / "compile_commands.json").write_text(json.dumps(database))
    return check(g, g.work, [path])


if __name__ == "__main__":
    gate.main("tidy", inspect, [("a comparison with itself, an if without braces", canary,
                              "misc-redundant-expression|readability-braces")])
