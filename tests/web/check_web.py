"""The page of examples/web: its module, its clock of steps, and the page itself in a browser.

    check_web.py parts <esbuild> <modules> <folder>      modules of the page by themselves, in Node.js
    check_web.py module <esbuild> <modules> <folder> <calls> <wasm> <replay-page>   in Node.js, the same calls as natively
    check_web.py page <page> <folder> <calls> <replay-page>              in Chromium, from the disk: mouse and keys
    check_web.py firefox <page> <folder> <calls> <replay-page>           in Firefox, from the disk: the same calls as natively
    check_web.py hands <page> <folder> <calls> <replay-page>             tracked hands, left-handed
    check_web.py headset <page> <folder> <calls> <replay-page>           controllers of a stand-in for a headset take the needle
    check_web.py task <page> <folder> <seeds> <replay-page>              they perform the whole task, as a scripted surgeon moves them
"""
import json
import pathlib
import shutil
import subprocess
import sys

import colours
import hands

HERE = pathlib.Path(__file__).resolve().parent


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    assert done.returncode == 0, (command, done.returncode, done.stdout[-2000:], done.stderr[-2000:])
    return done.stdout


def node():
    found = shutil.which("node") or shutil.which("nodejs")
    assert found, "no Node.js: .ci/install-packages thorough installs it"
    return found


def bundle(esbuild, source, folder):
    """A module for any Node.js: what a page's script is called makes it no module there."""
    out = folder / f"{source.stem}.mjs"
    run(esbuild, source, "--bundle", "--format=esm", "--target=es2022", "--log-level=warning", f"--outfile={out}")
    return out


def check_parts(esbuild, modules, folder):
    for part in ("step_clock", "resolution", "tracked_hand", "trocar", "mirror", "pose", "progress"):
        print(run(node(), HERE / f"check_{part}.mjs", bundle(esbuild, modules / f"{part}.js", folder)).strip())
    print(colours.check((modules / "style.css").read_text(), (modules / "panel.js").read_text()))
    print(colours.check_tension((modules.parent.parent / "viewer/materials.h").read_text()))


def check_replay(tool, log, folder):
    """The log is whole, and its steps are the same bits natively."""
    print(run(tool, log, "-o", folder / f"{log.stem}.html", "--rate", "5").strip())


def call_natively(calls, script, folder):
    return run(calls, input=script, cwd=folder).splitlines()


def check_played(simulation, wasm, log, script, wanted):
    """The module plays the log it has written: step by step, and by jumps to and fro, it is where it was when it was recorded."""
    answers, steps, at = iter(wanted), 0, {}
    for word, *numbers in (line.split() for line in script.splitlines()):
        if word == "step":
            steps += int(numbers[0])
        elif word in ("hash", "state"):
            answer = next(answers)
            if word == "hash":
                at[steps] = answer
    times = sorted(at)
    order = [*times, times[2], times[-2], times[0], 0, times[-1]]
    found = run(node(), HERE / "play_log.mjs", simulation, wasm, log, *order).splitlines()
    last = json.loads(found.pop())
    for step, answer in zip(order, found, strict=True):
        assert step == 0 or answer == at[step], f"played, after step {step}: {answer}, not {at[step]}"
    assert last["replay"]["steps"] == steps and last["replay"]["whole"] and not last["replay"]["differs"], last["replay"]
    assert last["steps"] == steps and last["tools"][hands.RIGHT]["position"], last
    print(f"played and sought: {len(found)} hashes are those that were recorded")


def check_module(esbuild, modules, folder, calls, wasm, replay_page):
    simulation = bundle(esbuild, modules / "simulation.js", folder)
    for name, scene in (("needle", hands.NEEDLE), ("stitch", hands.STITCH), ("coarse", hands.COARSE)):
        script = "\n".join(hands.controllers(scene)) + "\n"
        log = folder / f"{name}.vbss"
        wanted = call_natively(calls, script, folder)
        found = run(node(), HERE / "run_module.mjs", simulation, wasm, log, input=script).splitlines()
        assert len(wanted) == len(found) > 8, (len(wanted), len(found))
        for i, (a, b) in enumerate(zip(wanted, found)):
            same = json.loads(a) == json.loads(b) if a.startswith("{") else a == b
            assert same, f"{name}, answer {i}: natively {a}, in the module {b}"
        states = [json.loads(line) for line in wanted if line.startswith("{")]
        assert states[0]["tools"][hands.RIGHT]["holds"] == "the needle", states[0]["tools"]
        assert states[0]["tools"][hands.RIGHT]["position"][2] > 10e-3
        before, after = (s["tools"][hands.RIGHT]["target"] for s in states[:2])
        assert max(abs(p - q) for p, q in zip(before, after)) < 1e-5, f"the clutch does not hold: {before}, {after}"
        print(f"{name}: {states[-1]['steps']} steps, {len(wanted) - len(states)} hashes of scene and session are the same")
        check_replay(replay_page, log, folder)
        check_played(simulation, wasm, log, script, wanted)
        assert (folder / "log.vbss").read_bytes()[64:] and log.stat().st_size > 1000


def check_firefox(page, folder, calls, replay_page):
    import drive_firefox  # noqa: PLC0415
    assert drive_firefox.marionette.find(), "no Firefox: .ci/install-packages thorough installs it"
    log = drive_firefox.check(page, folder, lambda script: call_natively(calls, script, folder))
    check_replay(replay_page, log, folder)
    return 0


def check_browser(part, page, folder, calls, replay_page):
    import drive_headset  # noqa: PLC0415  of what needs a browser
    import drive_page  # noqa: PLC0415
    import drive_task  # noqa: PLC0415
    assert drive_page.browser.find(), "no Chromium: .ci/install-packages thorough installs it"

    def replay(log):
        check_replay(replay_page, log, folder)

    if part == "page":
        complaints = drive_page.check_desk(page, folder, lambda script: call_natively(calls, script, folder), replay)
    elif part == "headset":
        complaints = drive_headset.check_headset(page, folder, replay)
    elif part == "hands":
        complaints = drive_headset.check_hands(page, folder, replay)
    else:
        complaints = drive_task.check_task(page, folder, range(int(calls.name)), replay)
    print("\n".join(complaints))
    return 1 if complaints else 0


def main():
    part, rest = sys.argv[1], [pathlib.Path(word) for word in sys.argv[2:]]
    if part in ("parts", "module"):
        rest[2].mkdir(parents=True, exist_ok=True)
        {"parts": check_parts, "module": check_module}[part](*rest)
        return 0
    rest[1].mkdir(parents=True, exist_ok=True)
    if part == "firefox":
        return check_firefox(*(path.resolve() for path in rest))
    return check_browser(part, *(path.resolve() for path in rest))


sys.exit(main())
