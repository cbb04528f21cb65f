"""No fused multiply-add anywhere, even when the build allows the processor to have it: a fused
operation rounds once where two instructions round twice, so the bits would depend on the machine.

The tests determinism.matrix.<row> build the library by its own CMake rules by gcc and clang, for x86-64-v3 and v4
(AVX-512 has fused instructions of its own, which -mno-fma leaves) and for three other architectures whose baseline
has them. This gate looks at every instruction of the row that is its part, and at fusible.c, the code that compilers
fuse first, so that wrong flags show before our own code meets them."""
import re

import gate

FUSED = {
    "x86_64": r"vfn?m(add|sub|addsub|subadd)\w*",
    "aarch64": r"fn?m(add|sub)|fml[as]\w*|fcmla",
    "riscv64": r"fn?m(add|sub)\.[sdqh]|vfn?m(add|acc|sub|sac)\.\w+",
    "s390x": r"m[as][de]b?r?|[vw]fn?m[as](?!x)\w*", # not vfmaxdb, the larger of two
}
# Seen in any numeric object: without them the gate looks at nothing, or cannot read it.
PLAIN = {"x86_64": r"v?mul[sp]d", "aarch64": r"fmul", "riscv64": r"fmul\.d", "s390x": r"mdbr?|[vw]fmdb"}
OTHERS = {"aarch64": "-march=armv8.3-a", "riscv64": "", "s390x": "-march=z14"}  # z14: vectors of double


def check(g, what, machine, objdump, *files):
    fused, plain, function = {}, 0, ""
    output = g.run(g.tool(objdump), "-d", "--no-show-raw-insn", *files)
    for line in output.splitlines():
        title = re.match(r"[0-9a-f]+ <([^>]+)>:", line)
        if title:
            function = title.group(1)
        row = re.match(r"\s+[0-9a-f]+:\s+(\S+)", line)
        if row and re.fullmatch(FUSED[machine], row.group(1)):
            fused.setdefault((function, row.group(1)), 0)
            fused[function, row.group(1)] += 1
        plain += bool(row and re.fullmatch(PLAIN[machine], row.group(1)))
    if fused:
        (function, instruction), _ = next(iter(fused.items()))
        return [f"{what}: {sum(fused.values())} fused instructions, such as {instruction} in {function}"]
    if plain == 0:
        return [f"{what}: not one multiplication found, so this gate sees nothing"]
    g.notes.append(f"{what}: {plain} products")
    return []


def inspect(g):
    machine = g.part.removesuffix("-clang")
    if machine in OTHERS:
        return check_row(g, g.part, machine, machine + "-linux-gnu-objdump")
    return check_row(g, g.part, "x86_64", "objdump")


def check_row(g, row, machine, objdump):
    build = g.row(row)
    fusible = list(build.rglob("fusible.c.o"))
    if len(fusible) != 1:
        raise gate.Problem(f"{row} has not one object of what compilers like best to fuse, but {len(fusible)}")
    return check(g, row, machine, objdump, build / "vblast_ss/lib/libvblast_ss.a", *fusible)


# ---- canaries: the product, compiled without our flags

def without(machine, compiler, objdump, *flags):
    return lambda g: check(g, machine, machine, objdump, g.compile(
        machine, (g.source / "tests/determinism/standalone/fusible.c").read_text(), "-std=c11", "-O3", *flags,
        compiler=compiler))


def library_without(g):
    """Sources of the library's own, with contraction on after its flags."""
    copy = g.copy_base("contracted")
    with open(copy / "lib/CMakeLists.txt", "a") as rules:
        rules.write("target_compile_options(vbss_numeric INTERFACE -ffp-contract=fast -mfma)\n")
    build = g.build("contracted-build", f"-DCMAKE_C_COMPILER={g.tool('gcc')}", "-DCMAKE_BUILD_TYPE=Release",
                    "-DCMAKE_C_FLAGS=-march=x86-64-v3", source=copy, targets=["vblast_ss_static"])
    return check(g, "contracted library", "x86_64", "objdump", build / "lib/libvblast_ss.a")


SEEN = r"\d+ fused instructions, such as "
CANARIES = [
    ("the library with contraction", library_without, SEEN + r"vf"),
    ("gcc's vectoriser, although -ffp-contract=off",
     without("x86_64", "gcc", "objdump", "-march=x86-64-v3", "-ffp-contract=off"),
     SEEN + r"vfm(addsub|subadd)"),
    ("gcc's vectoriser on AVX-512, although -mno-fma",
     without("x86_64", "gcc", "objdump", "-march=x86-64-v4", "-ffp-contract=off", "-mno-fma"),
     SEEN + r"vfm(addsub|subadd)"),
    ("gcc's loop vectoriser on armv8.3-a, although -fno-tree-slp-vectorize",
     without("aarch64", "aarch64-linux-gnu-gcc", "aarch64-linux-gnu-objdump", "-march=armv8.3-a",
             "-ffp-contract=off", "-fno-tree-slp-vectorize"), SEEN + "fcmla"),
    ("clang with contraction",
     without("x86_64", "clang", "objdump", "-march=x86-64-v3", "-ffp-contract=fast"), SEEN + r"vf"),
] + [(f"{machine} with contraction",
      without(machine, f"{machine}-linux-gnu-gcc", f"{machine}-linux-gnu-objdump", "-ffp-contract=fast",
              *flags.split()), SEEN) for machine, flags in OTHERS.items()]

if __name__ == "__main__":
    gate.main("fma", inspect, CANARIES)
