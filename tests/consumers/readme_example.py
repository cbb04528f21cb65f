"""Takes the first C example out of README.md, builds it against the library and runs it.

    readme_example.py --readme FILE --compiler CC --include DIR --library FILE --work DIR
"""
import argparse
import pathlib
import re
import subprocess
import sys


def main():
    parser = argparse.ArgumentParser()
    for name in ("readme", "compiler", "include", "library", "work"):
        parser.add_argument(f"--{name}", required=True)
    options = parser.parse_args()

    found = re.search(r"^```c\n(.*?)^```", pathlib.Path(options.readme).read_text(),
                      re.MULTILINE | re.DOTALL)
    if found is None:
        sys.exit("README.md has no C example")
    work = pathlib.Path(options.work)
    work.mkdir(parents=True, exist_ok=True)
    (work / "example.c").write_text(found.group(1))
    subprocess.run([options.compiler, "-std=c11", "-Wall", "-Wextra", "-pedantic", "-Werror",
                    f"-I{options.include}", work / "example.c", options.library, "-lm",
                    "-o", work / "example"], check=True)
    done = subprocess.run([work / "example"], capture_output=True, text=True)
    print(done.stdout, end="")
    lines = found.group(1).count("\n")
    if done.returncode != 0 or not done.stdout:
        sys.exit("the README's example fails or says nothing")
    print(f"README example: {lines} lines, built and run")


if __name__ == "__main__":
    main()
