"""aisle for Python: maps, scans, images, simulated vehicles and robots as numpy arrays.

Lengths are metres, angles radians, times seconds, unless a name says otherwise. Frames have x ahead, y left (of a
vehicle) or x right, y up (of a map); headings count counter-clockwise. A pose is (x_m, y_m, heading_rad); a name
T_a_b is the pose of b in a. Pixels are (u, v), u right, v down, (0, 0) the CENTRE of the top-left pixel.

Bad input raises InputError, a ValueError with the words of the program; a file that cannot be had raises OSError.
Long calls let other threads run, and end on Ctrl-C.
"""

from ._aisle import (
    Building,
    Command,
    Decision,
    Footprint,
    Grid,
    LaserScanner,
    LineFinder,
    Lines,
    Match,
    MissionResult,
    Observation,
    Recording,
    RecordingMap,
    Scan,
    Session,
    SimulatedVehicle,
    Truth,
    Vehicle,
    Zone,
    __version__,
    detect_floor,
    drive,
    map_recording,
    match_scans,
    read_building,
    read_image,
    read_recording,
    read_session,
    shipped,
)
from ._failures import InputError, Problem
from .environment import Box, Environment
from .navigator import Navigator

__all__ = [
    "Box",
    "Building",
    "Command",
    "Decision",
    "Environment",
    "Footprint",
    "Grid",
    "InputError",
    "LaserScanner",
    "LineFinder",
    "Lines",
    "Match",
    "MissionResult",
    "Navigator",
    "Observation",
    "Problem",
    "Recording",
    "RecordingMap",
    "Scan",
    "Session",
    "SimulatedVehicle",
    "Truth",
    "Vehicle",
    "Zone",
    "__version__",
    "detect_floor",
    "drive",
    "map_recording",
    "match_scans",
    "read_building",
    "read_image",
    "read_recording",
    "read_session",
    "shipped",
]
