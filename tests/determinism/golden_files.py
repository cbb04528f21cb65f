"""The golden files tests/golden/<scene>.txt: reading, comparing, and that the CHANGELOG knows them.
One "index hash" a line; tests/harness/golden.c writes them (docs/explanation/determinism.md)."""
import hashlib
import pathlib

GOLDEN = pathlib.Path(__file__).resolve().parent.parent / "golden"
CHANGELOG = GOLDEN.parent.parent / "CHANGELOG.md"


def read_golden():
    """Scene -> hashes."""
    return {path.stem: [line.split()[1] for line in path.read_text().splitlines()]
            for path in sorted(GOLDEN.glob("*.txt"))}


def differences(found, golden, brief):
    """One line for each scene that is not as it was, naming the first differing index."""
    complaints = []
    for scene in sorted(set(found) | set(golden)):
        values, wanted = found.get(scene, []), golden.get(scene)
        if wanted is None:
            complaints.append(f"{scene} has no golden file")
            continue
        if not values or (not brief and len(values) != len(wanted)) or len(values) > len(wanted):
            complaints.append(f"{scene}: {len(values)} hashes, the golden file holds {len(wanted)}")
            continue
        first = next((i for i, value in enumerate(values) if value != wanted[i]), None)
        if first is not None:
            complaints.append(f"{scene} at index {first}")
    return complaints


def digest(values):
    return hashlib.sha256("\n".join(values).encode()).hexdigest()[:8]


def unrecorded(golden):
    """Other hashes are other results, which users must hear of: the CHANGELOG knows every scene."""
    lines = CHANGELOG.read_text().splitlines() if CHANGELOG.is_file() else []
    return [f"CHANGELOG.md does not tell of the hashes of {scene}: it needs a line "
            f"'- numerics ...: {scene} {digest(values)}'" for scene, values in golden.items()
            if not any("numerics" in line and f"{scene} {digest(values)}" in line for line in lines)]
