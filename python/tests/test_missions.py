"""Navigators in Python drive, and their sessions are read back."""

import unittest

import numpy as np

import aisle
from support import WORK


class Straight:
    """Drives straight on for so many cycles, and keeps what it saw."""

    def __init__(self, cycles):
        self.cycles = cycles
        self.seen = []

    def step(self, observation):
        self.seen.append(observation)
        if len(self.seen) > self.cycles:
            return aisle.Decision(status="done", state="there", why="far enough")
        return aisle.Command(speed_mps=0.5)


class Missions(unittest.TestCase):
    def test_are_driven_by_an_object_with_a_step(self):
        navigator = Straight(30)
        result = aisle.drive(navigator, "l-corridor", takes_images=False)
        self.assertTrue(result.arrived)
        self.assertEqual((result.state, result.why, result.cycles), ("there", "far enough", 31))
        self.assertAlmostEqual(result.distance_m, result.truth.path_m)
        self.assertGreater(result.distance_m, 0.8)
        self.assertEqual(result.collisions, 0)
        self.assertEqual(len(navigator.seen), 31)

    def test_are_recorded_as_sessions(self):
        navigator = Straight(10)
        aisle.drive(navigator, "l-corridor", takes_images=False, seed=5, out=WORK / "session")
        session = aisle.read_session(WORK / "session")
        self.assertEqual((session.navigator, session.seed, session.is_simulated), ("python", 5, True))
        cycles = list(session)
        self.assertEqual(len(cycles), 11)
        for seen, (observation, decision) in zip(navigator.seen, cycles):
            self.assertEqual(observation.stamp_s, seen.stamp_s)
            self.assertEqual(observation.odometry, seen.odometry)
            if seen.ranges_m is None:
                self.assertIsNone(observation.ranges_m)
            else:
                np.testing.assert_array_equal(observation.ranges_m, seen.ranges_m)
        self.assertEqual([decision.status for _, decision in cycles], ["going"] * 10 + ["done"])
        self.assertEqual(cycles[3][1].command, aisle.Command(speed_mps=0.5))
        with self.assertRaisesRegex(aisle.InputError, "is not empty"):
            aisle.drive(navigator, "l-corridor", out=WORK / "session")

    def test_give_images_without_copies(self):
        navigator = Straight(1)
        aisle.drive(navigator, "l-corridor", vehicle="alv")
        image = navigator.seen[0].images["corridor"]
        self.assertFalse(image.flags.owndata)
        self.assertFalse(image.flags.writeable)
        self.assertEqual(image.shape[:2], (480, 640))

    def test_end_with_what_a_navigator_raises(self):
        class Breaks:
            def step(self, observation):
                raise ZeroDivisionError("in step")

        with self.assertRaisesRegex(ZeroDivisionError, "in step"):
            aisle.drive(Breaks(), "l-corridor", takes_images=False)

    def test_refuse_what_is_no_decision(self):
        class Silent:
            def step(self, observation):
                return None

        with self.assertRaisesRegex(TypeError, "not an aisle.Command or an aisle.Decision"):
            aisle.drive(Silent(), "l-corridor", takes_images=False)
        with self.assertRaises(AttributeError):
            aisle.drive(object(), "l-corridor")
        with self.assertRaisesRegex(ValueError, "status: is 'ready', not going, done or failed"):
            aisle.Decision(status="ready")

    def test_end_when_their_time_is_up(self):
        result = aisle.drive(Straight(10**9), "l-corridor", takes_images=False, duration_max_s=2)
        self.assertFalse(result.arrived)
        self.assertEqual(result.state, "time-out")
        self.assertAlmostEqual(result.duration_s, 2, delta=0.15)

    def test_need_one_vehicle(self):
        for keywords in ({}, {"world": "l-corridor", "connect": WORK / "robot.yaml"}):
            with self.assertRaisesRegex(aisle.InputError, "name a world to simulate, or"):
                aisle.drive(Straight(1), **keywords)
        with self.assertRaises(FileNotFoundError):
            aisle.drive(Straight(1), connect=WORK / "robot.yaml")


if __name__ == "__main__":
    unittest.main()
