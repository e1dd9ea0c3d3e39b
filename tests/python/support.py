"""What the tests of the Python package share: a small scene, and the command line beside it."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest
import warnings

import lookout

PROGRAM = os.environ["LOOKOUT_PROGRAM"]
SOURCE = pathlib.Path(os.environ["LOOKOUT_SOURCE_DIR"])

# Two targets that pass one another in front of a vehicle, 24 scans.
SCENE = {
    "duration": 12.0,
    "vehicle": {"north_velocity": 0.8, "east_velocity": 0.2},
    "sonar": {"num_beams": 60, "first_bearing_deg": -29.5, "bearing_step_deg": 1.0, "max_range": 100.0, "scan_period": 0.5,
              "range_sigma": 1.0, "miss_probability": 0.1, "false_alarm_probability": 0.05},
    "targets": [
        {"id": 1, "north": 60.0, "east": 10.0, "north_velocity": -0.6, "east_velocity": -0.4},
        {"id": 2, "north": 50.0, "east": -10.0, "north_velocity": 0.2, "east_velocity": 0.7, "appear": 2.0},
    ],
}


class Case(unittest.TestCase):
    """A test with a folder of its own, in which a warning that nobody expects is an error."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        caught = warnings.catch_warnings()
        caught.__enter__()
        self.addCleanup(caught.__exit__, None, None, None)
        warnings.simplefilter("error")

    def write(self, name, values):
        """A YAML file of plain values (JSON is YAML); its path."""
        path = self.folder / name
        path.write_text(values if isinstance(values, str) else json.dumps(values))
        return path

    def command(self, *words, status=0):
        """Runs `lookout` and gives what it says: standard output, or the one line of a refusal."""
        done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, status, done.stderr)
        return done.stdout if status == 0 else done.stderr.removeprefix("lookout: ").rstrip("\n")

    def assert_same_bytes(self, first, second):
        self.assertEqual(first.read_bytes(), second.read_bytes(), f"{first.name} differs")

    def refusal(self, function, *arguments, **named):
        """The line of the ValueError that a call raises."""
        with self.assertRaises(ValueError) as raised:
            function(*arguments, **named)
        line = str(raised.exception)
        self.assertNotIn("\n", line)
        return line


def recording(seed=1000, **named):
    """The small scene, simulated."""
    return lookout.simulate(lookout.Scene(SCENE), seed=seed, **named)
