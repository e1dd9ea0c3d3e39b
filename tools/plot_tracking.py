#!/usr/bin/python3
"""Pictures of the csht-tracking experiment, after [Yan2018] Fig. 20 to 28: positions over time, tracks over the map, OSPA
and its parts over time (mean of the runs with its band), over P_F and over sigma; and the paper's tables.

Usage: plot_tracking.py DIR, where `lookout experiment csht-tracking --out DIR` has written: yan2018_fig20.png (and .pdf)
and so on, pictures.md with their captions, tables.md. What --only left out is not drawn.
"""
import csv
import json
import math
import pathlib
import sys

from plot_style import PAPER, Album, draw_band, plt, style

import paper_tables

PARTS = [("cardinality", "cardinality part [m]"), ("localization", "localisation part [m]"), ("total", "OSPA [m]")]
TABLES = [("ospa_cardinality", "cardinality part [m]", "23", "26"), ("ospa_localization", "localisation part [m]", "24", "27"),
          ("ospa_of_means", "OSPA of the means [m]", "25", "28")]


def rows_of(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def methods_in(directory):
    return sorted(path.stem[len("ospa_"):] for path in directory.glob("ospa_*.csv"))


def words_of(pictured):
    p = pictured["parameters"]
    return (f"Table 7 scene, {p['clutter']} clutter, P_F = {p['p_false_alarm']:g}, P_M = {p['p_miss']:g}, "
            f"sigma {p['sigma']:g} m, seed {pictured['seed']}")


def column(rows, name):
    return [float(row[name]) if row[name] else 0.0 for row in rows]


def plot_over_time(album, directory, methods, pictured):
    figure, axes = plt.subplots(3, 1, sharex=True, figsize=(9, 9))
    for index, method in enumerate(methods):
        rows = rows_of(directory / f"ospa_{method}.csv")
        for axis, (name, label) in zip(axes, PARTS):
            draw_band(axis, column(rows, "time_s"), column(rows, name), column(rows, name + "_ci95"), index, method)
            axis.set_ylabel(label)
            axis.grid(alpha=0.3)
    axes[0].legend(ncol=len(methods), loc="lower center", bbox_to_anchor=(0.5, 1.0))
    axes[-1].set_xlabel("time [s]")
    album.save(figure, "yan2018_fig22", f"OSPA of the targets in view and its parts over time, means over {pictured['runs']} runs with "
               f"95 % bands ({words_of(pictured)}). Paper's Fig. 22, there of one run.")


def paths_by(rows, x, y):
    paths = {}
    for row in rows:
        paths.setdefault(row["id"], []).append((float(row[x]), float(row[y])))
    return paths


def draw_tracks(axis, truth, tracks, x, y):
    for path in paths_by(truth, x, y).values():
        axis.plot(*zip(*path), color="0.87", linestyle="-", linewidth=5, solid_capstyle="round")
    for path in paths_by([row for row in truth if row["visible"] == "1"], x, y).values():
        axis.plot(*zip(*path), color="0.7", linestyle="-", linewidth=5, solid_capstyle="round")
    confirmed = [row for row in tracks if row["status"] == "confirmed"]
    for index, path in enumerate(paths_by(confirmed, x, y).values()):
        axis.plot(*zip(*path), markevery=20, **style(index, markersize=3))


def plot_positions(album, directory, methods, pictured):
    truth = rows_of(directory / "truth.csv")
    figure, axes = plt.subplots(2, len(methods), sharex=True, sharey="row", figsize=(4.5 * len(methods), 7), squeeze=False)
    for index, method in enumerate(methods):
        tracks = rows_of(directory / f"tracks_{method}.csv")
        for row, coordinate in enumerate(("north", "east")):
            draw_tracks(axes[row][index], truth, tracks, "time_s", coordinate + "_m")
            axes[row][0].set_ylabel(f"{coordinate} [m]")
        axes[0][index].text(0.03, 0.97, method, transform=axes[0][index].transAxes, va="top")
        axes[1][index].set_xlabel("time [s]")
    album.save(figure, "yan2018_fig20", f"Positions over time, run 0: targets (grey, dark while in view), confirmed tracks "
               f"({words_of(pictured)}). Paper's Fig. 20.")


def plot_map(album, directory, methods, pictured):
    truth = rows_of(directory / "truth.csv")
    figure, axes = plt.subplots(1, len(methods), sharex=True, sharey=True, figsize=(5.5 * len(methods), 5.5), squeeze=False)
    for axis, method in zip(axes[0], methods):
        draw_tracks(axis, truth, rows_of(directory / f"tracks_{method}.csv"), "east_m", "north_m")
        axis.text(0.03, 0.97, method, transform=axis.transAxes, va="top")
        axis.set_xlabel("east [m]")
        axis.set_aspect("equal")
    axes[0][0].set_ylabel("north [m]")
    album.save(figure, "yan2018_fig21", f"Confirmed tracks of run 0 over the map: targets grey, dark while in view "
               f"({words_of(pictured)}). Paper's Fig. 21.")


def is_paper_case(row):
    return row["sensor_figures"] == "known" and float(row["lag_s"]) == 0.0


def half_width(row):
    """Half of the 95 % interval; none of a single run."""
    width = float(row["ci95"] or "nan")
    return width if math.isfinite(width) else 0.0


def curve_name(row):
    return row["method"] + (f' W={row["window_scans"]}' if row["window_scans"] not in ("", "20") else "")


def draw_curves(axis, rows, key):
    """A curve a method over the parameter `key`, and the paper's figures as stars and pentagons."""
    for index, name in enumerate(sorted({curve_name(row) for row in rows})):
        curve = sorted((float(row[key]), float(row["mean"]), half_width(row)) for row in rows if curve_name(row) == name)
        axis.errorbar(*zip(*curve), label=name, capsize=2, **style(index))
    for method, name, marker in (("csht", "paper, CSHT", "*"), ("kalman", "paper, Kalman", "p")):
        printed = [(float(row[key]), float(row["paper"])) for row in rows if row["method"] == method and row["paper"]]
        if printed:
            axis.plot(*zip(*printed), **{**PAPER, "marker": marker}, label=name)
    axis.grid(alpha=0.3)


def plot_over_false_alarms(album, rows, clutter, metric, label, number):
    chosen = [row for row in rows if row["metric"] == metric and row["clutter"] == clutter and float(row["sigma"]) == 3.0]
    misses = sorted({row["p_miss"] for row in chosen}, key=float)
    if len({row["p_false_alarm"] for row in chosen}) < 2:
        return
    figure, axes = plt.subplots(1, len(misses), sharey=True, figsize=(4 * len(misses), 4), squeeze=False)
    for axis, p_miss in zip(axes[0], misses):
        draw_curves(axis, [row for row in chosen if row["p_miss"] == p_miss], "p_false_alarm")
        axis.text(0.03, 0.97, f"$P_M$ = {p_miss}", transform=axis.transAxes, va="top")
        axis.set_xlabel("$P_F$")
    axes[0][0].set_ylabel(label)
    axes[0][-1].legend(fontsize=8, loc="center left", bbox_to_anchor=(1.02, 0.5))
    album.save(figure, f"yan2018_fig{number}_{clutter}", f"{label} over the false alarm rate, targets in view, {clutter} clutter, "
               f"sigma 3 m; bars: 95 % intervals. Paper's Fig. {number}.")


def plot_over_sigma(album, rows, clutter, metric, label, number):
    chosen = [row for row in rows if row["metric"] == metric and row["clutter"] == clutter
              and float(row["p_miss"]) == 0.3 and float(row["p_false_alarm"]) == 0.3]
    if len({row["sigma"] for row in chosen}) < 2:
        return
    figure, axis = plt.subplots(figsize=(6, 4.2))
    draw_curves(axis, chosen, "sigma")
    axis.set_xlabel("sigma [m]")
    axis.set_ylabel(label)
    axis.legend(fontsize=7)
    album.save(figure, f"yan2018_fig{number}_{clutter}", f"{label} over sigma, targets in view, {clutter} clutter, P_F = P_M = 0.3; "
               f"bars: 95 % intervals. Paper's Fig. {number}.")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    directory = pathlib.Path(sys.argv[1])
    album = Album(directory)
    pictured = json.loads((directory / "pictured_run.json").read_text())
    methods = methods_in(directory)
    plot_positions(album, directory, methods, pictured)
    plot_map(album, directory, methods, pictured)
    plot_over_time(album, directory, methods, pictured)
    rows = [row for row in rows_of(directory / "results.csv") if is_paper_case(row)]
    for clutter in sorted({row["clutter"] for row in rows}):
        for metric, label, over_false_alarms, over_sigma in TABLES:
            plot_over_false_alarms(album, rows, clutter, metric, label, over_false_alarms)
            plot_over_sigma(album, rows, clutter, metric, label, over_sigma)
    paper_tables.write_tables(directory)


if __name__ == "__main__":
    main()
