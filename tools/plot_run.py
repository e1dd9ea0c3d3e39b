#!/usr/bin/python3
"""Draws a run, a replay or anyone's recording: map, scores, counts and the existence of each track over time.

Usage: plot_run.py DIRECTORY [--scores FILE.csv] [--title TEXT] FILE.png|FILE.pdf|FILE.gif ...

Reads what there is of scans.csv, vehicle.csv, truth.csv, tracks.csv, ospa.csv and sonar.yaml, and leaves out of the
picture what is missing. A GIF is the map over time. Exit status 2 with one line where nothing can be drawn.
"""
import csv
import math
import pathlib
import re
import sys

try:
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    import numpy as np
except ImportError as error:
    sys.exit(f"plot_run.py: {error}; install python3-numpy and python3-matplotlib")

MARKERS = {"confirmed": "o", "tentative": "^", "coasting": "s"}
COLOURS = plt.get_cmap("tab10").colors
CHI_SQUARE_95 = -2.0 * math.log(0.05)  # Of two degrees of freedom.
MOST_RETURNS = 60_000   # Points on a map; of more, an even choice.
MOST_ELLIPSES = 12      # A track.
MOST_FRAMES = 150       # Of an animation.
TRAIL_S = 30.0
FADE_S = 8.0


class Table:
    """The columns of a CSV file as arrays of floats, what is no number as nan; texts of `status` as they are."""

    def __init__(self, path):
        self.columns = {}
        self.status = []
        if not path.is_file():
            return
        try:
            with open(path, newline="", encoding="utf-8-sig", errors="replace") as file:
                text = file.read()
            semicolons = ";" in text.split("\n", 1)[0]
            rows = list(csv.reader(text.replace("\0", "").splitlines(), delimiter=";" if semicolons else ","))
        except (OSError, csv.Error) as error:
            warn(f"{path}: {error}")
            return
        if not rows:
            return
        header, body = [name.strip() for name in rows[0]], rows[1:]
        for k, name in enumerate(header):
            values = [row[k].strip() if k < len(row) else "" for row in body]
            if semicolons:
                values = [value.replace(",", ".") for value in values]
            self.columns[name] = np.array([to_float(value) for value in values])
            if name == "status":
                self.status = values

    def __len__(self):
        return len(next(iter(self.columns.values()), ()))

    def __getitem__(self, name):
        return self.columns.get(name, np.full(len(self), np.nan))

    def has(self, *names):
        return len(self) > 0 and all(name in self.columns and np.isfinite(self[name]).any() for name in names)

    def sure(self):
        """Which rows are not of tentative tracks."""
        return np.array([status != "tentative" for status in self.status] or [True] * len(self), dtype=bool)


def warn(line):
    print(f"plot_run.py: {line}", file=sys.stderr)


def to_float(text):
    try:
        return float(text)
    except ValueError:
        return math.nan


def read_sonar(path):
    """The plain `key: number` lines of sonar.yaml."""
    figures = {}
    if path.is_file():
        for line in path.read_text(errors="replace").splitlines():
            found = re.match(r"\s*(\w+)\s*:\s*(-?[\d.eE+-]+)\s*(#.*)?$", line)
            if found and math.isfinite(to_float(found.group(2))):
                figures[found.group(1)] = float(found.group(2))
    return figures


