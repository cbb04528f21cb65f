"""Does literally what README.md says under "In a program", in a copy of the checkout and with a home of
its own: the C block becomes example.c, the shell block after it builds, installs, compiles and runs.

    readme_example.py SOURCE_DIR
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile


def block(language, text):
    found = re.search(rf"^```{language}\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    if found is None:
        sys.exit(f"README.md has no {language} block under \"In a program\"")
    return found.group(1)


def main():
    source = pathlib.Path(sys.argv[1])
    # Not in the build folder, whose path may have spaces, which the shell lines do not expect.
    with tempfile.TemporaryDirectory() as work:
        follow(source, pathlib.Path(work))


def follow(source, work):
    checkout, home = work / "checkout", work / "home"
    shutil.copytree(source, checkout, ignore=shutil.ignore_patterns("build", ".git"))
    home.mkdir()
    section = (source / "README.md").read_text().split("## In a program")[1].split("\n## ")[0]
    example = block("c", section)
    (checkout / "example.c").write_text(example)
    done = subprocess.run(["bash", "-euo", "pipefail", "-c", block("sh", section)], cwd=checkout,
                          env=dict(os.environ, HOME=str(home)), stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)
    said = done.stdout.strip().splitlines()
    if done.returncode != 0 or not said or not said[-1].startswith("libvblast_ss "):
        sys.exit("the README's commands fail or end otherwise:\n" + "\n".join(said[-20:]))
    print(f"README: {example.count(chr(10))} lines of C built against the installed library: {said[-1]}")


if __name__ == "__main__":
    main()
