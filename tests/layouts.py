"""Size and offsets of every struct of the public headers, as the C compiler has them: bindings are compared with them."""
from __future__ import annotations

import pathlib
import subprocess
import sys
from typing import Callable

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bindings"))
import headers  # noqa: E402


def structs() -> list[headers.Struct]:
    return [struct for header in headers.read_all(ROOT / "include") for struct in header.structs if struct.fields]


def table(text: str) -> dict[str, list[int]]:
    """Of a program that prints a line for each struct: name, size, offset of each field."""
    return {line.split()[0]: [int(word) for word in line.split()[1:]] for line in text.splitlines()}


def of_c(compiler: str, folder: pathlib.Path, called: Callable[[str], str] = str) -> dict[str, list[int]]:
    """By what `called` makes of a struct's name."""
    rows = []
    for struct in structs():
        offsets = ", ".join(f"(unsigned)offsetof({struct.name}, {field.name})" for field in struct.fields)
        rows.append(f'    {{ const unsigned o[] = {{ {offsets} }}; printf("{called(struct.name)} %u", (unsigned)sizeof({struct.name}));\n'
                    '      for (unsigned i = 0; i < sizeof o / sizeof *o; i++) printf(" %u", o[i]); printf("\\n"); }')
    source = folder / "layout.c"
    source.write_text("#include <stddef.h>\n#include <stdio.h>\n#include <vblast_ss/vblast_ss.h>\nint main(void)\n{\n" +
                      "\n".join(rows) + "\n    return 0;\n}\n")
    subprocess.run([compiler, "-std=c11", f"-I{ROOT / 'include'}", str(source), "-o", str(folder / "layout")], check=True)
    return table(subprocess.run([folder / "layout"], check=True, capture_output=True, text=True).stdout)


def require_equal(language: str, wanted: dict[str, list[int]], printed: str) -> None:
    found = table(printed)
    differ = [f"{name}: {language} has {found.get(name)}, C has {numbers}" for name, numbers in wanted.items() if found.get(name) != numbers]
    if differ:
        sys.exit("layouts differ:\n" + "\n".join(differ))
    print(f"{len(wanted)} structs have the layout of C")
