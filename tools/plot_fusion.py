#!/usr/bin/python3
"""Plots and tables of `lookout experiment t2gt`: plot_fusion.py DIR

Reads results.json and rmse_over_time.csv in DIR; writes, for each azimuth noise and fault, rmse_NOISE_FAULT.png
(position RMSE of each target over time with its 95 % band, by method, in the manner of Figure 4 of Li, Fan, Yuan, Li), and
structure.png (Figure 1: the two structures of track fusion), scene.png (Figures 2 and 3: true courses, what the radars
tell, what printed `sdf` makes of it, or the method that --only left), pictures.md (captions), nees.md (how honest each
method's covariance is), and comparison.md (every figure with half the width of its 95 % interval beside the one of the
prototype in tools/data/t2gt_reference.csv, their ratio, and how many of them agree).
"""
import collections
import csv
import json
import math
import pathlib
import sys

from plot_style import COLOURS, Album, draw_band, plt

REFERENCE = pathlib.Path(__file__).parent / "data" / "t2gt_reference.csv"
COLUMNS = [("0.05deg", "none"), ("0.5deg", "none"), ("0.05rad", "none"), ("0.05deg", "worse"), ("0.05deg", "bias")]
DRAWN = ["single_1", "mean", "dw_a", "sdf_any", "sdf_fixed", "ci", "learned", "ml", "central"]
FAULTY_RADAR = 3
TOLERANCE = 0.05  # t2gt 9: "the table above within 5 %"


def read_curves(path):
    curves = collections.defaultdict(lambda: collections.defaultdict(list))
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            key = (row["azimuth_noise"], row["fault"])
            curves[key][(row["method"], int(row["target"]))].append(
                [float(row[name] or 0.0) for name in ("time_s", "rmse_m", "ci95")])
    return curves


def draw(album, noise, fault, curves, runs):
    figure, axes = plt.subplots(2, 2, figsize=(11, 8), sharex=True)
    for target, axis in enumerate(axes.flat, 1):
        drawn = [method for method in DRAWN if (method, target) in curves] or sorted({method for method, _ in curves})
        for index, method in enumerate(drawn):
            draw_band(axis, *zip(*curves[(method, target)]), index, method)
        axis.set_yscale("log")
        axis.text(0.03, 0.97, f"target {target}", transform=axis.transAxes, va="top")
        axis.grid(True, which="both", alpha=0.3)
        axis.set_ylabel("position RMSE [m]")
    for axis in axes[1]:
        axis.set_xlabel("time [s]")
    axes[0][0].legend(fontsize=7, ncol=2)
    figure.tight_layout()
    album.save(figure, f"rmse_{noise.replace('.', '')}_{fault}", f"Position RMSE of each target over {runs} runs with 95 % bands, "
               f"azimuth noise {noise}, fault: {fault}. [Li2018] Fig. 4.")


def draw_structure(album):
    """Figure 1 of the paper: local track to local track, and local track to global track."""
    figure, axes = plt.subplots(1, 2, figsize=(10, 3.2))
    for axis, feeds_back, title in zip(axes, (False, True), ("local to local", "local to global, as here")):
        axis.set_axis_off()
        axis.set_xlim(0, 10)
        axis.set_ylim(0, 4)
        for k in range(3):
            axis.text(1.2, 3.2 - 1.2 * k, f"node {k + 1}", bbox={"boxstyle": "round", "fc": "w"}, ha="center")
            axis.annotate("", (4.2, 2.0), (2.2, 3.2 - 1.2 * k), arrowprops={"arrowstyle": "->"})
            axis.text(3.1, 3.0 - 1.0 * k, "tracklets" if feeds_back else "tracks", fontsize=7, ha="center")
        axis.text(5.4, 2.0, "association,\nfusion", bbox={"boxstyle": "round", "fc": "w"}, ha="center", va="center")
        axis.annotate("", (8.0, 2.0), (6.6, 2.0), arrowprops={"arrowstyle": "->"})
        axis.text(8.9, 2.0, "global\ntracks", bbox={"boxstyle": "round", "fc": "w"}, ha="center", va="center")
        if feeds_back:
            axis.annotate("", (5.4, 1.3), (8.9, 1.3), arrowprops={"arrowstyle": "->", "connectionstyle": "arc3,rad=-0.4"})
            axis.text(7.2, 0.4, "prediction", fontsize=7, ha="center")
        axis.text(0.2, 0.0, title, fontsize=8)
    album.save(figure, "structure", "The two structures of track fusion. [Li2018] Fig. 1.")


def draw_scene(album, rows, pictured):
    """Figures 2 and 3 of the paper side by side."""
    figure, axes = plt.subplots(1, 2, figsize=(12, 5.5), sharex=True, sharey=True)
    for axis, kind, style, label in zip(axes, ("local", "fused"), ("x", "o"), ("radars' estimates", "global tracks")):
        for name, marker, text in (("truth", "-", "targets"), (kind, style, label)):
            tracks = collections.defaultdict(list)
            for row in rows:
                if row["kind"] == name:
                    tracks[row["id"]].append((float(row["north_m"]) / 1e3, float(row["east_m"]) / 1e3))
            for k, points in enumerate(tracks.values()):
                axis.plot(*zip(*points), marker, markersize=3, linewidth=0.8, color="k" if name == "truth" else COLOURS[k % len(COLOURS)],
                          label=text if k == 0 else None)
        axis.set_xlabel("x [km]")
        axis.set_ylabel("y [km]")
        axis.legend(fontsize=8)
    figure.tight_layout()
    words = ", ".join(f"{key.replace('_', ' ')} {value}" for key, value in pictured["parameters"].items() if value != "none")
    album.save(figure, "scene", f"True courses with the radars' estimates, and with the global tracks ({words}), run 0 of seed "
               f"{pictured['seed']}. [Li2018] Fig. 2 and 3.")


