"""Who may include whom: a folder of lib/ includes only folders above it, the C standard headers and
nothing else. The public headers, named after the folders, keep the same order."""
import re
import shutil

import gate

# Folders of one row do not know each other.
LAYERS = [["base"], ["collision"], ["solver"], ["thread", "drain", "needle", "grasper"], ["contact"],
          ["suture"], ["scene"], ["knot", "metrics", "device", "record", "replica"], ["visual"], ["session", "baseline"]]
# How a module reaches its method in lib/baseline: its own header declares a table of functions, lib/baseline defines it, and the
# file that chooses the table when an object is created refers to it. That is no call upward (gate.structure): calls go through
# the table. No other file outside lib/baseline may refer to anything in it.
METHOD_TABLES = {"vbss_baseline_ccd": "collision/ccd.c", "vbss_baseline_thread": "thread/thread.c",
                 "vbss_baseline_drain": "drain/drain.c", "vbss_baseline_scene": "scene/api/create.c",
                 "vbss_baseline_knots": "knot/memory.c"}
LEVEL = {folder: level for level, row in enumerate(LAYERS) for folder in row}
# Folders inside a folder of lib/, in their order: each includes, and calls (gate.structure), only those before it.
# Files beside the sub-folders may include all of them, and be included by all.
SUBFOLDERS = {"scene": ["world", "tools", "tissue", "topology", "contacts", "solve", "ccd", "step", "snapshot", "api"]}
# Contact works on features of any body and so must know none; metrics are fed by any simulator.
ONLY = {"contact": {"base", "collision", "solver"}, "metrics": {"base"}}
# Of scene, and of what lies below it, the folders after scene include base and this header alone: the task layer shall need no
# more than a host can get, and a change inside a scene shall not rebuild it. The header itself shows no other private header.
# The baseline is an exception: it implements methods of these modules.
INSPECT = "scene/api/inspect.h"
STANDARD = {"errno.h", "float.h", "inttypes.h", "limits.h", "math.h", "stdarg.h", "stdatomic.h", "stdbool.h", "stddef.h",
            "stdint.h", "stdio.h", "stdlib.h", "string.h"}
SYSTEM = {"cpuid.h",                     # which copy of the hot loops, on x86
          "malloc.h",                    # _aligned_malloc on Windows
          "xmmintrin.h"}                 # the floating-point mode, on x86
# Libraries loaded at run time, and a thread for lines that make one wait: in these files alone.
PLATFORM = {"dlfcn.h", "pthread.h", "time.h", "windows.h"}
PLATFORM_FILES = {"lib/device/dynamic_library.c", "lib/device/io_thread.c", "lib/device/platform.h"}
# Public headers that are not named after their folder.
OF_FOLDER = {"adapter": "device", "baseline": "base", "core_speed": "scene", "solver_options": "scene", "elementary": "base", "haptics": "device", "mapping": "device", "mock": "device", "scene_event": "scene", "scene_geometry": "scene", "scene_query": "scene", "scene_settings": "scene", "scene_surface": "scene", "session_assistance": "session", "session_coaching": "session", "session_exercise": "session",
             "output": "device"}


def subfolder(parts):
    """The sub-folder of a file of lib/, None outside all."""
    return parts[1] if len(parts) > 2 and parts[1] in SUBFOLDERS.get(parts[0], []) else None


def is_later(parts, than):
    """Whether a file stands in a later sub-folder than another file of the same folder."""
    a, b = subfolder(parts), subfolder(than)
    if not a or not b or parts[0] != than[0]:
        return False
    order = SUBFOLDERS[parts[0]]
    return order.index(a) > order.index(b)


def is_hidden(name, where, folder):
    """Whether a private header is hidden from a file after scene, or from the one header that is not."""
    target = name.split("/")[0]
    if target in ("vblast_ss", "base") or LEVEL[target] > LEVEL["scene"]:
        return False
    return where == f"lib/{INSPECT}" or (LEVEL[folder] > LEVEL["scene"] and folder != "baseline" and name != INSPECT)


