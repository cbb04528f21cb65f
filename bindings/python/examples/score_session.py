"""Scores a recorded session.

    python3 bindings/python/examples/score_session.py [session.vbss] [--plots folder] [--hdf5 file]

The log is replayed into a scene like the recorded one, its hashes are compared, and the metrics are told where the tools
were, what they bore, and which throws were tied. Without a file a throw is tied here and recorded first. A log of the whole
task (drive_needle.py --log) is played back with its session, which tells its metrics all of it."""
import argparse
import json
import pathlib

import vblast_ss as vb
from vblast_ss import analysis, suturing
from vblast_ss.environment import ScriptedThrow, ThrowEnvironment, run

W, C = 2, 3  # the bodies of the tools in the scene of a throw
NAMES = {1: "thread", W: "tool W", C: "tool C"}
TASK_NAMES = {3: "thread", 4: "right tool", 5: "left tool"}


def record(seed=3):
    with ThrowEnvironment(record=True) as environment:
        outcome = run(environment, ScriptedThrow(), seed=seed)
        print(f"recorded: {outcome.steps} steps, {'tied' if outcome.tied else 'nothing tied'}")
        return environment.take_log()


def tell(metrics, names):
    report = metrics.report
    print(f"score so far {report.score:.2f}, {report.throw_count} throws, {report.time:.2f} s")
    for penalty in metrics.penalties:
        print(f"    {penalty.amount:.2f} points: {penalty.text}")
    metrics.finish()  # the motion of the last quarter of a second
    for tool in ("right", "left"):
        motion = metrics.motion(tool)
        print(f"{names[tool]}: path {1e3 * motion.path_length:.0f} mm, peak force {motion.force_peak:.2f} N")


def score_throw(session):
    print(f"in the end: {session.notation or 'no knot'}")
    with analysis.score(session, left=C, right=W, throws_wanted=1) as metrics:
        tell(metrics, {"right": NAMES[W], "left": NAMES[C]})


def score_task(log):
    scene = suturing.played_back(log)
    print(f"in the end: {scene.session.status.phase.name.lower()}")
    tell(scene.metrics, {"right": "right tool", "left": "left tool"})
    scene.close()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("log", nargs="?", type=pathlib.Path)
    parser.add_argument("--plots", type=pathlib.Path)
    parser.add_argument("--hdf5", type=pathlib.Path)
    chosen = parser.parse_args()
    log = chosen.log.read_bytes() if chosen.log else record()
    whole = "suture" in json.loads(vb.Replay(log).info.note)
    session = analysis.trace(log, knots=not whole)
    print(f"replayed: {session.info['steps']} steps, {session.problem or 'every hash met again'}")
    names = TASK_NAMES if whole else NAMES
    if whole:
        score_task(log)
    else:
        score_throw(session)
    if chosen.plots:
        print("drawn:", *analysis.plot(session, chosen.plots, names))
    if chosen.hdf5:
        analysis.write_hdf5(session, chosen.hdf5)
        print("written:", chosen.hdf5)


if __name__ == "__main__":
    main()
