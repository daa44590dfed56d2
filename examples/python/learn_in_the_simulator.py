"""Learns to drive round a corner: learn_in_the_simulator.py

A linear policy of four numbers, found by the cross-entropy method: draw policies, keep the best, draw around them.
"""

import numpy as np
from numpy.typing import NDArray

import aisle

ROUNDS, DRAWN, KEPT = 4, 12, 3
SECTORS = 6  # the scan is summarised by what is nearest in each, from right to left

environment = aisle.Environment("l-corridor", start=(10.0, 1.05, 0.0), goal=(14.95, 5.0), steps_max=250)


def features(observed: dict[str, NDArray[np.float32]]) -> NDArray[np.float64]:
    """Mirrored: how much more room there is on the left than on the right, near, between and ahead; the goal."""
    seen_m = np.where(observed["ranges_m"] > 0, observed["ranges_m"], 30.0)
    nearest_m = np.array([part.min() for part in np.array_split(seen_m, SECTORS)]).clip(0, 4)
    half = SECTORS // 2
    return np.append(nearest_m[half:][::-1] - nearest_m[:half], observed["goal"][1])


def drive(policy: NDArray[np.float64], seed: int) -> tuple[float, bool]:
    """The return of one episode, and whether it arrived."""
    observed, info = environment.reset(seed=seed)
    total, is_over = 0.0, False
    while not is_over:
        action = np.array([0.5, features(observed) @ policy])
        observed, reward, terminated, truncated, info = environment.step(action)
        total += reward
        is_over = terminated or truncated
    return total, info["arrived"]


random = np.random.default_rng(1)
mean, deviation = np.zeros(SECTORS // 2 + 1), np.full(SECTORS // 2 + 1, 0.4)
for number in range(ROUNDS):
    policies = random.normal(mean, deviation, (DRAWN, len(mean)))
    returns = np.array([drive(policy, seed=number)[0] for policy in policies])
    best = policies[np.argsort(returns)[-KEPT:]]
    mean, deviation = best.mean(axis=0), best.std(axis=0) + 0.02
    print(f"round {number + 1}: return {returns.mean():.1f} on average, {returns.max():.1f} at best")
total, arrived = drive(mean, seed=100)
print(f"learned {mean.round(2)}: return {total:.1f}, arrived: {arrived}")
