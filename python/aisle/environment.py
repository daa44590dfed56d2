"""A simulated vehicle as an environment to learn in, in Gymnasium's form, without Gymnasium."""

import math
from typing import Any, NamedTuple, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._aisle import Command, Observation, SimulatedVehicle
from ._failures import InputError, Problem

Observed = dict[str, NDArray[np.float32]]
Info = dict[str, Any]

_ARRIVED_M = 0.5  # from the goal
_ARRIVAL_REWARD = 10.0
_COLLISION_REWARD = -10.0


class Box(NamedTuple):
    """Numbers between bounds, as Gymnasium's Box: gymnasium.spaces.Box(*box) is one."""

    low: NDArray[np.float32]
    high: NDArray[np.float32]
    shape: tuple[int, ...]
    dtype: Any

    def contains(self, values: Any) -> bool:
        """Whether an array has this shape and lies within the bounds."""
        array = np.asarray(values)
        return array.shape == self.shape and bool(np.all((array >= self.low) & (array <= self.high)))

    def sample(self, random: np.random.Generator) -> NDArray[np.float32]:
        """Uniformly random numbers between the bounds."""
        return random.uniform(self.low, self.high).astype(np.float32)


def _box(low: Sequence[float], high: Sequence[float]) -> Box:
    lows, highs = np.asarray(low, np.float32), np.asarray(high, np.float32)
    return Box(lows, highs, lows.shape, np.float32)


