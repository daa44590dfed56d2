"""Building files as arrays."""

import json
import unittest

import numpy as np

import aisle
from support import SOURCE, WORK, refusal

GOLDEN = SOURCE / "tests" / "golden"


def read(name):
    """A golden file as aisle reads it, and as JSON."""
    return aisle.read_building(GOLDEN / name), json.loads((GOLDEN / name).read_text())


class Buildings(unittest.TestCase):
    def test_have_the_walls_and_landmarks_of_the_file(self):
        building, file = read("building.v3.json")
        self.assertEqual(building.name, file["name"])
        ends = [wall["start_m"] + wall["end_m"] for wall in file["walls"]]
        np.testing.assert_array_equal(building.walls, ends)
        self.assertFalse(building.walls.flags.owndata)
        self.assertFalse(building.walls.flags.writeable)

    def test_have_corridors_between_named_nodes(self):
        building, file = read("building_corridors.v3.json")
        self.assertEqual(len(building.nodes), len(file["corridors"]["nodes"]))
        for start, end, path, width_m in building.corridors:
            np.testing.assert_allclose(path[0], building.nodes[start], atol=1e-9)
            np.testing.assert_allclose(path[-1], building.nodes[end], atol=1e-9)
            self.assertGreater(width_m, 0)

    def test_have_floor_as_an_image_with_its_top_row_first(self):
        building, _ = read("building_corridors.v3.json")
        o, u, f = 0, 205, 254  # occupied, unknown, free; in the file, rows go up: 5#, 1#3.1#, 1#1.2-1#, (none), 4-1.
        rows = [[u, u, u, u, f], [u, u, u, u, u], [o, f, u, u, o], [o, f, f, f, o], [o, o, o, o, o]]
        np.testing.assert_array_equal(building.floor.cells, np.array(rows, np.uint8))
        np.testing.assert_allclose(building.floor.origin_m, (-2 * 0.05, 7 * 0.05))

    def test_have_routes_as_poses(self):
        building, file = read("building_routes.v3.json")
        self.assertEqual(set(building.routes), {route["name"] for route in file["routes"]})
        for poses in building.routes.values():
            self.assertEqual(poses.shape[1], 3)

    def test_have_places_with_and_without_a_heading(self):
        file = json.loads((GOLDEN / "building_corridors.v3.json").read_text())
        del file["places"][1]["heading_deg"]
        (WORK / "places.json").write_text(json.dumps(file))
        places = aisle.read_building(WORK / "places.json").places
        self.assertEqual(set(places), {"home", "lift"})
        np.testing.assert_allclose(places["home"], (0.5, 0.02, np.radians(-1.5)), atol=1e-9)
        self.assertEqual(places["lift"], (4, 6, None))

    def test_are_written_as_they_were_read(self):
        for name in ("building.v3.json", "building_corridors.v3.json", "building_routes.v3.json"):
            building, _ = read(name)
            building.write(WORK / name)
            self.assertEqual((WORK / name).read_bytes(), (GOLDEN / name).read_bytes())
            with self.assertRaisesRegex(aisle.InputError, "exists already"):
                building.write(WORK / name)

    def test_are_refused_in_the_words_of_the_program(self):
        broken = WORK / "broken.json"
        broken.write_text('{"format": "aisle.building", "version": 3, "walls": [{"start_m": "here"}]}')
        with self.assertRaises(aisle.InputError) as refused:
            aisle.read_building(broken)
        self.assertEqual(str(refused.exception), refusal("show", broken))
        with self.assertRaises(FileNotFoundError):
            aisle.read_building(WORK / "none.json")


if __name__ == "__main__":
    unittest.main()
