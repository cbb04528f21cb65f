"""Builds packages out of a copy of the sources and tries them.

    packages.py PART --source DIR --work DIR --reference PROGRAM

versions  every recipe names the version of the headers
debian    dpkg-buildpackage makes the packages, lintian finds neither errors nor warnings in them, and what they hold works: a C program
          by pkg-config and one by CMake, the README's Python example, and the scripted surgeon with the hashes of PROGRAM
conan     the conan client, from the Python package index, creates both kinds of package; its test program links and runs

Ends with 77, and says why, where something is not there.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys

HASHES = 2
PARTS_OF_AN_ARCHIVE = ("CMakeLists.txt", "LICENSE", "README.md", "CHANGELOG.md", "include", "lib", "pkgconfig", "bindings")
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


def header_version(source):
    base = (source / "include/vblast_ss/base.h").read_text()
    numbers = re.findall(r"^#define VBSS_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$", base, re.M)
    return ".".join(numbers), re.search(r'^#define VBSS_VERSION_SUFFIX "(.*)"$', base, re.M).group(1)


def sources(options):
    """A copy of what an archive of the sources holds, to build in."""
    folder = options.work / "sources"
    for name in PARTS_OF_AN_ARCHIVE:
        path = options.source / name
        if path.is_dir():
            shutil.copytree(path, folder / name, ignore=shutil.ignore_patterns("__pycache__", "target"))
        else:
            folder.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, folder)
    return folder


def versions(options):
    numbers, suffix = header_version(options.source)
    packaging = options.source / "pkgconfig/packaging"
    wanted = {"debian/changelog": rf"^vblast-ss \({re.escape(numbers + suffix.replace('-', '~'))}-\d+\) ",
              "debian/libvblast-ss1.symbols": rf"^libvblast_ss\.so\.{numbers.split('.')[0]} ",
              "vcpkg/vcpkg.json": rf'"version-semver": "{re.escape(numbers + suffix)}"'}
    wrong = [file for file, pattern in wanted.items() if not re.search(pattern, (packaging / file).read_text(), re.M)]
    if wrong:
        sys.exit(f"not of version {numbers}{suffix}: {', '.join(wrong)}")
    nodes = re.findall(r"^(VBSS_[\d.]+) \{", (options.source / "lib/vblast_ss.map").read_text(), re.M)
    listed = re.findall(r"^ \(symver\)(\S+) ", (packaging / "debian/libvblast-ss1.symbols").read_text(), re.M)
    if nodes != listed:
        sys.exit(f"lib/vblast_ss.map has the versions {nodes}, debian/libvblast-ss1.symbols {listed}")
    print(f"the recipes are of version {numbers}{suffix}")


def debian(options):
    for tool in ("dpkg-buildpackage", "dh", "dh_python3", "lintian"):
        if shutil.which(tool) is None:
            skip(f"{tool} is not there. On Debian: apt-get install dpkg-dev debhelper dh-python lintian")
    folder = sources(options)
    shutil.copytree(folder / "pkgconfig/packaging/debian", folder / "debian")
    run("dpkg-buildpackage", "-us", "-uc", "-b", cwd=folder)
    said = run("lintian", "--fail-on", "error,warning", next(options.work.glob("*.changes")))
    made = sorted(path.name.split("_")[0] for path in options.work.glob("*.deb"))
    if [name for name in made if not name.endswith("-dbgsym")] != ["libvblast-ss-dev", "libvblast-ss1", "python3-vblast-ss"]:
        sys.exit(f"packages {made}")
    root = options.work / "root"
    for package in options.work.glob("*.deb"):
        run("dpkg-deb", "--extract", package, root)
    use_debian(options, root)
    print(f"{', '.join(made)}; lintian: {said.strip() or 'neither errors nor warnings'}")


def use_debian(options, root):
    libraries = next(root.glob("usr/lib/*/libvblast_ss.so")).parent
    environment = {**PLAIN, "LD_LIBRARY_PATH": str(libraries), "PKG_CONFIG_PATH": str(libraries / "pkgconfig")}
    flags = run("pkg-config", "--cflags", "--libs", "vblast_ss", env=environment).split()
    run("cc", options.source / "tests/consumers/host/host.c", *flags, "-o", options.work / "host")
    run(options.work / "host", env=environment)
    run("cmake", "-S", options.source / "tests/consumers/find_package", "-B", options.work / "found", f"-DCMAKE_PREFIX_PATH={root / 'usr'}")
    run("cmake", "--build", options.work / "found")
    for host in ("host_shared", "host_static"):
        run(options.work / "found" / host)
    section = (options.source / "README.md").read_text().split("## From Python")[1].split("\n## ")[0]
    example = re.search(r"^```python\n(.*?)^```", section, re.M | re.S).group(1)
    # Not installed, so the loader's cache does not know the library.
    said = run(sys.executable, "-B", "-c", example, env={**environment, "PYTHONPATH": str(root / "usr/lib/python3/dist-packages"),
                                                         "VBLAST_SS_LIBRARY": str(libraries / "libvblast_ss.so.1")})
    if not said.startswith("tip at"):
        sys.exit(f"the README's example says {said!r}")
    build = options.work / "standalone"
    run("cmake", "-S", options.source / "tests/determinism/standalone", "-B", build, "-DCMAKE_BUILD_TYPE=Release",
        f"-DVBSS_SHARED_LIBRARY={libraries / 'libvblast_ss.so'}")
    run("cmake", "--build", build, "--target", "vbss_performance")
    found, wanted = (run(program, 0, HASHES, env=environment).split() for program in (build / "vbss_performance", options.reference))
    if found != wanted or len(wanted) != 2 * HASHES:
        sys.exit(f"hashes {found}\nwanted {wanted}")


def conan(options):
    python = options.work / "environment/bin/python"
    run(sys.executable, "-m", "venv", options.work / "environment")
    if subprocess.run([python, "-m", "pip", "install", "-q", "conan>=2,<3"], env=PLAIN).returncode != 0:
        skip("the package index cannot be reached")
    folder = sources(options)
    shutil.copytree(folder / "pkgconfig/packaging/conan", folder, dirs_exist_ok=True)
    environment = {**PLAIN, "CONAN_HOME": str(options.work / "home")}
    client = python.with_name("conan")
    run(client, "profile", "detect", env=environment)
    for shared in (False, True):
        said = run(client, "create", folder, "--no-remote", f"--options=vblast_ss/*:shared={shared}", env=environment)
        # The example prints vbss_build_info.
        named = re.search(rf"^.*revision conan {re.escape(''.join(header_version(options.source)))}.*$", said, re.M)
        if named is None:
            sys.exit(f"the test program did not name its library:\n{said[-2000:]}")
        print(f"conan create, shared={shared}: {named[0]}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parts = {"versions": versions, "debian": debian, "conan": conan}
    parser.add_argument("part", choices=parts)
    for name in ("source", "work", "reference"):
        parser.add_argument(f"--{name}", type=pathlib.Path, required=True)
    options = parser.parse_args()
    options.work /= options.part
    shutil.rmtree(options.work, ignore_errors=True)
    options.work.mkdir(parents=True)
    parts[options.part](options)


if __name__ == "__main__":
    main()
