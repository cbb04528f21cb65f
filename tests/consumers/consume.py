"""Builds and runs a consumer of the library the way a stranger would.

    consume.py KIND --build DIR --source DIR --work DIR

The library is installed into a fresh prefix that is then moved elsewhere, so that nothing can depend
on where it was built or installed. KIND is a folder beside this script. Every consumer makes
host_shared and host_static, and both must run.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent


def run(*command, **options):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


def install_and_move(build, work):
    first, moved = work / "first prefix", work / "moved prefix"
    run("cmake", "--install", build, "--prefix", first)
    first.rename(moved)
    return moved


def with_cmake(kind, work, prefix, source, build_type):
    run("cmake", "-G", "Ninja", "-S", HERE / kind, "-B", work / "build", f"-DCMAKE_PREFIX_PATH={prefix}",
        f"-DVBSS_SOURCE={source}", f"-DCMAKE_BUILD_TYPE={build_type}",
        f"-DHOST_BUILD_TYPE={build_type}")
    run("cmake", "--build", work / "build")
    return work / "build"


def with_make(work, prefix):
    # Side by side and by plain names: make cannot have spaces in a path.
    out = work / "build"
    out.mkdir()
    shutil.copy(HERE / "pkg_config" / "Makefile", out)
    shutil.copy(HERE / "host" / "host.c", out)
    folder = next(prefix.rglob("vblast_ss.pc")).parent
    run("make", cwd=out, env=dict(os.environ, PKG_CONFIG_PATH=str(folder)))
    return out


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("kind")
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--source", type=pathlib.Path, required=True)
    parser.add_argument("--work", type=pathlib.Path, required=True)
    options = parser.parse_args()

    shutil.rmtree(options.work, ignore_errors=True)
    options.work.mkdir(parents=True)
    prefix = None
    if options.kind != "add_subdirectory":
        prefix = install_and_move(options.build, options.work)
    if options.kind == "pkg_config":
        made = with_make(options.work, prefix)
    else:
        # A host without a build type must keep none.
        build_type = "" if options.kind == "add_subdirectory" else "Release"
        made = with_cmake(options.kind, options.work, prefix, options.source, build_type)
    for host in ("host_shared", "host_static"):
        run(made / host)
        linked = run("readelf", "-d", made / host)
        if ("libvblast_ss.so" in linked) != (host == "host_shared"):
            sys.exit(f"{host} is not linked as its name says:\n{linked}")
    print(f"consumer {options.kind}: host_shared and host_static built and run")


if __name__ == "__main__":
    main()
