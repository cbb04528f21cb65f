"""A scripted policy takes the needle off the floor and drives it through both marks of the drain, and another draws the thread
after it: the begin of the whole task as an environment.

    python3 bindings/python/examples/drive_needle.py [--seed 0] [--segments 300] [--pull] [--plot needle.png]
        [--log needle.vbss]

Tells each event of the session, and what there was of reward by then. --plot draws what hands feel and how far the needle
is through, --log keeps the log, which score_session.py plays back."""
import argparse
import pathlib
import sys

from vblast_ss.suturing import FIELDS, ScriptedPull, ScriptedStitch, SutureEnvironment


def drive(seed, segments, pull=False, log=None):
    """Rows of time, pull on either hand, depth inward and outward, reward so far; and why it was given up, if it was."""
    rows, total, over = [], 0.0, False
    policy = ScriptedStitch()
    with SutureEnvironment(time_limit=40.0, record=log is not None) as environment:
        seen, info = environment.reset(seed=seed, options={"segments": segments})
        while not over and not policy.done:
            seen, reward, terminated, truncated, info = environment.step(policy(seen))
            total, over = total + reward, terminated or truncated
            for event in info["events"]:
                print(f"{event.time:7.3f} s  {event.kind.name.lower()} {event.number}{', undone' if event.undone else ''}"
                      f"  {info['phase'].lower()}  {total:+.2f}")
            pulls = [sum(part**2 for part in seen[FIELDS[name]])**0.5 for name in ("left_force", "right_force")]
            rows.append((info["time"], *pulls, *seen[FIELDS["depth"]], total))
            if pull and policy.phase == "done" and isinstance(policy, ScriptedStitch):
                policy = ScriptedPull()
        if log is not None:
            log.write_bytes(environment.take_log())
        print(f"{policy.phase} {policy.why or info.get('error', '')} after {info['time']:.2f} s, {info['steps']} steps; holes "
              "{:.2f} and {:.2f} mm off; ".format(*info["deviation_mm"]) + f"reward {total:.1f}, score {info['score']:.1f}")
    return rows, policy.phase == "done"


def draw(rows):
    from matplotlib.figure import Figure
    figure = Figure(figsize=(8.0, 6.0), layout="constrained")
    forces, depths, rewards = figure.subplots(3, 1, sharex=True)
    time, left, right, inward, outward, total = zip(*rows)
    forces.plot(time, left, label="left hand")
    forces.plot(time, right, label="right hand")
    forces.set_ylabel("force, N")
    depths.plot(time, [1e3 * depth for depth in inward], label="beyond the first wall")
    depths.plot(time, [1e3 * depth for depth in outward], label="beyond the second wall")
    depths.set_ylabel("needle's tip, mm")
    rewards.plot(time, total, color="k", label="reward so far")
    rewards.set_xlabel("time, s")
    for axes in (forces, depths, rewards):
        axes.grid(alpha=0.3)
        axes.legend(loc="upper left")
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--segments", type=int, default=300)
    parser.add_argument("--pull", action="store_true")
    parser.add_argument("--plot", type=pathlib.Path)
    parser.add_argument("--log", type=pathlib.Path)
    chosen = parser.parse_args()
    rows, done = drive(chosen.seed, chosen.segments, chosen.pull, chosen.log)
    if chosen.plot:
        draw(rows).savefig(chosen.plot)
        print("drawn:", chosen.plot)
    return 0 if done else 1


if __name__ == "__main__":
    sys.exit(main())
