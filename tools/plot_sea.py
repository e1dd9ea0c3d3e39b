#!/usr/bin/python3
"""Pictures of the experiment sea: of each condition the true density of false returns beside what each method learnt of it.

Usage: plot_sea.py DIR, where `lookout experiment sea --out DIR` has written: clutter_CONDITION.png (and .pdf), and
pictures.md with their captions. What --only left out is not drawn, nor methods that learn no map.
"""
import csv
import json
import pathlib
import sys

import numpy as np

from plot_style import Album, plt

MOST = 25.0  # dB, of the colour scale: some 300 times the background
COLUMNS = 3  # panels side by side


def maps_of(path):
    """Edges of bearing [degrees] and range [m], and by name a density [dB] of ranges by bearings."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    bearings = sorted({float(row["bearing_deg"]) for row in rows})
    ranges = sorted({float(row["range_m"]) for row in rows})
    names = [name[: -len("_db")] for name in rows[0] if name.endswith("_db")]
    maps = {name: np.full((len(ranges), len(bearings)), -np.inf) for name in names}
    at_bearing = {bearing: k for k, bearing in enumerate(bearings)}
    at_range = {distance: k for k, distance in enumerate(ranges)}
    for row in rows:
        cell = at_range[float(row["range_m"])], at_bearing[float(row["bearing_deg"])]
        for name in names:
            if row[f"{name}_db"]:
                maps[name][cell] = float(row[f"{name}_db"])
    return edges_of(bearings), edges_of(ranges), maps


def edges_of(middles):
    half = 0.5 * (middles[1] - middles[0])
    return np.array([middles[0] - half, *(middle + half for middle in middles)])


def draw_maps(bearings, ranges, maps):
    lines = -(-len(maps) // COLUMNS)
    columns = min(len(maps), COLUMNS)
    figure, panels = plt.subplots(lines, columns, figsize=(4.4 * columns + 1, 3.8 * lines), sharex=True, sharey=True, squeeze=False)
    for axes, (name, density) in zip(panels.flat, maps.items()):
        drawn = axes.pcolormesh(bearings, ranges, np.maximum(density, 0.0), cmap="magma_r", vmin=0.0, vmax=MOST, rasterized=True)
        axes.set_title("true" if name == "true" else f"learnt by {name}")
    for axes in panels.flat[len(maps):]:
        axes.set_visible(False)
    for axes in panels[-1]:
        axes.set_xlabel("bearing [deg]")
    for axes in panels[:, 0]:
        axes.set_ylabel("range [m]")
    figure.colorbar(drawn, ax=panels, label="density over the background's [dB]")
    return figure


def caption_of(condition, pictured):
    p = pictured["parameters"]
    return (f"Sea `{condition}`, targets {p['targets']}, P_F = {p['p_false_alarm']:g}, P_M = {p['p_miss']:g}, figures {p['sensor_figures']}, "
            f"seed {pictured['seed']}, first run: the density of false returns around the sonar at the end of the run, counted over ten thousand "
            "scans without targets, and what was learnt by then from the run's own scans. A learnt map has the densest place that a "
            "return in memory came from in each cell, and nothing where none came.")


def main(directory):
    directory = pathlib.Path(directory)
    album = Album(directory)
    for path in sorted(directory.glob("clutter_*.csv")):
        condition = path.stem[len("clutter_"):]
        pictured = json.loads((directory / f"pictured_{path.stem}.json").read_text(encoding="utf-8"))
        album.save(draw_maps(*maps_of(path)), path.stem, caption_of(condition, pictured))
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1]))
