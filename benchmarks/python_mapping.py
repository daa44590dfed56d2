#!/usr/bin/python3
"""Mapping from Python against the program: the same files, and processor time. python_mapping.py PROGRAM RECORDING [RUNS]

Both are whole processes, with their start, and take turns. Needs the package: PYTHONPATH=build/release/python
"""

import pathlib
import resource
import subprocess
import sys
import tempfile

import aisle

PYTHON = "import sys, aisle; aisle.map_recording(sys.argv[1]).trajectory"

if len(sys.argv) < 3:
    sys.exit(__doc__)
program, recording = sys.argv[1:3]
runs = int(sys.argv[3]) if len(sys.argv) > 3 else 5


def processor_s(*words: str) -> float:
    """Of a process, in all its threads."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(words, check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


with tempfile.TemporaryDirectory() as work:
    subprocess.run([program, "map", recording, "--out", work, "--force", "--quiet"], check=True, capture_output=True)
    mapped = aisle.map_recording(recording)
    mapped.building().write(work + "/python.json")
    texts = [pathlib.Path(work, name).read_bytes() for name in ("building.json", "python.json")]
    cells = pathlib.Path(work, "map.pgm").read_bytes()[-mapped.grid().cells.size :]
print("building files:", "identical" if texts[0] == texts[1] else "DIFFERENT")
print("cells:", "identical" if cells == mapped.grid().cells.tobytes() else "DIFFERENT")

times = []
for _ in range(runs):
    times.append((processor_s(program, "map", recording, "--quiet"), processor_s(sys.executable, "-c", PYTHON, recording)))
    print("program {:.2f} s, Python {:.2f} s".format(*times[-1]), flush=True)
least = [min(column) for column in zip(*times)]
print(f"least: program {least[0]:.2f} s, Python {least[1]:.2f} s: {least[1] / least[0]:.3f}")
