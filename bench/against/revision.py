"""Checks out a revision and builds the subjects of the paired bench with it.

Everything lies in build/against/: a folder for each measured revision, named after its commit, and `this` for the working
tree. They stay there for the next run."""
import os
import pathlib
import shutil
import subprocess
import tarfile
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
FOLDER = ROOT / "build/against"
OPTIONS = ["-DCMAKE_BUILD_TYPE=Release", "-DVBSS_BUILD_TESTS=OFF", "-DVBSS_BUILD_EXAMPLES=OFF", "-DVBSS_BUILD_BENCH=OFF",
           "-DVBSS_BUILD_SHARED=OFF", "-DVBSS_INSTALL=OFF",
           # A function of the hands that no subject calls may need what an old library lacks: the linker drops it.
           "-DCMAKE_C_FLAGS=-ffunction-sections", "-DCMAKE_EXE_LINKER_FLAGS=-Wl,--gc-sections"]
# Public names changed here. What is older is measured with the subjects and hands of the commit before.
RENAMED = "2dc5eebac2c2"
LOG_LINES = 20  # of a build that fails


class UnknownRevision(Exception):
    pass


class BuildFailed(Exception):
    pass


def git(*words):
    return subprocess.run(["git", "-C", ROOT, *words], capture_output=True, text=True)


def resolve(name):
    """The commit that a name stands for."""
    found = git("rev-parse", "--verify", "--quiet", "--end-of-options", f"{name}^{{commit}}")
    if found.returncode != 0:
        raise UnknownRevision(f"git knows no commit '{name}' here")
    return found.stdout.strip()


def describe():
    """The name of the working tree."""
    described = git("describe", "--always", "--dirty", "--exclude=*")
    return described.stdout.strip() if described.returncode == 0 else "unknown"


def check_out(commit):
    """The sources of a commit, which an earlier run may have left."""
    source = FOLDER / commit[:12] / "source"
    if source.is_dir():
        return source
    source.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=source.parent) as folder:
        archive = subprocess.Popen(["git", "-C", ROOT, "archive", commit], stdout=subprocess.PIPE)
        with tarfile.open(fileobj=archive.stdout, mode="r|") as files:
            files.extractall(pathlib.Path(folder) / "source")
        if archive.wait() != 0:
            raise BuildFailed(f"git cannot archive {commit}")
        os.rename(pathlib.Path(folder) / "source", source)  # complete, or not there
    return source


def subjects_for(commit):
    """The sources whose bench/against compiles against the public headers of a commit."""
    renamed = resolve(RENAMED)
    has_new_names = git("merge-base", "--is-ancestor", renamed, commit).returncode == 0
    return ROOT if has_new_names else check_out(resolve(renamed + "^"))


def build(source, folder, name, subjects):
    """The program with the subjects of one source tree, built with the library of another."""
    tree, log = folder / "build", folder / "build.log"
    folder.mkdir(parents=True, exist_ok=True)
    inject = subjects / "bench/against/inject.cmake"
    configure = ["cmake", "-S", source, "-B", tree, *OPTIONS, f"-DCMAKE_PROJECT_vblast_ss_INCLUDE={inject}"]
    if shutil.which("ninja") and not (tree / "CMakeCache.txt").is_file():
        configure += ["-G", "Ninja"]
    if shutil.which("ccache"):
        configure += ["-DCMAKE_C_COMPILER_LAUNCHER=ccache"]
    with open(log, "w") as text:
        for command in (configure, ["cmake", "--build", tree, "--target", "against_subjects", "--parallel"]):
            if subprocess.run(command, stdout=text, stderr=subprocess.STDOUT).returncode != 0:
                raise BuildFailed(refusal(name, log))
    return tree / "against/against_subjects"


def refusal(name, log):
    last = log.read_text(errors="replace").splitlines()[-LOG_LINES:]
    return (f"{name} does not build with the subjects in bench/against. They need its public headers and its library.\n"
            f"The whole log is in {log}. Its end:\n" + "\n".join("    " + line for line in last))


def build_this():
    return build(ROOT, FOLDER / "this", "the working tree", ROOT)


def build_other(commit, name):
    source = check_out(commit)
    return build(source, source.parent, name, subjects_for(commit))
