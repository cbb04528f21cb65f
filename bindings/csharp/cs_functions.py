"""Writes imported functions, and the methods and constructors that call them."""
from __future__ import annotations

import dataclasses
import re

import headers
import naming
from cs_types import OPTIONAL, Types, class_name, local, parameter_texts, pascal, summary

# Functions that the files beside Generated/ wrap: buffers, callbacks, and memory of the library.
BY_HAND = {
    "vbss_context_create", "vbss_context_destroy", "vbss_context_get_last_error", "vbss_core_speed_measure",
    "vbss_collision_add_chain", "vbss_collision_add_capsules", "vbss_collision_add_mesh", "vbss_collision_set_motion",
    "vbss_collision_test_batch", "vbss_thread_set_state", "vbss_drain_set_state", "vbss_thread_grade_lengths",
    "vbss_knot_detector_get_notation", "vbss_nidaqmx_list_devices", "vbss_scene_get_bodies", "vbss_scene_take_events",
    "vbss_scene_set_user_data", "vbss_scene_get_user_data", "vbss_record_take", "vbss_replay_create", "vbss_scene_load",
    "vbss_record_check_log", "vbss_replay_get_info", "vbss_replay_read", "vbss_metrics_get_penalty", "vbss_mock_get_adapter",
    "vbss_scene_add_thread", "vbss_scene_add_drain", "vbss_scene_add_needle", "vbss_scene_add_grasper", "vbss_scene_remove",
    "vbss_scene_move_surface", "vbss_scene_remesh_surface", "vbss_scene_set_surface_compliance", "vbss_scene_get_surface_view",
    "vbss_openhaptics_get_adapter", "vbss_nidaqmx_get_adapter", "vbss_session_begin_at"}
# Of every class that has them, in VbssObject.
SHARED = ("_save", "_restore", "_destroy", "_get_view")
# What a name would be in the way of a property or of a word of the language.
METHODS = {"Preset": "UsePreset", "Suture": "UseSuture", "Shape": "UseShape"}


def by_hand(function: headers.Function) -> bool:
    return function.name in BY_HAND or function.name.endswith(SHARED) or function.name.endswith("_init")


def import_lines(function: headers.Function, types: Types) -> list[str]:
    parameters = ", ".join(f"{types.native(p)} {local(p.name)}" for p in function.parameters)
    result = "IntPtr" if function.result.type == "char" else types.native(function.result)
    if function.name.endswith("_destroy"):  # the handle itself calls it
        parameters = parameters.replace("ObjectHandle", "IntPtr")
    return ["", "        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]",
            f"        internal static extern {result} {function.name}({parameters});"]


def owner(function: headers.Function, header: headers.Header, types: Types) -> tuple[str, str]:
    """Struct whose class the method belongs to ("": a static class of the header), and the rest of the name."""
    fitting = [name for name in types.structs if function.name.startswith(name + "_") and
               (name in types.opaque or name in types.inputs)]
    if fitting:
        longest = max(fitting, key=len)
        return longest, function.name[len(longest) + 1:]
    prefix = f"vbss_{header.name}_"
    return "", function.name[len(prefix if function.name.startswith(prefix) else "vbss_"):]


def on_any_thread(function: headers.Function) -> bool:
    """Whether another thread may be inside the context; then the call must not touch the context's state."""
    said = re.search(r"@threads (.*)", function.text)
    return not (said and said.group(1).startswith("one thread at a time per context"))


@dataclasses.dataclass
class Call:
    """What a method takes, does before, passes, does after, and gives."""
    takes: list[str] = dataclasses.field(default_factory=list)
    said: list[tuple[str, str]] = dataclasses.field(default_factory=list)  # parameter in C#, in the header
    before: list[str] = dataclasses.field(default_factory=list)
    passes: list[str] = dataclasses.field(default_factory=list)
    after: list[str] = dataclasses.field(default_factory=list)
    gives: list[tuple[str, str, str]] = dataclasses.field(default_factory=list)  # type, name, expression
    objects: list[str] = dataclasses.field(default_factory=list)
    pinned: bool = False

    def take(self, kind: str, declared: headers.Declared, default: str = "") -> str:
        name = local(declared.name)
        self.takes.append(f"{kind} {name}{default}")
        self.said.append((name, declared.name))
        return name


