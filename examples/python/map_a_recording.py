"""A wall map from a recorded laser log or bag: map_a_recording.py RECORDING BUILDING.json"""

import sys

import numpy as np

import aisle

if len(sys.argv) != 3:
    sys.exit(__doc__)
recording, building = sys.argv[1:]


def show(task: str, done: int, total: int) -> None:
    print(f"\r{task}: {done} of {total or '?'}", end="", file=sys.stderr)


mapped = aisle.map_recording(recording, progress=show)
print(file=sys.stderr)
for warning in mapped.warnings:
    print(f"warning: {warning}")

trajectory = mapped.trajectory  # stamp_s, x_m, y_m, heading_rad of every scan
driven_m = np.hypot(*np.diff(trajectory[:, 1:3], axis=0).T).sum()
lengths_m = np.hypot(*(mapped.walls[:, 2:] - mapped.walls[:, :2]).T)
grid = mapped.grid()
free_m2 = (grid.cells == 254).sum() * grid.resolution_m**2
print(f"{len(trajectory)} scans, {driven_m:.1f} m of path")
print(f"{len(lengths_m)} walls, {lengths_m.sum():.1f} m long together; {free_m2:.0f} m2 of floor were seen free")
print(f"trust: {mapped.trust} ({mapped.trust_reason})")
mapped.building().write(building, force=True)
