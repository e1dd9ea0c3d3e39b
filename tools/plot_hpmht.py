#!/usr/bin/python3
"""Plots of the hpmht experiments: tracks over image, existence over time, figures over SNR, deviations by scenario.

Usage: plot_hpmht.py DIR, where `lookout experiment hpmht-sonar` (or `hpmht-curves`, `hpmht-video`) `--out DIR` has
written.
"""
import csv
import json
import pathlib
import sys

import numpy as np

from plot_style import plt, save_both


def rows_of(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def read_pgm(path):
    data = path.read_bytes()
    _, columns, rows, _ = data.split(maxsplit=4)[:4]
    columns, rows = int(columns), int(rows)
    return np.frombuffer(data[-2 * columns * rows:], dtype=">u2").reshape(rows, columns).astype(float)


def save(figure, path):
    figure.tight_layout()
    save_both(figure, path)


def paths_by(rows, x, y):
    paths = {}
    for row in rows:
        paths.setdefault(row["id"], []).append((float(row[x]), float(row[y])))
    return paths


def plot_sonar_image(directory):
    image = read_pgm(directory / "sonar_image.pgm")
    tracks, truth = rows_of(directory / "sonar_tracks.csv"), rows_of(directory / "sonar_truth.csv")
    last = truth[-1]["time_s"]
    figure, (left, right) = plt.subplots(1, 2, figsize=(15, 6))
    left.imshow(image, aspect="auto", cmap="gray", vmax=np.percentile(image, 99.8), extent=[0, image.shape[1], image.shape[0], 0])
    here = [row for row in truth if row["time_s"] == last]
    left.plot([float(r["bin"]) for r in here], [float(r["beam"]) for r in here], "o", mfc="none", mec="tab:green", ms=16, label="target")
    here = [row for row in tracks if row["time_s"] == last and row["status"] == "confirmed"]
    left.plot([float(r["bin"]) for r in here], [float(r["beam"]) for r in here], "r+", ms=12, label="confirmed track")
    left.set(xlabel="range bin", ylabel="beam", title=f"image over its level at {last} s")
    left.legend()
    for path in paths_by(truth, "east_m", "north_m").values():
        right.plot(*zip(*path), color="0.75", linewidth=6, solid_capstyle="round")
    for number, path in paths_by([r for r in tracks if r["status"] == "confirmed"], "east_m", "north_m").items():
        right.plot(*zip(*path), linewidth=1.3, label=f"track {number}")
    right.set(xlabel="east [m]", ylabel="north [m]", title="targets (grey) and confirmed tracks", aspect="equal")
    right.legend(fontsize="small")
    save(figure, directory / "image_with_tracks.png")


def plot_existence(directory):
    figure, axis = plt.subplots(figsize=(9, 4))
    for path in paths_by(rows_of(directory / "sonar_tracks.csv"), "time_s", "existence").values():
        strong = max(value for _, value in path) > 0.995
        axis.plot(*zip(*path), color=None if strong else "0.8", linewidth=1.3 if strong else 0.6)
    axis.set(xlabel="time [s]", ylabel="existence", title="existence of every track (grey: never confirmed)")
    save(figure, directory / "existence.png")


def value(cell, metric):
    return cell["metrics"].get(metric, {}).get("mean", float("nan"))


def plot_over_snr(directory, cells):
    """The figures over the level; of h_pmht with the signature that it is told and with none."""
    cells = [c for c in cells if c["parameters"]["situation"] == "five_targets" and c["parameters"]["shape"] == 4]
    name = lambda c: c["method"] + (" (signature found)" if c["parameters"]["signature"] == "found" else "")
    figure, axes = plt.subplots(1, 3, figsize=(14, 4))
    names = [("in_track", "share of target-time in track"), ("rmse", "RMSE [m]"), ("false_per_scan", "false tracks a scan")]
    for axis, (metric, label) in zip(axes, names):
        for method, marker in zip(sorted({name(c) for c in cells}), "os^vD"):
            own = sorted((c["parameters"]["snr_db"], value(c, metric)) for c in cells if name(c) == method)
            axis.plot(*zip(*own), marker=marker, label=method)
        axis.set(xlabel="SNR [dB]", ylabel=label)
        axis.grid(alpha=0.3)
    axes[0].legend()
    save(figure, directory / "over_snr.png")


def plot_curves(directory, cells):
    """Operating curves: time in track over false tracks a scan, a point a threshold, a panel a level."""
    levels = sorted({c["parameters"]["snr_db"] for c in cells})
    figure, axes = plt.subplots(1, len(levels), figsize=(6 * len(levels), 4.5), squeeze=False)
    for axis, level in zip(axes[0], levels):
        here = [c for c in cells if c["parameters"]["snr_db"] == level]
        for (method, rule), marker in zip(sorted({(c["method"], c["parameters"]["rule"]) for c in here}), "os^vD"):
            own = [c for c in here if (c["method"], c["parameters"]["rule"]) == (method, rule)]
            axis.plot(*zip(*sorted((value(c, "false_per_scan"), value(c, "in_track")) for c in own)), marker=marker,
                      label=f"{method}, {rule}")
        axis.set(xlabel="false tracks a scan", ylabel="share of target-time in track", title=f"{level:g} dB")
        axis.set_xscale("symlog", linthresh=0.01)
        axis.grid(alpha=0.3)
    axes[0][0].legend(fontsize="small")
    save(figure, directory / "operating_curves.png")


def plot_video(directory, cells):
    figure, (left, right) = plt.subplots(1, 2, figsize=(14, 6))
    left.imshow(read_pgm(directory / "video_pdim.pgm"), cmap="gray", extent=None)
    rows = rows_of(directory / "video_tracks.csv")
    for method, truncation in sorted({(r["method"], r["truncation"]) for r in rows}):
        path = [(float(r["x_px"]) - 0.5, float(r["y_px"]) - 0.5) for r in rows if (r["method"], r["truncation"]) == (method, truncation)]
        style = {"truth": "w-"}.get(method, "--" if truncation == "impute" else "-")
        left.plot(*zip(*path), style, linewidth=1, label=f"{method} {truncation}")
    left.set_title("scenario 5: PDIM at scan 10, tracks at 5 dB")
    left.legend(fontsize="x-small")
    for method in ("h_pmht", "i_h_pmht_4", "i_h_pmht_1", "immpda_ai", "centroid_kf"):
        for truncation, style in (("impute", "--"), ("zero", "-"), ("none", "-")):
            own = sorted((c["parameters"]["scenario"], value(c, "deviation")) for c in cells
                         if c["method"] == method and c["parameters"]["truncation"] == truncation
                         and c["parameters"]["variant"] == "plain" and c["parameters"]["dct_db"] == 5)
            if own:
                right.plot(*zip(*own), style, marker="o", label=f"{method} {truncation}")
    right.set(xlabel="scenario", ylabel="deviation [px]", title="plain, 5 dB")
    right.legend(fontsize="small")
    save(figure, directory / "video.png")


def main():
    directory = pathlib.Path(sys.argv[1])
    results = json.loads((directory / "results.json").read_text())
    if results["experiment"] == "hpmht-sonar":
        if (directory / "sonar_tracks.csv").exists():  # of h_pmht, which --only may have left out
            plot_sonar_image(directory)
            plot_existence(directory)
        plot_over_snr(directory, results["cells"])
    elif results["experiment"] == "hpmht-curves":
        plot_curves(directory, results["cells"])
    else:
        plot_video(directory, results["cells"])


if __name__ == "__main__":
    main()
