"""The low-level binding is what the headers say, in names and in bytes."""
import ctypes
import os
import re
import shutil
import subprocess

import pytest

from conftest import BINDING, ROOT

import sys
sys.path.insert(0, str(BINDING))
import generate  # noqa: E402
import headers  # noqa: E402
from vblast_ss import _api  # noqa: E402


def modules():
    return [getattr(_api, name) for name in _api.__all__ if name != "FUNCTIONS"]


def structs():
    return {name: kind for module in modules() for name, kind in vars(module).items()
            if isinstance(kind, type) and issubclass(kind, ctypes.Structure) and hasattr(kind, "_fields_")}


def test_the_committed_files_are_what_the_headers_give():
    assert generate.differences() == []


def test_writing_them_twice_gives_the_same():
    assert generate.generate() == generate.generate()


@pytest.mark.parametrize("old, new", [
    ("uint64_t bytes_peak; ", "uint32_t bytes_peak, more; "),
    ("VBSS_LOG_INFO = 3", "VBSS_LOG_INFO = 4"),
    ("VBSS_API uint32_t vbss_version(void);", "VBSS_API uint64_t vbss_version(void);"),
    ('X(VBSS_ERROR_BUSY, -9,', 'X(VBSS_ERROR_BUSY, -90,')])
def test_a_changed_header_is_seen(tmp_path, old, new):
    include = tmp_path / "include"
    shutil.copytree(ROOT / "include", include)
    base = include / "vblast_ss" / "base.h"
    text = base.read_text()
    assert text.count(old) == 1
    base.write_text(text.replace(old, new))
    if ", more" in new:
        with pytest.raises(headers.Refused):
            generate.differences(include)
    else:
        assert generate.differences(include) == ["base.py"]


@pytest.mark.parametrize("text", [
    "struct vbss_loose { double x; };", "typedef union vbss_u { double x; } vbss_u;",
    "typedef struct vbss_f { double (*call)(void); } vbss_f;", "enum { VBSS_NEW = VBSS_OLD + 1 };",
    "VBSS_API void vbss_new(long double x);"])
def test_a_form_that_the_reader_does_not_know_is_refused(tmp_path, text):
    include = tmp_path / "include"
    shutil.copytree(ROOT / "include", include)
    with (include / "vblast_ss" / "base.h").open("a") as base:
        base.write(text + "\n")
    with pytest.raises(headers.Refused):
        generate.generate(include)


def test_forms_that_may_come_are_read(tmp_path):
    include = tmp_path / "include"
    shutil.copytree(ROOT / "include", include)
    (include / "vblast_ss" / "new.h").write_text(
        "#include <vblast_ss/base.h>\n#define VBSS_NEW_ROOM 4 /**< Room. */\n"
        "/** Bits. */\nenum {\n    VBSS_NEW_A = 0x10, /**< A. */\n    /** B. */\n    VBSS_NEW_B = 1 << 5\n};\n"
        "/** New. */\ntypedef struct vbss_new {\n    double rows[VBSS_NEW_ROOM][3]; /**< Rows. */\n} vbss_new;\n")
    text = generate.generate(include)["new.py"]
    assert "VBSS_NEW_ROOM = 4" in text and '("rows", (c_double * 3) * 4),' in text
    assert "class NewBits(IntFlag):" in text and "A = 16" in text and "B = 32" in text and '"""B."""' in text


def test_layouts_and_constants_are_those_of_the_compiler(tmp_path):
    compiler = os.environ.get("VBSS_CC") or shutil.which("cc") or shutil.which("gcc")
    if not compiler:
        pytest.skip("no C compiler")
    rows, expected = [], []
    for name, kind in structs().items():
        rows.append(f'printf("{name} %zu %zu\\n", sizeof({name}), _Alignof({name}));')
        expected.append(f"{name} {ctypes.sizeof(kind)} {ctypes.alignment(kind)}")
        for field, _ in kind._fields_:
            rows.append(f'printf("{name}.{field} %zu %zu\\n", offsetof({name}, {field}), sizeof((({name} *)0)->{field}));')
            expected.append(f"{name}.{field} {getattr(kind, field).offset} {getattr(kind, field).size}")
    for header in headers.read_all(ROOT / "include"):
        module = getattr(_api, header.name)
        for constants in header.constants:
            name, prefix = generate.enum_name(constants)
            members = list(getattr(module, name).__members__.values())
            assert len(members) == len(constants.names)
            for (constant, _, _), member in zip(constants.names, members):
                rows.append(f'printf("{constant} %lld\\n", (long long){constant});')
                expected.append(f"{constant} {int(member)}")
    source = tmp_path / "layout.c"
    source.write_text("#include <stddef.h>\n#include <stdio.h>\n#include <vblast_ss/vblast_ss.h>\nint main(void)\n{\n"
                      + "\n".join(rows) + "\nreturn 0;\n}\n")
    subprocess.run([compiler, "-std=c11", "-I", str(ROOT / "include"), str(source), "-o", str(tmp_path / "layout")],
                   check=True)
    said = subprocess.run([str(tmp_path / "layout")], check=True, capture_output=True, text=True).stdout.splitlines()
    assert len(said) > 900
    assert said == expected


def test_nothing_of_the_abi_baseline_is_missing():
    baseline = (ROOT / "tests" / "abi" / "layout-lp64.txt").read_text()
    fields = set(re.findall(r"^(vbss_\w+\.\w+) offset", baseline, re.M))
    assert fields == {f"{name}.{field}" for name, kind in structs().items() for field, _ in kind._fields_}
    constants = set(re.findall(r"^(VBSS_\w+) is ", baseline, re.M))
    assert constants == {name for header in headers.read_all(ROOT / "include") for some in header.constants
                         for name, _, _ in some.names}


def exported():
    return set(re.findall(r"^\s+(vbss_\w+);", (ROOT / "lib" / "vblast_ss.map").read_text(), re.M))


def test_the_binding_has_every_exported_function():
    assert set(_api.FUNCTIONS) == exported()
