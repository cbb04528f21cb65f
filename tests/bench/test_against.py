#!/usr/bin/env python3
"""The paired bench, bench/run.sh against: its arithmetic, its order of runs and its refusals.

    test_against.py          all but the next
    test_against.py Itself   HEAD against this tree, a few minutes for two builds
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "bench/against"))

import against  # noqa: E402
import figures  # noqa: E402
import revision  # noqa: E402
import runs  # noqa: E402
import table  # noqa: E402

TRIES = 3  # of a comparison with itself: other work on the machine may spoil one


def run_of(ns, **counters):
    return runs.Run(ns=ns, step_s=1e-3, counters=counters, seeds=1, done=1, hashes=["0"])


class Figures(unittest.TestCase):
    def test_percentiles_are_nearest_ranks(self):
        self.assertEqual(figures.percentile([3, 1, 2], 500), 2)
        self.assertEqual(figures.percentile(list(range(1, 1001)), 999), 999)
        self.assertEqual(figures.percentile(list(range(1, 1002)), 999), 1000)
        self.assertEqual(figures.percentile([7], 999), 7)

    def test_a_disturbed_step_does_not_count_when_another_run_has_it_undisturbed(self):
        reference = [run_of([100, 900, 100]), run_of([800, 100, 100])]
        this = [run_of([50, 50, 700]), run_of([50, 600, 50])]
        ratio = figures.ratios(reference, this)["sum"]
        self.assertEqual(ratio["value"], 0.5)
        self.assertEqual((ratio["low"], ratio["high"]), (0.5, 800 / 1100))
        self.assertEqual(figures.ratios(reference, reference[::-1])["sum"], {"value": 1.0, "low": 1000 / 1100, "high": 1.1})

    def test_time_left_out_is_not_simulated(self):
        side = figures.revision([run_of([1000] * 1000, left_out_s=0.25, operations=5000.0)])
        self.assertEqual(side["left_out"], 0.25)
        self.assertAlmostEqual(side["real_time_factor"], 0.75 / 1e-3)
        self.assertEqual(side["operations_a_step"], 5.0)

    def test_seeds_are_joined(self):
        whole = runs.join([run_of([1, 2], operations=3.0), run_of([4], operations=5.0)])
        self.assertEqual((whole.ns, whole.seeds, whole.counters["operations"]), ([1, 2, 4], 2, 8.0))


class Runs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def program(self, name, hash_text="5"):
        """Answers as against_subjects does, and notes that it ran."""
        path = self.folder / name
        path.write_text(f"#!/bin/sh\necho {name} >>{self.folder}/order\n"
                        f"printf 'step_s 0.001\\nhash %s\\ndone 1\\ntimes 2\\n10\\n20\\n' {hash_text}\n")
        path.chmod(0o755)
        return path

    def measure(self, first, second, pairs):
        return runs.measure((first, second), ("first", "second"), "x/y", 0, pairs, None, runs.CoreShare())

    def test_the_revisions_alternate(self):
        self.measure(self.program("A"), self.program("B"), 3)
        self.assertEqual((self.folder / "order").read_text().split(), list("ABBAAB"))

    def test_a_revision_that_does_not_repeat_itself_is_refused(self):
        restless = self.program("B", "$(wc -l <" + str(self.folder / "order") + ")")
        with self.assertRaisesRegex(runs.RunFailed, "x/y seed 0, second: .*does not repeat itself"):
            self.measure(self.program("A"), restless, 2)

    def test_a_run_that_fails_is_named(self):
        broken = self.folder / "C"
        broken.write_text("#!/bin/sh\necho CAPACITY >&2\nexit 1\n")
        broken.chmod(0o755)
        with self.assertRaisesRegex(runs.RunFailed, "first: CAPACITY"):
            self.measure(broken, self.program("B"), 1)

    def test_lost_output_is_refused(self):
        with self.assertRaises(runs.RunFailed):
            runs.parse("times 3\n1\n2\n")


class Refusals(unittest.TestCase):
    def test_a_revision_that_does_not_build(self):
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder) / "source"
            source.mkdir()
            (source / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.22)\nproject(older NONE)\n"
                                                   "message(FATAL_ERROR \"no such library\")\n")
            with self.assertRaisesRegex(revision.BuildFailed, "(?s)^v0 does not build .*no such library"):
                revision.build(source, pathlib.Path(folder) / "out", "v0", revision.ROOT)

    def test_a_name_that_git_does_not_know(self):
        self.assertEqual(against.main(["no-such-revision"]), 2)

    def test_a_subject_that_is_not_there(self):
        known = {"thread/free-120": False, "task/surgeon": True, "task/at-rest": False}
        self.assertEqual(against.select(known, ["task"]), ["task/surgeon", "task/at-rest"])
        self.assertEqual(against.select(known, []), list(known))
        with self.assertRaisesRegex(LookupError, "'tas'"):
            against.select(known, ["tas"])


class Tables(unittest.TestCase):
    def measured(self, core_share):
        both = figures.subject([run_of([2000] * 10, operations=10.0)], [run_of([1000] * 10, operations=5.0)])
        return {"cpu": "a processor", "core": 1, "core_share": core_share, "pairs": 1, "reference": {"name": "old"},
                "this": {"name": "new"}, "subjects": {"x/y": both}}

    def test_the_ratio_is_this_revision_by_the_other(self):
        row = next(line for line in table.text(self.measured(1.0)) if line.startswith("x/y"))
        self.assertEqual(row.split()[1:5], ["0.500", "(0.500", "to", "0.500)"])
        self.assertEqual(row.split()[-2:], ["0.500", "2.000"])

    def test_a_busy_core_is_reported(self):
        self.assertNotIn("OTHER WORK", "\n".join(table.text(self.measured(1.0))))
        self.assertIn("OTHER WORK", "\n".join(table.text(self.measured(0.5))))


class Itself(unittest.TestCase):
    def compare(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "against.json"
            subprocess.run([ROOT / "bench/run.sh", "against", "HEAD", "thread", "--pairs", "5", "--json", path], check=True)
            return json.loads(path.read_text())["subjects"]["thread/free-120"]

    def drop_later(self, folder):
        """Each commit has a folder of its own: slow suites must not pile them up."""
        if not folder.is_dir():
            self.addCleanup(shutil.rmtree, folder, ignore_errors=True)

    @unittest.skipUnless(revision.git("rev-parse", "HEAD").returncode == 0, "this is no git checkout")
    def test_a_revision_is_as_fast_as_itself(self):
        self.drop_later(revision.FOLDER / revision.resolve("HEAD")[:12])
        seen = []
        for _ in range(TRIES):
            found = self.compare()
            if not revision.git("status", "--porcelain", "lib", "include").stdout:
                self.assertEqual(found["reference"]["hashes"], found["this"]["hashes"])
            seen.append([found["ratios"][name]["value"] for name in ("median", "sum")])
            if all(0.9 <= value <= 1.1 for value in seen[-1]):
                return
        self.fail(f"ratios of the median and of the sum: {seen}")


if __name__ == "__main__":
    chosen = sys.argv[1:] or ["Figures", "Runs", "Refusals", "Tables"]
    unittest.main(argv=[sys.argv[0], *chosen])
