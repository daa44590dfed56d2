"""A navigator of one's own: along a corridor until something is near ahead. write_a_navigator.py [WORLD [CONNECTION]]

The simulator drives it; with the connection file of a robot that speaks ROS 2, the robot does.
"""

import sys

import numpy as np
from numpy.typing import NDArray

import aisle


class StopsBeforeWalls:
    """Keeps to the middle between what is on its left and on its right."""

    def __init__(self) -> None:
        self.nearest_m = 0.0  # before the first scan it is done at once: better than driving blind
        self.steering_rad = 0.0

    def step(self, observation: aisle.Observation) -> aisle.Command | aisle.Decision:
        if observation.bumper_pressed:
            return aisle.Decision(status="failed", why="touched something")
        if observation.ranges_m is not None:
            self.look(observation.ranges_m)
        if self.nearest_m < 1:
            return aisle.Decision(status="done", state="there")
        return aisle.Command(speed_mps=min(0.5, self.nearest_m - 0.9), steering_rad=self.steering_rad)

    def look(self, ranges_m: NDArray[np.float32]) -> None:
        seen_m = np.where(ranges_m > 0, ranges_m, np.inf)  # 0 says nothing
        fifth = len(seen_m) // 5
        self.nearest_m = float(seen_m[2 * fifth : 3 * fifth].min())
        right_m, left_m = seen_m[:fifth].min(), seen_m[-fifth:].min()
        self.steering_rad = float(np.clip(0.3 * (left_m - right_m), -0.2, 0.2))


world = sys.argv[1] if len(sys.argv) > 1 else "l-corridor"
if len(sys.argv) > 2:
    result = aisle.drive(StopsBeforeWalls(), connect=sys.argv[2])
else:
    result = aisle.drive(StopsBeforeWalls(), world, takes_images=False, duration_max_s=120)
outcome = "done" if result.arrived else "failed"
print(f"{outcome}: {result.state} {result.why}after {result.distance_m:.1f} m, {result.collisions} collisions")
sys.exit(0 if result.arrived else 1)