class Run:
    """What a directory holds."""

    def __init__(self, directory, scores):
        self.scans = Table(directory / "scans.csv")
        self.vehicle = Table(directory / "vehicle.csv")
        self.truth = Table(directory / "truth.csv")
        self.tracks = Table(directory / "tracks.csv")
        self.ospa = Table(scores) if scores and scores.is_file() else Table(directory / "ospa.csv")
        self.sonar = read_sonar(directory / "sonar.yaml")
        self.returns = self.placed_returns()

    def empty(self):
        return not (len(self.returns) or self.vehicle.has("north_m", "east_m") or self.ospa.has("time_s", "total")
                    or any(table.has("time_s", "north_m", "east_m") for table in (self.truth, self.tracks)))

    def pose(self, times):
        """Vehicle north, east, heading at `times`; the origin, looking north, where there is no vehicle.csv."""
        vehicle = self.vehicle
        if not vehicle.has("time_s", "north_m", "east_m", "heading_rad"):
            return np.zeros((3, len(times)))
        good = np.isfinite(vehicle["time_s"]) & np.isfinite(vehicle["north_m"]) & np.isfinite(vehicle["east_m"])
        good &= np.isfinite(vehicle["heading_rad"])
        order = np.argsort(vehicle["time_s"][good], kind="stable")
        at = vehicle["time_s"][good][order]
        columns = [vehicle[name][good][order] for name in ("north_m", "east_m")]
        columns.append(np.unwrap(vehicle["heading_rad"][good][order]))
        return np.array([np.interp(times, at, column) for column in columns])

    def sonar_pose(self, times):
        north, east, heading = self.pose(times)
        forward, starboard = self.sonar.get("mount_x", 0.0), self.sonar.get("mount_y", 0.0)
        return np.array([north + forward * np.cos(heading) - starboard * np.sin(heading),
                         east + forward * np.sin(heading) + starboard * np.cos(heading),
                         heading + math.radians(self.sonar.get("mount_heading_deg", 0.0))])

    def placed_returns(self):
        """Time, north and east of every return, a row each."""
        scans = self.scans
        if not scans.has("time_s", "bearing_rad", "range_m"):
            return np.empty((0, 3))
        good = np.isfinite(scans["time_s"]) & np.isfinite(scans["bearing_rad"]) & np.isfinite(scans["range_m"])
        time, bearing, reach = (scans[name][good] for name in ("time_s", "bearing_rad", "range_m"))
        north, east, heading = self.sonar_pose(time)
        angle = heading + bearing
        return np.column_stack([time, north + reach * np.cos(angle), east + reach * np.sin(angle)])

    def fan_edges(self):
        """First and last bearing [rad] and range [m] of the sonar: of sonar.yaml, else of the returns."""
        keys = ("num_beams", "first_bearing_deg", "bearing_step_deg", "max_range")
        if all(key in self.sonar for key in keys):
            beams, first, step, reach = (self.sonar[key] for key in keys)
            return math.radians(first - step / 2), math.radians(first + (beams - 0.5) * step), reach
        if not self.scans.has("bearing_rad", "range_m"):
            return None
        bearing = self.scans["bearing_rad"]
        return np.nanmin(bearing), np.nanmax(bearing), np.nanmax(self.scans["range_m"])

    def times(self):
        """First and last time of anything that moves; nothing where there is no time at all."""
        all_times = [table["time_s"] for table in (self.scans, self.tracks, self.truth) if table.has("time_s")]
        finite = np.concatenate(all_times)[np.isfinite(np.concatenate(all_times))] if all_times else np.array([])
        return np.unique(finite)


def fan_outline(run, time):
    edges = run.fan_edges()
    if edges is None:
        return None
    north, east, heading = run.sonar_pose(np.array([time]))[:, 0]
    angles = heading + np.linspace(edges[0], edges[1], 61)
    return (np.concatenate([[east], east + edges[2] * np.sin(angles), [east]]),
            np.concatenate([[north], north + edges[2] * np.cos(angles), [north]]))


def ellipse(north, east, covariance):
    """East and north of the curve that holds a position with probability 0.95; nothing for no covariance."""
    nn, ne, ee = covariance
    if not all(math.isfinite(value) for value in covariance):
        return None
    values, vectors = np.linalg.eigh(np.array([[nn, ne], [ne, ee]]))
    if values[0] < 0:
        return None
    turn = np.linspace(0, 2 * np.pi, 41)
    curve = vectors @ (np.sqrt(CHI_SQUARE_95 * values)[:, None] * np.array([np.cos(turn), np.sin(turn)]))
    return east + curve[1], north + curve[0]


COVARIANCE = ("covariance_nn_m2", "covariance_ne_m2", "covariance_ee_m2")


def by_id(table, keep=None):
    """(id, rows) of each id, in order."""
    keep = np.ones(len(table), dtype=bool) if keep is None else keep
    keep = keep & np.isfinite(table["north_m"]) & np.isfinite(table["east_m"])
    identity = table["id"]
    for value in np.unique(identity[keep & np.isfinite(identity)]):
        yield int(value), np.flatnonzero(keep & (identity == value))


def draw_returns(axes, returns):
    if not len(returns):
        return
    step = max(1, math.ceil(len(returns) / MOST_RETURNS))
    shown = returns[::step]
    alpha = min(0.5, max(0.03, 400.0 / len(shown)))
    axes.plot(shown[:, 2], shown[:, 1], ".", color="0.45", markersize=1.5, alpha=alpha, rasterized=True, zorder=1,
              label="returns")


def draw_truth(axes, run):
    for number, (_, rows) in enumerate(by_id(run.truth)):
        axes.plot(run.truth["east_m"][rows], run.truth["north_m"][rows], color="0.2", linewidth=5, alpha=0.3,
                  solid_capstyle="round", zorder=2, label=None if number else "truth")


