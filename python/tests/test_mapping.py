"""Mapping: the program's numbers, and what a long call owes to Python."""

import os
import signal
import tarfile
import threading
import unittest

import numpy as np

import aisle
from support import WORK, refusal, run, simulated_log


def trajectory_of(tum):
    """(scans, 4) of a TUM file."""
    rows = np.loadtxt(tum)
    return np.column_stack([rows[:, :3], 2 * np.arctan2(rows[:, 6], rows[:, 7])])


def cells_of(pgm):
    """The image of a binary PGM."""
    words = pgm.read_bytes().split(maxsplit=4)
    width, height = int(words[1]), int(words[2])
    return np.frombuffer(pgm.read_bytes()[-width * height :], np.uint8).reshape(height, width)


class Maps(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.out = WORK / "map"
        cls.figures = run("map", simulated_log(), "--out", cls.out)["figures"]
        cls.map = aisle.map_recording(simulated_log())

    def test_are_those_of_the_program_to_the_digit(self):
        self.map.building().write(WORK / "building.json", force=True)
        self.assertEqual((WORK / "building.json").read_bytes(), (self.out / "building.json").read_bytes())
        np.testing.assert_allclose(self.map.trajectory, trajectory_of(self.out / "trajectory.tum"), atol=2e-6)
        np.testing.assert_array_equal(self.map.grid().cells, cells_of(self.out / "map.pgm"))

    def test_are_judged_as_by_the_program(self):
        self.assertEqual(self.map.trust, self.figures["trust"])
        self.assertEqual(self.map.trust_reason, self.figures["trust_reason"])
        self.assertEqual(len(self.map.walls), self.figures["walls"])
        self.assertEqual(len(self.map.loop_closures), self.figures["loop_closures"])
        self.assertEqual([problem._asdict() for problem in self.map.warnings], self.figures["warnings"])

    def test_are_views(self):
        poses = aisle.map_recording(simulated_log(), parameters={"adjustment_rounds": 1}).poses
        self.assertFalse(poses.flags.owndata)
        self.assertEqual(poses.shape, (len(self.map.recording), 3))
        np.testing.assert_array_equal(self.map.poses, self.map.trajectory[:, 1:])

    def test_of_archives_are_the_same(self):
        archive = WORK / "log.tar.gz"
        with tarfile.open(archive, "w:gz") as packed:
            packed.add(simulated_log(), "drive.log")
        packed = aisle.map_recording(archive)
        np.testing.assert_array_equal(packed.trajectory, self.map.trajectory)
        self.assertEqual(len(aisle.read_recording(archive)), len(packed.recording))

    def test_refuse_all_bad_parameters_at_once(self):
        with self.assertRaises(aisle.InputError) as refused:
            aisle.map_recording(simulated_log(), parameters={"loops.submap_m": -1, "no_such_key": 2})
        self.assertEqual(len(refused.exception.problems), 2)
        said = refusal("map", simulated_log(), "--set", "loops.submap_m=-1", "--set", "no_such_key=2")
        self.assertEqual(str(refused.exception).replace("parameters: ", "--set: "), said)

    def test_of_missing_files_are_an_os_error(self):
        with self.assertRaises(FileNotFoundError):
            aisle.map_recording(WORK / "none.bag")


class LongCalls(unittest.TestCase):
    def test_say_how_far_they_are(self):
        reports = []
        aisle.map_recording(simulated_log(), progress=lambda *report: reports.append(report))
        self.assertTrue(any(done == total > 0 for _, done, total in reports))
        self.assertTrue(all(isinstance(task, str) for task, _, _ in reports))

    def test_pass_on_what_the_users_function_raises(self):
        def stop(task, done, total):
            raise LookupError("enough")

        with self.assertRaisesRegex(LookupError, "enough"):
            aisle.map_recording(simulated_log(), progress=stop)

    def test_end_on_an_interrupt(self):
        # The signal comes from another thread, so while the call is at work.
        begun = threading.Event()
        interrupting = threading.Thread(target=lambda: begun.wait() and os.kill(os.getpid(), signal.SIGINT))
        interrupting.start()
        with self.assertRaises(KeyboardInterrupt):
            aisle.map_recording(simulated_log(), progress=lambda *report: begun.set())
        interrupting.join()

    def test_let_other_threads_run(self):
        done = threading.Event()
        ticks = 0

        def count():
            nonlocal ticks
            while not done.is_set():
                ticks += 1

        counting = threading.Thread(target=count)
        counting.start()
        before = ticks
        aisle.map_recording(simulated_log())
        after = ticks
        done.set()
        counting.join()
        self.assertGreater(after - before, 1000)


if __name__ == "__main__":
    unittest.main()
