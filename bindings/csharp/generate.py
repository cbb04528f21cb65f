#!/usr/bin/env python3
"""Writes the C# binding's generated part, VblastSs/Generated, from the public headers.

    bindings/csharp/generate.py            writes the files
    bindings/csharp/generate.py --check    says which differ from what it would write, and fails

Run it after every change of include/vblast_ss; what it writes depends on the headers alone."""
from __future__ import annotations

import pathlib
import sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]
import cs_functions  # noqa: E402
import cs_structs  # noqa: E402
import headers  # noqa: E402
import naming  # noqa: E402
from cs_types import Types, class_name, pascal, summary  # noqa: E402

INCLUDE = HERE.parent.parent / "include"
OUT = HERE / "VblastSs" / "Generated"


def file_text(lines: list[str]) -> str:
    using = [f"using {name};" for name, words in (("System", ("IntPtr", "[Flags]", "Exception", "ReadOnlySpan")),
                                                  ("System.Runtime.InteropServices", ("StructLayout", "DllImport")))
             if any(word in line for word in words for line in lines)]
    while lines and not lines[0]:
        lines = lines[1:]
    return "\n".join(["// Written by bindings/csharp/generate.py from the public headers: do not edit.", *using,
                      *([""] if using else []), "namespace VblastSs", "{", *lines, "}"]) + "\n"


def types_file(header: headers.Header, types: Types) -> list[str]:
    lines: list[str] = []
    for constants in header.constants:
        lines += cs_structs.enum_lines(constants)
    for struct in header.structs:
        if struct.name == "vbss_view" or not struct.fields:
            continue
        lines += cs_structs.input_lines(struct, types) if struct.name in types.inputs else cs_structs.result_lines(struct, types)
    return lines


def methods_file(header: headers.Header, types: Types) -> list[str]:
    """Classes of the header's objects, with their methods."""
    methods: dict[str, list[str]] = {}
    for struct in header.structs:
        if struct.name in types.opaque and struct.name != "vbss_context":
            methods[struct.name] = object_lines(struct, header)
    for function in header.functions:
        if cs_functions.by_hand(function):
            continue
        home, lines = cs_functions.method_lines(function, header, types)
        methods.setdefault(home, []).extend(lines)
    lines = []
    for home, some in methods.items():
        name = class_name(home) if home else "Vblast" if header.name == "base" else pascal(header.name)
        if home in types.opaque:
            kind = f"sealed unsafe partial class {name} : VbssObject" if home != "vbss_context" else f"sealed unsafe partial class {name}"
            about = types.structs[home].text
        elif home:
            kind, about = f"sealed unsafe partial class {name}", ""
        else:
            kind, about = f"static unsafe partial class {name}", f"Functions of {header.name}.h that need no object."
        while some and not some[0]:
            some = some[1:]
        lines += ["", *(summary(about, "    ") if about else []), f"    public {kind}", "    {", *some, "    }"]
    return lines


def object_lines(struct: headers.Struct, header: headers.Header) -> list[str]:
    """What a class has apart from its functions: construction from a handle, and the functions that all objects share."""
    name, names = class_name(struct.name), {f.name for f in header.functions}
    lines = ["", f"        internal {name}(Context context, IntPtr handle, DestroyFunction destroy)", "            : base(context)",
             "        {", "            Adopt(handle, destroy);", "        }"]
    if f"{struct.name}_save" in names:
        lines += ["", "        /// <summary>The state, to go back to it or to go on elsewhere to the same bits.</summary>",
                  "        public byte[] Save()", "        {",
                  f"            return SaveState(Native.{struct.name}_save);", "        }", "",
                  "        /// <summary>Goes to a state that was saved from this object, or from one made alike. "
                  "A failed call changes nothing.</summary>",
                  "        public void Restore(ReadOnlySpan<byte> state)", "        {",
                  "            fixed (byte* bytes = state)", "            {",
                  f"                Context.Check(Native.{struct.name}_restore(Handle, bytes, (ulong)state.Length));",
                  "            }", "        }"]
    view = next((f for f in header.functions if f.name == f"{struct.name}_get_view"), None)
    if view:
        field = naming.camel(view.parameters[1].type)
        lines += ["", "        /// <summary>A read-only array inside the library; see <see cref=\"View\"/>.</summary>",
                  f"        public View GetView({field} field)", "        {",
                  f"            return new View(this, (int)field, {'true' if cs_functions.on_any_thread(view) else 'false'}, "
                  f"(handle, number, view, size) =>",
                  f"                Native.{view.name}(handle, ({field})number, view, size));",
                  "        }"]
    return lines


def generate(include: pathlib.Path = INCLUDE) -> dict[str, str]:
    """File name -> text."""
    all_headers = headers.read_all(include)
    types = Types(all_headers)
    files: dict[str, str] = {}
    for header in all_headers:
        stem = pascal(header.name)
        natives = [line for function in header.functions for line in cs_functions.import_lines(function, types)]
        for part, lines in (("Types", types_file(header, types)), ("Methods", methods_file(header, types)),
                            ("Native", ["    internal static unsafe partial class Native", "    {", *natives[1:], "    }"]
                             if natives else [])):
            if lines:
                files[f"{stem}{part}.cs"] = file_text(lines)
    constants = [f"        internal const uint {pascal(name.replace('VBSS_', ''))} = {number};"
                 for header in all_headers for name, number in header.numbers.items() if "VERSION" in name]
    files["Versions.cs"] = file_text(["    internal static class HeaderVersion", "    {", *constants, "    }"])
    files["Arrays.cs"] = file_text([line for element, count in sorted(types.arrays)
                                    for line in cs_structs.array_lines(element, count, types.array(element, count))])
    return files


def differences(include: pathlib.Path = INCLUDE, out: pathlib.Path = OUT) -> list[str]:
    """Files that are not what the headers say."""
    wanted = generate(include)
    there = {path.name: path.read_text() for path in out.glob("*.cs")} if out.is_dir() else {}
    return sorted(name for name in set(wanted) | set(there) if wanted.get(name) != there.get(name))


def main() -> int:
    if sys.argv[1:] == ["--check"]:
        differ = differences()
        for name in differ:
            print(f"{OUT.name}/{name} is not what the headers say: run bindings/csharp/generate.py", file=sys.stderr)
        return 1 if differ else 0
    if len(sys.argv) > 1:
        print(__doc__, file=sys.stderr)
        return 2
    OUT.mkdir(parents=True, exist_ok=True)
    files = generate()
    for path in OUT.glob("*.cs"):
        if path.name not in files:
            path.unlink()
    for name, text in files.items():
        (OUT / name).write_text(text)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except headers.Refused as refused:
        sys.exit(f"generate.py: {refused}")
