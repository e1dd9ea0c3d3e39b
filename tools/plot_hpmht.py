#!/usr/bin/python3
"""Plots of the hpmht experiments: tracks over image, existence over time, figures over SNR, deviations by scenario.

Usage: plot_hpmht.py DIR, where `lookout experiment hpmht-sonar` (or `hpmht-curves`, `hpmht-video`) `--out DIR` has
written: the pictures as PNG and PDF, their captions in pictures.md. What --only left out is not drawn.
"""
import csv
import json
import pathlib
import sys

import numpy as np

from plot_style import Album, plt, style


def rows_of(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def read_pgm(path):
    data = path.read_bytes()
    _, columns, rows, _ = data.split(maxsplit=4)[:4]
    columns, rows = int(columns), int(rows)
    return np.frombuffer(data[-2 * columns * rows:], dtype=">u2").reshape(rows, columns).astype(float)


def save(album, figure, name, caption):
    figure.tight_layout()
    album.save(figure, name, caption)


def pictured_in(directory, name):
    return json.loads((directory / f"pictured_{name}.json").read_text())


def paths_by(rows, x, y):
    paths = {}
    for row in rows:
        paths.setdefault(row["id"], []).append((float(row[x]), float(row[y])))
    return paths


def plot_sonar_image(album, directory, words):
    image = read_pgm(directory / "sonar_image.pgm")
    tracks, truth = rows_of(directory / "sonar_tracks.csv"), rows_of(directory / "sonar_truth.csv")
    last = (truth or tracks)[-1]["time_s"]
    figure, (left, right) = plt.subplots(1, 2, figsize=(15, 6))
    left.imshow(image, aspect="auto", cmap="gray", vmax=np.percentile(image, 99.8), extent=[0, image.shape[1], image.shape[0], 0])
    here = [row for row in truth if row["time_s"] == last]
    left.plot([float(r["bin"]) for r in here], [float(r["beam"]) for r in here], "o", mfc="none", mec="tab:green", ms=16, label="target")
    here = [row for row in tracks if row["time_s"] == last and row["status"] == "confirmed"]
    left.plot([float(r["bin"]) for r in here], [float(r["beam"]) for r in here], "r+", ms=12, label="confirmed track")
    left.set(xlabel="range bin", ylabel="beam")
    left.legend()
    for path in paths_by(truth, "east_m", "north_m").values():
        right.plot(*zip(*path), color="0.75", linewidth=6, solid_capstyle="round")
    confirmed = paths_by([r for r in tracks if r["status"] == "confirmed"], "east_m", "north_m")
    for index, (number, path) in enumerate(confirmed.items()):
        right.plot(*zip(*path), label=f"track {number}", markevery=10, **style(index))
    right.set(xlabel="east [m]", ylabel="north [m]", aspect="equal")
    if confirmed:
        right.legend(fontsize="small")
    save(album, figure, "image_with_tracks", f"Left: the image over its level at {last} s, targets and confirmed tracks; right: targets "
         f"(grey) and confirmed tracks of h_pmht ({words}).")


def plot_existence(album, directory, words):
    figure, axis = plt.subplots(figsize=(9, 4))
    for path in paths_by(rows_of(directory / "sonar_tracks.csv"), "time_s", "existence").values():
        strong = max(value for _, value in path) > 0.995
        look = {} if strong else {"color": "0.8", "linestyle": "-"}
        axis.plot(*zip(*path), linewidth=1.3 if strong else 0.6, **look)
    axis.set(xlabel="time [s]", ylabel="existence")
    save(album, figure, "existence", f"Existence of every track of h_pmht, grey where never confirmed ({words}).")


def value(cell, metric, part="mean"):
    found = cell["metrics"].get(metric, {}).get(part)
    return float("nan") if found is None else found


def draw_curve(axis, cells, key, metric, index, label):
    """A metric over a parameter of the cells, with the 95 % intervals of the runs where there are several."""
    points = sorted((cell["parameters"][key], value(cell, metric), value(cell, metric, "ci95")) for cell in cells)
    xs, means, widths = zip(*points)
    widths = [0.0 if width != width else width for width in widths]
    axis.errorbar(xs, means, widths, capsize=2, label=label, **style(index))


def method_of(cell):
    """The method, and whether it is told the instrument's signature."""
    return cell["method"] + (" (signature found)" if cell["parameters"]["signature"] == "found" else "")


def plot_over_snr(album, cells):
    """The figures over the level, a picture a shape of the background; of h_pmht with the signature told and found."""
    names = [("in_track", "share of target-time in track"), ("rmse", "RMSE [m]"), ("false_per_scan", "false tracks a scan")]
    cells = [c for c in cells if c["parameters"]["situation"] == "five_targets"]
    for shape in sorted({c["parameters"]["shape"] for c in cells}, reverse=True):
        own = [c for c in cells if c["parameters"]["shape"] == shape]
        figure, axes = plt.subplots(1, 3, figsize=(14, 4))
        for axis, (metric, label) in zip(axes, names):
            for index, method in enumerate(sorted({method_of(c) for c in own})):
                draw_curve(axis, [c for c in own if method_of(c) == method], "snr_db", metric, index, method)
            axis.set(xlabel="SNR [dB]", ylabel=label)
            axis.grid(alpha=0.3)
        axes[0].legend()
        save(album, figure, "over_snr" if shape == 4 else f"over_snr_shape_{shape:g}".replace(".", ""),
             f"Time in track, RMSE and false tracks over the level, five targets, K shape {shape:g}; bars: 95 % intervals.")


def plot_curves(album, cells):
    """Operating curves: time in track over false tracks a scan, a point a threshold, a panel a level."""
    levels = sorted({c["parameters"]["snr_db"] for c in cells})
    figure, axes = plt.subplots(1, len(levels), figsize=(6 * len(levels), 4.5), squeeze=False)
    for axis, level in zip(axes[0], levels):
        here = [c for c in cells if c["parameters"]["snr_db"] == level]
        for index, (method, rule) in enumerate(sorted({(c["method"], c["parameters"]["rule"]) for c in here})):
            own = [c for c in here if (c["method"], c["parameters"]["rule"]) == (method, rule)]
            axis.plot(*zip(*sorted((value(c, "false_per_scan"), value(c, "in_track")) for c in own)), label=f"{method}, {rule}",
                      **style(index))
        axis.text(0.03, 0.97, f"{level:g} dB", transform=axis.transAxes, va="top")
        axis.set(xlabel="false tracks a scan", ylabel="share of target-time in track")
        axis.set_xscale("symlog", linthresh=0.01)
        axis.grid(alpha=0.3)
    axes[0][0].legend(fontsize="small")
    save(album, figure, "operating_curves", "Time in track over false tracks, each method's threshold swept.")


def plot_video(album, directory, cells):
    pictured = pictured_in(directory, "video")
    shown = pictured["parameters"]
    figure, (left, right) = plt.subplots(1, 2, figsize=(14, 6))
    left.imshow(read_pgm(directory / "video_pdim.pgm"), cmap="gray", extent=None)
    rows = rows_of(directory / "video_tracks.csv")
    for index, (method, truncation) in enumerate(sorted({(r["method"], r["truncation"]) for r in rows})):
        path = [(float(r["x_px"]) - 0.5, float(r["y_px"]) - 0.5) for r in rows if (r["method"], r["truncation"]) == (method, truncation)]
        look = {"color": "w", "linestyle": "-"} if method == "truth" else style(index, markersize=3)
        left.plot(*zip(*path), label=f"{method} {truncation}", **{**look, "linewidth": 1})
    left.legend(fontsize="x-small")
    names = dict.fromkeys((c["method"], c["parameters"]["truncation"]) for c in cells if "deviation" in c["metrics"])
    for index, (method, truncation) in enumerate(names):
        own = [c for c in cells if (c["method"], c["parameters"]["truncation"]) == (method, truncation)
               and all(c["parameters"][key] == shown[key] for key in ("variant", "dct_db"))]
        if own:
            draw_curve(right, own, "scenario", "deviation", index, f"{method} {truncation}")
    right.set(xlabel="scenario", ylabel="deviation [px]")
    if right.get_legend_handles_labels()[0]:
        right.legend(fontsize="small")
    words = f"{shown['variant']}, {shown['dct_db']:g} dB"
    save(album, figure, "video", f"Left: PDIM at scan 10 of scenario {shown['scenario']:g} and what each method makes of it, run 0 of seed "
         f"{pictured['seed']}; right: deviation by scenario, means with 95 % intervals ({words}). [Pakfiliz2018] Fig. 1 to 3.")


def main():
    directory = pathlib.Path(sys.argv[1])
    results = json.loads((directory / "results.json").read_text())
    album = Album(directory)
    if results["experiment"] == "hpmht-sonar":
        if (directory / "sonar_tracks.csv").exists():  # of h_pmht, which --only may have left out
            pictured = pictured_in(directory, "sonar")
            words = ", ".join(f"{value:g}" if isinstance(value, float) else str(value) for value in pictured["parameters"].values())
            plot_sonar_image(album, directory, f"{words}, seed {pictured['seed']}")
            plot_existence(album, directory, f"{words}, seed {pictured['seed']}")
        plot_over_snr(album, results["cells"])
    elif results["experiment"] == "hpmht-curves":
        plot_curves(album, results["cells"])
    else:
        plot_video(album, directory, results["cells"])


if __name__ == "__main__":
    main()
