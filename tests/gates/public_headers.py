"""Reads the public headers: functions, structs and their fields, integer types.

Not a C parser: it knows the few forms the library uses and complains about any other, so that
nothing public escapes the gates because it was written differently."""
import re

FIXED_WIDTH = {f"{sign}int{bits}_t" for sign in ("", "u") for bits in (8, 16, 32, 64)}


def headers(include):
    return sorted((include / "vblast_ss").glob("*.h"))


def declarations(path):
    """The text without comments, preprocessor lines and the extern "C" bracket."""
    text = re.sub(r"/\*.*?\*/|//[^\n]*", " ", path.read_text(), flags=re.S)
    text = re.sub(r"\\\n", " ", text)
    # The rows of an X-macro between two directives are not declarations of their own.
    text = re.sub(r"^\s*#.*$", "", text, flags=re.M)
    return re.sub(r'extern\s+"C"\s*\{', "", text)


def functions(include):
    """Name -> prototype of every exported function."""
    found = {}
    for path in headers(include):
        for match in re.finditer(r"\bVBSS_API\b([^;{}]*?)\b(\w+)\s*(\([^;{}]*\))\s*;",
                                 declarations(path)):
            found[match.group(2)] = " ".join((match.group(1) + match.group(2) + match.group(3)).split())
    return found


def integer_types(include):
    """vbss_ name -> its type, for typedef int32_t vbss_...; - the types of constants."""
    found = {}
    for path in headers(include):
        for base, name in re.findall(r"typedef\s+(\w+)\s+(vbss_\w+)\s*;", declarations(path)):
            if base in FIXED_WIDTH:
                found[name] = base
    return found


def callback_types(include):
    """vbss_ name -> signature of every pointer to a function."""
    found = {}
    for path in headers(include):
        for returned, name, parameters in re.findall(
                r"typedef\s+([\w\s*]+)\(\s*\*\s*(vbss_\w+)\s*\)\s*(\([^;]*\))\s*;", declarations(path)):
            found[name] = " ".join((returned + parameters).split())
    return found


def structs(include):
    """Name -> list of (field, type, is pointer), in order; and complaints about other forms."""
    found, complaints = {}, []
    form = r"typedef\s+struct\s+(vbss_\w+)\s*\{([^{}]*)\}\s*(vbss_\w+)\s*;"
    for path in headers(include):
        text = declarations(path)
        for tag, body, name in re.findall(form, text):
            if tag != name:
                complaints.append(f"{path.name}: struct {tag} and its typedef {name} differ in name")
            found[name] = []
            for line in filter(None, (part.strip() for part in body.split(";"))):
                fields, complaint = read_fields(line)
                found[name] += fields
                if complaint:
                    complaints.append(f"{path.name}: {name}: {complaint}")
        rest = re.sub(form, "", text)
        for match in re.findall(r"\b(?:struct|union)\b[^;{}]*\{", rest):
            complaints.append(f"{path.name}: '{' '.join(match.split())}' is not of the form "
                              "'typedef struct vbss_x {...} vbss_x;', so no gate covers it")
    return found, complaints


def read_fields(line):
    """One member declaration: [(field, type, is pointer)], complaint."""
    if ":" in line:
        return [], f"bit-field '{line}'"
    if "(" in line:
        return [], f"'{line}': use a typedef for a pointer to a function"
    match = re.fullmatch(r"((?:const\s+)?(?:unsigned\s+|struct\s+|enum\s+|long\s+)*\w+)\s*(.*)", line,
                         flags=re.S)
    if not match:
        return [], f"'{line}' cannot be read"
    fields = []
    for declarator in match.group(2).split(","):
        part = re.fullmatch(r"\s*((?:\*\s*(?:const\s+)?)*)(\w+)\s*((?:\[[^\]]*\]\s*)*)", declarator)
        if not part:
            return fields, f"'{line}' cannot be read"
        kind = " ".join(match.group(1).replace("const ", "").split())
        fields.append((part.group(2), kind, "*" in part.group(1)))
    return fields, ""


def version(include):
    """Major and minor number, as texts."""
    numbers = dict(re.findall(r"#define VBSS_VERSION_(MAJOR|MINOR) (\d+)", (include / "vblast_ss/base.h").read_text()))
    return numbers["MAJOR"], numbers["MINOR"]


def since(include):
    """Name -> version of the @since line in the comment of every exported function; None: it has none."""
    found = {}
    for path in headers(include):
        for comment, name in re.findall(r"/\*\*((?:(?!\*/).)*)\*/\s*(?:VBSS_DEPRECATED\([^)]*\)\s*)?VBSS_API\b[^;{}(]*?\b(\w+)\s*\(",
                                        path.read_text(), flags=re.S):
            line = re.search(r"@since (\d+\.\d+)$", comment, flags=re.M)
            found[name] = line.group(1) if line else None
    return found