def write_nees(results, path):
    """NEES over its four degrees by method and column: 1 where covariances say what errors are."""
    table = collections.defaultdict(dict)
    for cell in results["cells"]:
        parameters = cell["parameters"]
        if parameters["targets"] != 4 or "nees" not in cell["metrics"]:
            continue
        name = " ".join([cell["method"]] + [str(parameters[key]) for key in ("support", "origin", "unit", "association",
                                                                              "radar") if key in parameters])
        table[name][(parameters["azimuth_noise"], parameters["fault"])] = cell["metrics"]["nees"]["mean"]
    lines = ["NEES / 4, mean over targets and scans 6 to 25.", "", "| method | " + " | ".join(" ".join(c) for c in COLUMNS) +
             " |", "|" + " --- |" * (len(COLUMNS) + 1)]
    for name, row in table.items():
        lines.append(f"| {name} | " + " | ".join(f"{row[c]:.2f}" if c in row else "" for c in COLUMNS) + " |")
    path.write_text("\n".join(lines) + "\n")


def measured(results):
    """(method, support, origin, noise, fault) -> (rmse, half the width of its interval); single radars pooled into their
    mean and the faulty one."""
    found, singles = {}, collections.defaultdict(list)
    for cell in results["cells"]:
        parameters, metric = cell["parameters"], cell["metrics"]["rmse"]
        rmse = (metric["mean"], metric["ci95"] or 0.0)
        if parameters["targets"] != 4 or "association" in parameters or "unit" in parameters:
            continue
        column = (parameters["azimuth_noise"], parameters["fault"])
        if "radar" in parameters:
            if column[1] != "none" and parameters["radar"] == FAULTY_RADAR:
                found[("single_faulty", "", "") + column] = rmse
            else:
                singles[column].append(rmse)
        else:
            found[(cell["method"], parameters.get("support", ""), parameters.get("origin", "")) + column] = rmse
    for column, values in singles.items():
        found[("single", "", "") + column] = (sum(mean for mean, _ in values) / len(values),
                                              math.hypot(*(error for _, error in values)) / len(values))
    return found


def write_comparison(results, path):
    with open(REFERENCE, newline="") as file:
        reference = {tuple(row[k] for k in ("method", "support", "origin", "azimuth_noise", "fault")): float(row["rmse"])
                     for row in csv.DictReader(file)}
    found = measured(results)
    rows = list(dict.fromkeys(key[:3] for key in list(reference) + list(found)))
    worst, within, with_error, compared = 0.0, 0, 0, 0
    lines = [f"Position RMSE [m] of the four targets, {results['runs']} runs, seed {results['seed']}: ours ± half the "
             "width of its 95 % interval (prototype's) ratio.",
             "", "| method | " + " | ".join(" ".join(c) for c in COLUMNS) + " |", "|" + " --- |" * (len(COLUMNS) + 1)]
    for row in rows:
        texts = []
        for column in COLUMNS:
            ours, theirs = found.get(row + column), reference.get(row + column)
            text = "" if ours is None else f"{ours[0]:.1f} ± {ours[1]:.2f}"
            if ours is not None and theirs is not None:
                text += f" ({theirs:g}) {ours[0] / theirs:.3f}"
                off = abs(ours[0] - theirs)
                worst = max(worst, off / theirs)
                within += off <= TOLERANCE * theirs
                with_error += off <= TOLERANCE * theirs + ours[1]
                compared += 1
            texts.append(text)
        lines.append("| " + " ".join(filter(None, row)) + " | " + " | ".join(texts) + " |")
    lines += ["", f"Largest deviation: {100 * worst:.1f} %. Within {100 * TOLERANCE:.0f} %: {within} of {compared}; within "
              f"{100 * TOLERANCE:.0f} % and the interval: {with_error} of {compared}.", ""] + order_lines(found, reference)
    path.write_text("\n".join(lines) + "\n")


def order_lines(found, reference):
    """Names the pairs of methods of one column that the reference tells apart by more than the tolerance, ours not."""
    reversed_pairs, told_apart = [], 0
    for column in COLUMNS:
        names = [key for key in reference if key[3:] == column and key in found]
        for better in names:
            for worse in names:
                if reference[better] * (1.0 + TOLERANCE) >= reference[worse]:
                    continue
                told_apart += 1
                if found[better][0] >= found[worse][0]:
                    reversed_pairs.append(" ".join(filter(None, better)) + " / " + " ".join(filter(None, worse[:3])))
    return [f"Order: of {told_apart} pairs of methods that the prototype's figures hold apart by more than "
            f"{100 * TOLERANCE:.0f} %, {len(reversed_pairs)} are reversed" + "".join(f"; {pair}" for pair in reversed_pairs) + "."]


def main():
    directory = pathlib.Path(sys.argv[1])
    results = json.loads((directory / "results.json").read_text())
    write_comparison(results, directory / "comparison.md")
    write_nees(results, directory / "nees.md")
    album = Album(directory)
    draw_structure(album)
    with open(directory / "scene.csv", newline="") as file:
        draw_scene(album, list(csv.DictReader(file)), json.loads((directory / "pictured_scene.json").read_text()))
    for (noise, fault), curves in read_curves(directory / "rmse_over_time.csv").items():
        draw(album, noise, fault, curves, results["runs"])


if __name__ == "__main__":
    main()
