"""From the log of a session to arrays, tables and plots.

    from vblast_ss import analysis

    trace = analysis.trace(log)                  # replayed, hashes compared
    print(trace.tools[2].force.max(), trace.knots)
    analysis.write_hdf5(trace, "session.h5")     # needs h5py
    analysis.plot(trace, "session")              # forces, motion and knots as pictures; needs matplotlib

A log says what hands did, and how the scene begins only to a scene that was made alike: the scene of an episode of
environment.ThrowEnvironment is made from the note in its log, for others give a function that makes it."""
from __future__ import annotations

import importlib
import json
import pathlib
from typing import Any, Callable, NamedTuple, Optional

import numpy as np

from ._api.record import RecordInputKind, ReplayOutcome
from .context import Context
from .errors import Error
from .grasper import Grasper
from .knots import KnotDetector, KnotEvent
from .metrics import Metrics
from .records import Replay
from .scene import SceneEventKind, Scene
from .thread import Thread

__all__ = ["KnotMoment", "SceneMoment", "ToolTrace", "Trace", "plot", "plot_forces", "plot_knots", "plot_motion",
           "read_hdf5", "score", "trace", "write_hdf5"]

Make = Callable[[Context, bytes], Scene]


class ToolTrace(NamedTuple):
    """A tool that hands moved, each array with a row a time."""
    position: Any
    """n x 3, m."""
    orientation: Any
    """n x 4."""
    force: Any
    """n x 3, N: of the hand on it."""
    torque: Any
    """n x 3, N m."""


class SceneMoment(NamedTuple):
    """Something that happened in the scene."""
    time: float
    kind: str
    """Of SceneEventKind or RecordEventKind."""
    body: int
    other: int
    number: int


class KnotMoment(NamedTuple):
    """Something that the detector told of the thread alone."""
    time: float
    kind: str
    """Of KnotEvent."""
    numbers: tuple[int, int, int]
    notation: str
    """Of what is tied by then."""


class Trace(NamedTuple):
    """A session as arrays over n times."""
    time: Any
    """n, s."""
    tools: dict[int, ToolTrace]
    """By the body's number."""
    tensions: dict[int, Any]
    """By the thread's number: n, N, the largest that four segments in a row bear: between nodes that are pinned to one
    body the thread may be strained without any pull."""
    contacts: Any
    """n."""
    events: list[SceneMoment]
    knots: list[KnotMoment]
    notation: str
    """Of the knot in the end, judged at leisure."""
    faithful: bool
    """Every hash in the log was met again, to its end."""
    problem: str
    """Why not; a log that is cut off gives what is in it."""
    info: dict[str, Any]
    """What the log says of itself."""


def _scene_of(context: Context, note: bytes) -> Scene:
    try:
        said = json.loads(note)
    except ValueError:
        said = {}
    from . import environment, suturing  # gymnasium may be slow to load
    for name, module in (("throw", environment), ("suture", suturing)):
        if isinstance(said, dict) and name in said:
            scene: Scene = module.scene_of_note(note, context).scene
            return scene
    raise ValueError("the log does not say from what its scene is made: give a function that makes it")


def _state(scene: Scene, body: int) -> Any:
    known = scene._bodies.get(body)
    return known.state if isinstance(known, Grasper) else scene.rigid(body)


def _tension(tensions: Any) -> float:
    row = min(4, len(tensions))
    return float(np.lib.stride_tricks.sliding_window_view(tensions, row).min(axis=1).max())


