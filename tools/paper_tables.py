#!/usr/bin/python3
"""Lays the figures of an experiment out as its paper's tables: Markdown grids of P_M by P_F, and rows of cells.

Usage: paper_tables.py DIR, where `lookout experiment NAME --out DIR` has written: writes DIR/tables.md.
tools/reproduce makes the tables of a results page with the same functions.
"""
import csv
import pathlib
import sys

KEYS_OF_RESULTS = ("metric", "mean", "ci95", "runs", "paper")
DOWN, ACROSS = "p_miss", "p_false_alarm"
LETTERS = {"p_miss": "P_M", "p_false_alarm": "P_F", "sigma": "σ"}
MACHINE_FIGURES = ("time_ms", "time_ms_median", "time_ms_p99", "share_of_real_time", "update_ms")  # these depend on the machine, so nothing compares them


class InputError(Exception):
    """What the user can mend, in one line."""


def read_results(path):
    """The rows of results.csv: a dictionary each, the figures as numbers or None."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        for key in ("mean", "ci95", "paper"):
            row[key] = float(row[key]) if row[key] not in ("", "nan", None) else None
    return rows


def same(a, b):
    """Whether two texts are the same parameter value; numbers are compared as numbers."""
    try:
        return float(a) == float(b)
    except ValueError:
        return a == b


def chosen(rows, wanted):
    """The rows whose parameters have the wanted values: a list of (key, value); the same key twice means or."""
    for key in {key for key, _ in wanted}:
        if rows and key not in rows[0]:
            raise InputError(f"the results have no column `{key}`, only {' '.join(rows[0])}")
        values = [value for name, value in wanted if name == key]
        rows = [row for row in rows if any(same(row[key], value) for value in values)]
    return rows


def parameters_of(rows):
    return [key for key in rows[0] if key not in KEYS_OF_RESULTS] if rows else []


def number(value, digits):
    return "–" if value is None else f"{value:.{digits}f}"


def figure_text(rows, metric, digits, with_interval=True):
    """One figure: mean, half width of its interval where it has one, the paper's in brackets."""
    found = [row for row in rows if row["metric"] == metric]
    if not found:
        return "–"
    if len(found) > 1:
        raise InputError(f"{len(found)} cells have a figure `{metric}` here; narrow `where`")
    row = found[0]
    text = number(row["mean"], digits)
    if with_interval and row["ci95"] is not None:
        text += f" ± {number(row['ci95'], digits)}"
    return text + (f" ({number(row['paper'], digits)})" if row["paper"] is not None else "")


def cell_text(rows, metrics, digits):
    """The figures of one cell, the first with its interval: `1.11 ± 0.05 (1.33) / 0.18 (0.13)`."""
    texts = [figure_text(rows, metric, digits, index == 0) for index, metric in enumerate(metrics)]
    return "" if set(texts) == {"–"} else " / ".join(texts)


def values_of(rows, key):
    """The values of a parameter, numbers rising, names in the order of the cells."""
    values = list(dict.fromkeys(row[key] for row in rows if row[key] != ""))
    try:
        return sorted(values, key=float)
    except ValueError:
        return values


def mean_of(values):
    known = [value for value in values if value is not None]
    return sum(known) / len(known) if known else None


def pooled(rows, keys):
    """The mean over all cells that agree in `keys`, a row for each and figure, without an interval."""
    groups = {}
    for row in rows:
        groups.setdefault((*(row[key] for key in keys), row["metric"]), []).append(row)
    return [{**own[0], "mean": mean_of([row["mean"] for row in own]), "ci95": None,
             "paper": mean_of([row["paper"] for row in own])} for own in groups.values()]


def grid(rows, metrics, down=DOWN, across=ACROSS, digits=2):
    """A table as [Yan2018] prints them: a row for each value of `down`, a column for each of `across`."""
    columns = values_of(rows, across)
    head = f"{LETTERS.get(down, down)} \\ {LETTERS.get(across, across)}"
    lines = [[head] + columns, ["---"] * (1 + len(columns))]
    for value in values_of(rows, down):
        own = [row for row in rows if row[down] == value]
        lines.append([value] + [cell_text([r for r in own if r[across] == column], metrics, digits) for column in columns])
    return lines


def listing(rows, metrics, columns, digits=2):
    """A table with a row for each cell: the parameters in `columns`, then the figures."""
    keys = list(dict.fromkeys(tuple(row[name] for name in columns) for row in rows))
    lines = [list(columns) + list(metrics), ["---"] * (len(columns) + len(metrics))]
    for key in keys:
        own = [row for row in rows if tuple(row[name] for name in columns) == key]
        lines.append(list(key) + [figure_text(own, metric, digits) for metric in metrics])
    return lines


def as_markdown(lines):
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def grids_of(rows):
    """(heading, lines) for every group of cells that differ in P_F and P_M alone, and for what varies with sigma."""
    others = [name for name in parameters_of(rows) if name not in (DOWN, ACROSS)]
    for key in dict.fromkeys(tuple(row[name] for name in others) for row in rows):
        own = [row for row in rows if tuple(row[name] for name in others) == key]
        heading = ", ".join(f"{name} {value}" for name, value in zip(others, key) if value != "")
        for metric in dict.fromkeys(row["metric"] for row in own):
            yield f"{metric}: {heading}", grid([row for row in own if row["metric"] == metric], [metric])


def write_tables(directory):
    rows = read_results(directory / "results.csv")
    if not rows or DOWN not in rows[0] or ACROSS not in rows[0]:
        return
    text = "# Tables\n\nmean ± half width of the 95 % interval (the paper's figure).\n"
    for heading, lines in grids_of(rows):
        text += f"\n{heading}\n\n{as_markdown(lines)}\n"
    (directory / "tables.md").write_text(text)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    try:
        write_tables(pathlib.Path(sys.argv[1]))
    except (InputError, OSError) as error:
        print(f"paper_tables.py: {error}", file=sys.stderr)
        sys.exit(2)


if __name__ == "__main__":
    main()
