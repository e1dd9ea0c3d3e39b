#!/usr/bin/python3
"""Pictures of the experiment image-sea: of each condition a ping, its learnt background, its returns and the tracks.

Usage: plot_image_sea.py DIR, where `lookout experiment image-sea --out DIR` has written. Captions are in pictures.md.
"""
import csv
import pathlib
import sys

import numpy as np

from plot_images import edges_of, read_pgm
from plot_style import Album, plt

DYNAMIC = 40.0  # dB from black to white
CONDITIONS = ["plain", "speckle", "stripes", "bottom", "standing", "shadows", "swerling1", "uneven", "all", "empty"]
METHODS = [("h_pmht", "#d55e00", "-"), ("detect+joint", "#0072b2", "--")]


def rows_of(path):
    if not path.exists():
        return []
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def numbers(rows, *names):
    return [np.array([float(row[name]) for row in rows]) for name in names]


def decibels(row, directory):
    scale, zero = float(row["intensity_scale"]), float(row.get("zero_level") or 0.0)
    return 20 * np.log10(np.maximum(scale * (read_pgm(directory / row["file"]) - zero), 1e-9))


def draw_image(axes, row, bearings, directory, top):
    values = decibels(row, directory)
    first, step = float(row["first_range_m"]), float(row["range_step_m"])
    ranges = first + step * (np.arange(values.shape[1] + 1) - 0.5)
    across, ahead = np.outer(np.sin(bearings), ranges), np.outer(np.cos(bearings), ranges)
    axes.pcolormesh(across, ahead, values, cmap="gray", vmin=top - DYNAMIC, vmax=top, rasterized=True)


def to_sonar(rows, pose):
    """Starboard and ahead [m] of places of the earth, as the sonar lies at the ping."""
    north, east = numbers(rows, "north_m", "east_m")
    north, east, heading = north - pose[0], east - pose[1], pose[2]
    return east * np.cos(heading) - north * np.sin(heading), north * np.cos(heading) + east * np.sin(heading)


def draw_paths(axes, rows, pose, **look):
    label = look.pop("label")
    for number in sorted({row["id"] for row in rows}, key=int):
        path = [row for row in rows if row["id"] == number]
        axes.plot(*to_sonar(path, pose), label=label, **look)
        label = None


def draw_tracks(axes, directory):
    pose = [values[0] for values in numbers(rows_of(directory / "pose.csv"), "north_m", "east_m", "heading_rad")]
    draw_paths(axes, rows_of(directory / "truth.csv"), pose, label="targets", color="0.75", linewidth=7, solid_capstyle="round")
    for method, colour, dash in METHODS:
        draw_paths(axes, rows_of(directory / f"tracks_{method}.csv"), pose, label=method, color=colour, linestyle=dash, linewidth=1.4)
    axes.legend(fontsize="small", loc="lower left")


def draw_returns(axes, directory):
    returns = rows_of(directory / "returns.csv")
    if returns:
        bearing, distance, level = numbers(returns, "bearing_rad", "range_m", "intensity_db")
        axes.scatter(distance * np.sin(bearing), distance * np.cos(bearing), s=2 + level, color="black", linewidths=0)


def draw_condition(directory, title):
    images = rows_of(directory / "images.csv")
    table = [row for row in rows_of(directory / "bearings.csv") if row["table"] == images[0]["bearings"]]
    column = "bearing_rad" if "bearing_rad" in table[0] else "bearing_deg"
    bearings = numbers(table, column)[0]
    edges = edges_of(bearings if column == "bearing_rad" else np.radians(bearings))
    top = np.percentile(decibels(images[0], directory), 99.9)
    figure, panels = plt.subplots(1, 4, figsize=(20, 5.2), sharex=True, sharey=True)
    for axes, row, name in zip(panels, images, ("ping", "background")):
        draw_image(axes, row, edges, directory, top)
        axes.set_title(f"{title}: {name}")
    draw_returns(panels[2], directory)
    panels[2].set_title("returns of detection")
    draw_tracks(panels[3], directory)
    panels[3].set_title("targets and confirmed tracks")
    for axes in panels:
        axes.set(aspect="equal", xlabel="starboard [m]")
    panels[0].set_ylabel("ahead [m]")
    figure.tight_layout()
    return figure


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    directory = pathlib.Path(sys.argv[1])
    album = Album(directory)
    for condition in CONDITIONS:
        if (directory / condition / "images.csv").exists():
            album.save(draw_condition(directory / condition, condition), f"image_{condition}",
                       f"`{condition}`, last ping of the first run: the ping, the background that h_pmht has learnt by then (both "
                       f"in dB, {DYNAMIC:.0f} dB from black to white), the returns of detection (larger: stronger), and the "
                       "targets' ways (grey) with the confirmed tracks of h_pmht and of detection with joint, as the sonar lies at "
                       "that ping.")


if __name__ == "__main__":
    main()
