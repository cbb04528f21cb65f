"""Every file that a page links to exists: check_links.py SOURCE_DIR"""
import pathlib
import re
import sys

source = pathlib.Path(sys.argv[1])
pages = [source / "README.md", source / "CHANGELOG.md", *sorted((source / "docs").rglob("*.md"))]
checked, broken = 0, []
for page in pages:
    prose = re.sub(r"^```.*?^```", "", page.read_text(), flags=re.M | re.S)
    for target in re.findall(r"\]\(([^)#\s]+)", prose):
        if "://" in target:
            continue
        checked += 1
        if not (page.parent / target).exists():
            broken.append(f"{page.relative_to(source)}: {target}")
if broken or checked == 0:
    sys.exit("docs links: FAIL\n" + "\n".join(broken))
print(f"docs links: pass, {checked} links in {len(pages)} pages")
