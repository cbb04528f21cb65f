"""Every exported function enters (lib/base/api_call.h): it detects a second thread in its context and sets the floating-point
mode. The others touch no state of a context and compute nothing in floating point: entry-exceptions.txt has their reasons. The
functions of the library's own device adapters are called by hosts and devices, so they enter, too."""
import re

import c_text
import gate
import public_headers

ADAPTER_MEMBERS = "open|describe|read|write|couple"  # close and explain return nothing and compute nothing
ENTRY = re.compile(r"\s*VBSS_ENTER(?:_WITH_RESULT)?\((\w+)(?:, (\w+))?\);")
# A function that returns a number: the computation is in another file, so no compiler moves it across the change of mode.
BY_VALUE = re.compile(r"\s*vbss_call call;\s*vbss_call_enter\(&call, NULL\);\s*const double (\w+) = \w+\([\w, ]*\);\s*"
                      r"vbss_call_leave\(&call\);\s*return \1;\s*")
INIT = re.compile(r"\s*return vbss_config_init\([^;]*\);\s*")


def definitions(texts):
    """Name -> (file, parameters, body) of the functions of the library that begin at the start of a line."""
    found = {}
    for name, text in texts.items():
        for match in re.finditer(r"^[a-z][\w *]*?\b(\w+)\(([^;{}]*?)\)\n\{\n(.*?)^\}\n", text, re.M | re.S):
            found[match[1]] = (name, " ".join(match[2].split()), match[3])
    return found


def handles(include):
    """Types that a header declares without a body."""
    return {name for path in public_headers.headers(include)
            for name in re.findall(r"typedef\s+struct\s+(vbss_\w+)\s+\1\s*;", public_headers.declarations(path))}


def exceptions(text):
    """Name -> reason, of the lines `name  # reason`."""
    lines = (line.partition("#") for line in text.splitlines() if line.strip() and not line.startswith("#"))
    return {name.strip(): reason.strip() for name, _, reason in lines}


def wanted_handle(parameters, handle_types):
    first = re.match(r"(?:const )?(vbss_\w+) \*(\w+)(?:,|$)", parameters)
    return first[2] if first and first[1] in handle_types else "NULL"


def complaint(name, definition, handle):
    """Why a function does not enter as it must; None if it does."""
    file, _, body = definition
    entry = ENTRY.match(body)
    if entry:
        return None if entry[1] == handle else f"{file}: {name} enters {entry[1]}, not {handle}"
    if BY_VALUE.fullmatch(body) or INIT.fullmatch(body):
        return None
    return f"{file}: {name} does not begin with VBSS_ENTER({handle})"


def adapter_functions(texts):
    for file, text in texts.items():
        if file.startswith("device/"):
            for name in re.findall(rf"\.(?:{ADAPTER_MEMBERS}) = (\w+),", text):
                yield name


def check(g, texts, excepted):
    found, types, complaints = definitions(texts), handles(g.include), []
    exported = public_headers.functions(g.include)
    for name in sorted(exported):
        if name not in found:
            complaints.append(f"{name}: no definition seen")
            continue
        problem = complaint(name, found[name], wanted_handle(found[name][1], types))
        if name in excepted and problem is None:
            complaints.append(f"{name} enters, so the exception is stale")
        elif problem and name not in excepted:
            complaints.append(problem)
    for name in sorted(set(adapter_functions(texts))):
        problem = complaint(name, found[name], "user")
        if problem:
            complaints.append(problem)
    for name, reason in excepted.items():
        if name not in exported:
            complaints.append(f"the exception {name} is not an exported function")
        if not reason:
            complaints.append(f"the exception {name} has no reason")
    g.notes.append(f"{len(exported)} functions, {len(excepted)} exceptions")
    return complaints


def read(g):
    lib = g.source / "lib"
    texts = {str(path.relative_to(lib)): c_text.code(c_text.read(path)) for path in c_text.sources(lib, (".c",))}
    return texts, exceptions((g.here / "entry-exceptions.txt").read_text())


def changed(file, old, new):
    def observe(g):
        texts, excepted = read(g)
        if texts[file].count(old) != 1:
            raise gate.Problem(f"the canary is stale: {old!r} stands {texts[file].count(old)} times in {file}")
        return check(g, texts | {file: texts[file].replace(old, new)}, excepted)
    return observe


def with_exception(name, reason):
    def observe(g):
        texts, excepted = read(g)
        return check(g, texts, excepted | {name: reason})
    return observe


STEP = "vbss_result vbss_scene_step(vbss_scene *scene, double h)\n{\n    VBSS_ENTER(scene);\n"
CANARIES = [
    ("a function that does not enter", changed("scene/api/scene_api.c", STEP, STEP.replace("    VBSS_ENTER(scene);\n", "")),
     r"vbss_scene_step does not begin"),
    ("one that enters late", changed("scene/api/scene_api.c", STEP, STEP.replace("{\n", "{\n    scene_object *early;\n")),
     r"vbss_scene_step does not begin"),
    ("one that enters without its handle", changed("scene/api/scene_api.c", STEP, STEP.replace("(scene);", "(NULL);")),
     r"vbss_scene_step enters NULL, not scene"),
    ("a number computed before the entry",
     changed("base/elementary_api.c", "    const double sine", "    angle = 2.0 * angle;\n    const double sine"),
     r"vbss_sin does not begin"),
    ("an init function that does more",
     changed("needle/config.c", "    return vbss_config_init(", "    struct_size += 0;\n    return vbss_config_init("),
     r"vbss_needle_config_init does not begin"),
    ("an adapter's function that does not enter",
     changed("device/mock.c", "static vbss_result mock_open(void *user)\n{\n    VBSS_ENTER(user);\n",
             "static vbss_result mock_open(void *user)\n{\n"), r"mock_open does not begin"),
    ("a stale exception", with_exception("vbss_scene_step", "it is fast"), r"vbss_scene_step enters, so"),
    ("an exception for nothing", with_exception("vbss_nothing", "none"), r"not an exported function"),
]

if __name__ == "__main__":
    gate.main("entry", lambda g: check(g, *read(g)), CANARIES)
