"""docs/explanation/speed-against-error.md, and the lines that README quotes from it."""
import re

from points import SUBJECTS, beats_us

BEGIN, END = "<!-- speed-against-error: written by bench/run.sh summary -->", "<!-- speed-against-error: end -->"


def figure(value):
    """Three digits."""
    return "0" if value == 0.0 else f"{value:.3g}" if 1e-4 <= abs(value) < 1e4 else f"{value:.1e}"


def table(subject, points):
    lines = [f"| method | setting | {subject.cost} | {subject.error} | |", "|---|---|---|---|---|"]
    for q in points:
        name = f"**{q.method}**" if q.ours else q.method
        lines.append(f"| {name} | {q.label} | {figure(q.cost)} | {figure(q.error)} | {q.note} |")
    return lines


def comparison(subject, points):
    """The settings of peers that none of ours covers."""
    better = [q for q in points if beats_us(q, points)]
    if better:
        return ["**A peer is ahead here.** No setting of ours is at most as expensive and at most as wrong as:", ""] + [
            f"- {q.method}, {q.label}: {figure(q.cost)} with an error of {figure(q.error)}" for q in better]
    if all(q.ours for q in points):
        return []
    if not any(q.ours and not q.note for q in points):
        return ["No setting of ours was measured."]
    return ["For every setting of a peer, one of ours is at most as expensive and at most as wrong."]


def machine(context):
    words = [context.get("cpu_model", "unknown processor"), context.get("compiler", ""), "one core"]
    return ", ".join(w for w in words if w)


def page(points, skipped, notes, context, hurried):
    lines = ["# Speed against error", "",
             "`./bench/run.sh summary` writes this page, its plot and the lines in the README. It measures all subjects in one run "
             "on one core, this library beside its peers.", "",
             f"Machine: {machine(context)}. Times of other machines differ; read ratios.", ""]
    if hurried:
        lines += ["THIS IS A QUICK RUN: its figures are not results.", ""]
    lines += ["![Error against cost of all subjects](speed-against-error.svg)", "",
              "Costs are processor time of one thread, without setting up and compiling. Every method solves the same problem with "
              "the same parameters ([`problem.py`](../../bench/peers/problem.py)), each at several resolutions and steps. PyElastica "
              "and DisMech call compiled functions from Python in each step, as their users do. Ours runs offline in the capstan and "
              "in the trefoil: it leaves no time out. Settings of the peers are chosen in their favour; the modules in "
              "[`bench/peers`](../../bench/peers) say how.", ""]
    for subject in SUBJECTS:
        of = [q for q in points if q.subject == subject.name]
        if of:
            lines += [f"## {subject.title}", "", subject.problem, "", *table(subject, of), "", *comparison(subject, of), ""]
    lines += ["## Peers", ""] + [f"- {name}: {note}." for name, note in notes] + [""]
    if skipped:
        lines += ["## Not measured", "", "| case | reason |", "|---|---|"]
        lines += [f"| {case} | {why} |" for case, why in skipped] + [""]
    return re.sub(r"\n{3,}", "\n\n", "\n".join(lines)).rstrip() + "\n"


def best(points, ours):
    """The point with the smallest product of cost and error among those that keep what they should."""
    of = [q for q in points if q.ours == ours and not q.note and q.error > 0.0]
    return min(of, key=lambda q: q.cost * q.error, default=None)


def quotes(points):
    """Lines for the README: of a subject with peers, our best setting beside the best one of the peers."""
    lines = ["| | ours | best peer |", "|---|---|---|"]
    for subject in SUBJECTS[:3]:
        of = [q for q in points if q.subject == subject.name]
        pair = [best(of, True), best(of, False)]
        if pair[0] is None:
            continue
        cells = [f"{figure(q.cost)} s/s, {figure(q.error)}{' (' + q.method + ')' if not q.ours else ''}" if q else "none"
                 for q in pair]
        lines.append(f"| {subject.title}; {subject.error} | {cells[0]} | {cells[1]} |")
    return lines


def quoted(readme, points):
    """The README's text with the lines between its two marks replaced."""
    if BEGIN not in readme or END not in readme:
        raise ValueError("the README has no marks for the summary")
    before, rest = readme.split(BEGIN, 1)
    _, after = rest.split(END, 1)
    return before + BEGIN + "\n" + "\n".join(quotes(points)) + "\n" + END + after
