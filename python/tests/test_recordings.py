"""Recordings as arrays."""

import gc
import pickle
import unittest

import numpy as np

import aisle
from support import SOURCE, WORK, refusal, simulated_log


class Recordings(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.recording = aisle.read_recording(simulated_log())

    def test_have_every_scan_of_the_file_and_its_odometry(self):
        lines = simulated_log().read_text().splitlines()
        scans = [line.split() for line in lines if line.startswith("FLASER")]
        self.assertEqual(len(self.recording), len(scans))
        beams = int(scans[7][1])
        odometry = np.array([scan[2 + beams + 3 : 2 + beams + 6] for scan in scans], float)
        np.testing.assert_allclose(self.recording.odometry[:, 1:], odometry, atol=1e-6)
        np.testing.assert_array_equal(self.recording[7].ranges_m, np.array(scans[7][2 : 2 + beams], np.float32))

    def test_give_views_that_outlive_them(self):
        scan = aisle.read_recording(simulated_log())[0]
        ranges_m, odometry = scan.ranges_m, aisle.read_recording(simulated_log()).odometry
        for view in (ranges_m, odometry):
            self.assertFalse(view.flags.owndata)
            self.assertFalse(view.flags.writeable)
        before = ranges_m.copy()
        del scan
        gc.collect()
        np.testing.assert_array_equal(ranges_m, before)
        np.testing.assert_array_equal(odometry, self.recording.odometry)

    def test_give_all_ranges_as_one_matrix(self):
        matrix = self.recording.ranges_m()
        self.assertEqual(matrix.shape, (len(self.recording), len(self.recording[0].ranges_m)))
        for index in (0, len(matrix) - 1):
            np.testing.assert_array_equal(matrix[index], self.recording[index].ranges_m)

    def test_are_sequences(self):
        self.assertEqual(sum(1 for _ in self.recording), len(self.recording))
        self.assertEqual(self.recording[-1].stamp_s, self.recording.stamps_s[-1])
        with self.assertRaises(IndexError):
            self.recording[len(self.recording)]

    def test_give_points_where_the_beams_hit(self):
        scan = self.recording[3]
        hit = (scan.ranges_m > 0) & (scan.ranges_m < min(20, scan.laser.range_max_m))
        ranges_m, angles_rad = scan.ranges_m[hit].astype(float), scan.angles_rad[hit]
        expected = np.column_stack([ranges_m * np.cos(angles_rad), ranges_m * np.sin(angles_rad)])
        np.testing.assert_allclose(scan.points_m(), expected, atol=1e-9)


class BadRecordings(unittest.TestCase):
    def test_are_refused_in_the_words_of_the_program(self):
        text = SOURCE / "README.md"
        with self.assertRaises(aisle.InputError) as refused:
            aisle.read_recording(text)
        self.assertEqual(str(refused.exception), refusal("map", text))
        self.assertIsInstance(refused.exception, ValueError)
        self.assertEqual(refused.exception.problems[0].where, str(text))

    def test_are_refused_alike_in_another_process(self):
        refused = aisle.InputError([aisle.Problem("a.log:3", "is no scan"), aisle.Problem("", "is empty")])
        again = pickle.loads(pickle.dumps(refused))
        self.assertEqual((str(again), again.problems), ("a.log:3: is no scan\nis empty", refused.problems))

    def test_that_are_not_there_are_an_os_error(self):
        with self.assertRaises(FileNotFoundError) as refused:
            aisle.read_recording(WORK / "none.log")
        self.assertEqual(refused.exception.filename, str(WORK / "none.log"))

    def test_options_are_checked(self):
        with self.assertRaisesRegex(aisle.InputError, "units: is 'inch', not m, cm or mm"):
            aisle.read_recording(simulated_log(), units="inch")
        for offset in ((1, 2), (float("nan"), 0, 0), "here"):
            with self.assertRaisesRegex(ValueError, "laser_offset: needs three numbers"):
                aisle.read_recording(simulated_log(), laser_offset=offset)


if __name__ == "__main__":
    unittest.main()
