#!/usr/bin/python3
"""The vehicle's program and the one ashore on the same log: their tracks are equal to a billionth of a metre.

usage: arm64_test.py LOOKOUT LOOKOUT_ARM64 SYSROOT SCENE; the second runs under qemu. Status 77 where it was not built.
"""
import csv
import pathlib
import shutil
import subprocess
import sys
import tempfile

MOST_APART = 1e-9  # m, m/s, ...; two libraries of elementary functions differ in the last digits
LONGEST = 1200.0  # s


def numbers(path):
    """The rows of a table; what is a number as one."""
    def value(text):
        try:
            return float(text)
        except ValueError:
            return text
    with open(path, newline="") as file:
        return [[value(text) for text in row] for row in csv.reader(file)]


def most_apart(one, other):
    """The largest difference of two tables' numbers; all else must be equal."""
    assert len(one) == len(other), f"{len(one)} and {len(other)} rows"
    apart = 0.0
    for a, b in zip(one, other):
        assert len(a) == len(b), f"rows {a} and {b}"
        for x, y in zip(a, b):
            if isinstance(x, float) and isinstance(y, float):
                apart = max(apart, abs(x - y))
            else:
                assert x == y, f"{x} and {y}"
    return apart


def main():
    here, vehicle, sysroot, scene = sys.argv[1:5]
    qemu = shutil.which("qemu-aarch64-static")
    if not pathlib.Path(vehicle).exists() or not qemu:
        print("SKIPPED: no arm64 build (tools/package arm64), or no qemu-aarch64-static")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        log = folder / "run.lcmlog"
        subprocess.run([here, "sim", scene, "--speed", "max", "--lcm-url", f"file://{log}?mode=w"], check=True, timeout=LONGEST)
        subprocess.run([here, "replay", log, "--out", folder / "here"], check=True, timeout=LONGEST)
        subprocess.run([qemu, "-L", sysroot, vehicle, "replay", log, "--out", folder / "vehicle"], check=True, timeout=LONGEST)
        for table in ("scans.csv", "vehicle.csv", "truth.csv"):
            assert (folder / "here" / table).read_bytes() == (folder / "vehicle" / table).read_bytes(), table
        tracks = [numbers(folder / place / "tracks.csv") for place in ("here", "vehicle")]
    apart = most_apart(*tracks)
    print(f"{len(tracks[0]) - 1} rows of tracks, at most {apart:.3g} apart")
    assert apart <= MOST_APART, "the vehicle's tracks are others"


if __name__ == "__main__":
    main()
