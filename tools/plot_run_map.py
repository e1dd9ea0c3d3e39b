"""The map of a run: whole, at one time, and over time as a GIF."""
import math

import matplotlib.pyplot as plt
import numpy as np

from plot_run_tables import by_id, longest, warn

MARKERS = {"confirmed": "o", "tentative": "^", "coasting": "s"}
COLOURS = plt.get_cmap("tab10").colors
COVARIANCE = ("covariance_nn_m2", "covariance_ne_m2", "covariance_ee_m2")
CHI_SQUARE_95 = -2.0 * math.log(0.05)  # Of two degrees of freedom.
MOST_RETURNS = 60_000   # Points on a map; of more, an even choice.
MOST_ELLIPSES = 12      # A track.
MOST_TRACKS = 200       # With a number and a colour of their own: the longest; each takes milliseconds.
MOST_FRAMES = 150       # Of an animation.
TRAIL_S = 30.0
FADE_S = 8.0


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


def draw_nameless(axes, table, colour):
    """What says where but not who."""
    there = ~np.isfinite(table["id"])
    if table.has("north_m", "east_m") and there.any():
        axes.plot(table["east_m"][there], table["north_m"][there], ".", color=colour, markersize=3, zorder=3)


def label_map(axes, run):
    unit = "px" if run.in_pixels else "m"
    axes.set(xlabel=f"x [{unit}]" if run.in_pixels else "east [m]", ylabel=f"y [{unit}]" if run.in_pixels else "north [m]")
    if run.in_pixels and not axes.yaxis_inverted():
        axes.invert_yaxis()


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
    tracks, others = longest(by_id(run.tracks, run.tracks.sure()), MOST_TRACKS)
    for number, (identity, rows) in enumerate(tracks):
        draw_track(axes, run, number, identity, rows)
    if len(others):
        axes.plot(run.tracks["east_m"][others], run.tracks["north_m"][others], ".", color="tab:olive", markersize=2, zorder=3,
                  label=f"shorter tracks than the {MOST_TRACKS} longest")
    draw_nameless(axes, run.truth, "0.2")
    draw_nameless(axes, run.tracks, "tab:green")
    axes.set_aspect("equal", adjustable="datalim")
    if axes.get_legend_handles_labels()[0]:
        axes.legend(loc="best", fontsize=7)
    label_map(axes, run)


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
    for number, (identity, rows) in enumerate(longest(by_id(tracks, tracks.sure()), MOST_TRACKS)[0]):
        rows = rows[then[rows]]
        if len(rows) and abs(tracks["time_s"][rows[-1]] - time) < FADE_S / 2:
            draw_track(axes, run, number, identity, rows)
    axes.set_title(f"{time:.1f} s")


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
        label_map(axes, run)

    FuncAnimation(figure, moment, frames=times).save(path, writer=PillowWriter(fps=10), dpi=80)
    plt.close(figure)
    return None
