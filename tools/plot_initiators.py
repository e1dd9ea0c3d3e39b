#!/usr/bin/python3
"""Plots of the initiator experiments: accumulators as pictures, scores and time against the clutter.

Usage: plot_initiators.py DIR, where `lookout experiment nht-simulated|nht-real|agfht-table2|agfht-sweep --out DIR`
has written. Also writes growth.csv: the exponent b of time ~ clutter^b, a straight line through the logarithms.
"""
import csv
import json
import math
import pathlib
import sys

from plot_style import plt, save_both

SWEPT = [("p1", "$P_1$"), ("p2", "$P_2$"), ("p3", "$P_3$"), ("discrimination", "discrimination $D$"),
         ("found", "found"), ("false_per_run", "false tracks a run"), ("time_ms", "time [ms]")]
LOGARITHMIC = {"time_ms"}
SITUATIONS = ["I", "II", "III", "IV", "real"]


def rows_of(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def save(figure, path):
    figure.tight_layout()
    save_both(figure, path)
    print(path)


def label_of(cell):
    """Method and every parameter but the clutter: one curve."""
    parameters = cell["parameters"]
    words = [cell["method"]] + [str(parameters[name]) for name in ("variant", "noise") if name in parameters]
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
    return {label: curve for label, curve in curves.items() if len(curve) > 1}


def points_of(curve, metric, source="metrics"):
    points = []
    for cell in curve:
        value = cell[source].get(metric)
        value = value["mean"] if isinstance(value, dict) else value
        if value is not None and math.isfinite(value):
            points.append((cell["parameters"]["clutter_per_scan"], value))
    return points


def plot_against_clutter(directory, curves):
    for metric, axis_label in SWEPT:
        figure, axis = plt.subplots(figsize=(8, 5))
        drawn = False
        for label, curve in curves.items():
            points = points_of(curve, metric)
            if len(points) < 2:
                continue
            drawn = True
            (line,) = axis.plot(*zip(*points), marker="o", label=label)
            paper = points_of(curve, metric, "paper")
            if len(paper) > 1:
                axis.plot(*zip(*paper), linestyle="--", marker="x", color=line.get_color(), label=label + " (paper)")
        axis.set_xlabel("mean clutter plots a scan")
        axis.set_ylabel(axis_label)
        if metric in LOGARITHMIC:
            axis.set_xscale("log")
            axis.set_yscale("log")
        if drawn:
            axis.legend(fontsize="x-small")
            save(figure, directory / f"{metric}_against_clutter.png")
        plt.close(figure)


def growth_exponent(points):
    xs = [math.log(x) for x, y in points if y > 0]
    ys = [math.log(y) for x, y in points if y > 0]
    mean_x, mean_y = sum(xs) / len(xs), sum(ys) / len(ys)
    return sum((x - mean_x) * (y - mean_y) for x, y in zip(xs, ys)) / sum((x - mean_x) ** 2 for x in xs)


def write_growth(directory, curves):
    with open(directory / "growth.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["curve", "exponent", "time_ms_least_clutter", "time_ms_most_clutter"])
        for label, curve in curves.items():
            points = points_of(curve, "time_ms")
            if len(points) > 1:
                writer.writerow([label, f"{growth_exponent(points):.2f}", points[0][1], points[-1][1]])


def draw_picture(axis, path):
    rows = rows_of(path)
    votes = [row for row in rows if row["target"] == "0"]
    targets = [row for row in rows if row["target"] == "1"]
    axis.scatter([float(row["theta_rad"]) for row in votes], [float(row["rho_m"]) for row in votes],
                 c=[float(row["value"]) for row in votes], s=1, cmap="viridis", marker="s", linewidths=0)
    axis.scatter([float(row["theta_rad"]) for row in targets], [float(row["rho_m"]) for row in targets],
                 facecolors="none", edgecolors="red", s=60)
    axis.set_xlim(0, math.pi)


def plot_pictures(directory):
    """One figure a method, a panel for each scene whose accumulator was written."""
    names = sorted({path.stem.split("_", 2)[2] for path in directory.glob("accumulator_*.csv")})
    for name in names:
        paths = [(situation, directory / f"accumulator_{situation}_{name}.csv") for situation in SITUATIONS]
        paths = [(situation, path) for situation, path in paths if path.exists()]
        figure, axes = plt.subplots(1, len(paths), figsize=(4 * len(paths), 4), sharey=True, squeeze=False)
        for axis, (situation, path) in zip(axes[0], paths):
            draw_picture(axis, path)
            axis.set_title(f"{name}, {'Table 3' if situation == 'real' else 'Situation ' + situation}")
            axis.set_xlabel(r"$\theta$ [rad]")
        axes[0][0].set_ylabel(r"$\rho$ [m]")
        save(figure, directory / f"accumulator_{name}.png")


def plot_table(directory, cells):
    """P2 and P3 side by side, the paper's as crosses, where the cells are rows of a table and not a sweep."""
    rows = [cell for cell in cells if "p3" in cell["metrics"] and "scans" in cell["parameters"]]
    if not rows:
        return
    figure, axes = plt.subplots(1, 2, figsize=(12, 0.35 * len(rows) + 1.5), sharey=True)
    labels = []
    for cell in rows:
        p = cell["parameters"]
        labels.append(f"{label_of(cell)} N={p['scans']:g} clutter {p['clutter_per_scan']:g} "
                      f"$P_D$ {p['detection_probability']:g}")
    for axis, metric, title in zip(axes, ("p2", "p3"), ("$P_2$", "$P_3$")):
        axis.barh(range(len(rows)), [cell["metrics"][metric]["mean"] or 0.0 for cell in rows], color="tab:blue")
        printed = [(cell["paper"][metric], i) for i, cell in enumerate(rows) if metric in cell["paper"]]
        axis.plot([x for x, _ in printed], [y for _, y in printed], "kx", label="paper")
        axis.set_title(title)
        axis.legend()
    axes[0].set_yticks(range(len(rows)), labels, fontsize="x-small")
    axes[0].invert_yaxis()
    save(figure, directory / "table.png")


def main():
    directory = pathlib.Path(sys.argv[1])
    cells = json.loads((directory / "results.json").read_text())["cells"]
    curves = curves_of(cells)
    plot_against_clutter(directory, curves)
    write_growth(directory, curves)
    plot_pictures(directory)
    plot_table(directory, cells)


if __name__ == "__main__":
    main()
