#!/usr/bin/python3
"""Checks docs/paper_index.md: every figure and table of the five papers stands in a row, and a row has a command and a
file, or says without a command where its content is.

usage: check_paper_index.py LOOKOUT
Experiments that a command names must be in `lookout experiment --list`, scripts and scenes in the tree. Prints one line a
fault and exits 1 where there is one.
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
INDEX = ROOT / "docs" / "paper_index.md"
# How many figures and tables each paper has.
PAPERS = {"Yan2018": (28, 13), "Fan2018": (15, 3), "Zeng2023": (12, 2), "Pakfiliz2018": (3, 4), "Li2018": (4, 1)}
WORD = re.compile(r"(Fig\.|Table)|(\d+)(?: to (\d+))?|([^\s,])")


def numbered(text):
    """The figures and tables that the first column of a row names: (kind, number); prose after them ends a list."""
    kind = None
    for name, first, last, other in WORD.findall(text):
        if name:
            kind = name
        elif other:
            kind = None
        elif kind:
            yield from ((kind, number) for number in range(int(first), int(last or first) + 1))


def rows_by_paper(text):
    for section in text.split("\n## ")[1:]:
        paper = re.match(r"\[(\w+)\]", section).group(1)
        lines = [line for line in section.splitlines() if line.startswith("| ")][1:]
        yield paper, [[cell.strip() for cell in line.strip("|").split("|")] for line in lines if not line.startswith("| ---")]


def faults_of_paper(paper, rows):
    named = {entry for row in rows for entry in numbered(row[0])}
    for kind, count in zip(("Fig.", "Table"), PAPERS[paper]):
        for number in range(1, count + 1):
            if (kind, number) not in named:
                yield f"[{paper}] {kind} {number} has no row"
    for row in rows:
        if len(row) != 3 or not row[2]:
            yield f"[{paper}] `{row[0]}`: a row has what, a command or nothing, and where it is found"


def faults_of_commands(text, lookout):
    listed = subprocess.run([lookout, "experiment", "--list"], check=True, capture_output=True, text=True).stdout
    names = set(re.findall(r"^\s*([a-z0-9-]+)", listed, re.MULTILINE))
    for name in re.findall(r"lookout\s+experiment ([a-z0-9-]+)", text):
        if name not in names:
            yield f"there is no experiment {name}"
    for path in re.findall(r"`((?:tools|examples)/[\w/.]+)`", text):
        if not (ROOT / path).exists():
            yield f"there is no {path}"


def main():
    text = INDEX.read_text()
    papers = dict(rows_by_paper(text))
    faults = [f"[{paper}] has no section" for paper in PAPERS if paper not in papers]
    for paper, rows in papers.items():
        faults += faults_of_paper(paper, rows)
    faults += faults_of_commands(text, sys.argv[1])
    for fault in faults:
        print(f"docs/paper_index.md: {fault}")
    print(f"paper index: {len(faults)} faults, {sum(len(rows) for rows in papers.values())} rows")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
