#!/usr/bin/python3
"""Plots of the csht-tracking experiment: OSPA and its parts over time, tracks over the map, OSPA over P_F.

Usage: plot_tracking.py DIR, where `lookout experiment csht-tracking --out DIR` has written.
"""
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

PARTS = [("total", "OSPA [m]"), ("localization", "localisation [m]"), ("cardinality", "cardinality [m]")]


def rows_of(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def methods_in(directory):
    return sorted(path.stem[len("ospa_"):] for path in directory.glob("ospa_*.csv"))


def plot_over_time(directory, methods):
    figure, axes = plt.subplots(3, 1, sharex=True, figsize=(9, 9))
    for method in methods:
        rows = rows_of(directory / f"ospa_{method}.csv")
        time = [float(row["time_s"]) for row in rows]
        for axis, (column, label) in zip(axes, PARTS):
            axis.plot(time, [float(row[column]) for row in rows], label=method, linewidth=1)
            axis.set_ylabel(label)
    axes[0].legend(ncol=len(methods), loc="lower center", bbox_to_anchor=(0.5, 1.0),
                   title="one run, light clutter, $P_F = P_M = 0.5$, targets in view")
    axes[-1].set_xlabel("time [s]")
    save(figure, directory / "ospa_over_time.png")


def paths_by(rows, key):
    paths = {}
    for row in rows:
        paths.setdefault(row[key], []).append((float(row["east_m"]), float(row["north_m"])))
    return paths


def plot_map(directory, methods):
    truth = rows_of(directory / "truth.csv")
    figure, axes = plt.subplots(1, len(methods), sharex=True, sharey=True, figsize=(5.5 * len(methods), 5.5), squeeze=False)
    for axis, method in zip(axes[0], methods):
        seen = [row for row in truth if row["visible"] == "1"]
        for path in paths_by(truth, "id").values():
            axis.plot(*zip(*path), color="0.85", linewidth=5, solid_capstyle="round")
        for path in paths_by(seen, "id").values():
            axis.plot(*zip(*path), color="0.65", linewidth=5, solid_capstyle="round")
        confirmed = [row for row in rows_of(directory / f"tracks_{method}.csv") if row["status"] == "confirmed"]
        for path in paths_by(confirmed, "id").values():
            axis.plot(*zip(*path), linewidth=1.2)
        axis.set_title(f"{method} (grey: targets, dark while in view)")
        axis.set_xlabel("east [m]")
        axis.set_aspect("equal")
    axes[0][0].set_ylabel("north [m]")
    save(figure, directory / "tracks_over_map.png")


def plot_table(directory):
    rows = [row for row in rows_of(directory / "results.csv")
            if row["metric"] == "ospa_of_means" and is_paper_case(row)]
    for clutter in sorted({row["clutter"] for row in rows}):
        chosen = [row for row in rows if row["clutter"] == clutter]
        misses = sorted({row["p_miss"] for row in chosen}, key=float)
        figure, axes = plt.subplots(1, len(misses), sharey=True, figsize=(4 * len(misses), 4), squeeze=False)
        for axis, p_miss in zip(axes[0], misses):
            plot_panel(axis, [row for row in chosen if row["p_miss"] == p_miss])
            axis.set_title(f"$P_M$ = {p_miss}, {clutter} clutter")
            axis.set_xlabel("$P_F$")
        axes[0][0].set_ylabel("OSPA of the means, in view [m]")
        axes[0][0].legend(fontsize=7)
        save(figure, directory / f"ospa_{clutter}.png")


def is_paper_case(row):
    return float(row["sigma"]) == 3.0 and row["sensor_figures"] == "known" and float(row["lag_s"]) == 0.0


def curve_name(row):
    return row["method"] + (f' W={row["window_scans"]}' if row["window_scans"] not in ("", "20") else "")


def plot_panel(axis, rows):
    for index, name in enumerate(sorted({curve_name(row) for row in rows})):
        curve = sorted((float(row["p_false_alarm"]), float(row["mean"]), float(row["ci95"]), row["paper"]) for row in rows if curve_name(row) == name)
        axis.errorbar([c[0] for c in curve], [c[1] for c in curve], [c[2] for c in curve], label=name, color=f"C{index}", capsize=2)
        printed = [(c[0], float(c[3])) for c in curve if c[3]]
        if printed:
            axis.plot(*zip(*printed), "--", color=f"C{index}", label=f"{name}, paper")


def save(figure, path):
    figure.tight_layout()
    figure.savefig(path, dpi=110)
    plt.close(figure)


def main():
    directory = pathlib.Path(sys.argv[1])
    methods = methods_in(directory)
    if methods:
        plot_over_time(directory, methods)
        plot_map(directory, methods)
    plot_table(directory)


if __name__ == "__main__":
    main()
