"""No fused multiply-add anywhere, even when the build allows the processor to have it: a fused
operation rounds once where two instructions round twice, so the bits would depend on the machine.

The library is built by its own CMake rules by gcc and clang, for x86-64-v3 and v4 (AVX-512 has fused
instructions of its own, which -mno-fma leaves) and for three other architectures whose baseline has
them, and every instruction is looked at. Two more sources go in, a quaternion product and a loop that gcc's
vectorisers like best, so that wrong flags show before our own code meets them."""
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
CROSS = {"aarch64": "-march=armv8.3-a", "riscv64": "", "s390x": "-march=z14"}  # z14: vectors of double

# As the product, in a loop: another vectoriser, which armv8.3-a gives complex instructions to fuse.
LOOP = """void vbss_loop(double *restrict c, const double *restrict a, const double *restrict b);
void vbss_loop(double *restrict c, const double *restrict a, const double *restrict b)
{
    for (int i = 0; i < 1024; i += 2) {
        c[i] = a[i] * b[i] - a[i + 1] * b[i + 1];
        c[i + 1] = a[i] * b[i + 1] + a[i + 1] * b[i];
    }
}
"""
PRODUCT = """typedef struct { double w, x, y, z; } q;
void vbss_product(const q *a, const q *b, q *c);
void vbss_product(const q *a, const q *b, q *c)
{
    q r = {a->w * b->w - a->x * b->x - a->y * b->y - a->z * b->z,
           a->w * b->x + a->x * b->w + a->y * b->z - a->z * b->y,
           a->w * b->y - a->x * b->z + a->y * b->w + a->z * b->x,
           a->w * b->z + a->x * b->y - a->y * b->x + a->z * b->w};
    *c = r;
}
"""


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


def archive(build):
    return build / "lib/libvblast_ss.a"


def builds(g):
    """Name, machine, flags and CMake options of everything that is looked at."""
    for compiler in ("gcc", "clang"):
        for level in ("v3", "v4"):
            yield f"{compiler} x86-64-{level}", "x86_64", f"-march=x86-64-{level}", [compiler]
        for machine, flags in CROSS.items():
            name = machine + "-linux-gnu-gcc" if compiler == "gcc" else compiler
            target = [f"-DCMAKE_C_COMPILER_TARGET={machine}-linux-gnu"] if compiler == "clang" else []
            yield f"{compiler} {machine}", machine, flags, [
                name, "-DCMAKE_SYSTEM_NAME=Linux", f"-DCMAKE_SYSTEM_PROCESSOR={machine}", *target]


def with_product(g, folder):
    copy = g.copy_source(folder)
    with open(copy / "lib/base/rotation.c", "a") as source:
        source.write(PRODUCT + LOOP)
    return copy


def look(g):
    complaints, copy = [], with_product(g, "source")
    for name, machine, flags, (compiler, *options) in builds(g):
        build = g.build(name.replace(" ", "-"), f"-DCMAKE_C_COMPILER={g.tool(compiler)}", *options,
                        "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_C_FLAGS={flags}", source=copy,
                        targets=["vblast_ss_static"])
        objdump = "objdump" if machine == "x86_64" else machine + "-linux-gnu-objdump"
        complaints += check(g, f"{name} {flags if machine in name else ''}".strip(), machine, objdump,
                            archive(build))
    return complaints


# ---- canaries: the product, compiled without our flags

def without(machine, compiler, objdump, *flags, text=PRODUCT):
    return lambda g: check(g, machine, machine, objdump, g.compile(
        machine, text, "-std=c11", "-O3", *flags, compiler=compiler))


def library_without(g):
    """The library's own sources, with contraction on after its flags."""
    copy = g.copy_source("contracted")
    with open(copy / "lib/CMakeLists.txt", "a") as rules:
        rules.write("target_compile_options(vbss_numeric INTERFACE -ffp-contract=fast -mfma)\n")
    build = g.build("contracted-build", f"-DCMAKE_C_COMPILER={g.tool('gcc')}", "-DCMAKE_BUILD_TYPE=Release",
                    "-DCMAKE_C_FLAGS=-march=x86-64-v3", source=copy, targets=["vblast_ss_static"])
    return check(g, "contracted library", "x86_64", "objdump", archive(build))


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
             "-ffp-contract=off", "-fno-tree-slp-vectorize", text=LOOP), SEEN + "fcmla"),
    ("clang with contraction",
     without("x86_64", "clang", "objdump", "-march=x86-64-v3", "-ffp-contract=fast"), SEEN + r"vf"),
] + [(f"{machine} with contraction",
      without(machine, f"{machine}-linux-gnu-gcc", f"{machine}-linux-gnu-objdump", "-ffp-contract=fast",
              *flags.split()), SEEN) for machine, flags in CROSS.items()]

if __name__ == "__main__":
    gate.main("fma", look, CANARIES)
