"""Prints what was measured."""

ALONE = 0.97  # share of the core's time from which on the runs count as undisturbed


def lines(rows):
    """Rows of cells as text: the first column left, the others right."""
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    for row in rows:
        yield "  ".join([row[0].ljust(widths[0])] + [cell.rjust(width) for cell, width in zip(row[1:], widths[1:])])


def with_spread(ratio):
    return f"{ratio['value']:.3f} ({ratio['low']:.3f} to {ratio['high']:.3f})"


def number(value, form):
    return "-" if value is None else format(value, form)


def ratio_rows(subjects):
    yield ["subject", "median", "p99.9", "sum", "operations", "real-time factor"]
    for name, found in subjects.items():
        r = found["ratios"]
        yield [name, with_spread(r["median"]), with_spread(r["p999"]), with_spread(r["sum"]), number(r["operations"], ".3f"),
               f"{r['real_time_factor']:.3f}"]


def side_rows(subjects, names):
    yield ["subject", "revision", "steps", "median us", "p99.9 us", "operations a step", "left out %", "truncated",
           "real-time factor", "done"]
    for subject, found in subjects.items():
        for name, side in zip(names, (found["reference"], found["this"])):
            yield [subject, name, str(side["steps"]), f"{side['median_us']:.1f}", f"{side['p999_us']:.1f}",
                   number(side["operations_a_step"], ".0f"), f"{100.0 * side['left_out']:.2f}", number(side["truncated"], ".0f"),
                   f"{side['real_time_factor']:.2f}", f"{side['done']} of {side['seeds']}"]


def text(measured):
    names = measured["reference"]["name"], measured["this"]["name"]
    core = f"on core {measured['core']}" if measured["core"] is not None else "on any core"
    yield f"This revision ({names[1]}) against {names[0]}: CPU time of each step, minimum over {measured['pairs']} run(s) of each"
    yield f"revision, alternately {core} ({measured['cpu']})."
    if measured["core_share"] < ALONE:
        yield f"OTHER WORK RAN ON THE CORE: the runs had {100.0 * measured['core_share']:.0f} % of its time. Do not quote these figures."
    yield ""
    yield "Ratios, this revision by the other. Below 1 this one is faster; the real-time factor is better above 1."
    yield "In brackets: range of the ratios of single pairs of runs. Operations do not depend on the machine."
    yield from lines(list(ratio_rows(measured["subjects"])))
    yield ""
    yield "Each revision. Left out: share of the simulated time for which the work limits left no room."
    yield from lines(list(side_rows(measured["subjects"], names)))