class Environment:
    """A vehicle with a range scanner in a simulated world: reset() and step() as Gymnasium has them.

    action: (2,) float32: speed [m/s], and the steering angle [rad] of a front-steered vehicle or the turn rate
        [rad/s] of a differential one; left positive. Beyond the bounds, it is clipped.
    observation: a dict of float32 arrays:
        ranges_m (beams,): the scan, right to left as Vehicle.scanner says; 0 nothing usable, the scanner's reach
            nothing seen. Where a cycle has no scan, the last one.
        motion (3,): x_m, y_m, heading_rad of the vehicle since the last step, by its wheels.
        goal (2,): distance [m] and direction [rad, left positive] of the goal from the vehicle, by the truth; only
            if there is a goal.
    reward: metres driven forwards; with a goal, metres by which the straight distance to it shrank, and 10 on
        arrival (0.5 m). A collision costs 10.
    terminated: arrived, or hit something. truncated: after `steps_max` steps.
    info: `truth` (Truth), `stamp_s`, `arrived`, `observation` (the whole Observation, with images).

    world, vehicle, scenario: files, or names of shipped ones (shipped()).
    start: (x_m, y_m, heading_rad) in `world`; None: the world's.
    goal: (x_m, y_m) in `world`, or the name of a place of the world; None: there is none.
    takes_images: cameras are traced by rays, which takes most of the time.
    """

    def __init__(
        self,
        world: str = "l-corridor",
        vehicle: str = "alv-scanner",
        *,
        scenario: str = "",
        start: Sequence[float] | None = None,
        goal: str | Sequence[float] | None = None,
        steps_max: int = 1000,
        takes_images: bool = False,
    ) -> None:
        self._simulated = SimulatedVehicle(
            world, vehicle, scenario=scenario, start=start, takes_images=takes_images
        )
        self.vehicle = self._simulated.vehicle  #: Vehicle that is simulated
        if self.vehicle.scanner is None:
            raise InputError([Problem("vehicle", f"'{vehicle}' has no range scanner")])
        if steps_max < 1:
            raise InputError([Problem("steps_max", f"is {steps_max}; needs 1 or more")])
        self._goal = self._goal_at(goal)
        self._steps_max = steps_max
        self._seed = 0
        self._steps = 0
        self._is_over = True
        self._ranges_m = np.zeros(self._simulated.beams, np.float32)
        self.action_space = self._action_space()  #: Box of the actions
        self.observation_space = self._observation_space()  #: {name: Box} of the observations

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Observed, Info]:
        """Sets the vehicle down at the start. seed: of all noise; None: the next one. options: not used."""
        self._seed = self._seed + 1 if seed is None else seed
        self._simulated.reset(self._seed)
        self._steps = 0
        self._is_over = False
        self._ranges_m = np.zeros_like(self._ranges_m)
        return self._sense()

    def step(self, action: ArrayLike) -> tuple[Observed, float, bool, bool, Info]:
        """Drives one cycle. Returns (observation, reward, terminated, truncated, info)."""
        if self._is_over:
            raise RuntimeError("the episode is over, or was not begun: call reset() first")
        before = self._simulated.truth
        self._simulated.act(self._command(action))
        observed, info = self._sense()
        self._steps += 1
        has_collided = info["truth"].collisions > 0
        terminated = has_collided or info["arrived"]
        truncated = not terminated and self._steps >= self._steps_max
        self._is_over = terminated or truncated
        reward = self._progress_m(before.pose, info["truth"].pose)
        reward += _ARRIVAL_REWARD * info["arrived"] + _COLLISION_REWARD * has_collided
        return observed, reward, terminated, truncated, info

    def close(self) -> None:
        """Does nothing: it is here because Gymnasium's environments have it."""

    def _goal_at(self, goal: str | Sequence[float] | None) -> NDArray[np.float64] | None:
        if goal is None:
            return None
        if isinstance(goal, str):
            places = self._simulated.places
            if goal not in places:
                raise InputError([Problem("goal", f"there is no place '{goal}', only {', '.join(places) or 'none'}")])
            return places[goal][:2]
        point = np.asarray(goal, float)
        if point.shape != (2,) or not np.all(np.isfinite(point)):
            raise InputError([Problem("goal", "needs the name of a place, or x_m, y_m")])
        return point

    def _action_space(self) -> Box:
        vehicle = self.vehicle
        turn_max = vehicle.turn_rate_max_rad_s if vehicle.is_differential else vehicle.steering_max_rad
        return _box([-vehicle.reverse_speed_max_mps, -turn_max], [vehicle.speed_max_mps, turn_max])

    def _observation_space(self) -> dict[str, Box]:
        assert self.vehicle.scanner is not None
        beams, reach_m = len(self._ranges_m), self.vehicle.scanner.range_max_m
        spaces = {
            "ranges_m": _box([0.0] * beams, [reach_m] * beams),
            "motion": _box([-math.inf, -math.inf, -math.pi], [math.inf, math.inf, math.pi]),
        }
        if self._goal is not None:
            spaces["goal"] = _box([0.0, -math.pi], [math.inf, math.pi])
        return spaces

    def _command(self, action: ArrayLike) -> Command:
        values = np.asarray(action, float)
        if values.shape != (2,) or not np.all(np.isfinite(values)):
            raise InputError([Problem("action", "needs two finite numbers: speed, and steering or turn rate")])
        speed, turn = np.clip(values, self.action_space.low, self.action_space.high)
        if self.vehicle.is_differential:
            return Command(speed_mps=speed, turn_rate_rad_s=turn)
        return Command(speed_mps=speed, steering_rad=turn)

    def _sense(self) -> tuple[Observed, Info]:
        observation = self._simulated.sense()
        truth = self._simulated.truth
        observed = self._observed(observation, truth.pose)
        arrived = self._goal is not None and bool(np.linalg.norm(self._goal - truth.pose[:2]) <= _ARRIVED_M)
        info = {"truth": truth, "stamp_s": observation.stamp_s, "arrived": arrived, "observation": observation}
        return observed, info

    def _observed(self, observation: Observation, pose: NDArray[np.float64]) -> Observed:
        assert self.vehicle.scanner is not None
        if observation.ranges_m is not None:
            self._ranges_m = np.minimum(observation.ranges_m, np.float32(self.vehicle.scanner.range_max_m))
        observed = {"ranges_m": self._ranges_m, "motion": self.vehicle.motion(observation).astype(np.float32)}
        if self._goal is not None:
            offset = self._goal - pose[:2]
            direction = math.remainder(math.atan2(offset[1], offset[0]) - pose[2], 2 * math.pi)
            observed["goal"] = np.array([np.linalg.norm(offset), direction], np.float32)
        return observed

    def _progress_m(self, before: NDArray[np.float64], after: NDArray[np.float64]) -> float:
        if self._goal is not None:
            return float(np.linalg.norm(self._goal - before[:2]) - np.linalg.norm(self._goal - after[:2]))
        step = after[:2] - before[:2]
        return float(step @ [math.cos(before[2]), math.sin(before[2])])
