#!/usr/bin/python3
"""Turns a file pair of the Autoferry data set (github.com/Autoferry/sensor_fusion_dataset) into a recording.

usage: tools/import_autoferry.py DETECTIONS.json GROUND_TRUTH.json OUT_DIRECTORY

Takes the radar's scans alone: time 0 is the first of them, heading is 0 (bearings are from north), the truth is the
one that stands beside each scan, its velocity the difference from scan to scan (0 in a target's first row: unknown).
OUT_DIRECTORY then holds scans.csv, vehicle.csv, truth.csv and a sonar.yaml, for `lookout replay`. What cannot be used is
left out and counted, by reason: returns and targets that are not finite, a second scan of one time, scans behind the end
of the truth. An entry that is not as the data set has it ends the import with its index, and nothing is written.
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
    """A file that is not of the data set; the text says where and what is wrong."""


class LeftOut:
    """What of the files does not reach the recording: by reason, how often and at which entry first."""

    def __init__(self):
        self.reasons = {}

    def add(self, reason, index):
        count, first = self.reasons.get(reason, (0, index))
        self.reasons[reason] = (count + 1, first)

    def lines(self):
        return [f"{count} {reason} (first: entry {first})" for reason, (count, first) in self.reasons.items()]


def load_list(path):
    try:
        content = json.loads(pathlib.Path(path).read_text(encoding="utf-8-sig"))
    except OSError as error:
        raise BadFile(f"{path}: cannot be read: {error.strerror}") from error
    except json.JSONDecodeError as error:
        raise BadFile(f"{path}:{error.lineno}:{error.colno}: not JSON") from error
    except (ValueError, RecursionError) as error:
        raise BadFile(f"{path}: not JSON in UTF-8") from error
    if not isinstance(content, list):
        raise BadFile(f"{path}: expected a list, one entry a scan")
    return content


def number(value):
    """A finite number, or NaN. Raises TypeError for what is none, `true` included."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise TypeError
    return float(value) if math.isfinite(value) else math.nan


def returns_of(scan):
    """(north, east) relative to the own ship of each return: two lists, or one flat pair, or nothing."""
    measurement = scan["measurement"]
    if not measurement:
        return []
    north, east = measurement
    if not isinstance(north, list):
        north, east = [north], [east]
    if len(north) != len(east):
        raise ValueError
    return [(number(n), number(e)) for n, e in zip(north, east)]


def scan_of(entry, index, left_out):
    """Time, own position and finite returns of a radar scan."""
    time, own = number(entry["time"]), [number(value) for value in entry["ownshipPosition"][:2]]
    if not all(map(math.isfinite, [time, *own])) or len(own) != 2:
        raise ValueError
    returns = []
    for pair in returns_of(entry):
        if all(map(math.isfinite, pair)):
            returns.append(pair)
        else:
            left_out.add("returns without a finite position", index)
    return {"time": time, "own": own, "returns": returns}


def truth_of(targets, index, left_out):
    """(identity, north, east) of each target beside a scan."""
    rows = []
    for target in targets:
        identity, (north, east) = target["targetID"], map(number, target["position"][:2])
        if isinstance(identity, bool) or not isinstance(identity, int) or abs(identity) >= 2**31:
            raise ValueError
        if not (math.isfinite(north) and math.isfinite(east)):
            left_out.add("targets without a finite position", index)
        elif any(identity == row[0] for row in rows):
            left_out.add("targets that stand twice beside one scan", index)
        else:
            rows.append((identity, north, east))
    return rows


def at_entry(path, index, make, *arguments):
    """make(*arguments), its complaints as those of an entry of a file."""
    try:
        return make(*arguments)
    except (KeyError, TypeError, ValueError, OverflowError, AttributeError) as error:
        raise BadFile(f"{path}: entry {index}: not as the data set has it") from error


def radar_scans(detections, truths, paths, left_out):
    """(scan, truth beside it) of the radar, in order of time, no two of one time."""
    pairs = []
    for index, entry in enumerate(detections):
        if at_entry(paths[0], index, lambda: entry["sensorID"]) != RADAR:
            continue
        if index >= len(truths):
            left_out.add("radar scans behind the end of the ground truth", index)
            continue
        scan = at_entry(paths[0], index, scan_of, entry, index, left_out)
        truth = at_entry(paths[1], index, truth_of, truths[index], index, left_out)
        pairs.append((scan, truth, index))
    kept = []
    for scan, truth, index in sorted(pairs, key=lambda pair: pair[0]["time"]):
        if kept and f"{scan['time']:.6f}" == f"{kept[-1][0]['time']:.6f}":
            left_out.add("radar scans with the time of another", index)
        else:
            kept.append((scan, truth))
    return kept


def scan_rows(time, scan):
    rows = [
        f"{time:.6f},{math.atan2(east, north):.7f},{math.hypot(north, east):.4f},1" for north, east in scan["returns"]
    ]
    return rows or [f"{time:.6f},,,"]


def truth_rows(time, truth, before):
    """Rows of one scan; `before` keeps each target's time and position, and is brought up to date."""
    for identity, north, east in truth:
        then, north_then, east_then = before.get(identity, (time, north, east))
        elapsed = time - then
        velocity = ((north - north_then) / elapsed, (east - east_then) / elapsed) if elapsed > 0 else (0.0, 0.0)
        before[identity] = (time, north, east)
        yield f"{time:.6f},{identity},{north:.4f},{east:.4f},{velocity[0]:.4f},{velocity[1]:.4f},1"


def convert(detections, truths, paths, left_out):
    """The text of each file of the recording, by name."""
    scans = ["time_s,bearing_rad,range_m,intensity"]
    vehicle = ["time_s,north_m,east_m,heading_rad"]
    truth = ["time_s,id,north_m,east_m,north_velocity_mps,east_velocity_mps,visible"]
    pairs = radar_scans(detections, truths, paths, left_out)
    if not pairs:
        raise BadFile(f"{paths[0]}: no radar scan (sensorID 2) with a truth beside it")
    before = {}
    for scan, beside in pairs:
        time = scan["time"] - pairs[0][0]["time"]
        north, east = scan["own"]
        scans += scan_rows(time, scan)
        vehicle.append(f"{time:.6f},{north:.4f},{east:.4f},0")
        truth += truth_rows(time, beside, before)
    tables = {"scans.csv": scans, "vehicle.csv": vehicle, "truth.csv": truth}
    return {name: "\n".join(rows) + "\n" for name, rows in tables.items()} | {"sonar.yaml": SONAR_YAML}, len(pairs)


def write_recording(out, files):
    folder = pathlib.Path(out)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in files.items():
            (folder / name).write_text(text)
    except OSError as error:
        raise BadFile(f"{error.filename or out}: cannot be written: {error.strerror}") from error


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("detections")
    parser.add_argument("ground_truth")
    parser.add_argument("out")
    arguments = parser.parse_args()
    paths, left_out = (arguments.detections, arguments.ground_truth), LeftOut()
    try:
        files, scans = convert(load_list(paths[0]), load_list(paths[1]), paths, left_out)
        write_recording(arguments.out, files)
    except BadFile as error:
        print(f"import_autoferry: {error}", file=sys.stderr)
        return 2
    for line in left_out.lines():
        print(f"import_autoferry: left out: {line}", file=sys.stderr)
    print(f"{arguments.out}: {scans} radar scans")
    return 0


if __name__ == "__main__":
    sys.exit(main())
