#!/usr/bin/python3
"""Plots of the initiator experiments: accumulators as pictures, scores and time against the clutter.

Usage: plot_initiators.py DIR, where `lookout experiment NAME --out DIR` has written, NAME one of nht-simulated nht-real
agfht-table2 agfht-sweep initiator-curves initiator-limits initiator-times. Accumulators are drawn flat and as surfaces,
scenes with the started tracks; captions are in pictures.md. Also writes growth.csv: the exponent b of time ~ clutter^b, a straight line through the logarithms.
"""
import csv
import json
import math
import pathlib
import sys

import numpy as np

from plot_style import PAPER, Album, plt, style

SWEPT = [("p1", "$P_1$"), ("p2", "$P_2$"), ("p3", "$P_3$"), ("discrimination", "discrimination $D$"),
         ("found", "found"), ("false_per_run", "false tracks a run"), ("time_ms", "time [ms]")]
LOGARITHMIC = {"time_ms"}
SHARES = {"p1", "p2", "p3", "found"}
SHARE_LIMITS = (-0.03, 1.03)  # the interval of few runs reaches beyond what a share can be
SHORT = {"scans": "N", "window_scans": "of", "min_plots": "K", "detection_probability": "$P_D$",
         "threshold": "at", "max_turn_rate_deg": "turns to"}
LIMITS = [("turn_rate_deg", "turn rate [degrees/s]"), ("acceleration", "acceleration [m/s$^2$]")]
SITUATIONS = ["I", "II", "III", "IV", "real"]
SURFACE_CELLS = 60  # a side: more take twice as long to draw and show nothing else


