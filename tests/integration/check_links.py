#!/usr/bin/python3
"""Checks that the pages (*.md) point at what exists.

1. A relative link's file exists, and its #anchor is a heading there.
2. A name in backticks that looks like a path of the tree exists: with a slash, such as `csht/hough_window` (as it
   stands, or with .hpp or .cpp), or the name of a source, script or page, such as `check_links.py`. Names that begin
   with a folder of the tree stand at its root; others, such as `frames/pdim`, may lie anywhere.
   Dated reports, the laboratory book and the change log speak of their own day and are spared this one.
3. With --sources: a page that a source names, such as `docs/frames.md`, exists.

Prints one line a fault and exits 1 where there is one.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
LEFT_OUT = {".git", "out"}
OF_THEIR_DAY = ("docs/results/", "docs/notes/", "CHANGELOG.md")
SUFFIXES = (".hpp", ".cpp")  # Of the files that a name without one may mean.
BARE_NAME = re.compile(r"^[\w-]+\.(hpp|cpp|md|py|sh|lcm|bib|cmake)$")
PATH = re.compile(r"^[\w*.-]+(/[\w*.-]+)+/?$")
LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
PAGE_IN_SOURCE = re.compile(r"\bdocs/[\w/-]+\.(?:md|bib)\b")
SOURCE_SUFFIXES = {".hpp", ".cpp", ".lcm", ".yaml", ".sh", ".cmake", ".py"}
CODE_BLOCK = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
BACKTICKS = re.compile(r"`([^`\n]+)`")
FOLDERS_OF_OTHERS = {"build", "out"}  # Made by a build or a run.
EXAMPLES = re.compile(r"(^|/)(x|x_test|mine)\.\w+$")  # What the reader is to write.


def left_out(path):
    top = path.relative_to(ROOT).parts[0]
    return top in LEFT_OUT or top.startswith("build")


FILES = [path for path in ROOT.rglob("*") if not left_out(path)]
NAMES = {path.name for path in FILES}
PATHS = {"/" + path.relative_to(ROOT).as_posix() for path in FILES}
TOP_FOLDERS = {path.name for path in ROOT.iterdir() if path.is_dir()}


def slug(heading):
    """The anchor that a heading gets: lower case, punctuation gone, blanks as hyphens."""
    plain = re.sub(r"[^\w\s-]", "", heading.replace("`", "").strip().lower())
    return re.sub(r"\s", "-", plain)


def anchors(page):
    return {slug(heading) for heading in re.findall(r"^#+\s+(.*)$", page.read_text(), re.MULTILINE)}


def fault_of_link(page, target):
    if re.match(r"^[a-z]+:", target):
        return None
    name, _, anchor = target.partition("#")
    file = (page.parent / name).resolve() if name else page
    if not file.exists():
        return f"link to {target}: no such file"
    if anchor and file.suffix == ".md" and anchor not in anchors(file):
        return f"link to {target}: no such heading"
    return None


def ends_like(name):
    """Whether a file or folder of the tree ends in `/name`, * standing for anything within a name."""
    pattern = re.compile(re.escape("/" + name.rstrip("/")).replace(r"\*", "[^/]*") + "$")
    return any(pattern.search(path) for path in PATHS)


def exists_anywhere(name):
    return any(ends_like(name + suffix) for suffix in ("", *SUFFIXES))


def exists_at_root(name):
    return any(next(ROOT.glob(name.rstrip("/") + suffix), None) for suffix in ("", *SUFFIXES))


def fault_of_name(name):
    name = name.removesuffix(":")
    if BARE_NAME.match(name):
        return None if name in NAMES or EXAMPLES.search(name) else f"`{name}`: no file of that name"
    if not PATH.match(name):
        return None
    first = name.split("/")[0]
    if EXAMPLES.search(name) or first in FOLDERS_OF_OTHERS or first.isupper() or re.fullmatch(r"[\d.*/]+", name):
        return None
    found = exists_at_root(name) if first in TOP_FOLDERS else exists_anywhere(name)
    return None if found else f"`{name}`: no such file"


def faults_of_page(page):
    name = page.relative_to(ROOT).as_posix()
    text = CODE_BLOCK.sub(lambda block: "\n" * block.group().count("\n"), page.read_text())
    found = [(match, fault_of_link(page, match.group(1))) for match in LINK.finditer(text)]
    if not name.startswith(OF_THEIR_DAY):
        found += [(match, fault_of_name(match.group(1))) for match in BACKTICKS.finditer(text)]
    for match, fault in found:
        if fault:
            line = text.count("\n", 0, match.start()) + 1
            yield f"{name}:{line}: {fault}"


def faults_of_source(source):
    for number, line in enumerate(source.read_text().splitlines(), 1):
        for page in PAGE_IN_SOURCE.findall(line):
            if not (ROOT / page).exists():
                yield f"{source.relative_to(ROOT)}:{number}: {page}: no such page"


def main():
    pages = sorted(path for path in FILES if path.suffix == ".md")
    faults = [fault for page in pages for fault in faults_of_page(page)]
    if "--sources" in sys.argv[1:]:
        own = pathlib.Path(__file__).resolve()
        sources = sorted(path for path in FILES if path.suffix in SOURCE_SUFFIXES and path != own)
        faults += [fault for source in sources for fault in faults_of_source(source)]
    print("\n".join(faults) or f"links: {len(pages)} pages, nothing points nowhere")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
