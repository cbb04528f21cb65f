"""Points of the table and of the plot: what a method costs in a subject, and its error."""
import dataclasses


@dataclasses.dataclass
class Point:
    subject: str
    method: str
    label: str  # resolution and step
    cost: float  # in the unit of the subject
    error: float
    ours: bool
    note: str = ""


@dataclasses.dataclass
class Subject:
    name: str
    title: str
    cost: str  # what it is, with unit
    error: str
    problem: str  # one sentence or two, for the page


PER_SECOND = "CPU seconds per simulated second"
SUBJECTS = [
    Subject("thread", "Thread", PER_SECOND, "tip error, mm",
            "A cantilever of 150 mm is released and falls for 0.1 s. The reference is a converged solution by another program."),
    Subject("capstan", "Contact: capstan", PER_SECOND, "error of ln(T2/T1), %",
            "A thread slides over half of a cylinder, friction 0.3. The reference is T2 = T1 exp(mu pi), less the share of bending."),
    Subject("trefoil", "Contact: trefoil pulled tight", PER_SECOND, "overlap, % of the diameter",
            "An open trefoil is pulled until it takes up 14 diameters of thread. The exact overlap is zero. "
            "The determinant of the knot decides whether it is still a trefoil."),
    Subject("drain", "Drain", PER_SECOND, "error of the gap's stiffness, %",
            "The slit of the drain is pulled open at its marks. The reference is a mesh of 851 nodes."),
    Subject("knots", "Knots", "CPU microseconds per reading", "readings that are not right, %",
            "Polylines with known throws are read. The paper's projection and our winding read its own cases."),
    Subject("collision", "Collision", "CPU nanoseconds per question", "wrong answers, %",
            "Do two moving segments meet in a step? Hard cases, against exact arithmetic."),
    Subject("task", "Task", PER_SECOND, "simulated time left out, %",
            "The scripted surgeon performs the whole task under the default work limit. No peer has this task."),
]
METHODS = {"ours": "ours", "ours-local": "ours, local bending", "paper": "the paper's method", "mujoco": "MuJoCo 2 chain",
           "mujoco-damped": "MuJoCo 2 chain, damped", "bullet-multibody": "Bullet multibody", "bullet-softbody": "Bullet soft body",
           "projection": "the paper's projection", "winding": "ours, winding", "topology": "ours, topology"}
OURS = {"ours", "ours-local", "winding", "topology", "conservative", "conservative-1e-6", "conservative-call",
        "conservative-batch", "conservative-batch-plain", "conservative-batch-call"}
COLLISION_METHODS = {"conservative": "ours", "conservative-batch": "ours, in rows", "paper": "the paper's method",
                     "cubic": "cubic", "accd-0.1": "ACCD", "fcl-end": "FCL at the end", "libccd-end": "libccd at the end",
                     "libccd-swept": "libccd, swept"}


def parts_of(entry):
    _, scene, method, *rest = entry["name"].split("/")
    return scene, method, rest[0] if rest else ""


def thread_points(entries):
    for e in entries:
        if isinstance(e.get("dynamic_tip_error_mm"), (int, float)):
            _, method, size = parts_of(e)
            yield Point("thread", METHODS[method], f"{size} segments, {e['dt_us']:.0f} us", 1e-3 * e["us_per_ms"],
                        e["dynamic_tip_error_mm"], method in OURS)


def drain_points(entries):
    for e in entries:
        if isinstance(e.get("k_gap_error_percent"), (int, float)):
            yield Point("drain", "ours", f"{parts_of(e)[2]} nodes", 1e-3 * e["us_per_ms"], abs(e["k_gap_error_percent"]), True)


def knot_points(entries):
    """A point a method for the cases of the paper together, and one for each number of segments of the stacks."""
    groups = {}
    for e in entries:
        scene, method, size = parts_of(e)
        if method in METHODS and e.get("configurations"):
            key = (method, "the paper's cases" if scene.startswith("case-") else f"stacks, {size} segments")
            groups.setdefault(key, []).append(e)
    for (method, label), group in groups.items():
        count = sum(e["configurations"] for e in group)
        missed = count - sum(e["right"] for e in group)
        yield Point("knots", METHODS[method], label, sum(e["mean_us"] for e in group) / len(group), 100.0 * missed / count,
                    method in OURS)


def collision_points(entries):
    for e in entries:
        scene, method, _ = parts_of(e)
        if scene == "hard" and method in COLLISION_METHODS and e.get("queries"):
            undecided = e.get("undecided") or 0.0
            wrong = e["fp"] + e["fn"] + undecided
            yield Point("collision", COLLISION_METHODS[method], f"{e['fn']:.0f} missed, {e['fp']:.0f} invented", e["cpu_time"],
                        100.0 * wrong / e["queries"], method in OURS)


def task_points(entries):
    for e in entries:
        if e.get("real_time_factor"):
            yield Point("task", "ours", f"p50 {e['p50_us']:.0f} us, p99.9 {e['p999_us']:.0f} us a call",
                        1e-3 * e["us_per_ms"], 100.0 * e["left_out"], True)


def peer_points(results, skipped):
    """Of the JSON lines of measure.py."""
    for r in results:
        method = "ours" if r["peer"] == "ours" else r.get("version", r["peer"])
        label = f"{r['segments']} segments, {r['step_us']:g} us"
        if "failed" in r:
            skipped.append((f"{r['subject']}: {method}, {label}", r["failed"]))
            continue
        kept = r.get("kept", True)
        if kept:
            note = ""
        else:
            note = "not a trefoil any more"
        error = r.get("error_mm", r.get("error_percent"))
        yield Point(r["subject"], method, label, r["cpu_per_s"], error, r["peer"] == "ours", note)


def all_points(entries, results, skipped):
    made = list(peer_points(results, skipped))
    for suite, read in (("thread", thread_points), ("tissue", drain_points), ("knots", knot_points),
                        ("collision", collision_points), ("task", task_points)):
        made += read(entries.get(suite, []))
    order = [s.name for s in SUBJECTS]
    return sorted(made, key=lambda q: (order.index(q.subject), not q.ours, q.method, q.cost))


def beats_us(point, points):
    """A peer's point for which none of ours is at most as expensive and at most as wrong."""
    ours = [q for q in points if q.subject == point.subject and q.ours and not q.note]
    return not point.ours and not point.note and bool(ours) and not any(
        q.cost <= point.cost and q.error <= point.error for q in ours)
