#!/usr/bin/env python3
"""Makes the archives of a release from a commit: the same bytes each time, on machines with the same compiler.

    pkgconfig/release.py [FOLDER] [--revision REV]     FOLDER: default build/release-archives

    vblast_ss-<version>.tar.gz                      the sources
    vblast_ss-<version>-<system>-<machine>.tar.gz   headers, shared and static library, files for pkg-config and CMake
    SHA256SUMS                                  for sha256sum --check

The working tree does not matter: what is not committed is not in the archives.
"""
import argparse
import gzip
import hashlib
import io
import pathlib
import platform
import re
import subprocess
import sys
import tarfile
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent


def output(*command):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=ROOT)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{(done.stdout + done.stderr).decode(errors='replace')}")
    return done.stdout


def version_of(base):
    numbers = re.findall(r"^#define VBSS_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$", base, re.M)
    return ".".join(numbers) + re.search(r'^#define VBSS_VERSION_SUFFIX "(.*)"$', base, re.M).group(1)


def packed(files):
    """The bytes of a compressed archive without times and names of this machine."""
    return gzip.compress(files, compresslevel=9, mtime=0)


def archive_of(folder, name, time):
    """A tar of everything in a folder, under a name, in one order and as of one time."""
    data = io.BytesIO()
    with tarfile.open(fileobj=data, mode="w", format=tarfile.USTAR_FORMAT) as tar:
        for path in sorted(folder.rglob("*")):
            entry = tar.gettarinfo(path, f"{name}/{path.relative_to(folder)}")
            entry.uid = entry.gid = 0
            entry.uname = entry.gname = "root"
            entry.mtime = time
            entry.mode = 0o755 if path.is_dir() or entry.mode & 0o100 or path.is_symlink() else 0o644
            if entry.isreg():
                with path.open("rb") as content:
                    tar.addfile(entry, content)
            else:
                tar.addfile(entry)
    return data.getvalue()


def build(source, work, revision):
    """The install tree of the sources."""
    output("cmake", "-S", source, "-B", work / "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DVBSS_BUILD_TESTS=OFF",
           "-DVBSS_BUILD_EXAMPLES=OFF", "-DCMAKE_INSTALL_LIBDIR=lib", f"-DVBSS_REVISION={revision}")
    output("cmake", "--build", work / "build")
    output("cmake", "--install", work / "build", "--prefix", work / "stage")
    return work / "stage"


def make(folder, revision):
    commit = output("git", "rev-parse", f"{revision}^{{commit}}").decode().strip()
    time = int(output("git", "show", "--no-patch", "--format=%ct", commit))
    name = "vblast_ss-" + version_of(output("git", "show", f"{commit}:include/vblast_ss/base.h").decode())
    sources = output("git", "-c", "tar.umask=0022", "archive", "--format=tar", f"--prefix={name}/", commit)
    with tempfile.TemporaryDirectory() as place:
        work = pathlib.Path(place)
        with tarfile.open(fileobj=io.BytesIO(sources)) as tar:
            tar.extractall(work)
        stage = build(work / name, work, commit[:12])
        for text in ("LICENSE", "CHANGELOG.md"):
            (stage / text).write_bytes((work / name / text).read_bytes())
        binary = f"{name}-{platform.system().lower()}-{platform.machine()}"
        made = {f"{name}.tar.gz": packed(sources), f"{binary}.tar.gz": packed(archive_of(stage, binary, time))}
    made["SHA256SUMS"] = "".join(f"{hashlib.sha256(made[file]).hexdigest()}  {file}\n" for file in sorted(made)).encode()
    folder.mkdir(parents=True, exist_ok=True)
    for file, content in made.items():
        (folder / file).write_bytes(content)
        print(f"{folder / file}: {len(content)} bytes")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path, nargs="?", default=ROOT / "build/release-archives")
    parser.add_argument("--revision", default="HEAD")
    options = parser.parse_args()
    make(options.folder.resolve(), options.revision)
