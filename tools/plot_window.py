#!/usr/bin/python3
"""Plots of the csht-window experiment: OSPA over P_M and over sigma beside the paper and the least-squares reference,
and one window drawn.

Usage: plot_window.py DIR, where `lookout experiment csht-window --out DIR` has written.
"""
import csv
import json
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from plot_demo import plot_votes  # noqa: E402

COLOURS = ["tab:blue", "tab:orange", "tab:green", "tab:red", "tab:purple", "tab:brown"]
SIGMA_OF_THE_GRID = 3.0
PROBABILITY_OF_THE_SIGMAS = 0.3
WINDOW_OF_THE_PAPER = 20


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
    for method, colour in zip(methods, COLOURS):
        own = sorted((c for c in cells if c["method"] == method), key=lambda c: c["parameters"][key])
        x = [c["parameters"][key] for c in own]
        axis.errorbar(x, [c["metrics"][metric]["mean"] for c in own], [c["metrics"][metric]["ci95"] or 0.0 for c in own],
                      color=colour, marker="o", markersize=3, capsize=2, linewidth=1, label=method)
    first = sorted((c for c in cells if c["method"] == methods[0]), key=lambda c: c["parameters"][key])
    x = [c["parameters"][key] for c in first]
    axis.plot(x, [c["metrics"]["bound"]["mean"] for c in first], "k--", linewidth=1, label="least squares, associated")
    paper = [(c["parameters"][key], c["paper"][metric]) for c in first if metric in c["paper"]]
    if paper:
        axis.plot(*zip(*paper), "k*", markersize=7, label="paper")


def plot_over_misses(directory, cells, clutter):
    grid = where(cells, clutter=clutter, sigma=SIGMA_OF_THE_GRID)
    false_alarms = sorted({c["parameters"]["p_false_alarm"] for c in grid})
    figure, axes = plt.subplots(1, len(false_alarms), sharey=True, figsize=(4 * len(false_alarms), 4.2), squeeze=False)
    for axis, p_false_alarm in zip(axes[0], false_alarms):
        draw_lines(axis, where(grid, p_false_alarm=p_false_alarm), "p_miss", "position_ospa")
        axis.set_title(f"$P_F$ = {p_false_alarm:g}")
        axis.set_xlabel("$P_M$")
        axis.grid(alpha=0.3)
    axes[0][0].set_ylabel("position OSPA [m]")
    axes[0][0].legend(fontsize=8, loc="upper left")
    figure.suptitle(f"Table 2 scene, W = {WINDOW_OF_THE_PAPER}, sigma 3 m, {clutter} clutter")
    save(figure, directory / f"window_ospa_{clutter}.png")


def plot_over_sigma(directory, cells, clutter):
    chosen = where(cells, clutter=clutter, p_false_alarm=PROBABILITY_OF_THE_SIGMAS, p_miss=PROBABILITY_OF_THE_SIGMAS)
    if len({c["parameters"]["sigma"] for c in chosen}) < 2:
        return
    figure, axis = plt.subplots(figsize=(6, 4.2))
    draw_lines(axis, chosen, "sigma", "position_ospa")
    axis.set_xlabel("sigma [m]")
    axis.set_ylabel("position OSPA [m]")
    axis.set_title(f"$P_F = P_M$ = {PROBABILITY_OF_THE_SIGMAS}, {clutter} clutter")
    axis.legend(fontsize=8)
    axis.grid(alpha=0.3)
    save(figure, directory / f"window_sigma_{clutter}.png")


def paths_by_id(rows):
    paths = {}
    for row in rows:
        paths.setdefault(row["id"], []).append((float(row["east_m"]), float(row["north_m"])))
    return paths


def plot_one_window(directory):
    detections, truth = rows_of(directory / "window_detections.csv"), rows_of(directory / "window_truth.csv")
    methods = sorted(path.stem[len("window_"):] for path in directory.glob("window_*.csv")
                     if path.stem not in ("window_detections", "window_truth"))
    figure, axes = plt.subplots(1, len(methods), sharex=True, sharey=True, figsize=(5 * len(methods), 5), squeeze=False)
    for axis, method in zip(axes[0], methods):
        axis.scatter([float(r["east_m"]) for r in detections], [float(r["north_m"]) for r in detections], s=6,
                     c=[float(r["time_s"]) for r in detections], cmap="viridis")
        for path in paths_by_id(truth).values():
            axis.plot(*zip(*path), color="0.7", linewidth=6, alpha=0.6, solid_capstyle="round", zorder=0)
        for row in rows_of(directory / f"window_{method}.csv"):
            axis.annotate("", (float(row["east_m"]), float(row["north_m"])),
                          (float(row["east_m"]) - 5 * float(row["east_velocity_mps"]),
                           float(row["north_m"]) - 5 * float(row["north_velocity_mps"])),
                          arrowprops={"arrowstyle": "->", "color": "tab:red", "linewidth": 2})
        axis.set_title(f"{method} (grey: targets; arrows: elements, last 5 s)", fontsize=9)
        axis.set_xlabel("east [m]")
        axis.set_aspect("equal")
    axes[0][0].set_ylabel("north [m]")
    save(figure, directory / "window.png")


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


def plot_joint_window(directory):
    """One literal window of the joint estimator: densities, hypotheses, and the elements that it reports."""
    detections, truth = rows_of(directory / "joint_detections.csv"), rows_of(directory / "joint_truth.csv")
    times = [float(row["time_s"]) for row in detections]
    seconds = max(times) - min(times)
    figure, axes = plt.subplots(1, 2, sharex=True, sharey=True, figsize=(12, 6))
    for axis in axes:
        axis.scatter([float(r["east_m"]) for r in detections], [float(r["north_m"]) for r in detections], s=4, c=times,
                     cmap="Greys", vmin=min(times) - seconds)
        for path in paths_by_id(truth).values():
            axis.plot(*zip(*path), color="tab:green", linewidth=7, alpha=0.3, solid_capstyle="round", zorder=0)
        axis.set_xlabel("east [m]")
        axis.set_aspect("equal")
    keep_near(axes[0], detections)
    draw_trajectories(axes[0], rows_of(directory / "joint_clouds.csv"), "tab:blue", seconds)
    draw_trajectories(axes[1], rows_of(directory / "joint_hypotheses.csv"), "tab:orange", seconds)
    for row in rows_of(directory / "joint_elements.csv"):
        axes[1].plot(float(row["east_m"]), float(row["north_m"]), "*", color="tab:red", markersize=13)
    axes[0].set_title("densities: the trajectories that stand for each hypothesis")
    axes[1].set_title("hypotheses (darker: likelier), elements (stars)")
    axes[0].set_ylabel("north [m]")
    figure.suptitle("joint, one window of 20 scans, literal clutter, $P_F = P_M$ = 0.3 "
                    "(green: targets; grey: detections)", y=0.97)
    save(figure, directory / "joint_window.png")


def save(figure, path):
    figure.savefig(path, dpi=130, bbox_inches="tight")
    plt.close(figure)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    directory = pathlib.Path(sys.argv[1])
    cells = paper_cells(directory)
    for clutter in sorted({cell["parameters"]["clutter"] for cell in cells}):
        plot_over_misses(directory, cells, clutter)
        plot_over_sigma(directory, cells, clutter)
    plot_one_window(directory)
    plot_joint_window(directory)
    plot_votes(directory)


if __name__ == "__main__":
    main()
