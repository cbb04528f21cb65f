"""Doxygen filter: writes VBSS_RESULTS out as documented enumeration constants.

    expand_results.py include/vblast_ss/base.h
"""
import pathlib
import re
import sys

source = pathlib.Path(sys.argv[1]).read_text()
table = re.search(r"#define VBSS_RESULTS\(X\)(?:.*\\\n)*.*\n", source).group(0)
rows = re.findall(r"X\((\w+),\s*(-?\d+),\s*\\?\s*\"([^\"]*)\"\)", table)
constants = "\n".join(f"    {name} = {number}, /**< {text} */" for name, number, text in rows)
expanded, count = re.subn(r"#define VBSS_RESULT_CONSTANT.*?#undef VBSS_RESULT_CONSTANT",
                          lambda _: constants, source, flags=re.DOTALL)
if count != 1 or len(rows) != table.count("X(VBSS_"):
    sys.exit("the table of results has another shape than this filter knows")
print(expanded, end="")