def trace(log: bytes, make: Optional[Make] = None, *, every: int = 10, knots: bool = True) -> Trace:
    """Replays a log, and notes what is to be seen every so many steps, 10 for 10 ms.

        make   called with a context and the log's note; gives a scene made as the recorded one was
        every  steps between rows; events are noted of all steps
        knots  show the first thread to a knot detector at each row
    """
    if every < 1:
        raise ValueError(f"every {every} steps")
    with Context() as context:
        replay = Replay(log, context)
        about = replay.info
        scene = (make or _scene_of)(context, about.note)
        replay.begin(scene)
        bodies = list(scene._bodies)
        threads = [number for number in bodies if isinstance(scene._bodies[number], Thread)]
        detector = KnotDetector(context) if knots and threads else None
        first_thread: Any = scene.thread(threads[0]) if threads else None
        rows: dict[int, list[tuple[Any, ...]]] = {}  # of tools; they are known when they are moved first
        tensions: dict[int, list[float]] = {number: [] for number in threads}
        time: list[float] = []
        contacts: list[int] = []
        events: list[SceneMoment] = []
        found: list[KnotMoment] = []
        moves = (RecordInputKind.RIGID_TARGET, RecordInputKind.GRASPER_TARGET)
        steps, problem = 0, ""
        while True:
            try:
                report = replay.step()
            except Error as error:
                problem = str(error)
                break
            if report.outcome != ReplayOutcome.STEPPED:
                problem = "" if report.outcome == ReplayOutcome.ENDED else f"other hashes after step {report.agreed_step}"
                break
            steps = int(report.step)
            told = replay.read(steps)
            for put in told.inputs:
                if put.kind in moves:
                    rows.setdefault(put.words[0], [(np.nan,) * 13] * len(time))
            events += [SceneMoment(told.time, getattr(one.kind, "name", str(one.kind)).lower(), *one[1:])
                       for one in told.events if one.kind not in (SceneEventKind.TOUCH, SceneEventKind.PART)]
            if steps % every == 0:
                time.append(told.time)
                contacts.append(scene.statistics.contacts)
                for body, seen in rows.items():
                    state = _state(scene, body)
                    seen.append((*state.position, *state.orientation, *state.hand_force, *state.hand_torque))
                for number, most in tensions.items():
                    most.append(_tension(scene.thread(number).tensions))
                if detector is not None:
                    notation = detector.judge(first_thread.positions).notation
                    found += [KnotMoment(told.time, one.kind.name.lower(), one.numbers, notation)
                              for one in detector.events if one.kind != KnotEvent.READ]
        notation = detector.judge(first_thread.positions).notation if detector is not None else ""
        tools = {}
        for body, seen in rows.items():
            table = np.array(seen, dtype=float).reshape(len(time), 13)
            tools[body] = ToolTrace(table[:, :3], table[:, 3:7], table[:, 7:10], table[:, 10:])
        return Trace(np.array(time), tools, {number: np.array(most) for number, most in tensions.items()},
                     np.array(contacts, dtype=np.uint32), events, found, notation,
                     not problem, problem,
                     {"library_version": about.library_version, "build_info": about.build_info,
                      "log_bytes": about.log_bytes, "steps": steps,
                      "note": about.note.decode(errors="replace")})


def score(session: Trace, *, left: int, right: int, **settings: Any) -> Metrics:
    """Measures a session anew: samples of both tools, and the throws that were certified. Keywords are settings of
    Metrics; what a trace does not know (punctures, cuts, gaps) may be told to what comes back."""
    settings.setdefault("duration", max(1.0, float(session.time[-1]) if len(session.time) else 1.0))
    metrics = Metrics(**settings)
    metrics.add_event("needle_appears", 0.0)
    throws = iter([one for one in session.knots if one.kind in ("certified", "revoked")])
    throw = next(throws, None)
    for i, time in enumerate(session.time):
        there = {name: (session.tools[body].position[i], session.tools[body].force[i])
                 for name, body in (("left", left), ("right", right))}
        metrics.add_sample(float(time), there["left"][0], there["right"][0], left_force=there["left"][1],
                           right_force=there["right"][1])
        while throw is not None and throw.time <= time:
            number, wraps, hand = throw.numbers
            if throw.kind == "certified" or any(one.number == number and one.standing for one in metrics.throws):
                metrics.add_event("throw", float(time), number=number, wraps=wraps, handedness=1 if hand == 2 else -1,
                                  relation="first" if number == 0 else "unknown", undone=int(throw.kind == "revoked"))
            throw = next(throws, None)
    return metrics


# ---- files

def _h5py() -> Any:
    try:
        return importlib.import_module("h5py")
    except ImportError:
        raise ImportError("HDF5 needs h5py: sudo apt-get install python3-h5py") from None


def write_hdf5(session: Trace, path: Any) -> None:
    """A file with a group a tool and a thread, units beside the numbers, events and knots as JSON lines."""
    h5py = _h5py()
    packed = {"compression": "gzip", "shuffle": True}
    with h5py.File(path, "w") as file:
        file.attrs.update(session.info)
        file.attrs.update(notation=session.notation, faithful=session.faithful, problem=session.problem)
        file.create_dataset("time", data=session.time, **packed).attrs["unit"] = "s"
        file.create_dataset("contacts", data=session.contacts, **packed)
        for body, tool in session.tools.items():
            for name, unit in (("position", "m"), ("orientation", "1"), ("force", "N"), ("torque", "N m")):
                made = file.create_dataset(f"tools/{body}/{name}", data=getattr(tool, name), **packed)
                made.attrs["unit"] = unit
        for number, most in session.tensions.items():
            file.create_dataset(f"threads/{number}/tension", data=most, **packed).attrs["unit"] = "N"
        lists: tuple[tuple[str, list[Any]], ...] = (("events", session.events), ("knots", session.knots))
        for name, listed in lists:
            file.create_dataset(name, data=[json.dumps(one._asdict()) for one in listed],
                                dtype=h5py.string_dtype(), shape=(len(listed),))


