"""Measures of the page in Chromium, beside the native library in the same run. Times want an idle machine.

    measure_web.py speed <page> <calls>             time of a step, page and native by turns; share of late steps
    measure_web.py memory <page> <minutes> [scene]  memory over so many minutes of the session, a hand at work (default scene: 4,
                                                    the stitch with 60 segments, whose steps are the shortest)
"""
import json
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import time

import drive_page

SCENES = {0: "throw", 2: "stitch, 300 segments", 3: "stitch, 120 segments", 4: "stitch, 60 segments"}
WARM, STEPS, ROUNDS = 1500, 1500, 3
LIVE = 20.0  # s of wall time


# ---- speed


def native_time(calls, scene, steps):
    script = f"begin {scene} 0\nstep {steps}\n"
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with tempfile.TemporaryDirectory() as folder:  # for its log
        subprocess.run([calls], input=script.encode(), check=True, cwd=folder)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def native_step(calls, scene):
    """ms of CPU time, of a long run less a short one."""
    return 1e3 * (native_time(calls, scene, WARM + STEPS) - native_time(calls, scene, WARM)) / STEPS


def page_step(page, scene):
    """ms of wall time of the worker's answer; nothing else is asked of it meanwhile."""
    page.run("suturing.asked = true")  # no pictures
    return page.run(f"""(async () => {{
      const steps = count => new Promise(done => {{ suturing.hearStepped = done; suturing.send({{ name: 'steps', count }}); }});
      suturing.send({{ name: 'pause', wanted: true }});
      suturing.send({{ name: 'begin', scene: {scene}, seed: 0 }});
      await steps({WARM});
      const begin = performance.now();
      await steps({STEPS});
      return (performance.now() - begin) / {STEPS};
    }})()""")


def late_steps(page_file, scene, draws):
    """In real time: steps, share of late ones, share of real time, ms of a step, pictures a second."""
    with drive_page.browser.Browser(drive_page.SIZE) as chromium:
        page = drive_page.Page(chromium, page_file)
        if not draws:
            page.run("suturing.renderer.draw = () => {}")
        page.run(f"suturing.scene.scene = {scene}; suturing.choose({scene})")
        page.until("suturing.shown.state.steps > 500")
        before = page.run("({ ...suturing.shown.clock, frames: suturing.frames })")
        begin = time.monotonic()
        time.sleep(LIVE)
        after = page.run("({ ...suturing.shown.clock, frames: suturing.frames })")
        wall = time.monotonic() - begin
    steps = after["steps"] - before["steps"]
    return steps, (after["late"] - before["late"]) / steps, 1e-3 * steps / wall, after["stepTime"], (after["frames"] - before["frames"]) / wall


def speed(page_file, calls):
    times = {scene: ([], []) for scene in SCENES}
    with drive_page.browser.Browser(drive_page.SIZE) as chromium:
        page = drive_page.Page(chromium, page_file)
        for _ in range(ROUNDS):
            for scene in SCENES:
                times[scene][0].append(native_step(calls, scene))
                times[scene][1].append(page_step(page, scene))
    print("| steps at rest | native, ms | page, ms | page : native |\n|---|---|---|---|")
    for scene, name in SCENES.items():
        native, in_page = (statistics.median(of) for of in times[scene])
        ratios = [b / a for a, b in zip(*times[scene])]
        print(f"| {name} | {native:.3f} | {in_page:.3f} | {in_page / native:.2f} ({min(ratios):.2f} to {max(ratios):.2f}) |")
    print(f"\n| {LIVE:.0f} s in real time, pictures by the processor | steps | late | of real time | ms a step | pictures a second |\n|---|---|---|---|---|---|")
    for draws in (True, False):
        for scene in (2, 4):
            steps, late, factor, step, rate = late_steps(page_file, scene, draws)
            drawn = "drawn" if draws else "not drawn"
            print(f"| {SCENES[scene]} (or what the page chose), {drawn} | {steps} | {100 * late:.1f} % | {factor:.2f} | {step:.2f} | {rate:.0f} |", flush=True)


# ---- memory

BLOCK = 5000  # steps between two pictures of the state
MOVE = 40  # counts to and fro


def resident(group):
    """MB of all processes of the browser."""
    total = 0
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text().rpartition(")")[2].split()
            if int(fields[2]) == group:
                total += int(next(line for line in (stat.parent / "smaps_rollup").read_text().splitlines() if line.startswith("Pss:")).split()[1])
        except (OSError, ValueError, StopIteration):
            continue  # it has ended meanwhile
    return total / 1024


def memory(page_file, minutes, scene=4):
    with drive_page.browser.Browser((240, 180)) as chromium:
        page = drive_page.Page(chromium, page_file)
        page.run("suturing.renderer.draw = () => {}")  # the processor's pictures take longer than the steps
        page.run(f"suturing.send({{ name: 'pause', wanted: true }}); suturing.send({{ name: 'begin', scene: {scene}, seed: 0 }})")
        page.run(f"""suturing.work = async blocks => {{
          for (let i = 0; i < blocks; i++) {{
            for (let k = 0; k < {BLOCK} / 50; k++) {{
              const way = {MOVE} * (k % 2 === 0 ? 1 : -1);
              suturing.send({{ name: 'move', side: k % 4 < 2 ? 1 : 0, turns: k % 8 > 5, right: way, up: way / 2, away: 0 }});
              if (k % 20 === 0) suturing.send({{ name: 'close', side: 1, closes: k % 40 === 0 }});
              await new Promise(done => {{ suturing.hearStepped = done; suturing.send({{ name: 'steps', count: 50 }}); }});
            }}
          }}
        }}; 0""")
        print("| minutes | module, MB | page's JavaScript heap, MB | browser, all processes, MB | wall time, s |\n|---|---|---|---|---|", flush=True)
        begin, done = time.monotonic(), 0
        for mark in sorted({0, 1, 2, 5, *range(10, minutes + 1, 10), minutes}):
            for _ in range((mark - done) * 60000 // BLOCK):
                page.run("suturing.work(1)")
            done = mark
            state = page.state()
            assert state["steps"] == 60000 * mark, state["steps"]
            chromium.ask("HeapProfiler.collectGarbage")
            heap = chromium.ask("Runtime.getHeapUsage")["usedSize"] / 2**20
            module = page.run("suturing.shown.clock.memory") / 2**20
            print(f"| {mark} | {module:.1f} | {heap:.1f} | {resident(chromium.process.pid):.0f} | {time.monotonic() - begin:.0f} |", flush=True)
        print(json.dumps({"steps": state["steps"], "requests": len(chromium.requests), "complaints": chromium.complaints}))


def main():
    what, page, *rest = sys.argv[1:]
    page = pathlib.Path(page).resolve()
    if what == "speed":
        speed(page, pathlib.Path(rest[0]).resolve())
    else:
        memory(page, *(int(word) for word in rest))


main()
