#!/usr/bin/python3
"""Draws a run, a replay or anyone's recording: map, scores, counts and the existence of each track over time.

Usage: plot_run.py DIRECTORY|FILE.csv [--scores FILE.csv] [--title TEXT] FILE.png|FILE.pdf|FILE.gif ...

Reads what there is of scans.csv, vehicle.csv, truth.csv, tracks.csv, ospa.csv and sonar.yaml, and leaves out of the
picture what is missing; one file alone is returns, tracks or scores, by its columns. A GIF is the map over time. Exit status 2 with one line where nothing can be
drawn, 1 where the disk is full.
"""
import errno
import pathlib
import sys

sys.dont_write_bytecode = True  # Of the two modules beside this script, which may lie where nobody may write.
try:
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    import numpy as np
except ImportError as error:
    sys.exit(f"plot_run.py: {error}; install python3-numpy and python3-matplotlib")
from plot_run_map import COLOURS, MOST_TRACKS, animate, draw_map
from plot_run_tables import Run, by_id, longest

DOTS_PER_INCH = 110  # Of a picture.


def draw_curves(axes, table, names, label):
    for name, text, colour in names:
        if table.has("time_s", name):
            axes.plot(table["time_s"], table[name], label=text, color=colour, linewidth=1.8 if colour == "k" else 1.0)
    axes.set_ylabel(label)
    axes.legend(fontsize=7, loc="upper right")


def draw_ospa(axes, run):
    draw_curves(axes, run.ospa, (("total", "OSPA", "k"), ("localization", "localization", "tab:blue"),
                                 ("cardinality", "cardinality", "tab:red")), "OSPA [m]")


def draw_gospa(axes, run):
    draw_curves(axes, run.ospa, (("gospa", "GOSPA", "k"), ("gospa_localization", "localization", "tab:blue"),
                                 ("gospa_missed", "missed", "tab:red"), ("gospa_false", "false", "tab:orange")), "GOSPA [m]")


def counts_over_time(table, keep):
    good = keep & np.isfinite(table["time_s"])
    return np.unique(table["time_s"][good], return_counts=True)


def draw_counts(axes, run):
    if run.ospa.has("time_s", "num_truth", "num_tracks"):
        axes.step(run.ospa["time_s"], run.ospa["num_truth"], "0.6", where="post", linewidth=3, label="targets that count")
        axes.step(run.ospa["time_s"], run.ospa["num_tracks"], "tab:green", where="post", label="tracks that count")
    else:
        axes.step(*counts_over_time(run.tracks, run.tracks.sure()), "tab:green", where="post", label="tracks")
    axes.set_ylabel("number")
    axes.legend(fontsize=7, loc="upper right")


def draw_existence(axes, run):
    tracks = run.tracks
    for number, (identity, rows) in enumerate(longest(by_id(tracks, tracks.sure()), MOST_TRACKS)[0]):
        colour = COLOURS[number % len(COLOURS)]
        axes.plot(tracks["time_s"][rows], tracks["existence"][rows], ".-", color=colour, markersize=2, linewidth=0.8)
        axes.annotate(str(identity), (tracks["time_s"][rows[-1]], tracks["existence"][rows[-1]]), color=colour, fontsize=7)
    axes.set(ylabel="existence", ylim=(-0.03, 1.05))


def panels(run):
    """The drawings over time for which there is something to draw."""
    chosen = []
    if run.ospa.has("time_s", "total"):
        chosen.append(draw_ospa)
    if run.ospa.has("time_s", "gospa"):
        chosen.append(draw_gospa)
    if run.ospa.has("time_s", "num_truth", "num_tracks") or run.tracks.has("time_s", "id"):
        chosen.append(draw_counts)
    if run.tracks.has("time_s", "id", "existence", "north_m", "east_m"):
        chosen.append(draw_existence)
    return chosen


def picture(run, title):
    chosen = panels(run)
    figure = plt.figure(figsize=(15, 8) if chosen else (9, 8))
    grid = figure.add_gridspec(max(1, len(chosen)), 2 if chosen else 1, width_ratios=(5, 4) if chosen else None)
    draw_map(figure.add_subplot(grid[:, 0]), run)
    first = None
    for number, draw in enumerate(chosen):
        first = axes = figure.add_subplot(grid[number, 1], sharex=first)
        draw(axes, run)
        axes.grid(alpha=0.3)
        if number == len(chosen) - 1:
            axes.set_xlabel("time [s]")
    figure.suptitle(title, y=0.94)
    return figure


def arguments(words):
    if not words or "--help" in words:
        sys.exit(__doc__)
    given = {"--scores": None, "--title": None}
    plain = []
    words = iter(words)
    for word in words:
        if word in given:
            given[word] = next(words, None)
        else:
            plain.append(word)
    files = [pathlib.Path(name) for name in plain[1:]] or [pathlib.Path(plain[0]) / "lookout.png"]
    return pathlib.Path(plain[0]), given["--scores"], given["--title"] or plain[0], files


def write_whole(path, write):
    """Writes a picture beside its place and moves it there: a full disk leaves no part of one."""
    part = path.with_name(f".{path.stem}.part{path.suffix}")
    try:
        write(part)
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)


def write_picture(run, title, path):
    if path.suffix == ".gif":
        return write_whole(path, lambda part: animate(run, part))
    figure = picture(run, title)
    write_whole(path, lambda part: figure.savefig(part, dpi=DOTS_PER_INCH, bbox_inches="tight"))
    plt.close(figure)
    return None


def main():
    directory, scores, title, files = arguments(sys.argv[1:])
    run = Run(directory, pathlib.Path(scores) if scores else None)
    if run.empty():
        print(f"plot_run.py: {directory}: nothing to draw: {run.lacks(directory)}", file=sys.stderr)
        return 2
    try:
        for path in files:
            write_picture(run, title, path)
    except OSError as error:
        print(f"plot_run.py: {error}", file=sys.stderr)
        return 1 if error.errno in (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO) else 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
