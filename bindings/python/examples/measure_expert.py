"""Counts how many throws the scripted hands tie, over seeds derived from a hash.

    python3 bindings/python/examples/measure_expert.py --seeds-of TEXT [--count 100] [--out expert.csv]

The seeds are the first four bytes of SHA-256 of "TEXT 0", "TEXT 1" and so on; with the hash of the commit that is measured as TEXT,
the hands cannot have been fitted to them. A row is written as soon as an episode has ended, and a table that is there already is
continued."""
import argparse
import csv
import hashlib
import pathlib
import time

from vblast_ss.environment import ScriptedThrow, ThrowEnvironment, run

COLUMNS = ["seed", "tied", "notation", "time", "pull", "phase", "error", "seconds"]


def seeds_of(text, count):
    return [int.from_bytes(hashlib.sha256(f"{text} {number}".encode()).digest()[:4], "big") for number in range(count)]


def episode(seed):
    hands, begun = ScriptedThrow(), time.process_time()
    with ThrowEnvironment() as environment:
        outcome = run(environment, hands, seed=seed)
    return {"seed": seed, "tied": int(outcome.tied), "notation": outcome.notation, "time": f"{outcome.time:.3f}",
            "pull": f"{outcome.pull:.3f}", "phase": hands.phase, "error": outcome.error,
            "seconds": f"{time.process_time() - begun:.2f}"}


def rows_of(path):
    """Whole rows of a table that was begun."""
    if not path.exists():
        return []
    with path.open(newline="") as file:
        return [row for row in csv.DictReader(file) if row["seconds"] is not None]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds-of", required=True, metavar="TEXT")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("expert.csv"))
    chosen = parser.parse_args()
    wanted = seeds_of(chosen.seeds_of, chosen.count)
    rows = [row for row in rows_of(chosen.out) if int(row["seed"]) in wanted]
    done = {int(row["seed"]) for row in rows}
    with chosen.out.open("w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS)
        writer.writeheader()
        writer.writerows(rows)
        file.flush()
        for seed in wanted:
            if seed not in done:
                rows.append(episode(seed))
                writer.writerow(rows[-1])
                file.flush()
    times = sorted(float(row["time"]) for row in rows if int(row["tied"]))
    print(f"tied: {len(times)} of {len(rows)}" + (f", after {times[0]:.2f} to {times[-1]:.2f} s" if times else ""))
    for row in rows:
        if not int(row["tied"]):
            print(f"    seed {row['seed']}: not tied, in phase {row['phase']} {row['error']}")


if __name__ == "__main__":
    main()
