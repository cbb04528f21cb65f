"""The archives of a release are the same bytes twice, their checksums are right, and a stranger builds against what is in
them, through pkg-config and through CMake.

    release.py --source DIR --work DIR
"""
import argparse
import hashlib
import pathlib
import shutil
import sys
import tarfile

import consume


def make(source, folder):
    consume.run(sys.executable, "-B", source / "pkgconfig/release.py", folder, cwd=source)
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def check_sums(made):
    listed = dict(reversed(line.split("  ")) for line in made["SHA256SUMS"].decode().splitlines())
    found = {name: hashlib.sha256(content).hexdigest() for name, content in made.items() if name != "SHA256SUMS"}
    if listed != found:
        sys.exit(f"SHA256SUMS has {listed}, and the archives are {found}")


def unpack(path, work):
    with tarfile.open(path) as archive:
        archive.extractall(work)
    return work / path.name.removesuffix(".tar.gz")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--source", type=pathlib.Path, required=True)
    parser.add_argument("--work", type=pathlib.Path, required=True)
    options = parser.parse_args()
    shutil.rmtree(options.work, ignore_errors=True)
    options.work.mkdir(parents=True)
    first, second = (make(options.source, options.work / name) for name in ("first", "second"))
    different = [name for name in sorted(first | second) if first.get(name) != second.get(name)]
    if different or len(first) != 3:
        sys.exit(f"made twice, these differ: {different} of {sorted(first)}")
    check_sums(first)
    sources, binaries = sorted((name for name in first if name != "SHA256SUMS"), key=len)
    if not (unpack(options.work / "first" / sources, options.work) / "lib/vblast_ss.map").is_file():
        sys.exit(f"{sources} does not hold the sources")
    prefix = unpack(options.work / "first" / binaries, options.work)
    for kind in ("pkg_config", "find_package"):
        work = options.work / kind
        work.mkdir()
        if kind == "pkg_config":
            built = consume.with_make(work, prefix)
        else:
            built = consume.configure(kind, work, prefix, options.source, "Release")
            consume.run("cmake", "--build", built)
        for host in ("host_shared", "host_static"):
            consume.run(built / host)
    print(f"release: {', '.join(sorted(first))}")


if __name__ == "__main__":
    main()
