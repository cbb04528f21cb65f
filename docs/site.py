"""Builds the site: the pages of docs/, the C interface from the headers, and the Python interface from its docstrings.

    docs/site.py SOURCE_DIR OUT_DIR

Every warning is an error: a dead link, a page that no list names, an undocumented function. Needs Doxygen, Sphinx, MyST, Breathe
and Furo; docs/site.sh installs them."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as xml

import check_reference
import site_python

PYTHONS = [sys.executable, "/usr/bin/python3"]  # the interpreter that has Sphinx may be another than this one
LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)\s]+)\)")
LISTS = ("index.md", "start/index.md", "guides/index.md", "reference/index.md", "explanation/index.md", "notebook/index.md",
         "decisions/index.md")  # a page is a child of the first list that links to it


def interpreter():
    for python in PYTHONS:
        test = subprocess.run([python, "-c", "import breathe, furo, myst_parser, sphinx"], capture_output=True, check=False)
        if test.returncode == 0:
            return python
    sys.exit("site: Sphinx, MyST, Breathe or Furo is missing; run docs/site.sh")


def outside(target, text, page):
    """A link to a file that is no page: to its reference page if it has one, else its path."""
    path = os.path.normpath(os.path.join("docs", os.path.dirname(page), target))
    for folder, kind in (("include/vblast_ss/", "c"), ("bindings/python/vblast_ss/", "python")):
        if path.startswith(folder):
            name = pathlib.Path(path).stem.replace("__init__", "index")
            return f"[{text}]({os.path.relpath(f'reference/{kind}/{name}.md', os.path.dirname(page) or '.')})"
    if path == "README.md":
        return f"[{text}]({os.path.relpath('index.md', os.path.dirname(page) or '.')})"
    return text if path in text or pathlib.Path(path).name in text else f"{text} (`{path}`)"


def staged(text, page):
    """The page with links that the site has."""
    def link(match):
        mark, words, target = match.groups()
        path = target.split("#")[0]
        inside = not os.path.normpath(os.path.join(os.path.dirname(page), path)).startswith("..") and \
            path.endswith((".md", ".gif", ".png", ".svg"))
        if "://" in target or not path or inside:
            return match.group(0)
        return mark + outside(path, words, page)
    return LINK.sub(link, text)


def children(text, page):
    """Pages that a list links to, in its order."""
    folder = os.path.dirname(page)
    found = [os.path.normpath(os.path.join(folder, target.split("#")[0])) for mark, _, target in LINK.findall(text)
             if not mark and "://" not in target and target.split("#")[0].endswith(".md")]
    return list(dict.fromkeys(found))


def add_trees(pages):
    """Appends a hidden table of contents to each list. The lists of a folder are children of the front page."""
    taken = {"index.md", *LISTS}
    for page in LISTS:
        if page not in pages:
            continue
        names = [name for name in LISTS[1:] if name in pages] if page == "index.md" else []
        names += [name for name in children(pages[page], page) if name not in taken]
        taken.update(names)
        lines = "\n".join("/" + name.removesuffix(".md") for name in names)
        pages[page] += f"\n```{{toctree}}\n:hidden:\n\n{lines}\n```\n"


def c_pages(source, folder):
    """A page a header, all from Doxygen's output, and a list of them."""
    files = sorted((source / "include/vblast_ss").glob("*.h"))
    rows = []
    for file in files:
        brief = re.search(r"@brief\s+(.*?)(?:\.\s|\n \*\s*\n|\*/)", file.read_text(encoding="utf-8"), re.S)
        words = " ".join(re.sub(r"^\s*\*", "", line).strip() for line in brief.group(1).splitlines()) if brief else ""
        rows.append((file.stem, words))
        if file.stem != "vblast_ss":
            (folder / f"{file.stem}.md").write_text(
                f"# {file.name}\n\n`#include <vblast_ss/{file.name}>`\n\n```{{doxygenfile}} {file.name}\n```\n", encoding="utf-8")
    lines = ["# vblast_ss.h", "", "`vblast_ss.h` includes all headers of the C interface.", "", "| header | subject |", "|---|---|"]
    lines += [f"| [{name}.h]({name}.md) | {words} |" for name, words in rows if name != "vblast_ss"]
    names = "\n".join(name for name, _ in rows if name != "vblast_ss")
    lines += ["", "```{toctree}", ":hidden:", "", names, "```", ""]
    (folder / "vblast_ss.md").write_text("\n".join(lines), encoding="utf-8")


def without_typedefs(folder):
    """Drops `typedef struct X X` beside a documented struct X: Sphinx takes both for one name."""
    structs = {xml.parse(file).findtext("compounddef/compoundname") for file in folder.glob("struct*.xml")}
    for file in folder.glob("*_8h.xml"):
        tree = xml.parse(file)
        for section in tree.iter("sectiondef"):
            for member in section.findall("memberdef"):
                if member.get("kind") == "typedef" and member.findtext("name") in structs:
                    section.remove(member)
        tree.write(file, encoding="utf-8", xml_declaration=True)


def stage(source, out):
    """The sources of the site: pages with their links, pictures, and generated pages."""
    work = out / "source"
    shutil.rmtree(work, ignore_errors=True)
    pages = {}
    for path in sorted((source / "docs").rglob("*")):
        name = path.relative_to(source / "docs").as_posix()
        if path.suffix == ".md":
            pages[name] = staged(path.read_text(encoding="utf-8"), name)
        elif path.suffix in (".gif", ".png", ".svg"):
            (work / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, work / name)
    add_trees(pages)
    for name, text in pages.items():
        (work / name).parent.mkdir(parents=True, exist_ok=True)
        (work / name).write_text(text, encoding="utf-8")
    for kind in ("c", "python"):
        (work / "reference" / kind).mkdir(parents=True, exist_ok=True)
    c_pages(source, work / "reference/c")
    site_python.write(source / "bindings/python/vblast_ss", work / "reference/python")
    shutil.copy(source / "docs/conf.py", work)
    return work


def version_of(source):
    text = (source / "include/vblast_ss/base.h").read_text(encoding="utf-8")
    return ".".join(re.search(rf"#define VBSS_VERSION_{part} (\d+)", text).group(1) for part in ("MAJOR", "MINOR", "PATCH"))


def main():
    source, out = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    python = interpreter()
    done = check_reference.build(source, out / "doxygen")
    if done.returncode != 0:
        sys.exit(f"site: FAIL\n{done.stdout}{done.stderr}")
    without_typedefs(out / "doxygen/xml")
    work = stage(source, out)
    environment = {**os.environ, "VBSS_SITE_XML": str(out / "doxygen/xml"), "VBSS_SITE_VERSION": version_of(source)}
    for left in ("html", "doctrees"):  # Doxygen renumbers anonymous enumerations in each run
        shutil.rmtree(out / left, ignore_errors=True)
    command = [python, "-B", "-m", "sphinx", "-b", "html", "-q", "-W", "--keep-going", "-d", str(out / "doctrees"),
               str(work), str(out / "html")]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"site: FAIL\n{done.stdout}{done.stderr}")
    print(f"site: pass, {len(list((out / 'html').rglob('*.html')))} pages; open {out / 'html/index.html'}")


if __name__ == "__main__":
    main()
