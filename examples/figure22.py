#!/usr/bin/python3
"""[Yan2018] Fig. 22 with the Python package: OSPA and its parts over time of the CSHT tracker and the Kalman filter on five
targets that come and go, in light clutter with P_F = P_M = 0.5.

usage: PYTHONPATH=build/python python3 examples/figure22.py [--runs N] [--seed N] [--duration S] [--out DIR]
Writes DIR/figure22.csv (utime, then a column a method and part, means over the runs) and DIR/figure22.png. The paper draws
one run.
"""
import argparse
import pathlib

import lookout
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the back end is chosen before)

METHODS = ["csht", "kalman"]
PARTS = {"cardinality": "cardinality part [m]", "localization": "localisation part [m]", "total": "OSPA [m]"}

# [Yan2018] Table 7: the keys of a scene's YAML.
SCENE = {
    "duration": 100.0,
    "vehicle": {"north_velocity": 0.87, "east_velocity": 0.5},
    "sonar": {"num_beams": 90, "first_bearing_deg": -44.5, "bearing_step_deg": 1.0, "max_range": 150.0, "scan_period": 0.5,
              "range_sigma": 3.0, "miss_probability": 0.5, "false_alarm_probability": 0.5, "clutter": "light"},
    "targets": [
        dict(id=1, north=120.0, east=80.0, north_velocity=-0.5, east_velocity=-1.0, appear=1.0, disappear=69.0),
        dict(id=2, north=20.0, east=0.0, north_velocity=2.0, east_velocity=0.25, appear=1.0, disappear=100.0),
        dict(id=3, north=70.0, east=-10.0, north_velocity=-0.25, east_velocity=1.5, appear=1.0, disappear=59.0),
        dict(id=4, north=200.0, east=20.0, north_velocity=-1.5, east_velocity=0.5, appear=22.0, disappear=88.0),
        dict(id=5, north=120.0, east=150.0, north_velocity=0.25, east_velocity=-0.75, appear=32.0, disappear=100.0),
    ],
}


def curves_of_run(scene, seed, run):
    """{(method, part): OSPA over time [m]} and the times [us] of one Monte Carlo run."""
    recording = lookout.simulate(scene, seed=seed, run=run)
    curves = {}
    for method in METHODS:
        tracked = lookout.track(recording, tracker=method, seed=seed)
        score = lookout.score(recording.truth, tracked.tracks, recording.times)
        curves.update({(method, part): score.over_time[part] for part in PARTS})
    return recording.times, curves


def mean_curves(scene, seed, runs):
    """The same, each the mean over the runs."""
    times, curves = curves_of_run(scene, seed, 0)
    for run in range(1, runs):
        for key, curve in curves_of_run(scene, seed, run)[1].items():
            curves[key] = curves[key] + curve
    return times, {key: curve / runs for key, curve in curves.items()}


def write_csv(path, times, curves):
    columns = [times] + list(curves.values())
    header = ",".join(["utime"] + [f"{method}_{part}" for method, part in curves])
    np.savetxt(path, np.column_stack(columns), delimiter=",", header=header, comments="", fmt=["%d"] + ["%.6g"] * len(curves))


def draw(path, times, curves):
    figure, axes = plt.subplots(len(PARTS), 1, sharex=True, figsize=(9, 9))
    for axis, (part, label) in zip(axes, PARTS.items()):
        for method, line in zip(METHODS, ["-", "--"]):
            axis.plot(times * 1e-6, curves[method, part], line, color="black", label=method)
        axis.set_ylabel(label)
        axis.grid(alpha=0.3)
    axes[0].legend(ncol=len(METHODS))
    axes[-1].set_xlabel("time [s]")
    figure.savefig(path, dpi=130, bbox_inches="tight")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=1)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--duration", type=float, default=SCENE["duration"], help="of the scene [s]")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/figure22"))
    given = parser.parse_args()
    times, curves = mean_curves(lookout.Scene(SCENE | {"duration": given.duration}), given.seed, given.runs)
    given.out.mkdir(parents=True, exist_ok=True)
    write_csv(given.out / "figure22.csv", times, curves)
    draw(given.out / "figure22.png", times, curves)
    for method in METHODS:
        print(f"{method}: OSPA {curves[method, 'total'].mean():.2f} m over {len(times)} scans, {given.runs} runs")


if __name__ == "__main__":
    main()
