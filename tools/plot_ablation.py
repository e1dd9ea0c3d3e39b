#!/usr/bin/python3
"""Pictures of the csht-ablation experiment: what each rung from [Yan2018] as printed to csht brings.

Usage: plot_ablation.py DIR, where `lookout experiment csht-ablation --out DIR` has written: ladder_light.png (and .pdf)
and so on, pictures.md with their captions, tables.md. What --only left out is not drawn.
"""
import json
import pathlib
import sys

from plot_style import PAPER, Album, plt, style

import paper_tables


def mean_of(cells, source):
    values = [source(cell) for cell in cells]
    return sum(values) / len(values)


def plot_ladder(album, cells, clutter):
    own = [cell for cell in cells if cell["parameters"]["clutter"] == clutter]
    rungs = list(dict.fromkeys(cell["parameters"]["variant"] for cell in own))
    figure, axis = plt.subplots(figsize=(9, 4.5))
    for index, p_miss in enumerate(sorted({cell["parameters"]["p_miss"] for cell in own})):
        heights = []
        for rung in rungs:
            chosen = [cell for cell in own if cell["parameters"]["variant"] == rung and cell["parameters"]["p_miss"] == p_miss]
            heights.append(mean_of(chosen, lambda cell: cell["metrics"]["position_ospa"]["mean"]))
        axis.plot(range(len(rungs)), heights, label=f"$P_M$ = {p_miss:g}", **style(index))
        paper = mean_of(chosen, lambda cell: cell["paper"]["position_ospa"])
        axis.plot(len(rungs) - 0.4, paper, **PAPER, label="paper" if index == 0 else None)
    axis.set_xticks(range(len(rungs)), rungs)
    axis.set_ylabel("position OSPA [m], mean over P_F and sigma")
    axis.grid(alpha=0.3)
    axis.legend(fontsize=8)
    album.save(figure, f"ladder_{clutter}", f"Position OSPA of each rung of the ladder, {clutter} clutter, mean over the cells of one miss "
               "rate (docs/csht.md names the rungs); stars: the paper's CSHT.")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    directory = pathlib.Path(sys.argv[1])
    album = Album(directory)
    cells = json.loads((directory / "results.json").read_text())["cells"]
    for clutter in sorted({cell["parameters"]["clutter"] for cell in cells}):
        plot_ladder(album, cells, clutter)
    paper_tables.write_tables(directory)


if __name__ == "__main__":
    main()
