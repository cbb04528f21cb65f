"""Runs the shell commands of README.md and of all pages below docs/ but those of the notebook.

    page_commands.py list SOURCE_DIR   each command is run or exempt; each exemption is still needed
    page_commands.py run SOURCE_DIR    runs them in a copy of the checkout, with a home of its own
    page_commands.py canary            a command that fails is refused, and an exemption without a command

A page's commands are its blocks sh, bash, console and shell, and indented blocks that begin with a program. Blocks run in the order of
the page, by bash -euo pipefail in the checkout. The C program of a page before a block is example.c there, the C# program Program.cs."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

# Commands that are not run, and why. A pattern is matched at the start of a command without its comment.
EXEMPT = [
    (r"sudo apt-get ", "needs root; .ci/install-packages installs the same packages for every front door"),
    (r"\./tests/run\.sh", "it runs this test"),
    (r"ctest ", "tests/run.sh all runs every test of the suites; those of -C real-time need an idle machine"),
    (r"\./examples/demo\.sh", "performs the whole task for minutes; test examples.demo_files_agree_with_its_log runs its program"),
    (r"\./examples/play\.sh", "opens a window for a person; tests examples.viewer_live to _pad operate the program by a script"),
    (r"build/(default|release)/examples/(ghost|surgeon|viewer)/", "performs the task for minutes, or opens a window; tests examples.surgeon_* and viewer_* run them"),
    (r"\./examples/web\.sh", "installs a second compiler, and serves without end; test examples.web_build builds the page"),
    (r"cmake --preset default && cmake --build --preset default --target web_performed_page", "builds the library for browsers; test examples.web_performed_build does"),
    (r"python3 tests/web/film_task\.py", "performs the whole task for minutes in a browser, with ffmpeg"),
    (r"(mkdir -p build/pad|build/release/examples/pad/pad)", "sews for two minutes; tests examples.pad and examples.pad_report run it"),
    (r"build/release/examples/report/vbss-report build/pad/", "reads the log of the pad; test examples.pad_report does"),
    (r"ffmpeg ", "needs the pictures of the command before it"),
    (r"build/release/examples/replay_page/vbss-replay-page suturing\.vbss", "reads the log of a person; tests examples.replay_logs and examples.replay_page make pages of other logs"),
    (r"\./docs/site\.sh", "installs Sphinx; test docs.site builds the site"),
    (r"\./bench/run\.sh ", "needs an idle machine and minutes to hours; tests bench.against and bench.summary run it on small cases"),
    (r"(python3 )?bench/knots_hold/run\.py", "2440 knots take 35 minutes; a soak, knot_holding, runs samples"),
    (r"/usr/bin/python3 docs/scripts/plot_knot_holding\.py", "draws the result of the command before it"),
    (r"python3 tests/determinism/\w+\.py", "tests determinism.matrix.* and determinism.performances run the rows"),
    (r"tests/masked\.sh ", "python3 tests/thorough.py masked runs it"),
    (r"tests/abi/update-baseline\.py", "changes the baseline, which only a maintainer does after a merge; gate.abi compares with it"),
    (r"pkgconfig/release\.py", "test consumer.release runs it"),
    (r"python3 bindings/python/wheels\.py", "cross-builds seven platforms with a compiler from the package index; tests wheels.build.* run it"),
    (r"cargo ", "needs Rust, which is too large for the packages of the tests; test rust.page runs it where cargo is there"),
    (r"(git clone \. /tmp/mutants|tests/mutants\.py)", "builds and tests the library thirty times"),
]
# Commands that run with smaller numbers.
SHORTER = [(r"--scenes 10000", "--scenes 50")]
FENCE = re.compile(r"^```(\w*)[^\n]*\n(.*?)^```", re.MULTILINE | re.DOTALL)
SHELL = ("sh", "bash", "console", "shell")
PROGRAMS = {"cmake", "ctest", "git", "python3", "pip", "cc", "gcc", "export", "sudo", "mkdir", "cd"}
CANARY = "Build:\n\n```sh\ntrue    # fine\nfalse\n```\n\nand\n\n    cmake --preset absent\n\n    int x = 1;\n"


class Block:
    def __init__(self, page, line, text, program):
        self.where, self.program = f"{page}:{line}", program
        joined = re.sub(r"\\\n\s*", " ", text)
        lines = (re.sub(r"(^|\s)#\s.*$", "", line).strip() for line in joined.splitlines())
        self.commands = [re.sub(r"^\$ ", "", line) for line in lines if line]


def is_command(line, source):
    first = line.split()[0] if line.split() else ""
    return first in PROGRAMS or ("/" in first and (source / first).is_file())


def blocks_of(page, text, source):
    """The shell blocks of a page in its order."""
    found, program = [], None
    for match in FENCE.finditer(text):
        language, body = match.groups()
        if (language, True) in (("c", "int main" in body), ("csharp", "static void Main" in body)):
            program = ("example.c" if language == "c" else "Program.cs", body)
        if language in SHELL:
            found.append((match.start(), body, program))
    plain = FENCE.sub(lambda match: re.sub(r"[^\n]", "", match.group(0)), text)
    offset = 0
    for part in re.split(r"(\n\s*\n)", plain):
        lines = part.strip("\n").splitlines()
        if lines and all(line.startswith("    ") for line in lines) and is_command(lines[0], source):
            line = plain[:offset].count("\n")
            found.append((sum(len(row) + 1 for row in text.splitlines()[:line]), "\n".join(row[4:] for row in lines), None))
        offset += len(part)
    return [Block(page, text.count("\n", 0, start) + 1, body, before) for start, body, before in sorted(found, key=lambda row: row[0])]


def pages(source):
    files = [source / "README.md", *sorted((source / "docs").rglob("*.md"))]
    return [file for file in files if source / "docs/notebook" not in file.parents]


def all_blocks(source):
    return [block for file in pages(source) for block in blocks_of(file.relative_to(source), file.read_text(encoding="utf-8"), source)]


def reason(command):
    return next((why for pattern, why in EXEMPT if re.match(pattern, command)), None)


def stale(blocks):
    commands = [command for block in blocks for command in block.commands]
    return [pattern for pattern, _ in EXEMPT if not any(re.match(pattern, command) for command in commands)]


def show(blocks):
    for block in blocks:
        for command in block.commands:
            print(f"{block.where}: {command}\n    {reason(command) or 'run'}")
    complaints = [f"no page has the exempt command {pattern}" for pattern in stale(blocks)]
    if not blocks or complaints:
        sys.exit("\n".join(complaints) or "no commands were found")


def run(blocks, checkout, home):
    """Runs all blocks; a complaint at the first one that fails, or None."""
    home.mkdir()
    done, count = set(), 0
    for block in blocks:
        if block.program is not None:
            name, text = block.program
            (checkout / name).write_text(text, encoding="utf-8")
        lines = [command for command in block.commands if reason(command) is None and not (command.startswith("./") and command in done)]
        for pattern, shorter in SHORTER:
            lines = [re.sub(pattern, shorter, line) for line in lines]
        if not lines:
            continue
        print(f"{block.where}: {len(lines)} commands", flush=True)
        ran = subprocess.run(["bash", "-euo", "pipefail", "-c", "\n".join(lines)], cwd=checkout, text=True, check=False,
                             env=dict(os.environ, HOME=str(home)), stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if ran.returncode != 0:
            return f"{block.where}: the commands fail\n" + "\n".join(lines + ran.stdout.splitlines()[-30:])
        done.update(lines)
        count += len(lines)
    print(f"pages: pass, {count} commands run")
    return None if count else "no command was run"


def canary():
    with tempfile.TemporaryDirectory() as work:
        folder = pathlib.Path(work)
        blocks = blocks_of("page.md", CANARY, folder)
        commands = [command for block in blocks for command in block.commands]
        if commands != ["true", "false", "cmake --preset absent"] or [block.where for block in blocks] != ["page.md:3", "page.md:10"]:
            sys.exit(f"the blocks are read as {commands}")
        complaint = run(blocks, folder, folder / "home")
        if complaint is None or "page.md:3" not in complaint:
            sys.exit(f"a failing command gives {complaint}")
        if len(stale(blocks)) != len(EXEMPT):
            sys.exit("exemptions without a command are not found")
    print("canary: pass")


def main():
    if sys.argv[1:] == ["canary"]:
        canary()
        return
    if len(sys.argv) != 3 or sys.argv[1] not in ("list", "run"):
        sys.exit(__doc__)
    source = pathlib.Path(sys.argv[2]).resolve()
    if sys.argv[1] == "list":
        show(all_blocks(source))
        return
    # Not in the build folder, whose path may have spaces, which the shell lines do not expect.
    with tempfile.TemporaryDirectory() as work:
        checkout = pathlib.Path(work) / "checkout"
        shutil.copytree(source, checkout, ignore=shutil.ignore_patterns("build", ".git"))
        complaint = run(all_blocks(source), checkout, pathlib.Path(work) / "home")
    if complaint:
        sys.exit(complaint)


if __name__ == "__main__":
    main()
