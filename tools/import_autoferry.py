#!/usr/bin/python3
"""Turns a file pair of the Autoferry data set (github.com/Autoferry/sensor_fusion_dataset) into a recording.

usage: tools/import_autoferry.py DETECTIONS.json GROUND_TRUTH.json OUT_DIRECTORY

Takes the radar's scans alone: time 0 is the first of them, heading is 0 (bearings are from north), the truth is the
one that stands beside each scan, its velocity the difference from scan to scan (0 in a target's first row: unknown).
OUT_DIRECTORY then holds scans.csv, vehicle.csv, truth.csv and a sonar.yaml, for `lookout replay`.
"""
import argparse
import json
import math
import pathlib
import sys

RADAR = 2  # sensorID: 1 lidar, 2 radar, 3 infrared, 4 camera

# What is known of the radar, measured on the data set itself: it names no accuracy.
SONAR_YAML = """num_beams: 360
first_bearing_deg: -179.5
bearing_step_deg: 1.0
max_range: 500.0
range_sigma: 4.0
bearing_sigma_deg: 1.0
miss_probability: 0.25
clutter_per_scan: 3.0
scan_period: 1.68
max_speed: 6.0
"""


class BadFile(Exception):
    """A file that is not of the data set; the text says what is wrong."""


def load_list(path):
    try:
        content = json.loads(pathlib.Path(path).read_text())
    except OSError as error:
        raise BadFile(f"{path}: cannot be read: {error.strerror}") from error
    except ValueError as error:
        raise BadFile(f"{path}: not JSON: {error}") from error
    if not isinstance(content, list):
        raise BadFile(f"{path}: expected a list, one entry a scan")
    return content


def returns_of(scan):
    """(north, east) relative to the own ship of each return: two lists, or one flat pair, or nothing."""
    measurement = scan["measurement"]
    if not measurement:
        return []
    north, east = measurement
    return list(zip(north, east)) if isinstance(north, list) else [(north, east)]


def radar_scans(detections, truths):
    """(scan, truth beside it) of the radar, in order of time."""
    pairs = [(scan, truth) for scan, truth in zip(detections, truths) if scan["sensorID"] == RADAR]
    return sorted(pairs, key=lambda pair: pair[0]["time"])


def scan_rows(time, scan):
    rows = [
        f"{time:.6f},{math.atan2(east, north):.7f},{math.hypot(north, east):.4f},1"
        for north, east in returns_of(scan)
    ]
    return rows or [f"{time:.6f},,,"]


def truth_rows(time, truth, before):
    """Rows of one scan; `before` keeps each target's time and position, and is brought up to date."""
    for target in truth:
        identity, (north, east) = target["targetID"], target["position"][:2]
        then, north_then, east_then = before.get(identity, (time, north, east))
        elapsed = time - then
        velocity = ((north - north_then) / elapsed, (east - east_then) / elapsed) if elapsed > 0 else (0.0, 0.0)
        before[identity] = (time, north, east)
        yield f"{time:.6f},{identity},{north:.4f},{east:.4f},{velocity[0]:.4f},{velocity[1]:.4f},1"


def convert(detections, truths):
    """The text of each file of the recording, by name."""
    scans = ["time_s,bearing_rad,range_m,intensity"]
    vehicle = ["time_s,north_m,east_m,heading_rad"]
    truth = ["time_s,id,north_m,east_m,north_velocity_mps,east_velocity_mps,visible"]
    pairs = radar_scans(detections, truths)
    if not pairs:
        raise BadFile("no radar scan (sensorID 2) in the detections")
    before = {}
    for scan, beside in pairs:
        time = scan["time"] - pairs[0][0]["time"]
        north, east = scan["ownshipPosition"]
        scans += scan_rows(time, scan)
        vehicle.append(f"{time:.6f},{north:.4f},{east:.4f},0")
        truth += truth_rows(time, beside, before)
    tables = {"scans.csv": scans, "vehicle.csv": vehicle, "truth.csv": truth}
    return {name: "\n".join(rows) + "\n" for name, rows in tables.items()} | {"sonar.yaml": SONAR_YAML}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("detections")
    parser.add_argument("ground_truth")
    parser.add_argument("out")
    arguments = parser.parse_args()
    try:
        files = convert(load_list(arguments.detections), load_list(arguments.ground_truth))
    except BadFile as error:
        print(f"import_autoferry: {error}", file=sys.stderr)
        return 2
    except (KeyError, TypeError, ValueError) as error:
        print(f"import_autoferry: an entry is not as the data set has it: {error!r}", file=sys.stderr)
        return 2
    folder = pathlib.Path(arguments.out)
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in files.items():
        (folder / name).write_text(text)
    print(f"{folder}: {len(set(line.split(',')[0] for line in files['scans.csv'].splitlines()[1:]))} radar scans")
    return 0


if __name__ == "__main__":
    sys.exit(main())