def optional_input(d: headers.Declared, function: headers.Function) -> bool:
    return "NULL for the defaults" in parameter_texts(function.text).get(d.name, "")


def add_pointer_to_struct(call: Call, d: headers.Declared, sized: bool, function: headers.Function, types: Types) -> None:
    kind, name = class_name(d.type), local(d.name)
    if d.type in types.inputs:
        call.pinned = True
        if sized:  # filled by the library
            call.before.append(f"var {name} = new {kind}();")
            call.gives.append((kind, name, name))
        else:
            call.take(kind, d, " = null" if optional_input(d, function) else "")
        call.passes.append(f"{name} == null ? null : {name}.Pin(pins)")
        return
    if d.constant:
        call.take(kind, d)
        call.passes.append(f"&{name}")
        return
    call.before.append(f"{kind} {name};")
    call.passes.append(f"&{name}")
    call.gives.append((kind, name, name))


def add_numbers(call: Call, d: headers.Declared, function: headers.Function, types: Types) -> None:
    """A pointer to numbers, or an array of a fixed size."""
    name, element = local(d.name), types.scalar(d)
    if d.dimensions:
        kind = types.vector(d)
    elif d.constant or (d.name in OPTIONAL and element == "double"):
        kind = OPTIONAL[d.name] if d.name in OPTIONAL else ""
        if not kind:
            raise headers.Refused(f"{function.name}: how many values {d.name} points to stands in no table")
    else:
        kind = element
    if not d.constant:
        call.before.append(f"{kind} {name};")
        call.passes.append(f"({element}*)&{name}")
        call.gives.append((kind, name, name))
    elif d.dimensions:
        call.take(kind, d)
        call.passes.append(f"({element}*)&{name}")
    else:
        call.take(f"{kind}?", d)
        call.before += [f"{kind} {name}Value = {name}.GetValueOrDefault();"]
        call.passes.append(f"{name}.HasValue ? ({element}*)&{name}Value : null")


def add(call: Call, d: headers.Declared, sized: bool, function: headers.Function, types: Types) -> None:
    name = local(d.name)
    if d.type in types.opaque and d.pointers == 1:
        call.take(class_name(d.type), d)
        call.objects.append(name)
        call.passes.append(f"ObjectHandle.Of({name})")
    elif d.type in types.opaque:
        call.before.append(f"IntPtr {name};")
        call.passes.append(f"out {name}")
        call.gives.append((class_name(d.type), name, ""))
    elif d.type in types.structs:
        add_pointer_to_struct(call, d, sized, function, types)
    elif d.type == "char" and d.pointers == 2:
        call.before.append(f"byte* {name};")
        call.passes.append(f"&{name}")
        call.gives.append(("string", name, f"Vblast.Text((IntPtr){name})"))
    elif d.pointers or d.dimensions:
        add_numbers(call, d, function, types)
    else:
        call.take(types.scalar(d), d)
        call.passes.append(name)


def signature(call: Call) -> str:
    """Parameters; only the last may have a default."""
    return ", ".join([*(one.replace(" = null", "") for one in call.takes[:-1]), *call.takes[-1:]])


def body(lines: list[str], pinned: bool, state: str = "") -> list[str]:
    if not pinned:
        return [f"            {line}" for line in lines]
    return [f"            using (Pins pins = Pins.Rent({state}))", "            {", *(f"                {line}" for line in lines),
            "            }"]


def documentation(function: headers.Function, call: Call) -> list[str]:
    texts = parameter_texts(function.text)
    lines = summary(function.text, "        ")
    for name, in_header in call.said:
        about = texts.get(in_header) or f"{name}".lstrip("@")
        if about:
            inner = summary(about, "        ")
            inner[0] = inner[0].replace("<summary>", f'<param name="{name.lstrip("@")}">')
            inner[-1] = inner[-1].replace("</summary>", "</param>")
            lines += inner
    return lines


