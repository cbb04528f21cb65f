"""Writes enumerations, results (structs) and inputs (classes with defaults)."""
from __future__ import annotations

import headers
import naming
from cs_types import Types, class_name, pascal, summary

# Arrays that an input points to: the field with their number, values for each, and how many more than that number.
COUNTS = {
    ("vbss_thread_config", "rest_lengths"): ("segment_count", 1, 0),
    ("vbss_thread_config", "positions"): ("segment_count", 3, 1),
    ("vbss_drain_surface", "positions"): ("node_count", 3, 0),
    ("vbss_drain_surface", "triangles"): ("triangle_count", 3, 0),
    ("vbss_drain_surface", "anchors"): ("anchor_count", 1, 0),
    ("vbss_drain_surface", "thickness"): ("triangle_count", 1, 0),
    ("vbss_drain_surface", "young_modulus"): ("triangle_count", 1, 0),
    ("vbss_scene_rigid_config", "capsules"): ("capsule_count", 1, 0),
    ("vbss_scene_static_mesh_config", "vertices"): ("vertex_count", 3, 0),
    ("vbss_scene_static_mesh_config", "triangles"): ("triangle_count", 3, 0),
    ("vbss_scene_height_field_config", "heights"): ("height_count", 1, 0),
    ("vbss_scene_distance_field_config", "distances"): ("distance_count", 1, 0),
    ("vbss_scene_surface_config", "vertices"): ("vertex_count", 3, 0),
    ("vbss_scene_surface_config", "triangles"): ("triangle_count", 3, 0),
    ("vbss_knot_input", "points"): ("point_count", 3, 0),
    ("vbss_knot_input", "tools"): ("tool_count", 1, 0),
    ("vbss_record_config", "note"): ("note_bytes", 1, 0),
    **{("vbss_collision_batch", name): ("stride", rows, 0) for name, rows in
       (("start", 12), ("end", 12), ("thickness", 1), ("hit", 1), ("decision", 1), ("time", 1), ("normal", 3),
        ("weights", 4))},
}


def enum_lines(constants: headers.Constants) -> list[str]:
    name, prefix = naming.enum_name(constants)
    flags = not constants.kind and all(number >= 0 for _, number, _ in constants.names)
    lines = ["", *summary(constants.text, "    "), *(["    [Flags]"] if flags else []),
             f"    public enum {name} : {'uint' if flags else 'int'}", "    {"]
    for constant, number, text in constants.names:
        lines += [*summary(text, "        "), f"        {pascal(naming.short_name(constant, prefix))} = {number},"]
    return lines + ["    }"]


def is_hidden(field: headers.Declared) -> bool:
    return field.name == "struct_size" or field.name.startswith("reserved")


def fields(struct: headers.Struct, types: Types, shown: str) -> list[str]:
    lines: list[str] = []
    for field in struct.fields:
        hidden = is_hidden(field) or bool(field.pointers) or field.type in types.callbacks
        if not hidden and shown == "public":
            lines += summary(field.text, "        ")
        kind = types.in_struct(field, struct.name)
        name = pascal(field.name)
        lines.append(f"        {'internal' if hidden else shown} {kind} {name + '_' if name == class_name(struct.name) else name};")
    return lines


def result_lines(struct: headers.Struct, types: Types) -> list[str]:
    """A struct that the library fills, or an element of an array."""
    lines = ["", *summary(struct.text, "    "), "    [StructLayout(LayoutKind.Sequential)]",
             f"    public partial struct {class_name(struct.name)}", "    {"]
    return lines + fields(struct, types, "public") + ["    }"]


