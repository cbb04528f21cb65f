"""Ties thousands of single throws with other parameters each, over processes or machines, into a table.

    python3 bindings/python/examples/sweep_throws.py [--sessions 1000] [--workers 2] [--out throws.csv]
        [--seconds S] [--scheduler ADDRESS]

Each session is an episode of vblast_ss.environment, at most 5 s simulated, by the scripted hands: friction, bending
stiffness, tremor and the hands' speed are drawn by the session's number. A row is written as soon as a session has ended,
whatever came of it, and a table that is there already is gone on with. --seconds ends the sweep early; --scheduler
takes the workers of a dask cluster on other machines in place of processes here; they need the same package and library."""
import argparse
import contextlib
import csv
import itertools
import os
import pathlib
import sys
import time

try:
    import dask.distributed
except ImportError:
    sys.exit("This example needs dask.distributed: sudo apt-get install python3-dask python3-distributed")

import numpy as np

PARAMETERS = {  # name: least, most
    "friction": (0.05, 0.3), "bending_stiffness": (0.5e-8, 2e-8), "tremor": (0.0, 0.5e-3), "speed": (0.12, 0.22)}
OUTCOME = ["status", "tied", "notation", "wraps", "time", "score", "total_reward", "pull", "path_w", "path_c", "steps",
           "seconds", "error"]


def session(number):
    """One episode, from its parameters to a row."""
    from vblast_ss.environment import ScriptedThrow, ThrowEnvironment, run
    random = np.random.default_rng(number)
    drawn = {name: float(random.uniform(*bounds)) for name, bounds in PARAMETERS.items()}
    begun = time.process_time()
    hands = ScriptedThrow(speed=drawn["speed"])
    options = {name: value for name, value in drawn.items() if name != "speed"}
    row = {"session": number, **drawn, "tied": 0}
    try:
        with ThrowEnvironment(time_limit=5.0) as environment:
            row.update(run(environment, hands, seed=number, options=options)._asdict())
    except Exception as error:  # a session that fails is a row like others
        row["error"] = f"{type(error).__name__}: {error}"
    return {**row, "tied": int(row["tied"]), "seconds": time.process_time() - begun,
            "status": "error" if row["error"] else "report"}


def rows_of(path):
    """Whole rows of a table that was begun; one that was cut off is as if it were not there."""
    if not path.exists():
        return []
    with path.open(newline="") as file:
        return [row for row in csv.DictReader(file) if row["error"] is not None]


def sweep(path, wanted, client, seconds):
    columns = ["session", *PARAMETERS, *OUTCOME]
    rows = rows_of(path)
    with path.open("w", newline="") as file:
        writer = csv.DictWriter(file, columns)
        writer.writeheader()
        writer.writerows(rows)
        file.flush()
        missing = iter(sorted(set(range(wanted)) - {int(row["session"]) for row in rows}))
        begun = time.monotonic()
        room = 2 * sum(client.nthreads().values())  # no more is sent out than is soon begun
        queue = dask.distributed.as_completed()
        for number in itertools.islice(missing, room):
            queue.add(client.submit(session, number, pure=False))
        for future in queue:
            row = future.result()
            writer.writerow(row)
            file.flush()
            rows.append(row)
            if time.monotonic() - begun < seconds:
                for number in itertools.islice(missing, 1):
                    queue.add(client.submit(session, number, pure=False))
    return rows


def account(rows, wanted, wall):
    print(f"{len(rows)} sessions in the table, {max(0, wanted - len(rows))} of {wanted} are missing; "
          f"{sum(row['status'] == 'report' for row in rows)} ended with a report, "
          f"{sum(row['status'] != 'report' for row in rows)} with an error; {wall:.0f} s by the clock for this run")
    if not rows:
        return
    steps, seconds = (sum(float(row.get(name) or 0) for row in rows) for name in ("steps", "seconds"))
    print(f"a session: {seconds / len(rows):.2f} s of processor time, {steps / len(rows):.0f} steps; "
          f"a step: {1e6 * seconds / max(steps, 1):.0f} us")
    print(f"tied: {sum(int(row['tied']) for row in rows)}")
    for name, (low, high) in PARAMETERS.items():
        middle = 0.5 * (low + high)
        shares = []
        for part in ([row for row in rows if float(row[name]) < middle],
                     [row for row in rows if float(row[name]) >= middle]):
            shares.append(f"{sum(int(row['tied']) for row in part)} of {len(part)}")
        print(f"    {name:18} below {middle:.3g}: {shares[0]:>12}   above: {shares[1]:>12}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sessions", type=int, default=1000)
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("throws.csv"))
    parser.add_argument("--seconds", type=float, default=float("inf"))
    parser.add_argument("--scheduler")
    chosen = parser.parse_args()
    begun = time.monotonic()
    if chosen.scheduler:
        cluster = contextlib.nullcontext(chosen.scheduler)
    else:
        cluster = dask.distributed.LocalCluster(n_workers=chosen.workers, threads_per_worker=1, processes=True,
                                                dashboard_address=None)
    with cluster as there, dask.distributed.Client(there) as client:
        rows = sweep(chosen.out, chosen.sessions, client, chosen.seconds)
    account(rows, chosen.sessions, time.monotonic() - begun)
    return 1 if any(row["status"] != "report" for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
