"""Scans fitted to each other."""

import unittest

import numpy as np

import aisle
from support import cast

ROOM = [(0, 0), (6.5, 0), (8, 1.5), (8, 6), (3, 6), (3, 7), (2, 7), (2, 6), (0, 6)]
BEAMS = np.radians(np.arange(-135, 136))


def seen_from(pose):
    return cast(ROOM, np.array(pose), BEAMS)


class Matching(unittest.TestCase):
    def test_finds_where_a_scan_was_taken(self):
        reference, moved = (3.0, 2.0, 0.3), (3.4, 2.3, 0.6)
        match = aisle.match_scans(seen_from(reference), seen_from(moved))
        turned = np.array([[np.cos(0.3), np.sin(0.3)], [-np.sin(0.3), np.cos(0.3)]])
        expected = [*(turned @ (np.array(moved) - reference)[:2]), 0.3]
        np.testing.assert_allclose(match.pose, expected, atol=0.005)
        self.assertGreater(match.share, 0.9)

    def test_of_a_scan_with_itself_does_not_move(self):
        match = aisle.match_scans(seen_from((3, 2, 0)), seen_from((3, 2, 0)), reach_m=0, reach_rad=0)
        np.testing.assert_allclose(match.pose, np.zeros(3), atol=1e-9)
        self.assertTrue(np.all(np.linalg.eigvalsh(match.information) > 0))

    def test_searches_around_the_guess(self):
        guess = (2.0, -1.0, 0.0)
        match = aisle.match_scans(seen_from((2, 3, 0)), seen_from((4, 2, 0)), guess, reach_m=0.3)
        np.testing.assert_allclose(match.pose, guess, atol=0.02)

    def test_says_so_where_there_is_no_surface(self):
        for points in (np.zeros((0, 2)), [[1.0, 2.0]]):
            with self.assertRaisesRegex(aisle.InputError, "points: shows no surface"):
                aisle.match_scans(seen_from((3, 2, 0)), points)

    def test_refuses_what_are_no_points(self):
        for points in (np.zeros((5, 3)), [[1, float("nan")]], [[1e300, 0]], "points"):
            with self.assertRaisesRegex(ValueError, "reference_points: needs a .points, 2. array"):
                aisle.match_scans(points, seen_from((3, 2, 0)))
        with self.assertRaisesRegex(aisle.InputError, "reach_m: is not from 0 to 5"):
            aisle.match_scans(seen_from((3, 2, 0)), seen_from((3, 2, 0)), reach_m=1e9)


if __name__ == "__main__":
    unittest.main()
