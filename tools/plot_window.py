#!/usr/bin/python3
"""Pictures of the csht-window experiment, after [Yan2018] Fig. 8 to 19: one window's samples, votes, classes and fitted
lines, the OSPA over P_M and over sigma beside the paper and the least-squares reference; and the paper's tables.

Usage: plot_window.py DIR, where `lookout experiment csht-window --out DIR` has written: yan2018_fig08.png (and .pdf) and
so on, pictures.md with their captions, tables.md. What --only left out is not drawn.
"""
import csv
import json
import pathlib
import sys

from plot_style import PAPER, Album, plt, style

import paper_tables
from plot_demo import draw_votes

WINDOW_OF_THE_PAPER = 20
METRICS = {"position_ospa": ("position OSPA [m]", "bound"), "velocity_ospa": ("velocity OSPA [m/s]", "velocity_bound")}
TRUTH = {"color": "0.75", "linestyle": "-", "linewidth": 5, "solid_capstyle": "round", "zorder": 0}
AXES = (("north", "n"), ("east", "e"))


def rows_of(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def paper_cells(directory):
    """The cells on the paper's window, without variants of the sensor figures."""
    results = json.loads((directory / "results.json").read_text())
    return [cell for cell in results["cells"]
            if cell["parameters"].get("window_scans") == WINDOW_OF_THE_PAPER
            and cell["parameters"].get("sensor_figures", "known") == "known"]


def methods_of(cells):
    return list(dict.fromkeys(cell["method"] for cell in cells))


def where(cells, **wanted):
    return [cell for cell in cells if all(cell["parameters"].get(key) == value for key, value in wanted.items())]


def draw_lines(axis, cells, key, metric):
    """Each method's figure with its interval over the parameter `key`; the reference and the paper once."""
    methods = methods_of(cells)
    for index, method in enumerate(methods):
        own = sorted((c for c in cells if c["method"] == method), key=lambda c: c["parameters"][key])
        axis.errorbar([c["parameters"][key] for c in own], [c["metrics"][metric]["mean"] for c in own],
                      [c["metrics"][metric]["ci95"] or 0.0 for c in own], capsize=2, label=method, **style(index))
    first = sorted((c for c in cells if c["method"] == methods[0]), key=lambda c: c["parameters"][key])
    axis.plot([c["parameters"][key] for c in first], [c["metrics"][METRICS[metric][1]]["mean"] for c in first],
              color="0.5", linestyle="-", linewidth=3, alpha=0.5, label="least squares, associated")
    for method, name, marker in (("csht", "paper, CSHT", "*"), ("sht", "paper, SHT", "p")):
        paper = [(c["parameters"][key], c["paper"][metric]) for c in cells
                 if c["method"] == method and metric in c["paper"]]
        if paper:
            axis.plot(*zip(*paper), **{**PAPER, "marker": marker}, label=name)


def plot_over_misses(album, cells, clutter, metric, name):
    grid = where(cells, clutter=clutter, sigma=3.0)
    false_alarms = sorted({c["parameters"]["p_false_alarm"] for c in grid})
    if not grid or len({c["parameters"]["p_miss"] for c in grid}) < 2:
        return
    figure, axes = plt.subplots(1, len(false_alarms), sharey=True, figsize=(4 * len(false_alarms), 4.2), squeeze=False)
    for axis, p_false_alarm in zip(axes[0], false_alarms):
        draw_lines(axis, where(grid, p_false_alarm=p_false_alarm), "p_miss", metric)
        axis.text(0.03, 0.97, f"$P_F$ = {p_false_alarm:g}", transform=axis.transAxes, va="top")
        axis.set_xlabel("$P_M$")
        axis.grid(alpha=0.3)
    axes[0][0].set_ylabel(METRICS[metric][0])
    axes[0][-1].legend(fontsize=8, loc="center left", bbox_to_anchor=(1.02, 0.5))
    album.save(figure, f"{name}_{clutter}", f"{METRICS[metric][0]} over the miss rate, Table 2 scene, window of 20 scans, "
               f"sigma 3 m, {clutter} clutter; bars: 95 % intervals. Paper's Fig. {int(name[-2:])}.")


def plot_over_sigma(album, cells, clutter, metric, name):
    chosen = where(cells, clutter=clutter, p_false_alarm=0.3, p_miss=0.3)
    if len({c["parameters"]["sigma"] for c in chosen}) < 2:
        return
    figure, axis = plt.subplots(figsize=(6, 4.2))
    draw_lines(axis, chosen, "sigma", metric)
    axis.set_xlabel("sigma [m]")
    axis.set_ylabel(METRICS[metric][0])
    axis.legend(fontsize=7)
    axis.grid(alpha=0.3)
    album.save(figure, f"{name}_{clutter}", f"{METRICS[metric][0]} over sigma, Table 2 scene, P_F = P_M = 0.3, {clutter} "
               f"clutter; bars: 95 % intervals. Paper's Fig. {int(name[-2:])}.")


def paths_by_id(rows):
    paths = {}
    for row in rows:
        paths.setdefault(row["id"], []).append((float(row["east_m"]), float(row["north_m"])))
    return paths


def words_of(pictured):
    p = pictured["parameters"]
    return (f"{p['clutter']} clutter, P_F = {p['p_false_alarm']:g}, P_M = {p['p_miss']:g}, sigma {p['sigma']:g} m, "
            f"{p['window_scans']:g} scans, seed {pictured['seed']}, run 0")


def draw_samples(axis, detections, truth, coordinate):
    """The samples of one coordinate over time, the targets as broad lines."""
    column = coordinate + "_m"
    for identity in dict.fromkeys(row["id"] for row in truth):
        own = [row for row in truth if row["id"] == identity]
        axis.plot([float(r["time_s"]) for r in own], [float(r[column]) for r in own], **TRUTH)
    axis.plot([float(r["time_s"]) for r in detections], [float(r[column]) for r in detections], "k.", markersize=4)
    axis.set_xlabel("time [s]")
    axis.set_ylabel(f"{coordinate} [m]")


def draw_fits(axis, elements, times, coordinate):
    """The fitted lines: an element is a position at the newest scan and a velocity."""
    end = max(times)
    for index, row in enumerate(elements):
        position, velocity = float(row[coordinate + "_m"]), float(row[coordinate + "_velocity_mps"])
        look = {**style(index), "marker": "none"}
        axis.plot([min(times), end], [position - velocity * (end - min(times)), position], **look)


def plot_samples(album, directory, words):
    detections, truth = rows_of(directory / "window_detections.csv"), rows_of(directory / "window_truth.csv")
    times = [float(row["time_s"]) for row in truth]
    for (coordinate, letter), name in zip(AXES, ("yan2018_fig08", "yan2018_fig13")):
        figure, axis = plt.subplots(figsize=(6, 4.2))
        draw_samples(axis, detections, truth, coordinate)
        album.save(figure, name, f"Samples in {letter} and t, grey: the targets ({words}). Paper's Fig. {int(name[-2:])}.")
    for method, names in (("sht", ("yan2018_fig10", "yan2018_fig14")), ("csht", ("yan2018_fig12", "yan2018_fig15")),
                          ("csht_printed", ("fits_printed_north", "fits_printed_east"))):
        if not (directory / f"window_{method}.csv").exists():
            continue
        elements = rows_of(directory / f"window_{method}.csv")
        for (coordinate, letter), name in zip(AXES, names):
            figure, axis = plt.subplots(figsize=(6, 4.2))
            draw_samples(axis, detections, truth, coordinate)
            draw_fits(axis, elements, times, coordinate)
            paper = f" Paper's Fig. {int(name[-2:])}." if name[-2:].isdigit() else ""
            album.save(figure, name, f"The {len(elements)} lines that {method} finds in {letter} and t ({words}).{paper}")


def plot_votes(album, directory, words):
    """Fig. 9: the vote distribution and its plane view; Fig. 11: the classes."""
    votes, classes = rows_of(directory / "votes.csv"), rows_of(directory / "classes.csv")
    north = [row for row in votes if row["axis"] == "north"]
    figure = plt.figure(figsize=(12, 5))
    space = figure.add_subplot(1, 2, 1, projection="3d")
    space.plot_trisurf([float(r["velocity_mps"]) for r in north], [float(r["intercept_m"]) for r in north],
                       [float(r["votes"]) for r in north], cmap="Greys", linewidth=0)
    space.set_xlabel("north velocity [m/s]")
    space.set_ylabel("north [m]")
    space.set_zlabel("votes")
    draw_votes(figure, figure.add_subplot(1, 2, 2), "north", north, [])
    album.save(figure, "yan2018_fig09", f"Vote distribution of the north axis and its plane view ({words}). Paper's Fig. 9.")
    figure, panels = plt.subplots(1, 2, figsize=(13, 5))
    for axes, (axis, _) in zip(panels, AXES):
        cells = [row for row in votes if row["axis"] == axis]
        draw_votes(figure, axes, axis, cells, [row for row in classes if row["axis"] == axis])
    counts = [sum(row["axis"] == axis for row in classes) for axis, _ in AXES]
    album.save(figure, "yan2018_fig11", f"Vote matrices of csht and the classes that fuzzy ISODATA finds, {counts[0]} in north "
               f"and {counts[1]} in east: each proposes a line, refit, ownership and evidence decide ({words}). Paper's Fig. 11.")


def plot_plan(album, directory, words):
    """Each method's elements over the plan view."""
    detections, truth = rows_of(directory / "window_detections.csv"), rows_of(directory / "window_truth.csv")
    methods = sorted(path.stem[len("window_"):] for path in directory.glob("window_*.csv")
                     if path.stem not in ("window_detections", "window_truth"))
    if not methods:
        return
    figure, axes = plt.subplots(1, len(methods), sharex=True, sharey=True, figsize=(5 * len(methods), 5), squeeze=False)
    for axis, method in zip(axes[0], methods):
        axis.scatter([float(r["east_m"]) for r in detections], [float(r["north_m"]) for r in detections], s=6,
                     c=[float(r["time_s"]) for r in detections], cmap="Greys", edgecolors="0.4", linewidths=0.3)
        for path in paths_by_id(truth).values():
            axis.plot(*zip(*path), **TRUTH)
        for row in rows_of(directory / f"window_{method}.csv"):
            end = (float(row["east_m"]), float(row["north_m"]))
            start = (end[0] - 5 * float(row["east_velocity_mps"]), end[1] - 5 * float(row["north_velocity_mps"]))
            axis.annotate("", end, start, arrowprops={"arrowstyle": "->", "color": "#d55e00", "linewidth": 2})
        axis.text(0.03, 0.97, method, transform=axis.transAxes, va="top")
        axis.set_xlabel("east [m]")
        axis.set_aspect("equal")
    axes[0][0].set_ylabel("north [m]")
    album.save(figure, "window", f"One window in plan view: detections (dark: late), targets (grey), elements with their last 5 s ({words}).")


def draw_trajectories(axis, rows, colour, seconds):
    """Each trajectory over its last `seconds`, the heavier the darker; the weights are in nats."""
    heaviest = max((float(row["weight"]) for row in rows), default=1.0)
    for row in rows:
        north, east = float(row["north_m"]), float(row["east_m"])
        back = (east - seconds * float(row["east_velocity_mps"]), north - seconds * float(row["north_velocity_mps"]))
        darkness = min(1.0, max(0.15, float(row["weight"]) / max(heaviest, 1.0)))
        axis.plot(*zip(back, (east, north)), color=colour, alpha=darkness, linewidth=1.2)
        axis.plot(east, north, ".", color=colour, alpha=darkness, markersize=4)


def keep_near(axis, detections):
    """Shows the detections and a quarter more on each side: what could not be seen yet may lie anywhere."""
    for name, show in (("east_m", axis.set_xlim), ("north_m", axis.set_ylim)):
        values = [float(row[name]) for row in detections]
        margin = 0.25 * (max(values) - min(values))
        show(min(values) - margin, max(values) + margin)


def plot_joint_window(album, directory, words):
    """One window of the joint estimator: densities, hypotheses, and the elements that it reports."""
    detections, truth = rows_of(directory / "joint_detections.csv"), rows_of(directory / "joint_truth.csv")
    times = [float(row["time_s"]) for row in detections]
    seconds = max(times) - min(times)
    figure, axes = plt.subplots(1, 2, sharex=True, sharey=True, figsize=(12, 6))
    for axis in axes:
        axis.scatter([float(r["east_m"]) for r in detections], [float(r["north_m"]) for r in detections], s=4, c=times,
                     cmap="Greys", vmin=min(times) - seconds)
        for path in paths_by_id(truth).values():
            axis.plot(*zip(*path), **TRUTH)
        axis.set_xlabel("east [m]")
        axis.set_aspect("equal")
    keep_near(axes[0], detections)
    draw_trajectories(axes[0], rows_of(directory / "joint_clouds.csv"), "#0072b2", seconds)
    draw_trajectories(axes[1], rows_of(directory / "joint_hypotheses.csv"), "#d55e00", seconds)
    for row in rows_of(directory / "joint_elements.csv"):
        axes[1].plot(float(row["east_m"]), float(row["north_m"]), "k*", markersize=13)
    axes[0].set_ylabel("north [m]")
    album.save(figure, "joint_window", f"joint, one window ({words}). Left the trajectories that stand for each hypothesis, right the "
               "hypotheses (darker: likelier) and the elements (stars); grey: targets.")


def pictured(directory, name):
    path = directory / f"pictured_{name}.json"
    return words_of(json.loads(path.read_text())) if path.exists() else None


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    directory = pathlib.Path(sys.argv[1])
    album = Album(directory)
    cells = paper_cells(directory)
    if words := pictured(directory, "window"):
        plot_samples(album, directory, words)
        plot_votes(album, directory, words)
        plot_plan(album, directory, words)
    if words := pictured(directory, "joint"):
        plot_joint_window(album, directory, words)
    for clutter in sorted({cell["parameters"]["clutter"] for cell in cells}):
        plot_over_misses(album, cells, clutter, "velocity_ospa", "yan2018_fig16")
        plot_over_misses(album, cells, clutter, "position_ospa", "yan2018_fig17")
        plot_over_sigma(album, cells, clutter, "velocity_ospa", "yan2018_fig18")
        plot_over_sigma(album, cells, clutter, "position_ospa", "yan2018_fig19")
    paper_tables.write_tables(directory)


if __name__ == "__main__":
    main()
