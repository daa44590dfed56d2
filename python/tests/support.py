"""What the tests share: the program to compare with, and recordings that it has simulated."""

import functools
import json
import os
import pathlib
import subprocess
import tempfile

import numpy as np

SOURCE = pathlib.Path(os.environ["AISLE_SOURCE"])
PROGRAM = os.environ["AISLE_PROGRAM"]

_work = tempfile.TemporaryDirectory(prefix="aisle-python-")
WORK = pathlib.Path(_work.name)


def run(*arguments):
    """Runs the program, which must end well; its JSON."""
    words = [PROGRAM, *map(str, arguments), "--json", "--quiet"]
    return json.loads(subprocess.run(words, check=True, capture_output=True, text=True).stdout)


def refusal(*arguments):
    """What the program says when it refuses its input."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == 2, done
    return done.stderr.strip()


@functools.lru_cache(maxsize=None)
def simulated_log():
    """A simulated drive along a corridor and round its corner."""
    run("sim", "log", "l-corridor", "--seed", 1, "--out", WORK / "log")
    return WORK / "log" / "simulated-trip.log"


@functools.lru_cache(maxsize=None)
def corridor_view():
    """The picture of a simulated corridor."""
    run("sim", "render", "l-corridor", "--out", WORK / "view.png")
    return WORK / "view.png"


def cast(corners, pose, angles_rad):
    """Points in the sensor's frame that beams hit on the closed polygon of `corners`."""
    corners = np.asarray(corners, float)
    starts, along = corners, np.roll(corners, -1, axis=0) - corners
    points = []
    for angle in angles_rad:
        ray = np.array([np.cos(pose[2] + angle), np.sin(pose[2] + angle)])
        to_start = starts - pose[:2]
        parallel = ray[0] * along[:, 1] - ray[1] * along[:, 0]
        with np.errstate(divide="ignore", invalid="ignore"):
            ranges = (to_start[:, 0] * along[:, 1] - to_start[:, 1] * along[:, 0]) / parallel
            shares = (to_start[:, 0] * ray[1] - to_start[:, 1] * ray[0]) / parallel
        hit = ranges[(ranges > 0) & (shares >= 0) & (shares <= 1)].min()
        points.append(hit * np.array([np.cos(angle), np.sin(angle)]))
    return np.array(points)