def draw_track(axes, run, number, identity, rows):
    tracks, colour = run.tracks, COLOURS[number % len(COLOURS)]
    east, north = tracks["east_m"], tracks["north_m"]
    axes.plot(east[rows], north[rows], "-", color=colour, linewidth=1.3, zorder=4)
    status = tracks.status[rows[-1]] if tracks.status else "confirmed"
    axes.plot(east[rows[-1]], north[rows[-1]], MARKERS.get(status, "o"), color=colour, markersize=6, zorder=5)
    axes.annotate(str(identity), (east[rows[-1]], north[rows[-1]]), xytext=(5, 5), textcoords="offset points",
                  color=colour, fontweight="bold", fontsize=9)
    for row in rows[::-max(1, len(rows) // MOST_ELLIPSES)]:
        curve = ellipse(north[row], east[row], [tracks[name][row] for name in COVARIANCE])
        if curve is not None:
            axes.plot(*curve, color=colour, linewidth=0.5, alpha=0.6, zorder=3)


def draw_map(axes, run):
    times = run.times()
    for number, time in enumerate((times[0], times[-1]) if len(times) else ()):
        outline = fan_outline(run, time)
        if outline is not None:
            axes.fill(*outline, color="tab:blue", alpha=0.06, zorder=0)
            axes.plot(*outline, color="tab:blue", linewidth=0.7, alpha=0.5, zorder=0,
                      label=None if number else "fan, first and last scan")
    draw_returns(axes, run.returns)
    if run.vehicle.has("north_m", "east_m"):
        axes.plot(run.vehicle["east_m"], run.vehicle["north_m"], "k-", linewidth=1.5, label="vehicle", zorder=3)
    draw_truth(axes, run)
    for number, (identity, rows) in enumerate(by_id(run.tracks, run.tracks.sure())):
        draw_track(axes, run, number, identity, rows)
    axes.set(xlabel="east [m]", ylabel="north [m]")
    axes.set_aspect("equal", adjustable="datalim")
    if axes.get_legend_handles_labels()[0]:
        axes.legend(loc="best", fontsize=7)


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
    for number, (identity, rows) in enumerate(by_id(tracks, tracks.sure())):
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


def draw_moment(axes, run, time):
    """The map at one time: returns that fade, fan, targets, tracks with a trail of 30 s."""
    outline = fan_outline(run, time)
    if outline is not None:
        axes.fill(*outline, color="tab:blue", alpha=0.08)
    age = time - run.returns[:, 0]
    recent = (age >= 0) & (age < FADE_S)
    shade = np.zeros((recent.sum(), 4))
    shade[:, 3] = 1 - age[recent] / FADE_S
    axes.scatter(run.returns[recent, 2], run.returns[recent, 1], s=4, color=shade)
    if run.truth.has("time_s", "north_m", "east_m"):
        now = np.isclose(run.truth["time_s"], time, atol=1e-6, rtol=0)
        axes.plot(run.truth["east_m"][now], run.truth["north_m"][now], "x", color="m", markersize=9)
    tracks = run.tracks
    then = (tracks["time_s"] <= time + 1e-6) & (tracks["time_s"] > time - TRAIL_S) & tracks.sure()
    for number, (identity, rows) in enumerate(by_id(tracks, tracks.sure())):
        rows = rows[then[rows]]
        if len(rows) and abs(tracks["time_s"][rows[-1]] - time) < FADE_S / 2:
            draw_track(axes, run, number, identity, rows)
    axes.set(xlabel="east [m]", ylabel="north [m]", title=f"{time:.1f} s")


def limits(run):
    points = [run.returns[:, 1:]] + [np.column_stack([table["north_m"], table["east_m"]])
                                     for table in (run.vehicle, run.truth, run.tracks) if table.has("north_m", "east_m")]
    every = np.concatenate(points)
    return np.nanmin(every, axis=0) - 5.0, np.nanmax(every, axis=0) + 5.0


def animate(run, path):
    from matplotlib.animation import FuncAnimation, PillowWriter
    times = run.times()
    if not len(times):
        return warn(f"{path}: nothing has a time, no animation")
    times = times[:: max(1, math.ceil(len(times) / MOST_FRAMES))]
    low, high = limits(run)
    figure, axes = plt.subplots(figsize=(6, 6))

    def moment(time):
        axes.clear()
        draw_moment(axes, run, time)
        axes.set(xlim=(low[1], high[1]), ylim=(low[0], high[0]), aspect="equal")

    FuncAnimation(figure, moment, frames=times).save(path, writer=PillowWriter(fps=10), dpi=80)
    plt.close(figure)
    return None


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


def main():
    directory, scores, title, files = arguments(sys.argv[1:])
    run = Run(directory, pathlib.Path(scores) if scores else None)
    if run.empty():
        print(f"plot_run.py: {directory}: nothing to draw; expected scans.csv, vehicle.csv, truth.csv, tracks.csv or ospa.csv",
              file=sys.stderr)
        return 2
    try:
        for path in files:
            if path.suffix == ".gif":
                animate(run, path)
            else:
                figure = picture(run, title)
                figure.savefig(path, dpi=110, bbox_inches="tight")
                plt.close(figure)
    except OSError as error:
        print(f"plot_run.py: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