def pointer_lines(struct: headers.Struct, field: headers.Declared, types: Types) -> tuple[list[str], list[str]]:
    """Property of a pointer of an input, and the lines that set the pointer before a call."""
    name = pascal(field.name)
    about = summary(field.text, "        ")
    at = f"data.{name}"
    if field.dimensions:
        kind = class_name(field.type)
        shown = [*about, f"        public {kind}[] {name} {{ get; }} = new {kind}[{field.dimensions[0]}];"]
        return shown, [f"for (int i = 0; i < {field.dimensions[0]}; i++)", "{",
                       f"    {at}[i] = pins.Handle({name}[i]);", "}"]
    if field.type in types.opaque:
        return [*about, f"        public {class_name(field.type)} {name} {{ get; set; }}"], [f"{at} = pins.Handle({name});"]
    if field.type in types.inputs:
        return [*about, f"        public {class_name(field.type)} {name} {{ get; set; }}"], \
               [f"{at} = {name} == null ? IntPtr.Zero : (IntPtr){name}.Pin(pins);"]
    if field.type == "char":
        return [*about, f"        public string {name} {{ get; set; }}"], \
               [f"if ({name} != null)", "{", f"    {at} = pins.Text({name});", "}"]
    counted = COUNTS.get((struct.name, field.name))
    if not counted:
        raise headers.Refused(f"{struct.name}.{field.name}: how many values it points to stands in no table")
    count, each, more = counted
    kind = "byte" if field.type == "void" else types.scalar(field) or class_name(field.type)
    return [*about, f"        public {kind}[] {name} {{ get; set; }}"], [
        f"{at} = pins.Array({name});", f"if ({name} != null)", "{",
        f"    data.{pascal(count)} = pins.Count(nameof({name}), {name}.Length, {each}, {more}, ref counted{pascal(count)});", "}"]


def input_lines(struct: headers.Struct, types: Types) -> list[str]:
    """A class with the defaults of the library, which the caller changes."""
    name = class_name(struct.name)
    lines = ["", "    [StructLayout(LayoutKind.Sequential)]", f"    internal struct {name}Data", "    {",
             *fields(struct, types, "internal"), "    }"]
    lines += ["", *summary(struct.text, "    "), f"    public sealed unsafe partial class {name}", "    {",
              f"        private readonly {name}Data[] box = new {name}Data[1];", "",
              "        /// <summary>The defaults of the library.</summary>", f"        public {name}()", "        {",
              f"            fixed ({name}Data* data = box)", "            {",
              f"                Vblast.Check(Native.{struct.name}_init(data, (uint)sizeof({name}Data)));",
              "            }", "        }"]
    pins: list[str] = []
    counts: list[str] = []
    hooks = False
    for field in struct.fields:
        member = pascal(field.name)
        if field.type in types.callbacks or (field.type == "void" and field.name.endswith("user")):
            hooks = True
        elif field.pointers:
            shown, set_pointer = pointer_lines(struct, field, types)
            lines += ["", *shown]
            pins += set_pointer
            counted = COUNTS.get((struct.name, field.name))
            if counted and pascal(counted[0]) not in counts:
                counts.append(pascal(counted[0]))
        elif not is_hidden(field):
            kind = types.in_struct(field, struct.name)
            lines += ["", *summary(field.text, "        "), f"        public {kind} {member}", "        {",
                      f"            get {{ return box[0].{member}; }}", f"            set {{ box[0].{member} = value; }}",
                      "        }"]
    lines += ["", f"        internal {name}Data* Pin(Pins pins)", "        {"]
    if pins or hooks:
        lines += [f"            ref {name}Data data = ref box[0];"] if pins else []
        lines += [f"            uint? counted{count} = null;" for count in counts]
        lines += [f"            {line}" for line in pins]
        lines += ["            PinCallbacks(pins);"] if hooks else []
    lines += [f"            return ({name}Data*)pins.Array(box);", "        }"]
    if hooks:
        lines += ["", "        partial void PinCallbacks(Pins pins);"]
    return lines + ["    }"]


def array_lines(element: str, count: int, name: str) -> list[str]:
    """An array inside a struct: fields one after another, with an index."""
    kind = "internal" if element == "IntPtr" else "public"
    return ["", f"    /// <summary>{count} values.</summary>", "    [StructLayout(LayoutKind.Sequential)]",
            f"    {kind} unsafe struct {name}", "    {",
            "        private " + element + " " + ", ".join(f"e{i}" for i in range(count)) + ";", "",
            "        /// <summary>Number of values.</summary>", f"        public int Length {{ get {{ return {count}; }} }}", "",
            "        /// <summary>A value by its index, from 0 on.</summary>", f"        public {element} this[int index]",
            "        {", "            get",
            "            {", "                Require(index);", f"                fixed ({element}* first = &e0)",
            "                {", "                    return first[index];", "                }", "            }",
            "            set",
            "            {", "                Require(index);", f"                fixed ({element}* first = &e0)",
            "                {", "                    first[index] = value;", "                }", "            }", "        }", "",
            "        private static void Require(int index)", "        {", f"            if (index < 0 || index >= {count})",
            "            {", "                throw new IndexOutOfRangeException();", "            }", "        }", "    }"]
