#!/usr/bin/python3
"""Checks that every citation, such as [Yan2018], has an entry in docs/references.bib, and that every entry is whole.

A citation is an author's name and a year in square brackets, in any text file of the tree. An entry is whole where its
braces balance and it names author, title and year. Prints one line a fault and exits 1 where there is one.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
BIBLIOGRAPHY = ROOT / "docs" / "references.bib"
TEXT_SUFFIXES = {".cpp", ".hpp", ".md", ".py", ".sh", ".yaml", ".csv", ".lcm", ".cmake", ".txt", ""}
LEFT_OUT = {".git", "build", "out"}
CITATION = re.compile(r"\[([A-Z][A-Za-z]+(?:19|20)\d\d[a-z]?)(?=[\],; ])")
ENTRY = re.compile(r"^@\w+\{(\w+),", re.MULTILINE)
REQUIRED_FIELDS = ("author", "title", "year")


def text_files():
    for path in sorted(ROOT.rglob("*")):
        top = path.relative_to(ROOT).parts[0]
        if top in LEFT_OUT or top.startswith("build") or not path.is_file() or path.suffix not in TEXT_SUFFIXES:
            continue
        yield path


def entries(text):
    """The key and the text of each entry: from its @ to the next one's."""
    starts = list(ENTRY.finditer(text))
    for start, following in zip(starts, [*starts[1:], None]):
        yield start.group(1), text[start.start() : following.start() if following else len(text)]


def faults_of_entry(key, entry):
    if entry.count("{") != entry.count("}"):
        yield f"docs/references.bib: {key}: braces do not balance"
    for field in REQUIRED_FIELDS:
        if not re.search(rf"^\s*{field}\s*=", entry, re.MULTILINE):
            yield f"docs/references.bib: {key}: no {field}"


def faults_of_file(path, keys):
    try:
        lines = path.read_text().splitlines()
    except UnicodeDecodeError:
        return
    for number, line in enumerate(lines, 1):
        for key in CITATION.findall(line):
            if key not in keys:
                yield f"{path.relative_to(ROOT)}:{number}: [{key}] has no entry in docs/references.bib"


def main():
    found = list(entries(BIBLIOGRAPHY.read_text()))
    keys = [key for key, _ in found]
    faults = [fault for key, entry in found for fault in faults_of_entry(key, entry)]
    faults += [f"docs/references.bib: {key}: twice" for key in sorted(set(keys)) if keys.count(key) > 1]
    faults += [fault for path in text_files() for fault in faults_of_file(path, keys)]
    print("\n".join(faults) or f"citations: all resolve, {len(keys)} entries")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
