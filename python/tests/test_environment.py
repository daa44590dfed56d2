"""The simulator as an environment to learn in."""

import unittest

import numpy as np

import aisle


def episode(environment, seed, actions):
    observed, _ = environment.reset(seed=seed)
    steps = [environment.step(action) for action in actions]
    return [observed["ranges_m"], *(step[0]["ranges_m"] for step in steps)], [step[1] for step in steps]


class Environments(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.environment = aisle.Environment("l-corridor", goal="corner", steps_max=20)

    def test_have_the_form_of_gymnasium(self):
        environment = self.environment
        observed, info = environment.reset(seed=3)
        self.assertEqual(set(observed), set(environment.observation_space))
        for _ in range(5):
            action = environment.action_space.sample(np.random.default_rng(1))
            self.assertTrue(environment.action_space.contains(action))
            observed, reward, terminated, truncated, info = environment.step(action)
            for name, space in environment.observation_space.items():
                self.assertTrue(space.contains(observed[name]), name)
                self.assertEqual(observed[name].dtype, space.dtype)
            self.assertIsInstance(reward, float)
            self.assertIsInstance(terminated, bool)
            self.assertIsInstance(truncated, bool)

    def test_repeat_themselves_by_their_seeds(self):
        actions = [(0.5, 0.1)] * 10
        first, second, other = (episode(self.environment, seed, actions) for seed in (7, 7, 8))
        np.testing.assert_array_equal(first[0], second[0])
        self.assertEqual(first[1], second[1])
        self.assertFalse(np.array_equal(first[0], other[0]))

    def test_do_not_change_what_they_gave(self):
        observed, info = self.environment.reset(seed=1)
        ranges_m, pose = observed["ranges_m"].copy(), info["truth"].pose
        truth = info["truth"]
        for _ in range(10):
            self.environment.step((1.0, 0.0))
        self.environment.reset()
        np.testing.assert_array_equal(observed["ranges_m"], ranges_m)
        np.testing.assert_array_equal(truth.pose, pose)

    def test_reward_what_brings_the_goal_nearer(self):
        self.environment.reset(seed=1)
        before = self.environment.step((1.0, 0.0))[4]["truth"].pose
        rewards = [self.environment.step((1.0, 0.0)) for _ in range(10)]
        after = rewards[-1][4]["truth"].pose
        goal = np.array([14.95, 1.05])
        nearer_m = np.linalg.norm(goal - before[:2]) - np.linalg.norm(goal - after[:2])
        self.assertAlmostEqual(sum(step[1] for step in rewards), nearer_m, places=9)
        self.assertGreater(nearer_m, 0)

    def test_end_after_their_steps_and_then_must_be_reset(self):
        self.environment.reset(seed=1)
        ends = [self.environment.step((0.0, 0.0))[2:4] for _ in range(20)]
        self.assertEqual(ends, [(False, False)] * 19 + [(False, True)])
        with self.assertRaisesRegex(RuntimeError, "reset"):
            self.environment.step((0.0, 0.0))

    def test_end_where_the_goal_is(self):
        environment = aisle.Environment("l-corridor", start=(10, 1.05, 0), goal=(10.8, 1.05))
        environment.reset(seed=1)
        step = environment.step((1.0, 0.0))
        while not (step[2] or step[3]):
            step = environment.step((1.0, 0.0))
        self.assertTrue(step[4]["arrived"])
        self.assertGreater(step[1], 9)

    def test_end_at_a_collision(self):
        environment = aisle.Environment("l-corridor", start=(14, 1.05, 0), steps_max=200)
        environment.reset(seed=1)
        step = environment.step((1.0, 0.0))
        while not (step[2] or step[3]):
            step = environment.step((1.0, 0.0))
        self.assertEqual((step[2], step[4]["truth"].collisions), (True, 1))
        self.assertLess(step[1], -9)

    def test_drive_differential_vehicles_too(self):
        environment = aisle.Environment("l-corridor", "turtlebot")
        environment.reset(seed=1)
        for _ in range(10):
            info = environment.step((0.0, 1.0))[4]
        self.assertGreater(info["truth"].pose[2], 0.2)

    def test_give_images_where_asked(self):
        environment = aisle.Environment("l-corridor", takes_images=True)
        _, info = environment.reset(seed=1)
        image = info["observation"].images["corridor"]
        self.assertEqual(image.shape, environment.vehicle.cameras["corridor"])
        self.assertGreater(image.std(), 5)

    def test_refuse_what_cannot_be(self):
        for words, keywords in (
            ("no such file, nor one of the shipped worlds", {"world": "nowhere"}),
            ("has no range scanner", {"vehicle": "alv"}),
            ("there is no place 'x', only west end", {"goal": "x"}),
            ("needs the name of a place, or x_m, y_m", {"goal": (1, 2, 3)}),
            ("the vehicle does not fit there", {"start": (0, 0, 0)}),
            ("steps_max: is 0", {"steps_max": 0}),
        ):
            with self.assertRaisesRegex(aisle.InputError, words):
                aisle.Environment(**keywords)
        self.environment.reset(seed=1)
        for action in ((1.0,), (float("nan"), 0.0)):
            with self.assertRaisesRegex(aisle.InputError, "action: needs two finite numbers"):
                self.environment.step(action)


if __name__ == "__main__":
    unittest.main()
