#!/usr/bin/python3
"""Plots and tables of `lookout experiment t2gt`: plot_fusion.py DIR

Reads results.json and rmse_over_time.csv in DIR; writes, for each azimuth noise and fault, rmse_NOISE_FAULT.png
(position RMSE of each target over time, by method, in the manner of Figures 2 to 4 of Li, Fan, Yuan, Li), and
comparison.md (every figure beside the one of the prototype in tools/data/t2gt_reference.csv, and their ratio).
"""
import collections
import csv
import json
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

REFERENCE = pathlib.Path(__file__).parent / "data" / "t2gt_reference.csv"
COLUMNS = [("0.05deg", "none"), ("0.5deg", "none"), ("0.05rad", "none"), ("0.05deg", "worse"), ("0.05deg", "bias")]
DRAWN = ["single_1", "mean", "dw_a", "sdf_any", "sdf_fixed", "ci", "learned", "ml", "central"]
FAULTY_RADAR = 3


def read_curves(path):
    curves = collections.defaultdict(lambda: collections.defaultdict(list))
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            key = (row["azimuth_noise"], row["fault"])
            curves[key][(row["method"], int(row["target"]))].append((float(row["time_s"]), float(row["rmse_m"])))
    return curves


def draw(noise, fault, curves, path):
    figure, axes = plt.subplots(2, 2, figsize=(11, 8), sharex=True)
    for target, axis in enumerate(axes.flat, 1):
        for method in DRAWN:
            points = curves.get((method, target))
            if points:
                axis.semilogy(*zip(*points), label=method, linewidth=1.2)
        axis.set_title(f"target {target}")
        axis.grid(True, which="both", alpha=0.3)
        axis.set_ylabel("position RMSE [m]")
    for axis in axes[1]:
        axis.set_xlabel("time [s]")
    axes[0][0].legend(fontsize=7, ncol=2)
    figure.suptitle(f"azimuth noise {noise}, fault {fault}")
    figure.tight_layout()
    figure.savefig(path, dpi=110)
    plt.close(figure)


def measured(results):
    """(method, support, origin, noise, fault) -> rmse; single radars pooled into their mean and the faulty one."""
    found, singles = {}, collections.defaultdict(list)
    for cell in results["cells"]:
        parameters, rmse = cell["parameters"], cell["metrics"]["rmse"]["mean"]
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
        found[("single", "", "") + column] = sum(values) / len(values)
    return found


def write_comparison(results, path):
    with open(REFERENCE, newline="") as file:
        reference = {tuple(row[k] for k in ("method", "support", "origin", "azimuth_noise", "fault")): float(row["rmse"])
                     for row in csv.DictReader(file)}
    found = measured(results)
    rows = list(dict.fromkeys(key[:3] for key in list(reference) + list(found)))
    worst = 0.0
    lines = [f"Position RMSE [m] of the four targets, {results['runs']} runs, seed {results['seed']}: ours (prototype's) ratio.",
             "", "| method | " + " | ".join(" ".join(c) for c in COLUMNS) + " |", "|" + " --- |" * (len(COLUMNS) + 1)]
    for row in rows:
        texts = []
        for column in COLUMNS:
            ours, theirs = found.get(row + column), reference.get(row + column)
            text = "" if ours is None else f"{ours:.1f}"
            if ours is not None and theirs is not None:
                text += f" ({theirs:g}) {ours / theirs:.3f}"
                worst = max(worst, abs(ours / theirs - 1.0))
            texts.append(text)
        lines.append("| " + " ".join(filter(None, row)) + " | " + " | ".join(texts) + " |")
    lines += ["", f"Largest deviation: {100 * worst:.1f} %."]
    path.write_text("\n".join(lines) + "\n")


def main():
    directory = pathlib.Path(sys.argv[1])
    write_comparison(json.loads((directory / "results.json").read_text()), directory / "comparison.md")
    for (noise, fault), curves in read_curves(directory / "rmse_over_time.csv").items():
        draw(noise, fault, curves, directory / f"rmse_{noise.replace('.', '')}_{fault}.png")


if __name__ == "__main__":
    main()
