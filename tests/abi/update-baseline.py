#!/usr/bin/env python3
"""Takes today's public interface as the new baseline: the ABI dump and the layout file.

    tests/abi/update-baseline.py <build folder>     such as build/default

Then add the printed line to CHANGELOG.md, with what changed; until its sha256 stands there the gate
`abi` fails. When this is right, and when it is not: docs/reference/abi.md."""
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "gates"))
import abi   # noqa: E402
import gate  # noqa: E402

if len(sys.argv) != 2:
    sys.exit(__doc__)
try:
    print(abi.update(gate.Gate("abi.update", pathlib.Path(sys.argv[1]) / "tests/gates/gates.json", False)))
except (gate.Problem, OSError) as problem:
    sys.exit(f"no new baseline: {problem}")
