#!/usr/bin/python3
"""Draws a run or a replay: tracks over the sonar's fan, OSPA over time, the vote matrices with their classes.

usage: plot_demo.py DIRECTORY  (with truth.csv, tracks.csv, vehicle.csv, ospa.csv, sonar.yaml; votes.csv where there is one)
"""
import csv
import math
import pathlib
import sys

from matplotlib.collections import PolyCollection

from plot_style import plt, save_both

TRUTH_STYLE = dict(color="0.3", linestyle="-", linewidth=5, alpha=0.35, solid_capstyle="round", zorder=3)
COLOURS = plt.get_cmap("tab10").colors


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def by_id(table, keep=lambda row: True):
    groups = {}
    for row in table:
        if keep(row):
            groups.setdefault(row["id"], []).append((float(row["time_s"]), float(row["north_m"]), float(row["east_m"])))
    return groups


def sonar_figures(path):
    figures = {}
    for line in path.read_text().splitlines():
        key, _, value = line.partition(":")
        figures[key.strip()] = float(value)
    return figures


def draw_fan(axes, vehicle, sonar, label):
    """The sector of the sonar at one vehicle pose."""
    half = math.radians(sonar["bearing_step_deg"]) * sonar["num_beams"] / 2
    middle = math.radians(sonar["first_bearing_deg"] - sonar["bearing_step_deg"] / 2) + half
    heading = float(vehicle["heading_rad"]) + math.radians(sonar["mount_heading_deg"]) + middle
    north, east = float(vehicle["north_m"]), float(vehicle["east_m"])
    angles = [heading - half + 2 * half * k / 60 for k in range(61)]
    outline = [(east, north)]
    outline += [(east + sonar["max_range"] * math.sin(a), north + sonar["max_range"] * math.cos(a)) for a in angles]
    outline.append((east, north))
    axes.fill(*zip(*outline), color="tab:blue", alpha=0.07, label=label)
    axes.plot(*zip(*outline), color="tab:blue", linestyle="-", linewidth=0.6, alpha=0.5)


def plot_tracks(folder):
    figure, axes = plt.subplots(figsize=(9, 8))
    vehicle = rows(folder / "vehicle.csv")
    sonar = sonar_figures(folder / "sonar.yaml")
    draw_fan(axes, vehicle[0], sonar, "sonar's fan, first and last scan")
    draw_fan(axes, vehicle[-1], sonar, None)
    axes.plot([float(r["east_m"]) for r in vehicle], [float(r["north_m"]) for r in vehicle], "k-", linewidth=1.5, label="vehicle")
    if (folder / "truth.csv").exists():
        for number, points in enumerate(by_id(rows(folder / "truth.csv")).values()):
            axes.plot([p[2] for p in points], [p[1] for p in points], label=None if number else "truth", **TRUTH_STYLE)
    confirmed = by_id(rows(folder / "tracks.csv"), lambda row: row["status"] == "confirmed")
    for number, (identity, points) in enumerate(sorted(confirmed.items(), key=lambda item: int(item[0]))):
        colour = COLOURS[number % len(COLOURS)]
        axes.plot([p[2] for p in points], [p[1] for p in points], ".-", color=colour, markersize=3, linewidth=1)
        axes.annotate(identity, (points[-1][2], points[-1][1]), color=colour, fontsize=9, fontweight="bold")
    axes.set_xlabel("east [m]")
    axes.set_ylabel("north [m]")
    axes.set_aspect("equal")
    axes.legend(loc="lower left", fontsize=8)
    save_both(figure, folder / "tracks.png")


def plot_ospa(folder):
    table = rows(folder / "ospa.csv")
    time = [float(row["time_s"]) for row in table]
    figure, (distance, count) = plt.subplots(2, 1, figsize=(9, 6), sharex=True, height_ratios=(2, 1))
    for name, style in (("total", dict(color="k", linestyle="-", linewidth=1.5)), ("cardinality", dict(color="tab:red", linestyle="--")),
                        ("localization", dict(color="tab:blue", linestyle=":"))):
        distance.plot(time, [float(row[name]) for row in table], label=name, **style)
    distance.set_ylabel("OSPA [m]")
    distance.legend()
    distance.grid(alpha=0.3)
    count.step(time, [int(row["num_truth"]) for row in table], "0.55", linestyle="-", where="post", linewidth=3, label="targets")
    count.step(time, [int(row["num_tracks"]) for row in table], "tab:green", linestyle="--", where="post", label="tracks")
    count.set_xlabel("time [s]")
    count.set_ylabel("number")
    count.legend()
    count.grid(alpha=0.3)
    save_both(figure, folder / "ospa.png")


def cell_boxes(cells):
    """The cells of a vote matrix as rectangles in (intercept, velocity)."""
    velocities = sorted({float(row["velocity_mps"]) for row in cells})
    height = min((b - a for a, b in zip(velocities, velocities[1:])), default=1.0)
    first_row = sorted(float(r["intercept_m"]) for r in cells if float(r["velocity_mps"]) == velocities[0])
    width = min((b - a for a, b in zip(first_row, first_row[1:])), default=1.0)
    corners = ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))
    return [[(float(r["intercept_m"]) + x * width, float(r["velocity_mps"]) + y * height) for x, y in corners] for r in cells]


def draw_votes(figure, axes, axis, cells, centres):
    image = PolyCollection(cell_boxes(cells), array=[float(row["votes"]) for row in cells], cmap="viridis")
    axes.add_collection(image)
    figure.colorbar(image, ax=axes, label="votes")
    kept = [row for row in cells if float(row["votes"]) > float(row["threshold"])]
    axes.plot([float(r["intercept_m"]) for r in kept], [float(r["velocity_mps"]) for r in kept], "w.", markersize=1.5,
              label="above the primary threshold")
    if centres:
        axes.plot([float(r["intercept_m"]) for r in centres], [float(r["velocity_mps"]) for r in centres], "r+",
                  markersize=11, markeredgewidth=2, label="class centres")
    axes.autoscale_view()
    axes.set_xlabel(f"{axis} at the middle of the window [m]")
    axes.set_ylabel(f"{axis} velocity [m/s]")
    axes.legend(fontsize=8, facecolor="0.5", labelcolor="w")


def plot_votes(folder):
    votes, classes = rows(folder / "votes.csv"), rows(folder / "classes.csv")
    figure, panels = plt.subplots(1, 2, figsize=(13, 5))
    for axes, axis in zip(panels, ("north", "east")):
        cells = [row for row in votes if row["axis"] == axis]
        if cells:
            draw_votes(figure, axes, axis, cells, [row for row in classes if row["axis"] == axis])
    save_both(figure, folder / "votes.png")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    plot_tracks(folder)
    if (folder / "ospa.csv").exists():
        plot_ospa(folder)
    if (folder / "votes.csv").exists():
        plot_votes(folder)


if __name__ == "__main__":
    main()