def check_file(path, folder, root):
    complaints = []
    where = path.relative_to(root)
    for form, name in re.findall(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', path.read_text(), flags=re.M):
        if name in STANDARD | SYSTEM or (name in PLATFORM and str(where) in PLATFORM_FILES):
            continue
        parts = name.split("/")
        inner = subfolder(parts)
        target = parts[1].removesuffix(".h") if parts[0] == "vblast_ss" else parts[0]
        target = OF_FOLDER.get(target, target) if parts[0] == "vblast_ss" else target
        if len(parts) != (3 if inner else 2) or target not in LEVEL:
            complaints.append(f"{where} includes {name}, which is neither ours nor an allowed "
                              "standard header")
        elif target != folder and LEVEL[target] >= LEVEL[folder]:
            complaints.append(f"{where} includes {name}: {folder} may not know {target}")
        elif target != folder and folder in ONLY and target not in ONLY[folder]:
            complaints.append(f"{where} includes {name}: {folder} may know only "
                              f"{', '.join(sorted(ONLY[folder]))}")
        elif is_hidden(name, where.as_posix(), folder):
            complaints.append(f"{where} includes {name}: of scene and below it may include only base and {INSPECT}")
        elif is_later(parts, where.parts[1:]):
            complaints.append(f"{where} includes {name}: {subfolder(where.parts[1:])} may not know {inner}")
        elif parts[0] != "vblast_ss" and not (root / "lib" / name).is_file():
            complaints.append(f"{where} includes {name}, which is not in lib/")
    return complaints


def check(g, root):
    complaints, count = [], 0
    for path in sorted((root / "lib").rglob("*.[ch]")):
        folder = path.relative_to(root / "lib").parts[0]
        if folder not in LEVEL:
            complaints.append(f"lib/{folder} is no layer: add it to LAYERS in layers.py and to the design")
            continue
        parts = path.relative_to(root / "lib").parts
        if folder in SUBFOLDERS and len(parts) > 2 and not subfolder(parts):
            complaints.append(f"lib/{folder}/{parts[1]} has no place: add it to SUBFOLDERS in layers.py")
        complaints += check_file(path, folder, root)
        count += 1
    for path in sorted((root / "include/vblast_ss").glob("*.h")):
        folder = OF_FOLDER.get(path.stem, path.stem)
        if folder in LEVEL:
            complaints += check_file(path, folder, root)
        elif path.stem != "vblast_ss":
            complaints.append(f"{path.name} is named after no folder of lib/")
        count += 1
    g.notes.append(f"{count} files")
    return complaints


# ---- canaries: a tree with one more file, and empty ones

def with_file(name, text, *empty):
    def inspect(g):
        root = g.work / "tree"
        shutil.rmtree(root, ignore_errors=True)
        shutil.copytree(g.source / "lib", root / "lib")
        shutil.copytree(g.source / "include", root / "include")
        for folder in ("thread", "drain", "contact"):
            (root / "lib" / folder).mkdir(exist_ok=True)
            (root / "lib" / folder / f"{folder}.h").touch()
        for path in (root / name, *(root / other for other in empty)):
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text if path == root / name else "")
        return check(g, root)
    return inspect


def in_order(order, canary):
    """A canary in a tree where lib/scene has these sub-folders, in this order, after its own."""
    def inspect(g):
        global SUBFOLDERS
        kept, SUBFOLDERS = SUBFOLDERS, {"scene": SUBFOLDERS["scene"] + list(order)}
        try:
            return canary(g)
        finally:
            SUBFOLDERS = kept
    return inspect


CANARIES = [
    ("base includes thread", with_file("lib/base/canary.c", '#include "thread/thread.h"\n'),
     r"lib/base/canary.c includes thread/thread.h: base may not know thread"),
    ("base includes the public header of thread",
     with_file("lib/base/canary.c", "#include <vblast_ss/thread.h>\n"), r"base may not know thread"),
    ("one body includes another", with_file("lib/thread/canary.c", '#include "drain/drain.h"\n'),
     r"thread may not know drain"),
    ("contact includes a body", with_file("lib/contact/canary.c", '#include "thread/thread.h"\n'),
     r"contact may know only base, collision, solver"),
    ("a session includes the inside of a scene",
     with_file("lib/session/canary.c", '#include "scene/world/world.h"\n'),
     r"lib/session/canary.c includes scene/world/world.h: of scene and below it may include only base and scene/api/inspect.h"),
    ("a record includes the handles of a scene", with_file("lib/record/canary.c", '#include "scene/api/api.h"\n'),
     r"lib/record/canary.c includes scene/api/api.h: of scene"),
    ("a visual includes the inside of a drain", with_file("lib/visual/canary.c", '#include "drain/mesh.h"\n'),
     r"lib/visual/canary.c includes drain/mesh.h: of scene"),
    ("the header for inspecting shows the inside of a thread",
     with_file("lib/scene/api/inspect.h", '#include "thread/thread.h"\n'),
     r"lib/scene/api/inspect.h includes thread/thread.h: of scene"),
    ("a session that inspects a scene",
     with_file("lib/session/canary.c", '#include "scene/api/inspect.h"\n#include <vblast_ss/thread.h>\n'), None),
    ("a foreign header", with_file("lib/base/canary.c", "#include <pthread.h>\n"),
     r"includes pthread.h, which is neither"),
    ("a way out of the folders", with_file("lib/base/canary.c", '#include "../tests/fixtures/rod.h"\n'),
     r"which is neither"),
    ("a folder nobody placed", with_file("lib/misc/canary.c", ""), r"lib/misc is no layer"),
    ("a sub-folder that includes a later one",
     in_order(["first", "second"], with_file("lib/scene/first/canary.c", '#include "scene/second/canary.h"\n')),
     r"lib/scene/first/canary.c includes scene/second/canary.h: first may not know second"),
    ("a sub-folder that includes an earlier one",
     in_order(["first", "second"], with_file("lib/scene/second/canary.c", '#include "scene/first/canary.h"\n',
                                             "lib/scene/first/canary.h")), None),
    ("a sub-folder without a place in the order", with_file("lib/scene/misc/canary.c", ""), r"lib/scene/misc has no place"),
    ("what is allowed",
     with_file("lib/contact/canary.c", '#include <math.h>\n#include "base/error.h"\n'), None),
]

if __name__ == "__main__":
    gate.main("layers", lambda g: check(g, g.source), CANARIES)