def method_lines(function: headers.Function, header: headers.Header, types: Types) -> tuple[str, list[str]]:
    """Struct whose class gets it, and the lines."""
    home, rest = owner(function, header, types)
    parameters = list(function.parameters)
    call = Call()
    first = parameters[0] if parameters else None
    instance = bool(first and home and first.type == home and first.pointers == 1)
    input_self = instance and home in types.inputs
    if instance:
        parameters = parameters[1:]
        call.pinned = bool(input_self)
        call.passes.append("Pin(pins)" if input_self else "Handle")
    skip = False
    for number, d in enumerate(parameters):
        if skip:
            skip = False
            continue
        follows = parameters[number + 1] if number + 1 < len(parameters) else None
        sized = follows is not None and follows.name == "struct_size"
        skip = sized
        add(call, d, sized, function, types)
        if sized:
            kind = types.data(d.type)
            call.passes.append(f"(uint)sizeof({kind})")
    name = METHODS.get(pascal(rest), pascal(rest)) if input_self else pascal(rest)
    arguments = ", ".join(call.passes)
    native = f"Native.{function.name}({arguments})"
    about = ["", *documentation(function, call)]
    creates = home in types.opaque and rest == "create"
    if creates:
        context = call.objects[0] + ("" if parameters[0].type == "vbss_context" else ".Context")
        base = f"Require({call.objects[0]})" if context == call.objects[0] else f"Require({call.objects[0]}).Context"
        out = next(local(d.name) for d in parameters if d.pointers == 2)
        lines = [*call.before, f"Context.Check({native});",
                 f"Adopt({out}, Native.{home}_destroy{', pins' if call.pinned else ''});"]
        lines += [f"Keep({one});" for one in call.objects[1 if context == call.objects[0] else 0:]]
        return home, [*about, f"        public {class_name(home)}({signature(call)})",
                      f"            : base({base})", "        {", *body(lines, call.pinned, "Context.State"), "        }"]
    if function.result.type == "char":
        result, after = "string", [f"return Vblast.Text({native});"]
        return home, [*about, f"        public static string {name}({signature(call)})", "        {",
                      *body([*call.before, *after], call.pinned), "        }"]
    if types.scalar(function.result) != "int" and function.result.type != "vbss_result":
        return home, [*about, f"        public static {types.scalar(function.result)} {name}({signature(call)})", "        {",
                      *body([*call.before, f"return {native};"], call.pinned), "        }"]
    check = ("Check" if home == "vbss_context" else "Context.Check") if instance and not input_self else \
        (f"{call.objects[0]}.Context.Check" if call.objects and call.objects[0] != "context" else
         "context.Check" if call.objects else "Vblast.Check")
    lines = [*call.before]
    lines += [f"Keep({one});" for one in call.objects] if instance and not input_self else []
    context = check.rsplit(".", 1)[0]
    lines.append(f"{'Vblast.Check' if on_any_thread(function) else check}({native});")

    def expression(kind: str, made: str, text: str) -> str:
        if text:
            return text
        struct = next(d.type for d in parameters if d.pointers == 2 and local(d.name) == made)
        if rest.startswith("get_"):
            return f"{context}.Find({made}, (owner, handle) => new {kind}(owner, handle, null))"
        return f"new {kind}({context}, {made}, Native.{struct}_destroy)"

    if len(call.gives) == 1:
        kind, made, text = call.gives[0]
        result = kind
        lines.append(f"return {expression(kind, made, text)};")
    else:
        result = "void"
        for kind, made, text in call.gives:
            call.takes.append(f"out {kind} {made}Result")
            lines.append(f"{made}Result = {expression(kind, made, text)};")
            call.said.append((f"{made}Result", next(d.name for d in parameters if local(d.name) == made)))
        about = ["", *documentation(function, call)]
    return home, [*about, f"        public {'' if instance else 'static '}{result} {name}({signature(call)})", "        {",
                  *body(lines, call.pinned), "        }"]
