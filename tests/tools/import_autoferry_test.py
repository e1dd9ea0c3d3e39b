#!/usr/bin/python3
"""Tests of tools/import_autoferry.py: a file pair small enough to check on paper, and the real one where LOOKOUT_DATA
names the folder that holds it. usage: import_autoferry_test.py [LOOKOUT]. Status 77: all but the real one passed."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "tools" / "import_autoferry.py"
CASES = pathlib.Path(__file__).resolve().parents[1] / "data" / "cases" / "autoferry_forms"
SKIPPED = 77


def run(*arguments):
    return subprocess.run([SCRIPT, *map(str, arguments)], capture_output=True, text=True)


def expect(condition, what):
    if not condition:
        sys.exit(f"FAILED: {what}")


def test_small_pair(folder):
    scan = {"sensorID": 2, "ownshipPosition": [10, 20]}
    detections = [
        {**scan, "time": 102.0, "measurement": []},
        {**scan, "time": 100.0, "measurement": [[3, 0], [4, 5]]},
        {**scan, "time": 101.0, "measurement": [0.0, -2.0]},
        {**scan, "sensorID": 1, "time": 100.5, "measurement": [1.0, 1.0]},
    ]
    truths = [[{"targetID": 7, "position": [north, 1.0, 0]}] for north in (5.0, 1.0, 2.0, 9.0)]
    (folder / "d.json").write_text(json.dumps(detections))
    (folder / "t.json").write_text(json.dumps(truths))
    expect(run(folder / "d.json", folder / "t.json", folder / "out").returncode == 0, "conversion of a good pair")
    scans = (folder / "out" / "scans.csv").read_text().splitlines()[1:]
    # atan2(4, 3) = 0.9272952; east is pi/2; due west -pi/2; a flat pair is one return; no return is a row of blanks.
    expect(
        scans
        == [
            "0.000000,0.9272952,5.0000,1",
            "0.000000,1.5707963,5.0000,1",
            "1.000000,-1.5707963,2.0000,1",
            "2.000000,,,",
        ],
        f"scans {scans}",
    )
    truth = (folder / "out" / "truth.csv").read_text().splitlines()[1:]
    # From 1 m to 2 m to 5 m north, a second each: 1 m/s, then 3 m/s.
    expect(
        truth
        == [
            "0.000000,7,1.0000,1.0000,0.0000,0.0000,1",
            "1.000000,7,2.0000,1.0000,1.0000,0.0000,1",
            "2.000000,7,5.0000,1.0000,3.0000,0.0000,1",
        ],
        f"truth {truth}",
    )


def rows(path):
    return path.read_text().splitlines()[1:]


def test_forms_people_have(folder, program):
    """Pairs of 40 scans; two without returns, one with a NaN, one with the time of another, a truth of 15 scans."""
    for detections, truths, scans, left_out in (
        ("empty_d", "short_g", 15, "25 radar scans behind the end of the ground truth (first: entry 15)"),
        ("empty_d", "ok_g", 40, ""),
        ("nan_d", "ok_g", 40, "returns without a finite position"),
        ("repeat_d", "ok_g", 39, "1 radar scans with the time of another"),
    ):
        out = folder / detections / truths
        result = run(CASES / f"{detections}.json", CASES / f"{truths}.json", out)
        expect(result.returncode == 0, f"{detections}: {result}")
        expect(left_out in result.stderr and bool(left_out) == bool(result.stderr), f"{detections}: {result.stderr}")
        expect(len(rows(out / "vehicle.csv")) == scans, f"{detections}: {len(rows(out / 'vehicle.csv'))} scans")
        expect("nan" not in (out / "scans.csv").read_text(), f"{detections}: nan")
        if program:
            replay = [program, "replay", out, "--out", folder / "tracks", "--tracker", "gnn"]
            expect(subprocess.run(list(map(str, replay)), capture_output=True).returncode == 0, f"{detections}: replay")


def test_bad_entries_name_their_index(folder):
    good = {"sensorID": 2, "time": 1.0, "ownshipPosition": [0, 0], "measurement": []}
    truth = folder / "truth.json"
    truth.write_text("[[], []]")
    for change in ({"time": float("nan")}, {"measurement": [[1], [1, 2]]}, {"measurement": "xy"}, {"ownshipPosition": 3}):
        (folder / "entry.json").write_text(json.dumps([good, {**good, "time": 2.0, **change}]))
        result = run(folder / "entry.json", truth, folder / "never")
        expect(result.returncode == 2 and "entry.json: entry 1: not as" in result.stderr, f"{change}: {result}")
        expect(not (folder / "never").exists(), "nothing is written")


def test_bad_files(folder):
    (folder / "bad.json").write_text("{")
    (folder / "none.json").write_text("[]")
    (folder / "odd.json").write_text('[{"sensorID": 2}]')
    for name in ("missing.json", "bad.json", "none.json", "odd.json"):
        result = run(folder / name, folder / "none.json" if name != "odd.json" else folder / "odd.json", folder / "x")
        expect(result.returncode == 2 and result.stderr.count("\n") == 1, f"{name}: {result}")


def test_real_pair(folder, data):
    source = data / "autoferry"
    raw = [source / "raw" / f"scenario16_{part}.json" for part in ("detections", "groundTruth")]
    expect(run(*raw, folder / "real").returncode == 0, "conversion of scenario 16")
    for name in ("scans.csv", "vehicle.csv", "truth.csv", "sonar.yaml"):
        expect((folder / "real" / name).read_bytes() == (source / "scenario16" / name).read_bytes(), name)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        test_small_pair(folder)
        test_bad_files(folder)
        test_bad_entries_name_their_index(folder)
        test_forms_people_have(folder, sys.argv[1] if len(sys.argv) > 1 else "")
        if "LOOKOUT_DATA" not in os.environ:
            print("SKIPPED in part: LOOKOUT_DATA does not name the folder of the Autoferry recordings")
            return SKIPPED
        test_real_pair(folder, pathlib.Path(os.environ["LOOKOUT_DATA"]))
    print("passed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
