#!/usr/bin/python3
"""Draws the sonar images of a recording as fans: up to six pings evenly over its time, each as wide as its beams are.

Usage: plot_images.py DIRECTORY FILE.png|FILE.pdf|FILE.gif ...

Reads images.csv, bearings.csv and the pictures that they name. A GIF shows every ping, of many an even choice. Exit
status 2 with one line where nothing can be drawn.
"""
import csv
import pathlib
import sys

try:
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    import numpy as np
except ImportError as error:
    sys.exit(f"plot_images.py: {error}; install python3-numpy and python3-matplotlib")

MOST_PINGS = 6     # Of a picture.
MOST_FRAMES = 150  # Of an animation.
DARK_SHARE, BRIGHT_SHARE = 2.0, 99.8  # Percentiles that are drawn black and white.


def read_pgm(path):
    """Rows of a binary PGM of two bytes a pixel, as a recording has them."""
    data = path.read_bytes()
    words = data.split(maxsplit=4)[:4]
    columns, rows = int(words[1]), int(words[2])
    pixels = np.frombuffer(data[-2 * rows * columns :], dtype=">u2")
    return pixels.reshape(rows, columns).astype(float)


def edges_of(bearings):
    """One edge more than beams: midway between neighbours, half a step outside the outer ones."""
    if len(bearings) == 1:
        return np.array([bearings[0] - 0.01, bearings[0] + 0.01])
    inner = 0.5 * (bearings[1:] + bearings[:-1])
    return np.concatenate([[1.5 * bearings[0] - 0.5 * bearings[1]], inner, [1.5 * bearings[-1] - 0.5 * bearings[-2]]])


class Recording:
    """The images of a directory, read one at a time."""

    def __init__(self, directory):
        self.directory = directory
        with open(directory / "images.csv", newline="", encoding="utf-8") as file:
            self.rows = list(csv.DictReader(file))
        tables = {}
        with open(directory / "bearings.csv", newline="", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                bearing = float(row["bearing_rad"]) if "bearing_rad" in row else np.radians(float(row["bearing_deg"]))
                tables.setdefault(int(row["table"]), []).append(bearing)
        self.edges = {table: edges_of(np.array(bearings)) for table, bearings in tables.items()}

    def choice(self, most):
        """At most so many indices, evenly over all."""
        return np.unique(np.linspace(0, len(self.rows) - 1, min(most, len(self.rows))).round().astype(int))

    def draw(self, axes, index):
        row = self.rows[index]
        pixels = read_pgm(self.directory / row["file"])
        bearings = self.edges[int(row.get("bearings") or 0)]
        first, step = float(row["first_range_m"]), float(row["range_step_m"])
        ranges = first + step * (np.arange(pixels.shape[1] + 1) - 0.5)
        across, ahead = np.outer(np.sin(bearings), ranges), np.outer(np.cos(bearings), ranges)
        low, high = np.percentile(pixels, [DARK_SHARE, BRIGHT_SHARE])
        axes.pcolormesh(across, ahead, pixels, cmap="inferno", vmin=low, vmax=max(high, low + 1), rasterized=True)
        axes.set(aspect="equal", xlabel="starboard [m]", ylabel="ahead [m]", title=f"{float(row['time_s']):.3f} s")


def picture(recording, path):
    indices = recording.choice(MOST_PINGS)
    columns = min(3, len(indices))
    rows = -(-len(indices) // columns)
    figure, all_axes = plt.subplots(rows, columns, figsize=(5 * columns, 5 * rows), squeeze=False)
    for axes in all_axes.flat[len(indices):]:
        axes.axis("off")
    for axes, index in zip(all_axes.flat, indices):
        recording.draw(axes, index)
    figure.tight_layout()
    figure.savefig(path, dpi=110)
    plt.close(figure)


def animate(recording, path):
    from matplotlib.animation import FuncAnimation, PillowWriter
    figure, axes = plt.subplots(figsize=(6, 6))

    def ping(index):
        axes.clear()
        recording.draw(axes, index)

    FuncAnimation(figure, ping, frames=recording.choice(MOST_FRAMES)).save(path, writer=PillowWriter(fps=10), dpi=80)
    plt.close(figure)


def main():
    if len(sys.argv) < 3 or "--help" in sys.argv:
        sys.exit(__doc__)
    directory = pathlib.Path(sys.argv[1])
    try:
        recording = Recording(directory)
        if not recording.rows:
            raise ValueError("images.csv holds no image")
        for name in sys.argv[2:]:
            (animate if name.endswith(".gif") else picture)(recording, pathlib.Path(name))
    except (OSError, ValueError, KeyError, IndexError) as error:
        print(f"plot_images.py: {directory}: cannot be drawn: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
