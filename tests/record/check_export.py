#!/usr/bin/env python3
"""What vbss-log prints of whole, cut and damaged logs: complete, readable, with the numbers to the bit.

    check_export.py VBSS_LOG WRITE_SEEDS
"""
import csv
import io
import json
import pathlib
import subprocess
import sys
import tempfile

TOOL, WRITER = sys.argv[1:3]


def run(command, path, wanted):
    done = subprocess.run([TOOL, command, path], capture_output=True, text=True)
    if done.returncode != wanted:
        sys.exit(f"{command} {path}: exit {done.returncode}, not {wanted}: {done.stderr}")
    return done.stdout


def check_tables(path, wanted):
    """The same steps, inputs and events as CSV and as JSON; the JSON."""
    document = json.loads(run("json", path, wanted))
    rows = list(csv.DictReader(io.StringIO(run("csv", path, wanted))))
    steps = document["steps"]
    by = {name: [r for r in rows if r["row"] == name] for name in ("step", "input", "event")}
    assert len(by["step"]) == len(steps) > 0
    assert len(by["input"]) == sum(len(s["inputs"]) for s in steps) > 0
    assert len(by["event"]) == sum(len(s["events"]) for s in steps)
    for row, step in zip(by["step"], steps):
        assert int(row["step"]) == step["step"] and row["hash"] == step["hash"]
        assert float(row["time_s"]) == step["time_s"] and float(row["number_0"]) == step["h_s"]
    for row, entry in zip(by["input"], [i for s in steps for i in s["inputs"]]):
        numbers = [float(row[f"number_{k}"]) for k in range(len(entry["numbers"]))]
        words = [int(row[f"word_{k}"]) for k in range(len(entry["words"]))]
        assert (row["kind"], words, numbers) == (entry["kind"], entry["words"], entry["numbers"])
    for row, event in zip(by["event"], [e for s in steps for e in s["events"]]):
        words = [int(row[f"word_{k}"]) for k in range(3)]
        assert (row["kind"], words) == (event["kind"], event["bodies"] + [event["number"]])
    return document


def main():
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([WRITER, folder, "log"], check=True)
        seed = (pathlib.Path(folder) / "log-29-0").read_bytes()[1:]  # behind the fuzzer's own byte
        log = pathlib.Path(folder) / "whole.vbss"
        log.write_bytes(seed)
        whole = check_tables(log, 0)
        assert whole["result"] == "VBSS_OK" and whole["log_bytes"] == len(seed)
        kinds = {i["kind"] for s in whole["steps"] for i in s["inputs"]}
        assert {"move_grasper", "set_opening", "pin", "exchange", "cut"} <= kinds, kinds
        assert any(s["events"] for s in whole["steps"])
        assert f"{len(whole['steps'])} steps" in run("info", log, 0)
        assert run("validate", log, 0).startswith("0 faults")

        log.write_bytes(seed[:-100])
        cut = check_tables(log, 1)
        assert cut["result"] == "VBSS_ERROR_TRUNCATED"
        assert cut["steps"] == whole["steps"][:len(cut["steps"])]
        assert "VBSS_ERROR_TRUNCATED" in run("validate", log, 1)

        bad = bytearray(seed)
        bad[-200] ^= 1
        log.write_bytes(bad)
        assert "checksum" in run("validate", log, 1)
        check_tables(log, 1)

        log.write_bytes(b"no log")
        for command in ("info", "validate", "csv", "json"):
            run(command, log, 1)
        run("info", log.with_suffix(".missing"), 2)


if __name__ == "__main__":
    main()
