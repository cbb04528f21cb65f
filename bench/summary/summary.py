"""Measures all subjects with their peers, and writes the page, the plot and the README's lines.

    ./bench/run.sh summary [--quick] [--core N] [--no-peers] [--out FOLDER]

With --quick or --out nothing in docs/ or README.md changes: the page goes to the folder, build/bench/summary by default."""
import argparse
import json
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "bench/summary"), str(ROOT / "bench/peers")]
import environments  # noqa: E402
import page  # noqa: E402
import suites  # noqa: E402
from points import SUBJECTS, all_points  # noqa: E402

PEER_LIMIT = 300.0  # s a peer


def build():
    folder = ROOT / "build/release"
    targets = [f"bench_{suite}" for suite in suites.names()] + ["vblast_ss_shared"]
    subprocess.run(["cmake", "--preset", "release"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", str(folder), "--target", *targets], cwd=ROOT, check=True)
    return folder


def measured(python, peer, out, chosen, environment, skipped):
    """The JSON lines of one peer: all up to the time limit."""
    file = out / f"peer-{peer}.jsonl"
    file.unlink(missing_ok=True)
    command = [str(python), "-B", str(ROOT / "bench/peers/measure.py"), peer, "--out", str(file), "--core", str(chosen.core)]
    print(f"summary: {peer}", flush=True)
    try:
        done = subprocess.run(command + ["--quick"] * chosen.quick, env=environment, capture_output=True, text=True,
                              timeout=PEER_LIMIT, check=False)
        if done.returncode != 0:
            skipped.append((peer, environments.plain((done.stderr.strip().splitlines() or ["it failed"])[-1])))
    except subprocess.TimeoutExpired:
        skipped.append((peer, f"its later cases: no time after {PEER_LIMIT:g} s"))
    if not file.exists():
        return []
    return [json.loads(line) for line in file.read_text(encoding="utf-8").splitlines() if line.endswith("}")]


def run_peers(folder, out, chosen, skipped):
    ours = {**os.environ, "VBLAST_SS_LIBRARY": str(folder / "lib"), "PYTHONPATH": str(ROOT / "bindings/python")}
    results = measured("/usr/bin/python3", "ours", out, chosen, ours, skipped)
    for peer, packages in [] if chosen.no_peers else environments.listed():
        python, why = environments.python_of(peer, packages)
        if python is None:
            skipped.append((peer, why))
        else:
            results += measured(python, peer, out, chosen, dict(os.environ), skipped)
    return results


def write(points, skipped, results, context, out, chosen):
    notes = list(dict.fromkeys((r["version"], r["note"]) for r in results if "note" in r))
    kept = chosen.quick or chosen.out is not None
    docs = out if kept else ROOT / "docs/explanation"
    (docs / "speed-against-error.md").write_text(page.page(points, skipped, notes, context, chosen.quick), encoding="utf-8")
    print(docs / "speed-against-error.md")
    if not kept:
        readme = ROOT / "README.md"
        readme.write_text(page.quoted(readme.read_text(encoding="utf-8"), points), encoding="utf-8")
    try:
        import draw  # noqa: PLC0415  (without matplotlib there is no plot)
    except ImportError:
        print("no plot without matplotlib: apt-get install -y python3-matplotlib")
        return
    draw.draw(SUBJECTS, points, str(docs / "speed-against-error"))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="a look, not a measurement")
    parser.add_argument("--core", type=int, default=max(os.sched_getaffinity(0)))
    parser.add_argument("--no-peers", action="store_true", help="without the peers of the package index")
    parser.add_argument("--out", type=pathlib.Path)
    chosen = parser.parse_args()
    out = chosen.out or ROOT / "build/bench/summary"
    out.mkdir(parents=True, exist_ok=True)
    folder = build()
    skipped = []
    entries, context = suites.run(folder / "bench", out, chosen.core, chosen.quick, skipped)
    results = run_peers(folder, out, chosen, skipped)
    failed = [f"{r['subject']}, {r['segments']} segments: {r['failed']}" for r in results if r["peer"] == "ours" and "failed" in r]
    if failed:
        sys.exit("no page is written, as cases of this library failed:\n" + "\n".join(failed))
    points = all_points(entries, results, skipped)
    write(points, skipped, results, context, out, chosen)


if __name__ == "__main__":
    main()
