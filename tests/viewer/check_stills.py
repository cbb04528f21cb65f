"""Stills of a session, block by block, against those that were looked at when stills.txt was written:

    check_stills.py <viewer> <log> <folder>

With VBSS_UPDATE_STILLS=1 stills.txt is written instead: look at the stills before it is committed."""
import os
import pathlib
import subprocess
import sys

import blocks

HERE = pathlib.Path(__file__).resolve().parent
WIDTH, HEIGHT = 320, 240


def main():
    viewer, log, folder = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("frame-*.png"):
        old.unlink()
    environment = dict(os.environ, LIBGL_ALWAYS_SOFTWARE="1", GALLIUM_DRIVER="llvmpipe")
    run = subprocess.run([viewer, "--replay", log, "--png", str(folder), "--every", "1.2", "--size",
                          f"{WIDTH}x{HEIGHT}"], env=environment)
    if run.returncode != 0:
        return run.returncode
    found = [blocks.blocks(blocks.read_png(path)) for path in sorted(folder.glob("frame-*.png"))]
    reference = HERE / "stills.txt"
    if os.environ.get("VBSS_UPDATE_STILLS"):
        blocks.write(reference, found)
    complaints = blocks.compare(reference, found)
    for i, still in enumerate(found):
        if still[0] > 3.0 or still[-1] > 3.0:
            complaints.append(f"still {i} is bright outside of the round field")
    print("\n".join(complaints))
    return 1 if complaints else 0


sys.exit(main())
