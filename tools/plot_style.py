"""How every picture of the experiments looks: line styles and markers that a grey print keeps apart, PNG and PDF side
by side, and captions in a list of pictures rather than titles in them.
"""
import math
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from cycler import cycler  # noqa: E402

# Dark to light by turns, so that neighbours differ in grey; seven colours, four dashes and nine markers repeat out of
# step, so that no two of the first 63 curves agree in colour and marker.
COLOURS = ["#000000", "#0072b2", "#d55e00", "#56a9d8", "#7a3e9d", "#2f8f5b", "#b8860b"]
DASHES = ["-", "--", "-.", ":"]
MARKERS = ["o", "s", "^", "D", "v", "x", "P", "<", ">"]
PAPER = {"linestyle": "none", "marker": "*", "markersize": 9, "markerfacecolor": "none", "markeredgecolor": "0.25"}
RESOLUTION = 130  # [dots per inch] of the PNG

# Curves that name no style of their own go through the same colours and dashes.
_LENGTH = math.lcm(len(COLOURS), len(DASHES))
plt.rcParams["axes.prop_cycle"] = cycler(color=(COLOURS * _LENGTH)[:_LENGTH]) + cycler(linestyle=(DASHES * _LENGTH)[:_LENGTH])


def style(index, markersize=4):
    """Keywords of the curve number `index` for `Axes.plot` and `Axes.errorbar`."""
    return {"color": COLOURS[index % len(COLOURS)], "linestyle": DASHES[index % len(DASHES)],
            "marker": MARKERS[index % len(MARKERS)], "markersize": markersize, "linewidth": 1.2}


def draw_band(axis, x, mean, half_width, index, label):
    """A curve over time with its 95 % band; a marker at each tenth point."""
    every = 10
    look = style(index)
    axis.plot(x, mean, label=label, markevery=(index % every, every), **look)
    low = [m - h for m, h in zip(mean, half_width)]
    high = [m + h for m, h in zip(mean, half_width)]
    axis.fill_between(x, low, high, color=look["color"], alpha=0.18, linewidth=0)


def save_both(figure, path):
    """The picture at `path` (.png) and as vectors beside it (.pdf)."""
    for ending in (".png", ".pdf"):
        figure.savefig(pathlib.Path(path).with_suffix(ending), dpi=RESOLUTION, bbox_inches="tight")
    plt.close(figure)


class Album:
    """The pictures of one directory: NAME.png and NAME.pdf, and pictures.md with a caption for each."""

    def __init__(self, directory):
        self.directory = pathlib.Path(directory)
        self.entries = []

    def save(self, figure, name, caption):
        save_both(figure, self.directory / f"{name}.png")
        self.entries.append(f"![{name}]({name}.png)\n\n*{caption}* ([PDF]({name}.pdf))\n")
        (self.directory / "pictures.md").write_text("# Pictures\n\n" + "\n".join(self.entries))
