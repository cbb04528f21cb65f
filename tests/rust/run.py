#!/usr/bin/env python3
"""Tests of the Rust binding.

    run.py generated    the committed files are what the headers give, with every function
    run.py crates       cargo test, without a network; a hanging thread has the hash of Python
    run.py layout       all structs have the layout of C
    run.py page         the program of docs/start/rust.md compiles and runs by the commands of the page

VBLAST_SS_LIBRARY is the shared library, VBSS_CC a C compiler, VBSS_WORK a folder to work in. Ends with 77 where cargo is missing."""
from __future__ import annotations

import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
BINDING = ROOT / "bindings" / "rust"
sys.path[:0] = [str(BINDING), str(ROOT / "tests")]
import generate  # noqa: E402
import hanging_thread  # noqa: E402
import headers  # noqa: E402
import layouts  # noqa: E402


def work() -> pathlib.Path:
    folder = pathlib.Path(os.environ["VBSS_WORK"])
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def environment() -> dict[str, str]:
    """The linker wants the name without a version, which stands beside the file."""
    library = str(pathlib.Path(os.environ["VBLAST_SS_LIBRARY"]).parent)
    return {**os.environ, "VBLAST_SS_LIB_DIR": library, "LD_LIBRARY_PATH": library, "CARGO_TARGET_DIR": str(work() / "target"),
            "CARGO_NET_OFFLINE": "true"}


def run(*command: object, cwd: pathlib.Path = BINDING) -> str:
    done = subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, cwd=cwd,
                          env=environment())
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))} failed:\n{done.stdout[-6000:]}")
    return done.stdout


def need_cargo() -> None:
    if not shutil.which("cargo") or not shutil.which("rustc"):
        print("skipped: cargo or rustc is not there. On Debian: apt-get install cargo")
        sys.exit(77)


def generated() -> None:
    differ = generate.differences()
    if differ:
        sys.exit(f"run bindings/rust/generate.py: {', '.join(differ)}")
    functions = {f.name for h in headers.read_all(ROOT / "include") for f in h.functions}
    exported = set(re.findall(r"^\s+(vbss_\w+);", (ROOT / "lib/vblast_ss.map").read_text(), re.M))
    declared = set(re.findall(r"pub fn (vbss_\w+)\(", "".join(path.read_text() for path in (BINDING / "vblast-ss-sys/src").glob("*.rs"))))
    if not functions == exported == declared:
        sys.exit(f"in Rust, but not in the library: {sorted(declared - exported)}; not in Rust: {sorted((functions | exported) - declared)}")
    base = (ROOT / "include/vblast_ss/base.h").read_text()
    version = ".".join(re.findall(r"^#define VBSS_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$", base, re.M)) + \
        re.search(r'^#define VBSS_VERSION_SUFFIX "(.*)"$', base, re.M).group(1)  # type: ignore[union-attr]
    for path in (BINDING / "Cargo.lock", *BINDING.glob("*/Cargo.toml")):
        if set(re.findall(r'\bversion = "(\d+\.\d+\..*?)"', path.read_text())) != {version}:
            sys.exit(f"{path.relative_to(ROOT)} is not of version {version}")
    print(f"{len(declared)} functions are declared")


def crates() -> None:
    need_cargo()
    said = run("cargo", "test", "--offline", "--locked")
    print("\n".join(line for line in said.splitlines() if line.startswith("test ")))
    if "warning" in said:
        sys.exit(f"rustc warns:\n{said}")
    found = run("cargo", "run", "--quiet", "--offline", "--locked", "--example", "hash").strip()
    if found != hanging_thread.python_hash():
        sys.exit(f"a hanging thread has the hash {found} in Rust, {hanging_thread.python_hash()} in Python")


def layout() -> None:
    need_cargo()
    run("cargo", "build", "--offline", "--locked", "--package", "vblast-ss-sys")
    rows = []
    for struct in layouts.structs():
        fields = ", ".join(f"std::ptr::addr_of!((*at).{generate.identifier(field.name)}) as usize - at as usize" for field in struct.fields)
        rows.append(f"    let memory = std::mem::MaybeUninit::<{struct.name}>::uninit();\n    let at = memory.as_ptr();\n"
                    f"    let offsets = unsafe {{ [{fields}] }};\n"
                    f'    print!("{struct.name} {{}}", std::mem::size_of::<{struct.name}>());\n'
                    '    offsets.iter().for_each(|offset| print!(" {offset}"));\n    println!();')
    source = work() / "layout.rs"
    source.write_text("use vblast_ss_sys::*;\nfn main() {\n" + "\n".join(rows) + "\n}\n")
    debug = work() / "target/debug"
    run("rustc", "--edition", "2021", source, "--extern", f"vblast_ss_sys={debug / 'libvblast_ss_sys.rlib'}",
        "-L", f"native={environment()['VBLAST_SS_LIB_DIR']}", "-o", work() / "layout_rs")
    layouts.require_equal("Rust", layouts.of_c(os.environ["VBSS_CC"], work()), run(work() / "layout_rs"))


def page() -> None:
    """In a folder that looks like the checkout after the page's build."""
    need_cargo()
    text = (ROOT / "docs/start/rust.md").read_text()
    checkout = work() / "checkout"
    shutil.rmtree(checkout, ignore_errors=True)
    (checkout / "build/release").mkdir(parents=True)
    (checkout / "build/release/lib").symlink_to(environment()["VBLAST_SS_LIB_DIR"])
    (checkout / "bindings").symlink_to(ROOT / "bindings")
    (checkout / "main.rs").write_text(re.findall(r"^```rust\n(.*?)^```", text, re.M | re.S)[0])
    commands = [line for block in re.findall(r"^```sh\n(.*?)^```", text, re.M | re.S) for line in block.splitlines()
                if not line.startswith(("cmake ", "sudo "))]
    said = run("bash", "-euo", "pipefail", "-c", "\n".join(commands), cwd=checkout)
    if not re.search(r"^the last node is at \[.*\]\nVBSS_ERROR_OUT_OF_RANGE: .+$", said, re.M):
        sys.exit(f"the program of docs/start/rust.md said {said}")
    print("\n".join(said.splitlines()[-2:]))


if __name__ == "__main__":
    parts = {"generated": generated, "crates": crates, "layout": layout, "page": page}
    if len(sys.argv) != 2 or sys.argv[1] not in parts:
        sys.exit(__doc__)
    parts[sys.argv[1]]()