def rows_of(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def save(album, figure, name, caption):
    figure.tight_layout()
    album.save(figure, name, caption)
    print(album.directory / f"{name}.png")


def draw_curve(axis, points, index, label):
    """(x, mean, half width of the 95 % interval) as a curve with bars."""
    axis.errorbar(*zip(*points), capsize=2, label=label, **style(index))


def name_panel(axis, name):
    axis.text(0.03, 0.97, name, transform=axis.transAxes, va="top", fontsize=8, bbox={"fc": "w", "alpha": 0.7, "lw": 0})


def label_of(cell):
    """Method and every parameter but the clutter and the scene's situation: one curve."""
    words = [cell["method"]]
    for name, value in cell["parameters"].items():
        if name in ("clutter_per_scan", "situation"):
            continue
        words.append(value if isinstance(value, str) else f"{SHORT.get(name, name)} {value:g}")
    return " ".join(words)


def curves_of(cells):
    """Cells by curve, rising clutter; of the NHT scene Situation IV alone."""
    curves = {}
    for cell in cells:
        parameters = cell["parameters"]
        if parameters.get("situation", "IV") != "IV" or parameters.get("clutter_per_scan", 0) <= 0:
            continue
        curves.setdefault(label_of(cell), []).append(cell)
    for curve in curves.values():
        curve.sort(key=lambda cell: cell["parameters"]["clutter_per_scan"])
    clutters = {label: {cell["parameters"]["clutter_per_scan"] for cell in curve} for label, curve in curves.items()}
    return {label: curve for label, curve in curves.items() if len(clutters[label]) > 1}


def estimate_of(cell, metric, source="metrics"):
    """(mean, half width) of a figure of a cell; None where it has none. A paper's figure has no width."""
    value = cell[source].get(metric)
    mean, width = (value["mean"], value.get("ci95")) if isinstance(value, dict) else (value, None)
    return None if mean is None or not math.isfinite(mean) else (mean, width or 0.0)


def points_of(curve, metric, source="metrics", key="clutter_per_scan"):
    """(x, mean, half width) of the cells that have the figure."""
    found = [(cell["parameters"][key], estimate_of(cell, metric, source)) for cell in curve]
    return [(x, *estimate) for x, estimate in found if estimate]


def plot_against_clutter(album, curves):
    for metric, axis_label in SWEPT:
        drawn = {label: points_of(curve, metric) for label, curve in curves.items()}
        drawn = {label: points for label, points in drawn.items() if len(points) > 1}
        if not drawn:
            continue
        figure, axis = plt.subplots(figsize=(8, 5))
        for index, (label, points) in enumerate(drawn.items()):
            draw_curve(axis, points, index, label)
            paper = points_of(curves[label], metric, "paper")
            if len(paper) > 1:
                axis.plot(*list(zip(*paper))[:2], **{**PAPER, "markeredgecolor": style(index)["color"]}, label=label + " (paper)")
        axis.set_xlabel("mean clutter plots a scan")
        axis.set_ylabel(axis_label)
        if metric in LOGARITHMIC:
            axis.set_xscale("log")
            axis.set_yscale("log")
        if metric in SHARES:
            axis.set_ylim(SHARE_LIMITS)
        axis.legend(fontsize="x-small")
        save(album, figure, f"{metric}_against_clutter", f"{axis_label} against the clutter; bars: 95 % intervals, stars: the paper's.")


def growth_exponent(points):
    """None where the points have one clutter only, or no time."""
    xs = [math.log(x) for x, y, *_ in points if y > 0]
    ys = [math.log(y) for x, y, *_ in points if y > 0]
    if len(set(xs)) < 2:
        return None
    mean_x, mean_y = sum(xs) / len(xs), sum(ys) / len(ys)
    return sum((x - mean_x) * (y - mean_y) for x, y in zip(xs, ys)) / sum((x - mean_x) ** 2 for x in xs)


def write_growth(directory, curves):
    with open(directory / "growth.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["curve", "exponent", "time_ms_least_clutter", "time_ms_most_clutter"])
        for label, curve in curves.items():
            points = points_of(curve, "time_ms")
            exponent = growth_exponent(points)
            if exponent is not None:
                writer.writerow([label, f"{exponent:.2f}", points[0][1], points[-1][1]])


def words_of(situation):
    return {"real": "real tracks, Table 3", "radar": "five targets and a radar"}.get(situation, f"Situation {situation}")


def draw_picture(axis, path):
    rows = rows_of(path)
    votes = [row for row in rows if row["target"] == "0"]
    targets = [row for row in rows if row["target"] == "1"]
    axis.scatter([float(row["theta_rad"]) for row in votes], [float(row["rho_m"]) for row in votes],
                 c=[float(row["value"]) for row in votes], s=1, cmap="viridis", marker="s", linewidths=0)
    axis.scatter([float(row["theta_rad"]) for row in targets], [float(row["rho_m"]) for row in targets],
                 facecolors="none", edgecolors="red", s=60)
    axis.set_xlim(0, math.pi)


def plot_pictures(album):
    """One figure a method, a panel for each scene whose accumulator was written."""
    directory = album.directory
    names = sorted({path.stem.split("_", 2)[2] for path in directory.glob("accumulator_*.csv")})
    for name in names:
        paths = [(situation, directory / f"accumulator_{situation}_{name}.csv") for situation in SITUATIONS]
        paths = [(situation, path) for situation, path in paths if path.exists()]
        figure, axes = plt.subplots(1, len(paths), figsize=(4 * len(paths), 4), sharey=True, squeeze=False)
        for axis, (situation, path) in zip(axes[0], paths):
            draw_picture(axis, path)
            name_panel(axis, words_of(situation))
            axis.set_xlabel(r"$\theta$ [rad]")
        axes[0][0].set_ylabel(r"$\rho$ [m]")
        save(album, figure, f"accumulator_{name}", f"Accumulator of {name} from above, the targets' lines as circles. [Fan2018] Fig. 7 to "
             "10, 15.")


def cells_of_picture(path, columns=SURFACE_CELLS):
    """The votes of a picture on a coarse grid of theta and rho, the largest of each cell: a surface that can be seen."""
    votes = [row for row in rows_of(path) if row["target"] == "0"]
    if not votes:
        return None
    theta = [float(row["theta_rad"]) for row in votes]
    rho = [float(row["rho_m"]) for row in votes]
    low, high = min(rho), max(rho) or 1.0
    heights = np.zeros((columns, columns))
    for t, r, row in zip(theta, rho, votes):
        i = min(columns - 1, int(t / math.pi * columns))
        j = min(columns - 1, int((r - low) / max(high - low, 1e-9) * columns))
        heights[j, i] = max(heights[j, i], float(row["value"]))
    return np.linspace(0, math.pi, columns), np.linspace(low, high, columns), heights


def plot_surfaces(album):
    """The accumulators in three dimensions, as the papers draw them: one figure a scene, a panel a method."""
    for situation in SITUATIONS:
        paths = sorted(album.directory.glob(f"accumulator_{situation}_*.csv"))
        pictures = [(path.stem.split("_", 2)[2], cells_of_picture(path)) for path in paths]
        pictures = [(name, cells) for name, cells in pictures if cells is not None]
        if not pictures:
            continue
        figure = plt.figure(figsize=(5 * len(pictures), 4.5))
        for k, (name, (theta, rho, heights)) in enumerate(pictures, 1):
            axis = figure.add_subplot(1, len(pictures), k, projection="3d")
            axis.plot_surface(*np.meshgrid(theta, rho), heights, cmap="viridis", rcount=SURFACE_CELLS, ccount=SURFACE_CELLS)
            axis.set_xlabel(r"$\theta$ [rad]")
            axis.set_ylabel(r"$\rho$ [m]")
            axis.set_zlabel("votes")
            axis.text2D(0.03, 0.97, name, transform=axis.transAxes, va="top")
        save(album, figure, f"surface_{situation}", f"Accumulators in three dimensions, {words_of(situation)}, the first run.")


def draw_scene(axis, rows):
    def points(kind):
        own = [row for row in rows if row["kind"] == kind]
        return [float(row["x_m"]) for row in own], [float(row["y_m"]) for row in own]

    axis.plot(*points("clutter"), ".", color="0.6", markersize=2, label="clutter")
    axis.plot(*points("target"), "k+", markersize=6, label="plots of targets")
    tracks = {}
    for row in rows:
        if row["kind"] == "track":
            tracks.setdefault(row["id"], []).append((float(row["x_m"]), float(row["y_m"])))
    for k, track in enumerate(tracks.values()):
        axis.plot(*zip(*track), "-", color="#d55e00", linewidth=1.5, label="started tracks" if k == 0 else None)
    axis.set_aspect("equal")
    axis.set_xlabel("x [m]")


def plot_scenes(album):
    """The plots of a scene and what each method starts there: one figure a scene, a panel a method."""
    scenes = {}
    for path in sorted(album.directory.glob("scene_*_*.csv")):
        _, situation, name = path.stem.split("_", 2)
        scenes.setdefault(situation, []).append((name, path))
    for situation, paths in scenes.items():
        figure, axes = plt.subplots(1, len(paths), figsize=(5 * len(paths), 4), sharey=True, squeeze=False)
        for axis, (name, path) in zip(axes[0], paths):
            draw_scene(axis, rows_of(path))
            name_panel(axis, name)
        axes[0][0].set_ylabel("y [m]")
        axes[0][0].legend(fontsize="x-small")
        save(album, figure, f"scene_{situation}", f"Plots of the targets and clutter, and the tracks that each method starts, "
             f"{words_of(situation)}, the first run.")


def grouped(cells, swept):
    """Cells that have the parameter `swept`, by every other one."""
    groups = {}
    for cell in cells:
        if swept in cell["parameters"]:
            rest = {name: value for name, value in cell["parameters"].items() if name != swept}
            groups.setdefault(label_of({"method": cell["method"], "parameters": rest}), []).append(cell)
    return {label: group for label, group in groups.items() if len(group) > 1}


def plot_operating_curves(album, cells):
    """P2 against P3 by threshold, a panel for each detection probability."""
    swept = [cell for cell in cells if "threshold" in cell["parameters"]]
    detections = sorted({cell["parameters"]["detection_probability"] for cell in swept})
    if not detections:
        return
    figure, axes = plt.subplots(1, len(detections), figsize=(5 * len(detections), 4.5), sharey=True, squeeze=False)
    for axis, detection in zip(axes[0], detections):
        own = [cell for cell in swept if cell["parameters"]["detection_probability"] == detection]
        for k, method in enumerate(dict.fromkeys(cell["method"] for cell in own)):
            points = [(cell["metrics"]["p3"]["mean"], cell["metrics"]["p2"]["mean"]) for cell in own
                      if cell["method"] == method and cell["metrics"].get("p3", {}).get("mean") is not None]
            if points:
                axis.plot(*zip(*points), label=method, **style(k))
        axis.set_xlabel("$P_3$, false share of the declared")
        name_panel(axis, f"$P_D$ = {detection:g}")
    axes[0][0].set_ylabel("$P_2$, targets with a true track")
    axes[0][0].legend(fontsize="x-small")
    save(album, figure, "operating_curves", "True against false tracks, each method's threshold swept, four plots of six scans.")


def plot_limits(album, cells):
    """P2 and P3 against what a scene of the papers leaves out."""
    for swept, axis_label in LIMITS:
        groups = grouped(cells, swept)
        if not groups:
            continue
        figure, axes = plt.subplots(1, 2, figsize=(11, 4.5))
        for axis, metric, text in zip(axes, ("p2", "p3"), ("$P_2$", "$P_3$")):
            for k, (label, group) in enumerate(groups.items()):
                points = points_of(group, metric, key=swept)
                if points:
                    draw_curve(axis, points, k, label)
            axis.set_xlabel(axis_label)
            axis.set_ylabel(text)
            axis.set_ylim(SHARE_LIMITS)
        axes[1].legend(fontsize="xx-small", loc="center left", bbox_to_anchor=(1.02, 0.5))
        save(album, figure, f"limits_{swept}", f"$P_2$ and $P_3$ over the {axis_label}; bars: 95 % intervals.")


def plot_times(album, cells):
    """Processor time of a window, our bars beside the papers' crosses, on a logarithmic axis."""
    rows = [cell for cell in cells if cell["metrics"].get("time_ms", {}).get("mean")]
    if not any("time_ms" in cell["paper"] for cell in rows):
        return
    swept = [cell for cell in cells if set(cell["parameters"]) == {"scenario", "clutter_per_scan"}]  # initiator-times: all methods
    rows = swept or [cell for cell in rows if "time_ms" in cell["paper"]]
    if not rows:
        return
    figure, axis = plt.subplots(figsize=(9, 0.35 * len(rows) + 1.5))
    axis.barh(range(len(rows)), [cell["metrics"]["time_ms"]["mean"] for cell in rows], color="#0072b2", label="ours")
    printed = [(cell["paper"]["time_ms"], k) for k, cell in enumerate(rows) if "time_ms" in cell["paper"]]
    axis.plot(*zip(*printed), "kx", label="paper")
    axis.set_yticks(range(len(rows)), [f"{label_of(cell)} clutter {cell['parameters']['clutter_per_scan']:g}"
                                      for cell in rows], fontsize="x-small")
    axis.set_xscale("log")
    axis.set_xlabel("time [ms]")
    axis.invert_yaxis()
    axis.legend()
    save(album, figure, "times", "Processor time of one window, ours as bars, the papers' as crosses.")


def plot_table(album, cells):
    """P2 and P3 side by side, the paper's as crosses, where the cells are rows of a table and not a sweep."""
    rows = [cell for cell in cells if "p3" in cell["metrics"] and "scans" in cell["parameters"]
            and "threshold" not in cell["parameters"]]
    if not rows:
        return
    figure, axes = plt.subplots(1, 2, figsize=(12, 0.35 * len(rows) + 1.5), sharey=True)
    labels = []
    for cell in rows:
        p = cell["parameters"]
        labels.append(f"{label_of(cell)} clutter {p['clutter_per_scan']:g}")
    for axis, metric, title in zip(axes, ("p2", "p3"), ("$P_2$", "$P_3$")):
        axis.barh(range(len(rows)), [cell["metrics"][metric]["mean"] or 0.0 for cell in rows], color="#0072b2")
        printed = [(cell["paper"][metric], i) for i, cell in enumerate(rows) if metric in cell["paper"]]
        axis.plot([x for x, _ in printed], [y for _, y in printed], "kx", label="paper")
        axis.set_xlabel(title)
        axis.legend()
    axes[0].set_yticks(range(len(rows)), labels, fontsize="x-small")
    axes[0].invert_yaxis()
    save(album, figure, "table", "True and false tracks by row, ours as bars, the paper's as crosses.")


def main():
    directory = pathlib.Path(sys.argv[1])
    cells = json.loads((directory / "results.json").read_text())["cells"]
    curves = curves_of(cells)
    album = Album(directory)
    plot_against_clutter(album, curves)
    write_growth(directory, curves)
    plot_pictures(album)
    plot_surfaces(album)
    plot_scenes(album)
    plot_operating_curves(album, cells)
    plot_limits(album, cells)
    plot_times(album, cells)
    plot_table(album, cells)


if __name__ == "__main__":
    main()
