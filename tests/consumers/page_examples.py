"""Compiles and runs each complete C and C++ program of the pages below docs/start and docs/guides.

    page_examples.py SOURCE_DIR LIBRARY CC CXX WORK_DIR

A block without `int main` is a fragment; it is counted and not compiled."""
import pathlib
import re
import subprocess
import sys


def main():
    source, library = (pathlib.Path(argument) for argument in sys.argv[1:3])
    work = pathlib.Path(sys.argv[5])
    work.mkdir(parents=True, exist_ok=True)
    compilers = {"c": [sys.argv[3], "-std=gnu11"], "cpp": [sys.argv[4], "-std=c++17"]}
    programs, fragments = 0, 0
    for page in sorted([*(source / "docs/start").glob("*.md"), *(source / "docs/guides").glob("*.md")]):
        for language, text in re.findall(r"^```(c|cpp)\n(.*?)^```", page.read_text(encoding="utf-8"), re.M | re.S):
            if "int main" not in text:
                fragments += 1
                continue
            programs += 1
            file = work / f"{page.stem}-{programs}.{language}"
            file.write_text(text, encoding="utf-8")
            command = [*compilers[language], "-Wall", "-Wextra", "-Werror", f"-I{source / 'include'}", str(file), str(library),
                       f"-Wl,-rpath,{library.parent}", "-lm", "-o", str(file.with_suffix(""))]
            for step in (command, [str(file.with_suffix(""))]):
                done = subprocess.run(step, capture_output=True, text=True, timeout=60, cwd=work, check=False)
                if done.returncode != 0:
                    sys.exit(f"{page.relative_to(source)}: program {programs} fails\n{done.stdout}{done.stderr}")
    if programs < 6:
        sys.exit(f"only {programs} programs were found")
    print(f"pages: pass, {programs} programs compiled and run, {fragments} fragments left out")


if __name__ == "__main__":
    main()
