#!/usr/bin/python3
"""Lists what the library's headers offer without a docstring: types, public functions and public fields.

A docstring is a `///` comment before the declaration or a `///<` comment behind it. What needs none: overrides (the
interface speaks), constructors without arguments, copies and moves, destructors, defaulted and deleted members,
operators, aliases, specialisations, forward declarations, enumerators, and names in a namespace `detail`. With FILE...
only those headers are read. Prints one line a name and exits 1 where there is one.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ["core", "csht", "tracking", "fusion", "sonar_sim", "lcmtypes", "python"]
NEEDS_NONE = re.compile(
    r"\boverride\b|=\s*(default|delete)$|\boperator\b|^(using|typedef|friend|static_assert|extern)\b|^template ?<>|~\w+\s*\("
    r"|\b(\w+)\s*\((const )?\3 ?&&?( \w+)?\)"
)
FORWARD = re.compile(r"^(template ?<.*> ?)?(class|struct|enum class) [\w:]+$")
TYPE = re.compile(r"^(?:template ?<.*?> ?)?(class|struct|enum class|enum|union) (\w+)")
COMMENT_OR_LITERAL = re.compile(
    r'R"(?P<mark>\w*)\(.*?\)(?P=mark)"|"(\\.|[^"\\])*"|(?<!\w)\'(\\.|[^\'\\])*\'|//[^\n]*|/\*.*?\*/', re.DOTALL
)
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.MULTILINE)
ACCESS = re.compile(r"\s*(public|private|protected)\s*")
WHOLE, BODY, TYPE_SCOPE = "namespace", "body", "type"


def blank(match):
    text = match.group()
    return re.sub(r"[^\n]", "0" if text[0] in "R\"'" else " ", text)


def code_of(text):
    """The text without comments, directives and literals, each character in its place."""
    return DIRECTIVE.sub(blank, COMMENT_OR_LITERAL.sub(blank, text))


def without_templates(text):
    while (shorter := re.sub(r"<[^<>]*>", "", text)) != text:
        text = shorter
    return text


def function_name(statement):
    """The name of the function that a statement declares; None for a field."""
    match = re.search(r"(\w+)\s*\(", without_templates(statement).split("=")[0])
    return match.group(1) if match else None


def field_name(statement):
    return re.findall(r"\w+", re.sub(r"\[[^\]]*\]", "", without_templates(statement).split("=")[0]))[-1]


class Scope:
    """An open brace; what a public one holds is offered to others."""

    def __init__(self, kind, name, public, statement="", first=None):
        self.kind, self.name, self.public = kind, name, public
        self.statement, self.first = statement, first


class Header:
    """Walks through a header's declarations; `found` holds (line, name) of those without a docstring."""

    def __init__(self, text):
        self.lines, self.scopes, self.found = text.splitlines(), [], []
        self.line, self.depth = 0, 0
        self.restart()
        for character in code_of(text):
            self.take(character)

    def restart(self, statement="", first=None):
        self.statement, self.first = statement, first

    def take(self, character):
        self.line += character == "\n"
        self.depth += (character in "([") - (character in ")]")
        act = {"{": self.open, "}": self.close, ";": self.end, ":": self.colon}.get(character)
        if self.depth > 0 or act is None or not act():
            self.append(character)

    def append(self, character):
        if self.first is None and not character.isspace():
            self.first = self.line
        self.statement += character

    def open(self):
        head = " ".join(self.statement.split())
        kind = TYPE.match(head)
        if head.startswith(("namespace", "inline namespace", "extern")):
            self.enter(Scope(WHOLE, "", "detail" not in head))
        elif kind and function_name(head.split(":")[0]) is None:
            self.judge(head)
            self.enter(Scope(TYPE_SCOPE, kind.group(2), kind.group(1) in ("struct", "union")))
        else:
            self.enter(Scope(BODY, "", False, self.statement, self.first))
        return True

    def enter(self, scope):
        self.scopes.append(scope)
        self.restart()

    def close(self):
        scope = self.scopes.pop()
        self.restart()
        if scope.kind == BODY:
            self.restart(scope.statement, scope.first)
            if function_name(scope.statement) and not self.in_initialisers(scope.statement):
                self.judge(scope.statement)
                self.restart()
        return True

    @staticmethod
    def in_initialisers(statement):
        """Whether the brace belonged to a member of a constructor's list, so that its body is still to come."""
        return re.search(r"\)\s*:[^:].*\w+_?\s*$|\)\s*:\s*\w+_?\s*$", statement, re.DOTALL) and statement.rstrip()[-1] != ")"

    def end(self):
        if not FORWARD.match(" ".join(self.statement.split())):
            self.judge(self.statement)
        self.restart()
        return True

    def colon(self):
        access = ACCESS.fullmatch(self.statement)
        if access:
            self.scopes[-1].public = access.group(1) == "public"
            self.restart()
        return access is not None

    def judge(self, statement):
        statement = re.sub(r"^(\[\[\w+\]\] ?)+", "", " ".join(statement.split()))
        if not statement or not all(scope.public for scope in self.scopes) or NEEDS_NONE.search(statement):
            return
        kind, function = TYPE.match(statement), function_name(statement)
        own_type = self.scopes[-1].name if self.scopes else None
        if not kind and function and function == own_type and re.search(r"\(\s*\)", statement):
            return
        if not self.documented():
            self.found.append((self.first + 1, kind.group(2) if kind else function or field_name(statement)))

    def documented(self):
        before = self.lines[self.first - 1].strip() if self.first > 0 else ""
        return before.startswith("///") or any("///<" in line for line in self.lines[self.first : self.line + 1])


def headers(arguments):
    """The headers to read and their names below the root."""
    paths = [pathlib.Path(name).resolve() for name in arguments]
    paths = paths or sorted(path for folder in FOLDERS for path in (ROOT / folder).rglob("*.hpp"))
    for path in paths:
        name = str(path.relative_to(ROOT))
        if path.suffix == ".hpp" and name.split("/")[0] in FOLDERS:
            yield path, name


def main():
    found = [
        f"{name}:{line}: {what} has no docstring"
        for path, name in headers(sys.argv[1:])
        for line, what in Header(path.read_text()).found
    ]
    print("\n".join(found) or "docstrings: none is missing")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
