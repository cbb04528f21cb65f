"""Builds a wheel for another platform and tries it, as far as this machine can.

    wheels.py PART PLATFORM --source DIR --work DIR --reference PROGRAM

build        the wheel, by bindings/python/wheels.py, which inspects it
python       pip installs it in a fresh virtual environment, where the README's Python example runs
performance  a C program links the library out of the wheel and performs the scripted surgeon's task: the hashes are those
             of PROGRAM, which this build's own library made. Emulators: qemu, wine, musl's loader
refuse       wheels with a wrong tag or a wrong library are refused
source       pip builds a wheel out of the source distribution, and its library runs the README's example

Ends with 77, and says why, where something is not there.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import zipfile

HASHES = 4
PLAIN = {key: value for key, value in os.environ.items() if key not in ("PYTHONPATH", "VBLAST_SS_LIBRARY")}


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(77)


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          **{"env": PLAIN, "timeout": 1500, **options})
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))} (exit code {done.returncode})\n{done.stdout[-4000:]}")
    return done.stdout


def need(tool, package):
    path = shutil.which(tool)
    if path is None:
        skip(f"{tool} is not there. On Debian: apt-get install {package}")
    return path


class Trial:
    def __init__(self, options):
        self.source, self.reference, self.name = options.source, options.reference, options.platform
        self.work = options.work / f"{options.part}-{options.platform}"
        self.dist = options.work / "dist"
        sys.path.insert(0, str(self.source / "bindings/python"))
        import wheels
        self.wheels, self.platform = wheels, wheels.PLATFORMS[options.platform]
        shutil.rmtree(self.work, ignore_errors=True)
        self.work.mkdir(parents=True)

    def build(self):
        for older in self.dist.glob(f"*-{self.platform.tags}.whl"):
            older.unlink()
        done = subprocess.run([sys.executable, "-B", self.source / "bindings/python/wheels.py", self.dist, "--only", self.name],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if self.wheels.NO_INDEX in done.stdout:
            skip(self.wheels.NO_INDEX)
        print(done.stdout)
        sys.exit(done.returncode)

    def wheel(self):
        found = list(self.dist.glob(f"*-{self.platform.tags}.whl"))
        if not found:
            skip(f"no wheel for {self.name} was built")
        return found[0]

    def library(self):
        with zipfile.ZipFile(self.wheel()) as archive:
            path = self.work / self.platform.library
            path.write_bytes(archive.read(f"vblast_ss/lib/{self.platform.library}"))
        return path

    def environment(self):
        run(sys.executable, "-m", "venv", self.work / "environment")
        return self.work / "environment/bin/python"

    def try_readme(self, python):
        section = (self.source / "README.md").read_text().split("## From Python")[1].split("\n## ")[0]
        example = re.search(r"^```python\n(.*?)^```", section, re.M | re.S).group(1)
        where = "\nimport sys; assert vb.library_path.startswith(sys.prefix), vb.library_path\n"
        said = run(python, "-c", example + where, cwd=self.work)
        if not said.startswith("tip at"):
            sys.exit(f"the README's example says {said!r}")
        print(said.strip())

    def python(self):
        python = self.environment()
        run(python, "-m", "pip", "install", "--no-index", "--no-deps", self.wheel())
        self.try_readme(python)

    def source_distribution(self):
        run(sys.executable, "-B", "-c", f"import backend; backend.build_sdist(r'{self.work}')",
            cwd=self.source / "bindings/python")
        archive, python = next(self.work.glob("*.tar.gz")), self.environment()
        # Neither CMake nor Ninja of the system: both come from the index.
        empty = self.work / "path"
        empty.mkdir()
        for tool in ("cc", "gcc", "as", "ld", "ar", "ranlib", "nm", "objdump", "objcopy", "readelf", "strip", "uname", "sh"):
            if path := shutil.which(tool):
                (empty / tool).symlink_to(path)
        done = subprocess.run([python, "-m", "pip", "install", "--no-deps", archive], text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, env={**PLAIN, "PATH": str(empty), "CMAKE_BUILD_PARALLEL_LEVEL": "2"})
        if done.returncode != 0 and "No matching distribution found for" in done.stdout:
            skip("CMake cannot be had from the package index")
        if done.returncode != 0:
            sys.exit(done.stdout[-4000:])
        self.try_readme(python)

    def runner(self):
        """What runs a program of the platform, and its environment."""
        if self.platform.system == "Windows":
            need("wine", "wine wine64")
            return ["wine"], {**PLAIN, "WINEPREFIX": str(self.work / "wine"), "WINEDEBUG": "-all"}
        if self.name.startswith("musllinux"):
            loader = pathlib.Path(f"/lib/ld-musl-{self.platform.processor}.so.1")
            if not loader.exists():
                skip(f"{loader} is not there. On Debian: apt-get install musl")
            return [loader], {**PLAIN, "LD_LIBRARY_PATH": str(self.work)}
        if self.platform.processor == "aarch64":
            emulator, root = need("qemu-aarch64", "qemu-user"), pathlib.Path("/usr/aarch64-linux-gnu")
            if not root.is_dir():
                skip("no C library for aarch64. On Debian: apt-get install libc6-dev-arm64-cross")
            return [emulator, "-L", root, "-E", f"LD_LIBRARY_PATH={self.work}"], PLAIN
        return [], {**PLAIN, "LD_LIBRARY_PATH": str(self.work)}

    def performance(self):
        library = self.library()
        runner, environment = self.runner()
        build = self.work / "build"
        run("cmake", "-S", self.source / "tests/determinism/standalone", "-B", build, "-G", "Ninja",
            *self.wheels.configured(self.name), f"-DVBSS_SHARED_LIBRARY={library}")
        run("cmake", "--build", build, "--target", "vbss_performance")
        program = build / ("vbss_performance.exe" if self.platform.system == "Windows" else "vbss_performance")
        if self.platform.system == "Windows":
            shutil.copy(library, build)
        found = run(*runner, program, 0, HASHES, env=environment).split()
        wanted = run(self.reference, 0, HASHES).split()
        if found != wanted or len(wanted) != 2 * HASHES:
            sys.exit(f"hashes {found}\nwanted {wanted}")
        print(f"{HASHES} hashes equal those of this build: {' '.join(found[1::2])}")

    def refuse(self):
        wheel, inspect = self.wheel(), self.wheels.inspect_wheel
        tools = self.wheels.tools()
        inspect.inspect(wheel, tools)
        for tag in ("manylinux_2_5_x86_64", "manylinux_2_17_aarch64", "musllinux_1_2_x86_64", "win_amd64", "macosx_11_0_arm64"):
            bad = self.work / wheel.name.replace(self.platform.tags, tag)
            with zipfile.ZipFile(wheel) as good, zipfile.ZipFile(bad, "w") as archive:
                for name in good.namelist():
                    data = good.read(name)
                    if name.endswith("WHEEL"):
                        data = re.sub(rb"(Tag: .*\n)+", f"Tag: py3-none-{tag}\n".encode(), data)
                    archive.writestr(name, data)
            try:
                found = inspect.inspect(bad, tools)
            except inspect.Wrong as wrong:
                print(f"{tag}: refused: {str(wrong)[:100]}")
                continue
            sys.exit(f"{bad.name} is accepted: {found}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("part", choices=("build", "python", "performance", "refuse", "source"))
    parser.add_argument("platform")
    for name in ("source", "work", "reference"):
        parser.add_argument(f"--{name}", type=pathlib.Path, required=True)
    options = parser.parse_args()
    trial = Trial(options)
    {"build": trial.build, "python": trial.python, "performance": trial.performance, "refuse": trial.refuse,
     "source": trial.source_distribution}[options.part]()


if __name__ == "__main__":
    main()
