"""Builds the reference of the public headers with Doxygen; undocumented is an error.

    check_reference.py --source DIR --out DIR [--canary]

The canary adds a header with an undocumented function and passes only if Doxygen refuses it by name.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import xml.etree.ElementTree as xml

CANARY = """/** @file canary.h
 * @brief A header with a fault. */
void vbss_canary_undocumented(int argument);
/** Documented, its parameter not. @return nothing of use */
int vbss_canary_parameter(int argument);
"""


def build(source, out):
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    return subprocess.run(["doxygen", "docs/Doxyfile"], cwd=source, capture_output=True, text=True,
                          env=dict(os.environ, VBSS_DOCS_OUT=str(out)))


def documented_functions(out):
    names = set()
    for file in (out / "xml").glob("*.xml"):
        for member in xml.parse(file).iter("memberdef"):
            if member.get("kind") == "function":
                names.add(member.findtext("name"))
    return names


def canary(source, out):
    """A copy of what Doxygen reads, with the faulty header in it."""
    copy = out / "source"
    shutil.rmtree(out, ignore_errors=True)
    for folder in ("docs", "include"):
        shutil.copytree(source / folder, copy / folder)
    (copy / "include" / "vblast_ss" / "canary.h").write_text(CANARY)
    done = build(copy, out / "reference")
    for wanted in ("vbss_canary_undocumented", "vbss_canary_parameter"):
        if done.returncode == 0 or wanted not in done.stderr:
            sys.exit(f"docs canary: FAIL, {wanted} was not refused\n{done.stderr}")
    print("docs canary: pass, both faults were refused by name")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--source", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--canary", action="store_true")
    options = parser.parse_args()
    if options.canary:
        canary(options.source, options.out)
        return
    done = build(options.source, options.out)
    if done.returncode != 0:
        sys.exit(f"docs: FAIL\n{done.stdout}{done.stderr}")
    names = documented_functions(options.out)
    if "vbss_context_create" not in names:
        sys.exit("docs: FAIL, the reference does not hold the functions")
    print(f"docs: pass, {len(names)} functions; open html/index.html in the build's docs folder")


if __name__ == "__main__":
    main()
