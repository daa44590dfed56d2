#!/usr/bin/env python3
"""Drives a method under forty faults, single and in pairs (simulated), and prints what became of each mission.

usage: benchmarks/fault_pairs.py AISLE METHOD WORLD SEED      for example: build/release/bin/aisle landmarks l-corridor 401
"""

import json
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from os import cpu_count
from pathlib import Path

LASTING = {
    "late 0.2 s": "camera: {fault: late, delay_s: 0.2}",
    "late 0.4 s": "camera: {fault: late, delay_s: 0.4}",
    "dark": "camera: {fault: dark}",
    "frozen": "camera: {fault: frozen}",
    "dropped": "camera: {fault: dropped}",
    "steering 3 deg": "steering: {bias_deg: 3}",
    "steering 6 deg": "steering: {bias_deg: 6}",
    "steering -6 deg": "steering: {bias_deg: -6}",
    "wheels count half": "slip: {spin: -0.5}",
    "wheels count twice": "slip: {spin: 1.0}",
    "wheels count 1.15": "slip: {spin: 0.15}",
    "light 0.3": "light: {light: 0.3}",
    "lamps off": "light: {light: 0.5, lamps: off}",
    "laser off": "laser_off: {}",
}
BRIEF = {
    "dark for 2 s": "for_s: 2, camera: {fault: dark}",
    "frozen for 1 s": "for_s: 1, camera: {fault: frozen}",
    "dropped for 3 s": "for_s: 3, camera: {fault: dropped}",
    "wheels count twice for 2 s": "for_s: 2, slip: {spin: 1.0}",
}
FAULTS = LASTING | BRIEF
PAIRS = [
    ("late 0.4 s", "steering 6 deg"),
    ("late 0.4 s", "steering -6 deg"),
    ("late 0.4 s", "wheels count 1.15"),
    ("late 0.4 s", "wheels count twice for 2 s"),
    ("steering 6 deg", "wheels count 1.15"),
    ("steering 6 deg", "wheels count twice for 2 s"),
    ("steering 6 deg", "dark for 2 s"),
    ("steering -6 deg", "dark for 2 s"),
    ("steering 6 deg", "frozen for 1 s"),
    ("steering 6 deg", "dropped for 3 s"),
    ("wheels count 1.15", "dark for 2 s"),
    ("wheels count 1.15", "frozen for 1 s"),
    ("wheels count half", "steering 3 deg"),
    ("wheels count twice", "steering 3 deg"),
    ("light 0.3", "steering 6 deg"),
    ("light 0.3", "late 0.4 s"),
    ("lamps off", "wheels count 1.15"),
    ("late 0.2 s", "steering 6 deg"),
    ("late 0.2 s", "wheels count half"),
    ("frozen for 1 s", "wheels count twice for 2 s"),
    ("dark for 2 s", "wheels count twice for 2 s"),
    ("laser off", "steering 6 deg"),
]
FIRST_S, LATER_S = 8, 4  # of autonomous driving: the first fault begins, the second one so much later


def scenario(names):
    events = [f"  - {{from_s: {FIRST_S + LATER_S * i}, {FAULTS[name]}}}\n" for i, name in enumerate(names)]
    return "format: aisle.scenario\nversion: 1\nname: faults\nevents:\n" + "".join(events)


def drive(program, method, world, seed, names):
    with tempfile.TemporaryDirectory() as folder:
        faults = Path(folder) / "faults.yaml"
        faults.write_text(scenario(names))
        command = [program, "trial", method, "--world", world, "--seeds", seed, "--jobs", "1", "--json"]
        done = subprocess.run([*command, "--faults", faults], capture_output=True, text=True, check=False)
        answer = json.loads(done.stdout) if done.stdout else {}
        if "figures" not in answer:
            sys.exit(f"{sys.argv[0]}: no mission under {' and '.join(names)}: {done.stderr.strip()}")
        return answer["figures"]


def outcome(run):
    """How a mission ended, in the words of its method."""
    ended = run.get("ended_because") or run["state"]
    why = f" ({run['why']})" if run.get("why") else ""
    return f"{ended}{why}, {run['distance_m']:.1f} m" + (", TOUCHED" if run["collisions"] else "")


def main():
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    program, method, world, seed = sys.argv[1:]
    cases = [(name,) for name in FAULTS] + PAIRS
    with ThreadPoolExecutor(cpu_count()) as pool:
        results = pool.map(lambda names: drive(program, method, world, seed, names), cases)
        for names, figures in zip(cases, results):
            sure = ", SURE OF A WRONG PLACE" if figures.get("wrong_confident") else ""
            endings = [outcome(run) + sure for run in figures["runs"]] or ["no mission was driven"]
            print(f"{' and '.join(names)}: {'; '.join(endings)}", flush=True)


if __name__ == "__main__":
    main()
