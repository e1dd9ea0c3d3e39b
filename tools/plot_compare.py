#!/usr/bin/python3
"""Pictures and report of a comparison: means over time with bands, as PDF and PNG, and report.html.

Usage: plot_compare.py DIR, where `lookout compare --out DIR` or `lookout merge --out DIR` has written.
"""
import csv
import json
import pathlib
import sys

import plot_compare_report

PANELS = [("ospa", "OSPA [m]"), ("gospa", "GOSPA [m]"), ("gospa_missed", "GOSPA, missed [m]"),
          ("gospa_false", "GOSPA, false [m]"), ("ospa2", "OSPA(2) [m]"), ("tgospa", "T-GOSPA of a scan [m]"),
          ("num_tracks", "tracks (black: targets)"), ("nees", "NEES (dotted: 95 % bounds)"),
          ("time_to_confirm_s", "time to confirm so far [s]"), ("false_per_100s", "false tracks in 100 s so far"),
          ("identity_switches", "identity switches so far"), ("velocity_ospa", "velocity OSPA [m/s]")]
COLUMNS = 3
PANEL_SIZE = (4.6, 2.7)  # inches


def curves_of(directory):
    """{(scene, method, metric): [(time, mean, ci95 or None, low or None, high or None), ...]}."""
    curves = {}
    with open(directory / "means.csv", newline="") as file:
        for row in csv.DictReader(file):
            optional = [float(row[name]) if row[name] else None for name in ("ci95", "bound_low", "bound_high")]
            curves.setdefault((row["scene"], row["method"], row["metric"]), []).append(
                (float(row["time_s"]), float(row["mean"]), *optional))
    return curves


def draw_curve(axis, points, colour, label):
    times, means, half, low, high = (list(values) for values in zip(*points))
    axis.plot(times, means, color=colour, linewidth=1, label=label)
    if all(value is not None for value in low):
        axis.plot(times, low, times, high, color=colour, linewidth=0.6, linestyle=":")
        return
    # No measure is below 0, though an interval by Student's t may reach there.
    banded = [(t, max(0.0, m - h), m + h) for t, m, h in zip(times, means, half) if h is not None]
    if banded:
        axis.fill_between(*zip(*banded), color=colour, alpha=0.2, linewidth=0)


def draw_panel(axis, metric, label, scene, methods, curves):
    for number, method in enumerate(methods):
        points = curves.get((scene, method, metric))
        if points:
            draw_curve(axis, points, f"C{number}", method)
    if metric == "num_tracks" and (scene, methods[0], "num_targets") in curves:
        points = curves[scene, methods[0], "num_targets"]
        axis.plot([p[0] for p in points], [p[1] for p in points], color="black", linewidth=1)
    if metric == "nees":
        axis.set_yscale("log")
    axis.set_title(label, fontsize=9)
    axis.tick_params(labelsize=8)


def draw_scene(plt, directory, scene, results, curves):
    rows = -(-len(PANELS) // COLUMNS)
    figure, axes = plt.subplots(rows, COLUMNS, sharex=True, figsize=(PANEL_SIZE[0] * COLUMNS, PANEL_SIZE[1] * rows))
    for axis, (metric, label) in zip(axes.flat, PANELS):
        draw_panel(axis, metric, label, scene, results["methods"], curves)
    for axis in axes[-1]:
        axis.set_xlabel("time [s]", fontsize=9)
    handles, labels = axes.flat[0].get_legend_handles_labels()
    figure.legend(handles, labels, ncol=len(labels), loc="upper center", fontsize=9)
    figure.suptitle(f"{scene}: mean of {results['runs']} runs, band: 95 % interval of the mean", y=0.955, fontsize=10)
    figure.tight_layout(rect=(0, 0, 1, 0.95))
    save(figure, directory / scene.replace("/", "_"))
    plt.close(figure)


def draw_sweep(plt, directory, results):
    """The tested metrics over the values of a parameter, where `lookout tune` has written sweep.csv."""
    with open(directory / "sweep.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    metrics = [name for name, column in results["columns"].items() if column["tested"]]
    figure, axes = plt.subplots(-(-len(metrics) // COLUMNS), COLUMNS, squeeze=False,
                                figsize=(PANEL_SIZE[0] * COLUMNS, PANEL_SIZE[1] * -(-len(metrics) // COLUMNS)))
    for axis, metric in zip(axes.flat, metrics):
        for scene in results["scenes"]:
            points = [row for row in rows if row["metric"] == metric and row["scene"] == scene]
            axis.errorbar([float(row["value"]) for row in points], [float(row["mean"]) for row in points],
                          [float(row["ci95"] or 0) for row in points], marker="o", markersize=3, linewidth=1, capsize=2)
        axis.axvline(float(results["reference"]), color="0.6", linestyle="--", linewidth=0.8)
        unit = results["columns"][metric]["unit"]
        axis.set_title(metric if unit == "1" else f"{metric} [{unit}]", fontsize=9)
        axis.tick_params(labelsize=8)
    for axis in axes.flat[len(metrics):]:
        axis.set_visible(False)
    figure.suptitle(f"{results['parameter']} (dashed: present value), mean and 95 % interval of {results['runs']} runs",
                    fontsize=10)
    figure.tight_layout()
    save(figure, directory / "sweep")
    plt.close(figure)


def save(figure, stem):
    """As PNG and PDF, the same bytes each time."""
    figure.savefig(f"{stem}.png", dpi=110, metadata={"Software": None})
    figure.savefig(f"{stem}.pdf", metadata={"CreationDate": None, "Producer": None, "Creator": None})


def draw(directory, results):
    """Draws every scene; False where Matplotlib is not installed."""
    try:
        import matplotlib
    except ImportError:
        return False
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    curves = curves_of(directory)
    for scene in results["scenes"]:
        draw_scene(plt, directory, scene, results, curves)
    if results["parameter"]:
        draw_sweep(plt, directory, results)
    return True


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    directory = pathlib.Path(sys.argv[1])
    results = json.loads((directory / "results.json").read_text())
    drawn = draw(directory, results)
    plot_compare_report.write(directory, results)
    if not drawn:
        sys.exit("plot_compare.py: no pictures in report.html: python3-matplotlib is not installed")


if __name__ == "__main__":
    main()
