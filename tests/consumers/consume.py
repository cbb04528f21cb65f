"""Builds and runs a consumer of the library the way a stranger would.

    consume.py KIND --build DIR --source DIR --work DIR [--plan]

The library is installed into a fresh prefix that is then moved elsewhere, so that nothing can depend
on where it was built or installed. KIND is a folder beside this script. Every consumer makes
host_shared and host_static, and both must run; with --plan they are only configured, and the build is
planned to its end: each of its sources is there, each command is known. KIND static_only first builds the static library
alone, and makes host_default in place of host_shared.
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


# The library as a part of the host's build; both kinds share a host.
AS_A_PART = ("add_subdirectory", "fetch_content")


def configure(kind, work, prefix, source, build_type):
    folder = "add_subdirectory" if kind in AS_A_PART else kind
    run("cmake", "-G", "Ninja", "-S", HERE / folder, "-B", work / "build", f"-DCMAKE_PREFIX_PATH={prefix}",
        f"-DVBSS_SOURCE={source}", f"-DCMAKE_BUILD_TYPE={build_type}",
        f"-DHOST_BUILD_TYPE={build_type}", f"-DHOST_FETCHES={kind == 'fetch_content'}")
    return work / "build"


def build_static_only(source, work, only_plan):
    """The build folder of a library without the shared one."""
    build = work / "library"
    run("cmake", "-G", "Ninja", "-S", source, "-B", build, "-DVBSS_BUILD_SHARED=OFF", "-DVBSS_BUILD_TESTS=OFF",
        "-DVBSS_BUILD_EXAMPLES=OFF", "-DCMAKE_BUILD_TYPE=Release")
    planned = run("ninja", "-C", build, "-n", "-v")
    if "libvblast_ss.a" not in planned or "libvblast_ss.so" in planned:
        sys.exit(f"not the static library alone is planned:\n{planned}")
    if not only_plan:
        run("cmake", "--build", build, "-j", "2")
    return build


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
    parser.add_argument("--plan", action="store_true")
    options = parser.parse_args()

    shutil.rmtree(options.work, ignore_errors=True)
    options.work.mkdir(parents=True)
    prefix = None
    hosts = ("host_shared", "host_static")
    if options.kind == "static_only":
        hosts = ("host_default", "host_static")
        options.build = build_static_only(options.source, options.work, options.plan)
        if options.plan:
            print("consumer static_only: configured, and the build of the static library alone planned to its end")
            return
    if options.kind not in AS_A_PART:
        prefix = install_and_move(options.build, options.work)
        if options.kind == "static_only" and list(prefix.rglob("*.so*")):
            sys.exit("a shared library is installed")
    if options.kind == "pkg_config":
        made = with_make(options.work, prefix)
    else:
        # A host without a build type must keep none.
        build_type = "" if options.kind in AS_A_PART else "Release"
        made = configure(options.kind, options.work, prefix, options.source, build_type)
        if options.plan:
            planned = run("ninja", "-C", made, "-n", "-v", "host_shared", "host_static")
            for product in ("libvblast_ss.so", "libvblast_ss.a", "-o host_shared", "-o host_static"):
                if product not in planned:
                    sys.exit(f"{product} is not planned:\n{planned}")
            print(f"consumer {options.kind}: configured, and its build planned to the end")
            return
        run("cmake", "--build", made)
    for host in hosts:
        run(made / host)
        linked = run("readelf", "-d", made / host)
        if ("libvblast_ss.so" in linked) != (host == "host_shared"):
            sys.exit(f"{host} is not linked as its name says:\n{linked}")
    print(f"consumer {options.kind}: {' and '.join(hosts)} built and run")


if __name__ == "__main__":
    main()
