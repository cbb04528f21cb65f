"""The figures of a revision and their ratios.

A revision repeats itself to the bit, so the minimum over all runs of a step is the best estimate of its cost. The spread of a
ratio is the range of the values that the single pairs of runs give, widened to contain the ratio itself."""

FIGURES = ("median", "p999", "sum")


def percentile(times, permille):
    """Nearest rank, as in bench/harness/stats.c."""
    ordered = sorted(times)
    return ordered[max((len(ordered) * permille + 999) // 1000, 1) - 1]


def of_times(ns):
    return {"median": percentile(ns, 500), "p999": percentile(ns, 999), "sum": sum(ns)}


def minima(runs):
    return [min(times) for times in zip(*(run.ns for run in runs))]


def revision(runs):
    """What one revision took, in us and s, and what it did."""
    first, times = runs[0], of_times(minima(runs))
    steps, simulated = len(first.ns), len(first.ns) * first.step_s
    left_out = first.counters.get("left_out_s", 0.0)
    return {"steps": steps, "seeds": first.seeds, "done": first.done, "hashes": first.hashes,
            "median_us": 1e-3 * times["median"], "p999_us": 1e-3 * times["p999"], "sum_s": 1e-9 * times["sum"],
            "operations_a_step": first.counters["operations"] / steps if "operations" in first.counters else None,
            "left_out": left_out / simulated, "truncated": first.counters.get("truncated"),
            "real_time_factor": (simulated - left_out) / (1e-9 * times["sum"])}


def ratios(reference, this):
    """This revision by the reference: value, low and high of each figure."""
    best = [of_times(minima(runs)) for runs in (reference, this)]
    single = [[of_times(run.ns) for run in runs] for runs in (reference, this)]
    found = {}
    for name in FIGURES:
        value = best[1][name] / best[0][name]
        all_values = [value] + [b[name] / a[name] for a, b in zip(*single)]
        found[name] = {"value": value, "low": min(all_values), "high": max(all_values)}
    return found


def subject(reference, this):
    sides = {"reference": revision(reference), "this": revision(this)}
    found = {"ratios": ratios(reference, this), **sides}
    work = [side["operations_a_step"] for side in sides.values()]
    found["ratios"]["operations"] = work[1] / work[0] if work[0] and work[1] else None
    factors = [side["real_time_factor"] for side in sides.values()]
    found["ratios"]["real_time_factor"] = factors[1] / factors[0]
    return found
