"""Pages of the Python interface, from the docstrings; nothing is imported, so the library need not be built."""
import ast
import inspect


def public(name):
    return not name.startswith("_")


def signature(function, bound):
    """Arguments as written, without annotations, which the docstrings explain."""
    arguments = function.args
    for argument in [*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs, arguments.vararg, arguments.kwarg]:
        if argument is not None:
            argument.annotation = None
    listed = arguments.posonlyargs or arguments.args
    if bound and listed:
        listed.pop(0)
    return f"({ast.unparse(arguments)})"


def is_property(function):
    return any("property" in ast.unparse(decorator) for decorator in function.decorator_list)


def is_static(function):
    return any(ast.unparse(decorator) == "staticmethod" for decorator in function.decorator_list)


def directive(kind, head, body, depth):
    fence = "`" * (6 - depth)
    return f"{fence}{{{kind}}} {head}\n\n{body}\n{fence}\n"


def text_of(node):
    """Prose with indented code; a paragraph that is indented stays code in Markdown."""
    return inspect.cleandoc(ast.get_docstring(node, clean=False) or "")


def members(node):
    parts, seen = [], set()
    for item in node.body:
        if isinstance(item, (ast.FunctionDef, ast.AsyncFunctionDef)) and public(item.name) and item.name not in seen:
            seen.add(item.name)
            if is_property(item):
                parts.append(directive("py:property", item.name, text_of(item), 2))
            else:
                parts.append(directive("py:method", item.name + signature(item, not is_static(item)), text_of(item), 2))
    return parts


def class_of(node):
    start = next((item for item in node.body if isinstance(item, ast.FunctionDef) and item.name == "__init__"), None)
    head = node.name + (signature(start, True) if start else "")
    start_text = text_of(start) if start else ""
    body = "\n\n".join(part for part in (text_of(node), start_text, *members(node)) if part)
    return directive("py:class", head, body, 1)


def page(path):
    tree = ast.parse(path.read_text(encoding="utf-8"))
    name = f"vblast_ss.{path.stem}"
    parts, seen = [f"# {name}\n", text_of(tree) + "\n", f"```{{py:module}} {name}\n```\n"], set()
    for node in tree.body:
        if isinstance(node, (ast.ClassDef, ast.FunctionDef)) and public(node.name) and node.name not in seen:
            seen.add(node.name)
            parts.append(class_of(node) if isinstance(node, ast.ClassDef) else
                         directive("py:function", node.name + signature(node, False), text_of(node), 1))
    return "\n".join(parts)


def write(package, folder):
    """A page a module, and a list of them."""
    modules = [path for path in sorted(package.glob("*.py")) if public(path.stem)]
    rows = []
    for path in modules:
        (folder / f"{path.stem}.md").write_text(page(path), encoding="utf-8")
        first = text_of(ast.parse(path.read_text(encoding="utf-8"))).split("\n\n")[0].replace("\n", " ")
        rows.append(f"| [vblast_ss.{path.stem}]({path.stem}.md) | {first} |")
    overview = text_of(ast.parse((package / "__init__.py").read_text(encoding="utf-8")))
    lines = ["# Package vblast_ss", "", overview, "", "| module | subject |", "|---|---|", *rows, "", "```{toctree}", ":hidden:", "",
             *(path.stem for path in modules), "```", ""]
    (folder / "index.md").write_text("\n".join(lines), encoding="utf-8")
