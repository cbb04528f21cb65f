#!/usr/bin/env python3
"""The summary of all subjects, bench/run.sh summary: its judge of knots, its references, its comparison with peers."""
import math
import pathlib
import sys
import unittest

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT / "bench/summary"), str(ROOT / "bench/peers")]

import environments  # noqa: E402
import judge  # noqa: E402
import page  # noqa: E402
import points  # noqa: E402
import problem  # noqa: E402


def figure_eight():
    """Open, with its ends far along x."""
    t = np.linspace(0.02, 2 * math.pi - 0.02, 400)
    closed = np.stack([(2 + np.cos(2 * t)) * np.cos(3 * t), (2 + np.cos(2 * t)) * np.sin(3 * t), np.sin(4 * t)], axis=1)
    return np.concatenate(([closed[0] + [20, 0, 0]], closed, [closed[-1] + [20, 0, 0]]))


def point(method, cost, error, **other):
    return points.Point("thread", method, "", cost, error, method == "ours", **other)


class Judge(unittest.TestCase):
    def test_a_knot_is_known_by_its_determinant(self):
        self.assertEqual(judge.determinant(problem.trefoil_points(120)), 3)
        self.assertEqual(judge.determinant(problem.capstan_points(60)), 1)
        self.assertEqual(judge.determinant(figure_eight()), 5)

    def test_a_trefoil_whose_strands_pass_is_none(self):
        curve = problem.trefoil_points(120)
        curve[:, 0] *= 0.0  # its loops lie in a plane, and every strand is shifted aside a little
        curve[:, 0] = np.linspace(0.0, 1e-3, len(curve))
        self.assertEqual(judge.determinant(curve), 1)

    def test_min_distance_is_between_segments(self):
        u = np.array([[0.0, 0, 0], [10, 0, 0], [10, 5, 1], [5, 5, 1], [5, -5, 1]])
        self.assertAlmostEqual(judge.min_distance(u, 3.0), 1.0)

    def test_neighbours_do_not_count(self):
        self.assertEqual(judge.min_distance(np.array([[0.0, 0, 0], [1, 0, 0], [2, 0, 0]]), 1.0), math.inf)


class Problem(unittest.TestCase):
    def test_the_rope_law_has_no_error(self):
        less = problem.BENDING / (2.0 * problem.MIDDLE**2)
        pull = less + (problem.LOAD - less) * math.exp(problem.FRICTION * math.pi)
        self.assertAlmostEqual(problem.capstan_error_percent(pull), 0.0)
        self.assertAlmostEqual(problem.capstan_error_percent(problem.LOAD), 100.0)

    def test_a_pull_of_something_else_than_a_thread_on_a_cylinder_is_refused(self):
        shape = problem.capstan_points(30)
        problem.check_capstan(shape)
        for wrong in (1.2 * shape, shape + [problem.CYLINDER, 0.0, 0.0], math.nan * shape):
            with self.assertRaises(ArithmeticError):
                problem.check_capstan(wrong)

    def test_the_trefoil_ends_at_the_length_it_shall_take_up(self):
        shape = problem.trefoil_points(90)
        apart = np.linalg.norm(shape[-1] - shape[0]) + 2.0 * problem.KNOT_SPEED * problem.trefoil_seconds(shape)
        self.assertAlmostEqual(np.linalg.norm(np.diff(shape, axis=0), axis=1).sum() - apart, problem.TIGHT)


class Comparison(unittest.TestCase):
    def test_a_peer_is_better_where_nothing_of_ours_is_as_cheap_and_as_exact(self):
        listed = [point("ours", 1.0, 1.0), point("ours", 4.0, 0.1)]
        for cost, error, better in ((2.0, 2.0, False), (2.0, 0.5, True), (0.5, 9.0, True), (4.0, 0.1, False)):
            self.assertEqual(points.beats_us(point("peer", cost, error), listed), better)

    def test_a_lost_knot_beats_none(self):
        self.assertFalse(points.beats_us(point("peer", 0.1, 0.0, note="lost"), [point("ours", 1.0, 1.0)]))

    def test_the_page_names_better_peers_and_what_was_not_measured(self):
        text = page.page([point("ours", 1.0, 1.0), point("peer", 0.5, 0.5)], [("other peer", "no index")], [], {}, False)
        self.assertIn("A peer is ahead here", text)
        self.assertIn("| other peer | no index |", text)
        text = page.page([point("ours", 1.0, 1.0), point("peer", 2.0, 2.0)], [], [], {}, False)
        self.assertIn("For every setting of a peer", text)
        text = page.page([point("peer", 2.0, 2.0)], [], [], {}, False)
        self.assertNotIn("For every setting of a peer", text)
        self.assertIn("No setting of ours was measured", text)

    def test_a_failed_case_is_reported(self):
        skipped = []
        failed = {"peer": "rod", "subject": "thread", "segments": 3, "step_us": 1.0, "failed": "unstable"}
        self.assertEqual(list(points.peer_points([failed], skipped)), [])
        self.assertEqual(skipped, [("thread: rod, 3 segments, 1 us", "unstable")])

    def test_the_readme_has_the_marks(self):
        readme = (ROOT / "README.md").read_text(encoding="utf-8")
        text = page.quoted(readme, [point("ours", 1.0, 1.0), point("peer", 2.0, 2.0)])
        self.assertIn("2 s/s, 2 (peer)", text)
        self.assertEqual(page.quoted(text, []).count(page.END), 1)
        self.assertRaises(ValueError, page.quoted, "no marks", [])


class Peers(unittest.TestCase):
    def test_every_package_is_pinned_and_every_peer_has_its_module(self):
        listed = environments.listed()
        self.assertGreater(len(listed), 2)
        for peer, packages in listed:
            self.assertTrue((ROOT / f"bench/peers/{peer}.py").exists())
            self.assertTrue(packages and all("==" in package for package in packages))


if __name__ == "__main__":
    unittest.main()
