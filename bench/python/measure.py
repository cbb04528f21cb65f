#!/usr/bin/env python3
"""What the Python binding costs, beside C with the same shared library.

    bench/python/measure.py [library folder]      default build/release/lib

Import time in fresh interpreters; time of a scene's step from Python and from C, for scenes of nothing and of a hanging
thread, with equal hashes of the end states: processor time, the least of several runs. Steps a second of one and of two
Python threads with a scene each, the best of several runs: by the clock, and by the processor time of each thread, which is what a
core of its own would give; by the clock two gain less on a machine that does other things. Environments: processor time of a
simulated second."""
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
LIBRARY = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/lib").resolve()
os.environ["VBLAST_SS_LIBRARY"] = str(LIBRARY)
os.environ["PYTHONPATH"] = str(ROOT / "bindings/python")
sys.path.insert(0, str(ROOT / "bindings/python"))
import vblast_ss as vb  # noqa: E402
from vblast_ss.batch import Batch  # noqa: E402

RUNS = 9


def import_time(statement):
    """ms of processor time that a statement adds to an interpreter, with compiled files already there."""
    def run(text):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([sys.executable, "-c", text], check=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return 1e3 * (after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    run(statement)
    return min(run(statement) for _ in range(RUNS)) - min(run("pass") for _ in range(RUNS))


def scene_of(segments):
    scene = vb.Scene(vb.Context())
    if segments:
        thread = vb.Thread(scene.context, segment_count=segments)
        thread.attach("pin", 0, position=(0, 0, 0))
        scene.add(thread)
    return scene


def python_steps(segments, steps):
    scene = scene_of(segments)
    begin = time.thread_time()
    for _ in range(steps):
        scene.step(1e-3)
    return 1e9 * (time.thread_time() - begin) / steps, scene.state_hash


def c_steps(program, segments, steps):
    text = subprocess.run([program, str(segments), str(steps)], check=True, capture_output=True, text=True,
                          env={**os.environ, "LD_LIBRARY_PATH": str(LIBRARY)}).stdout.split()
    return float(text[0]), int(text[1])


def throughput(workers, segments, steps):
    """Steps a second of all workers together by the clock, and of each by its processor time, in a batch of a scene each."""
    with Batch(scene_of, [segments] * workers, workers=workers) as batch:
        made = [cost.seconds for cost in batch.costs]
        begin = time.perf_counter()
        batch.step(1e-3, steps)
        seconds = time.perf_counter() - begin
        own = [steps / (cost.seconds - before) for cost, before in zip(batch.costs, made)]
        return workers * steps / seconds, sum(own) / workers, set(batch.map(lambda scene: scene.state_hash))


def environments():
    """ms of processor time a simulated second takes, at its begin, while hands are still."""
    from vblast_ss import environment, suturing  # want numpy
    for name, make, options in (("a throw", environment.ThrowEnvironment, {}),
                                ("the whole task, 60 segments", suturing.SutureEnvironment, {"segments": 60}),
                                ("the whole task, 300 segments", suturing.SutureEnvironment, {})):
        costs = []
        with make() as made:
            for _ in range(3):
                made.reset(seed=0, options=options)
                still = [0.0] * made.action_space.shape[0]
                begin = time.thread_time()
                for _ in range(50):
                    made.step(still)
                costs.append((time.thread_time() - begin) / (1e-3 * made.control * 50))
        print(f"{name} as an environment: {1e3 * min(costs):.0f} ms of processor time a simulated second")


def main():
    print(f"{vb.build_info()}\nload {os.getloadavg()[0]:.1f}, Python {sys.version.split()[0]}, {os.cpu_count()} cores\n")
    print(f"import vblast_ss: {import_time('import vblast_ss'):.0f} ms; with numpy, at the first array: "
          f"{import_time('import vblast_ss, numpy'):.0f} ms")
    with tempfile.TemporaryDirectory() as folder:
        program = str(pathlib.Path(folder) / "steps")
        subprocess.run([os.environ.get("CC", "cc"), "-O2", "-std=c11", "-I", str(ROOT / "include"),
                        str(pathlib.Path(__file__).with_name("steps.c")), "-o", program, f"-L{LIBRARY}", "-lvblast_ss"],
                       check=True)
        print("\nscene                 C, us    Python, us    ratio")
        for name, segments, steps in (("nothing", 0, 20000), ("thread of 20", 20, 3000), ("thread of 120", 120, 1000)):
            runs = [(c_steps(program, segments, steps), python_steps(segments, steps)) for _ in range(RUNS)]
            if len({found for pair in runs for _, found in pair}) != 1:
                sys.exit("the end states differ")
            c, python = (min(pair[i][0] for pair in runs) for i in (0, 1))
            print(f"{name:18} {1e-3 * c:8.2f} {1e-3 * python:13.2f} {python / c:8.2f}")
        scene = scene_of(120)
        thread = scene.thread(1)
        costs = []
        for _ in range(RUNS):
            begin = time.thread_time()
            for _ in range(2000):
                thread.positions
            costs.append((time.thread_time() - begin) / 2000)
        print(f"\nan array of positions: {1e6 * min(costs):.2f} us")
    try:
        environments()
    except ImportError:
        print("environments: want numpy")
    rates = [[throughput(workers, 120, 1500) for workers in (1, 2)] for _ in range(3 * RUNS)]
    if len({found for row in rates for *_, hashes in row for found in hashes}) != 1:
        sys.exit("the end states differ")
    one, two = (max(row[i][0] for row in rates) for i in (0, 1))
    own_one, own_two = (max(row[i][1] for row in rates) for i in (0, 1))
    print(f"steps a second, thread of 120: 1 worker {one:.0f}, 2 workers {two:.0f} together ({two / one:.2f} times); "
          f"by processor time a core: {own_one:.0f} with 1, {own_two:.0f} with 2 ({own_two / own_one:.2f})")


if __name__ == "__main__":
    main()
