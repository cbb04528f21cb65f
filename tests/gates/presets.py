"""Every preset of CMakePresets.json can be configured; with a preset's name as the part, it also builds.

A preset whose compiler is not installed is skipped, with a line that says so."""
import json
import shutil

import gate


def presets(source):
    """Name -> cache variables with those of the presets that it inherits, for all presets that are not hidden."""
    rows = {row["name"]: row for row in json.loads((source / "CMakePresets.json").read_text())["configurePresets"]}

    def variables(row):
        inherited = row.get("inherits", [])
        found = {}
        for name in [inherited] if isinstance(inherited, str) else reversed(inherited):
            found |= variables(rows[name])
        return found | row.get("cacheVariables", {})

    return {name: variables(row) for name, row in rows.items() if not row.get("hidden")}


def configure(g, source, name, variables):
    """The build folder, or None if the preset's compiler is not installed."""
    compiler = variables.get("CMAKE_C_COMPILER", "cc")
    if shutil.which(compiler) is None:
        print(f"  preset {name}: skipped, {compiler} is not installed")
        return None
    build = g.work / name
    g.run(g.tool("cmake"), "--preset", name, "-S", source, "-B", build, cwd=source)
    return build


def inspect(g):
    known = presets(g.source)
    chosen = [g.part] if g.part else list(known)
    for name in chosen:
        build = configure(g, g.source, name, known[name])
        if build and g.part:
            g.run(g.tool("cmake"), "--build", build, "-j", "2")
    if not chosen:
        return ["CMakePresets.json has no preset"]
    g.notes.append(", ".join(chosen))
    return []


def unlisted_test(g):
    """A copy with a test file that no list names: the presets that build tests must refuse it."""
    copy = g.work / "tree"
    shutil.copytree(g.source, copy, ignore=shutil.ignore_patterns("build", ".git"))
    (copy / "tests/base/test_in_no_list.c").touch()
    complaints = []
    for name in ("fuzz", "coverage"):
        try:
            configure(g, copy, name, presets(copy)[name])
        except gate.Problem as problem:
            complaints.append(str(problem))
    return complaints if len(complaints) == 2 else []


if __name__ == "__main__":
    gate.main("presets", inspect, [("a preset that cannot be configured", unlisted_test, "In no list of subjects")])