def read_hdf5(path: Any) -> Trace:
    """What write_hdf5 wrote."""
    h5py = _h5py()
    with h5py.File(path, "r") as file:
        info = {name: value.item() if hasattr(value, "item") else value for name, value in file.attrs.items()}
        notation, faithful, problem = info.pop("notation"), bool(info.pop("faithful")), info.pop("problem")
        tools = {int(body): ToolTrace(*(group[name][()] for name in ToolTrace._fields))
                 for body, group in sorted(file.get("tools", {}).items(), key=lambda pair: int(pair[0]))}
        tensions = {int(number): group["tension"][()] for number, group in file.get("threads", {}).items()}
        events = [SceneMoment(**json.loads(one)) for one in file["events"].asstr()[()]]
        told: list[dict[str, Any]] = [json.loads(one) for one in file["knots"].asstr()[()]]
        knots = [KnotMoment(one["time"], one["kind"], (first, second, third), one["notation"])
                 for one in told for first, second, third in [one["numbers"]]]
        return Trace(file["time"][()], tools, tensions, file["contacts"][()], events, knots, notation, faithful, problem,
                     info)


# ---- pictures

def _figure(rows: int, height: float) -> Any:
    try:
        matplotlib: Any = importlib.import_module("matplotlib.figure")
    except ImportError:
        raise ImportError("plots need matplotlib: sudo apt-get install python3-matplotlib") from None
    figure = matplotlib.Figure(figsize=(9.0, height), layout="constrained")
    return figure, list(figure.subplots(rows, 1, sharex=True, squeeze=False)[:, 0])


def _length(vectors: Any) -> Any:
    return np.sqrt((vectors**2).sum(axis=1))


def _name(names: Optional[dict[int, str]], body: int) -> str:
    return (names or {}).get(body, f"body {body}")


def plot_forces(session: Trace, names: Optional[dict[int, str]] = None) -> Any:
    """A matplotlib figure: forces of the hands on their tools, and the largest tension of each thread."""
    figure, (hands, threads) = _figure(2, 5.0)
    for body, tool in session.tools.items():
        hands.plot(session.time, _length(tool.force), label=_name(names, body), linewidth=1.0)
    hands.set_ylabel("force of the hand, N")
    for number, most in session.tensions.items():
        threads.plot(session.time, most, label=_name(names, number), linewidth=1.0, color="tab:red")
    threads.set_ylabel("largest tension, N")
    threads.set_xlabel("time, s")
    for axes in (hands, threads):
        axes.grid(alpha=0.3)
        if axes.lines:
            axes.legend()
    return figure


def plot_motion(session: Trace, names: Optional[dict[int, str]] = None) -> Any:
    """A matplotlib figure: where the tools are, and how fast."""
    figure, panels = _figure(len(session.tools) + 1, 2.2 * (len(session.tools) + 1))
    for axes, (body, tool) in zip(panels, session.tools.items()):
        for column, axis in enumerate("xyz"):
            axes.plot(session.time, 1e3 * tool.position[:, column], label=axis, linewidth=1.0)
        axes.set_ylabel(f"{_name(names, body)}, mm")
        axes.legend(ncol=3)
    for body, tool in session.tools.items():
        if len(session.time) > 2:
            speed = _length(np.gradient(tool.position, session.time, axis=0))
            panels[-1].plot(session.time, 1e3 * speed, label=_name(names, body), linewidth=1.0)
    panels[-1].set_ylabel("speed, mm/s")
    panels[-1].set_xlabel("time, s")
    if panels[-1].lines:
        panels[-1].legend()
    for axes in panels:
        axes.grid(alpha=0.3)
    return figure


def plot_knots(session: Trace, names: Optional[dict[int, str]] = None) -> Any:
    """A matplotlib figure: what the detector told, the pins, cuts and grasps of the scene, and contacts."""
    figure, (line, touching) = _figure(2, 4.5)
    kinds = list(dict.fromkeys([one.kind for one in session.knots] + [one.kind for one in session.events]))
    for height, kind in enumerate(kinds):
        times = [one.time for one in session.knots if one.kind == kind]
        times += [one.time for one in session.events if one.kind == kind]
        line.plot(times, [height] * len(times), "|", markersize=14, markeredgewidth=2)
    said = ""
    for one in session.knots:
        if one.notation != said:
            said = one.notation
            line.annotate(f"'{said}'", (one.time, kinds.index(one.kind)), xytext=(4, 6), textcoords="offset points")
    line.set_yticks(range(len(kinds)), [kind.replace("_", " ") for kind in kinds])
    line.set_ylim(-0.7, max(len(kinds), 1) - 0.1)
    line.set_title(f"in the end: {session.notation or 'no knot'}")
    touching.plot(session.time, session.contacts, linewidth=1.0)
    touching.set_ylabel("contacts")
    touching.set_xlabel("time, s")
    for axes in (line, touching):
        axes.grid(alpha=0.3)
    return figure


def plot(session: Trace, folder: Any, names: Optional[dict[int, str]] = None) -> list[pathlib.Path]:
    """Writes forces.png, motion.png and knots.png into a folder."""
    where = pathlib.Path(folder)
    where.mkdir(parents=True, exist_ok=True)
    written = []
    for name, draw in (("forces", plot_forces), ("motion", plot_motion), ("knots", plot_knots)):
        path = where / f"{name}.png"
        draw(session, names).savefig(path, dpi=110)
        written.append(path)
    return written
