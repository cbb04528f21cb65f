#!/usr/bin/env python3
"""Counts how many scripted surgeons complete the task, over seeds that are derived from a commit.

    bench/task/population.py build/release/examples/surgeon/surgeon --of REVISION [--skill expert] [--left] [--count 100]

Seed number i is the first four bytes of SHA-256 of "HASH i", where HASH is the hash of the revision, so the hands cannot have been
fitted to these seeds. Each performance adds a line to build/population/HASH-SKILL.jsonl when it has ended (HASH-SKILL-left.jsonl,
left-handed). A run that was stopped goes on where it was, as long as the program is the same."""
import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SHUT_MM = 0.5  # a slit below this is shut
FAULTS = {1: "first throw not of two wraps", 2: "a later throw not of one", 4: "too few throws", 8: "too many throws",
          16: "granny", 32: "knot in one limb", 64: "half hitch", 128: "order not known", 256: "no stack of throws",
          512: "uncertain"}


def seeds_of(text, count):
    return [int.from_bytes(hashlib.sha256(f"{text} {number}".encode()).digest()[:4], "big") for number in range(count)]


def perform(surgeon, skill, hand, seed):
    """The line of one performance, or one that says how the program ended. hand: further words for the program."""
    with tempfile.TemporaryDirectory() as folder:
        lines = pathlib.Path(folder) / "outcome.jsonl"
        done = subprocess.run([surgeon, "-s", str(seed), "-k", skill, "-j", lines, *hand], stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True)
        if lines.is_file():
            return json.loads(lines.read_text())
        return {"seed": seed, "skill": skill, "good": False, "exit": done.returncode, "said": done.stderr[-500:]}


def read_rows(path, program, seeds):
    """Whole lines of an earlier run of the same program."""
    rows = {}
    for line in path.read_text().splitlines() if path.is_file() else []:
        try:
            row = json.loads(line)
        except json.JSONDecodeError:
            continue  # the run was stopped while it wrote
        if row.get("program") == program and row["seed"] in seeds:
            rows[row["seed"]] = row
    return rows


def digest_of(surgeon):
    """Of the program and of the library that it loads."""
    digest = hashlib.sha256(surgeon.read_bytes())
    listed = subprocess.run(["ldd", surgeon], capture_output=True, text=True).stdout if shutil.which("ldd") else ""
    for library in re.findall(r"libvblast_ss\S* => (\S+)", listed):
        digest.update(pathlib.Path(library).read_bytes())
    return digest.hexdigest()[:12]


def is_done(row):
    return bool(row.get("complete")) and row.get("slit_mm", 1e9) < SHUT_MM


def words_of(row):
    if "exit" in row:
        return f"the program ended with {row['exit']}: {row['said']}"
    words = f"stage {row['stage']}, {row['doing']}, after {row['hands_s']:.1f} s; slit {row['slit_mm']:.2f} mm"
    return words + (f"; {row['why']}" if row["why"] else "")


def spread(values):
    if not values:
        return "none"
    values = sorted(values)
    return f"{statistics.median(values):.4g} ({values[0]:.4g} to {values[-1]:.4g})"


def summarise(rows):
    done = [row for row in rows if is_done(row)]
    print(f"done, slit below {SHUT_MM} mm: {len(done)} of {len(rows)}")
    for row in rows:
        if not is_done(row):
            print(f"    seed {row['seed']}: {words_of(row)}")
    flawless = [row for row in done if row.get("faults") == 0]
    print(f"knot without fault: {len(flawless)} of {len(rows)}")
    for bit, name in FAULTS.items():
        count = sum(1 for row in done if row.get("faults", 0) & bit)
        if count:
            print(f"    {name}: {count}")
    print(f"time, s: {spread([row['time_s'] for row in done])}")
    print(f"slit, mm: {spread([row['slit_mm'] for row in done])}")
    for hand in ("left", "right"):
        print(f"{hand} tool: path, m {spread([row[hand]['path_m'] for row in done])}; "
              f"largest force, N {spread([row[hand]['force_peak_N'] for row in done])}; "
              f"idle share {spread([row[hand]['idle_share'] for row in done])}")
    print(f"drops: {sum(row['drops'] for row in done)}; transfers missed: {sum(row['transfers_missed'] for row in done)}; "
          f"punctures withdrawn: {sum(row['withdrawn'] for row in done)}")
    print(f"left out, s: {spread([row['left_out_s'] for row in done])}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surgeon", type=pathlib.Path, help="the program")
    parser.add_argument("--of", default="HEAD", metavar="REVISION", help="whose hash gives the seeds (HEAD)")
    parser.add_argument("--skill", default="expert", choices=["expert", "resident", "novice"])
    parser.add_argument("--left", action="store_true", help="left-handed ones")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--out", type=pathlib.Path, help="folder for the lines (build/population)")
    chosen = parser.parse_args()
    if not chosen.surgeon.is_file():
        parser.error(f"there is no program {chosen.surgeon}")
    revision = subprocess.run(["git", "rev-parse", chosen.of], cwd=ROOT, capture_output=True, text=True)
    if revision.returncode != 0:
        parser.error(f"there is no revision {chosen.of}")
    text, program = revision.stdout.strip(), digest_of(chosen.surgeon)
    seeds = seeds_of(text, chosen.count)
    folder = chosen.out or ROOT / "build/population"
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"{text[:12]}-{chosen.skill}{'-left' if chosen.left else ''}.jsonl"
    rows = read_rows(path, program, seeds)
    print(f"{chosen.skill}, seeds of {text[:12]}: {len(rows)} of {chosen.count} are there", flush=True)
    with path.open("a") as out, concurrent.futures.ThreadPoolExecutor(chosen.jobs) as pool:
        out.write("\n" if rows else "")  # the last line may have been cut off
        running = {pool.submit(perform, chosen.surgeon.resolve(), chosen.skill, ["--left"] if chosen.left else [], seed)
                   for seed in seeds if seed not in rows}
        for ended in concurrent.futures.as_completed(running):
            row = ended.result() | {"program": program}
            rows[row["seed"]] = row
            out.write(json.dumps(row) + "\n")
            out.flush()
            print(f"{len(rows):4} seed {row['seed']}: " + ("done" if is_done(row) else words_of(row)), flush=True)
    summarise([rows[seed] for seed in seeds if seed in rows])
    sys.exit(0 if all("exit" not in row for row in rows.values()) else 1)


if __name__ == "__main__":
    main()
