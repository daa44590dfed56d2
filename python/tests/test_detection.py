"""Features in images given as arrays."""

import unittest

import numpy as np

import aisle
from support import corridor_view, run


class Detection(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.image = aisle.read_image(corridor_view())
        cls.lines = aisle.LineFinder().find(cls.image)

    def test_finds_the_vertical_lines_of_the_program(self):
        found = run("detect", "verticals", corridor_view())["figures"]["images"][0]["verticals"]
        self.assertGreater(len(found), 3)
        ends = np.array([line["top"] + line["bottom"] for line in found])
        np.testing.assert_allclose(self.lines.verticals, ends, atol=6e-4)
        self.assertEqual(list(self.lines.has_floor_point), [line["foot"] for line in found])
        self.assertEqual(len(self.lines.contrasts), len(found))

    def test_finds_the_wall_floor_edges_of_the_program(self):
        found = run("detect", "baselines", corridor_view())["figures"]["images"][0]
        self.assertIsNotNone(found["right_baseline"])
        for line, name in ((self.lines.left_base_line, "left"), (self.lines.right_base_line, "right")):
            np.testing.assert_allclose(line, found[name + "_baseline"], atol=6e-4)

    def test_finds_the_floor_of_the_program(self):
        mask = aisle.detect_floor(self.image)
        self.assertEqual(mask.shape, self.image.shape[:2])
        share = run("detect", "region", corridor_view())["figures"]["images"][0]["region_share"]
        self.assertAlmostEqual(np.mean(mask == 255), share, places=3)

    def test_takes_images_however_they_lie_in_memory(self):
        turned = np.ascontiguousarray(self.image[::-1])[::-1]
        np.testing.assert_array_equal(aisle.LineFinder().find(turned).verticals, self.lines.verticals)

    def test_refuses_what_is_no_image(self):
        for wrong in (self.image.astype(float), self.image.reshape(-1), np.zeros((0, 4), np.uint8),
                      np.zeros((4, 4, 2), np.uint8)):
            with self.assertRaisesRegex(ValueError, "needs .height, width. or .height, width, 3. of uint8"):
                aisle.detect_floor(wrong)

    def test_refuses_unknown_parameters(self):
        with self.assertRaisesRegex(aisle.InputError, "verticals.no_such: unknown key"):
            aisle.LineFinder({"verticals.no_such": 1})


if __name__ == "__main__":
    unittest.main()
