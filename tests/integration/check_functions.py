#!/usr/bin/python3
"""Measures the functions of the tree and holds them to the limits below: their lines, from the first of the head to the
closing brace, and their parameters.

C++ is read by its braces, Python by its own parser; a lambda counts as lines of the function that it stands in, and so
does a nested function. Tests count for the longest function alone: their length is that of their scene. With PATH...
only those files or folders are measured. Prints the median and the share, one line for each function beyond a limit,
and exits 1 where there is one.
"""
import ast
import pathlib
import re
import statistics
import sys

from check_docstrings import TYPE, code_of, function_name, without_templates

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ["core", "csht", "examples", "fusion", "lcmtypes", "python", "sonar_sim", "tests", "tools", "tracking"]
MOST_LINES, MOST_PARAMETERS = 40, 6
MEDIAN_LINES = 7
NINE_IN_TEN_LINES, NINE_IN_TEN = 18, 0.9
# Words in place of the signs that an operator's name holds.
OPERATOR = re.compile(r"\boperator\s*(\(\)|(new|delete)?\s*\[\]|[^\s\w(]+)")
ACCESS = re.compile(r"\s*(public|private|protected)\s*")
# What opens a brace in a function, or a value's: no function of its own.
NO_FUNCTION = re.compile(r"^(if|for|while|switch|do|else|try|catch|return)\b|=\s*$|^[^()]*=\s*\[|^\s*$")
IN_INITIALISERS = re.compile(r"\)\s*:(?!:).*[\w>]\s*$", re.DOTALL)  # Name(...) : member_{, the body still to come


class Function:
    """One function: where it stands, its name, its lines and its parameters."""

    def __init__(self, where, name, lines, parameters):
        self.where, self.name, self.lines, self.parameters = where, name, lines, parameters


def closing(text, opening):
    """The place of the bracket that closes the one at `opening`."""
    depth = 0
    for place in range(opening, len(text)):
        depth += (text[place] in "({[") - (text[place] in ")}]")
        if depth == 0:
            return place
    return len(text)


def parameter_count(head):
    """How many parameters the head of a C++ function names."""
    head = without_templates(head)
    opening = head.find("(")
    inside = head[opening + 1 : closing(head, opening)]
    while (flat := re.sub(r"\([^()]*\)|\{[^{}]*\}|\[[^\[\]]*\]", "", inside)) != inside:
        inside = flat
    return inside.count(",") + 1 if inside.strip() not in ("", "void") else 0


class Walk:
    """Walks through the declarations of one C++ file; `found` holds its functions."""

    def __init__(self, name, text):
        self.name, self.text, self.found = name, code_of(text), []
        self.place = self.head_from = 0
        while self.place < len(self.text):
            self.take(self.text[self.place])
            self.place += 1

    def take(self, character):
        if character in "([":
            self.place = closing(self.text, self.place)
        elif character == "{":
            self.open()
        elif character in ";}" or (character == ":" and ACCESS.fullmatch(self.text[self.head_from : self.place])):
            self.judge_declaration(character)
            self.head_from = self.place + 1

    def head(self):
        """What stands since the last declaration, in one line."""
        head = re.sub(r"\[\[\w+\]\]", "", self.text[self.head_from : self.place])
        return " ".join(OPERATOR.sub("operator_", head).split())

    def open(self):
        head = self.head()
        if head.startswith(("namespace", "inline namespace")) or head == "extern 000" or self.is_type(head):
            self.head_from = self.place + 1
        elif NO_FUNCTION.search(head) or function_name(head) is None or IN_INITIALISERS.search(head):
            self.place = closing(self.text, self.place)
        else:
            self.body(head)

    @staticmethod
    def is_type(head):
        return TYPE.match(head) is not None and function_name(head.split(":")[0]) is None

    def body(self, head):
        end = closing(self.text, self.place)
        first = self.line(re.compile(r"\S").search(self.text, self.head_from).start())
        self.add(first, head, self.line(end) - first + 1)
        self.place, self.head_from = end, end + 1

    def judge_declaration(self, character):
        head = self.head()
        if character == ";" and re.match(r"^[^=]*\w\s*\(.*\)[^=()]*(= 0)?$", head) and function_name(head):
            self.add(self.line(self.place), head, 0)

    def add(self, first, head, lines):
        self.found.append(Function(f"{self.name}:{first}", function_name(head), lines, parameter_count(head)))

    def line(self, place):
        return self.text.count("\n", 0, place) + 1


def python_functions(name, text):
    """The functions of a Python file; one within another counts as its lines."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.FunctionDef):
            names = [argument.arg for argument in node.args.posonlyargs + node.args.args + node.args.kwonlyargs]
            counted = len([argument for argument in names if argument != "self"])
            yield Function(f"{name}:{node.lineno}", node.name, node.end_lineno - node.lineno + 1, counted)


def is_python(path):
    return path.suffix == ".py" or (path.suffix == "" and path.read_bytes().startswith(b"#!/usr/bin/python3"))


def chosen(arguments):
    """The files to measure and their names below the root."""
    for start in [pathlib.Path(name).resolve() for name in arguments] or [ROOT / folder for folder in FOLDERS]:
        for path in sorted(start.rglob("*")) if start.is_dir() else [start]:
            if path.is_file() and "__pycache__" not in path.parts:
                yield path, str(path.relative_to(ROOT))


def functions(arguments):
    """All functions of the chosen files."""
    for path, name in chosen(arguments):
        if path.suffix in (".cpp", ".hpp"):
            yield from Walk(name, path.read_text()).found
        elif is_python(path):
            yield from python_functions(name, path.read_text())


def too_much(function):
    """What is wrong with one function, in words."""
    if function.lines > MOST_LINES:
        yield f"{function.where}: {function.name} has {function.lines} lines, at most {MOST_LINES}"
    if function.parameters > MOST_PARAMETERS:
        yield f"{function.where}: {function.name} has {function.parameters} parameters, at most {MOST_PARAMETERS}"


def distribution_breaches(lengths):
    """Says how long the functions are, and yields what is wrong with them together."""
    median = statistics.median(lengths)
    share = sum(lines <= NINE_IN_TEN_LINES for lines in lengths) / len(lengths)
    print(f"functions: {len(lengths)}, median {median:g} lines, {share:.3f} with at most {NINE_IN_TEN_LINES}")
    if median > MEDIAN_LINES:
        yield f"the median is {median:g} lines, at most {MEDIAN_LINES}"
    if share < NINE_IN_TEN:
        yield f"a share of {share:.3f} has at most {NINE_IN_TEN_LINES} lines, at least {NINE_IN_TEN}"


def main():
    every = list(functions(sys.argv[1:]))
    lengths = [function.lines for function in every if function.lines and not function.where.startswith("tests/")]
    found = [breach for function in every for breach in too_much(function)]
    found += distribution_breaches(lengths) if lengths else []
    print("\n".join(found) or "functions: none beyond a limit")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
