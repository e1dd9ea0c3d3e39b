#!/usr/bin/python3
"""Writes C++ that lists the fields of parameter structs: name, range and docstring, as their headers state them.

Usage: parameter_fields.py SOURCE_DIR OUTPUT HEADER:STRUCT... [-- SKIPPED_FIELD...]

For each STRUCT, and each struct in the same headers that it holds, OUTPUT gets a function
`list_fields(core::ParameterList&, const std::string& prefix, STRUCT&)` in the struct's namespace. Fields of a type that
is neither a number, a flag nor a struct of these headers are left out, and so are those named as STRUCT.FIELD behind --.
"""
import pathlib
import re
import sys

NUMBERS = {"double", "int", "bool", "std::optional<int>"}
NUMBER = r"(-?\d+(?:\.\d+)?)"
STRUCT = re.compile(r"^struct (\w+)(?: : ([\w:]+))? \{\n(.*?)^\};", re.MULTILINE | re.DOTALL)
# A type, then names with their defaults, then the semicolon.
FIELD = re.compile(r"^(std::optional<int>|[\w:]+) (\w+[^;()]*);$", re.DOTALL)
NAME = re.compile(r"(\w+)\s*(?:=[^,{]*(?:\{[^}]*\})?|\{[^}]*\})?(?:,|$)")


class Struct:
    def __init__(self, name, base, namespace, header, fields):
        self.name, self.base, self.namespace, self.header, self.fields = name, base, namespace, header, fields


def statements(body):
    """(statement, comment) of each member, the comment before it or behind it joined."""
    before, code, behind = [], "", []
    for line in body.splitlines():
        text, _, comment = line.strip().partition("//")
        is_behind, comment = comment.startswith("/<"), comment.lstrip("/<").strip()
        if text.strip():
            if code.endswith(";"):
                yield code, " ".join(before if not behind else before + behind)
                before, code, behind = [], "", []
            if before and code == "" and behind == [] and not is_behind and comment:
                before.append(comment)
            code = f"{code} {text.strip()}".strip()
            if is_behind:
                behind.append(comment)
        elif code.endswith(";") and (not comment or line.strip().startswith("/// ")):
            yield code, " ".join(before + behind)
            before, code, behind = ([comment] if comment else []), "", []
        elif comment:
            (behind if code else before).append(comment)
    if code:
        yield code, " ".join(before + behind)


def fields_of(body):
    for code, comment in statements(body):
        match = FIELD.match(code)
        if not match or code.startswith(("static", "using", "friend")):
            continue
        for name in NAME.findall(match[2]):
            yield match[1], name, comment


def with_beginnings(fields):
    """A comment that goes on from the one before is joined to it."""
    before = ""
    for kind, name, comment in fields:
        goes_on = before and (comment[:1].islower() or comment.startswith(("[", "Likewise", "So is")))
        before = f"{before} {comment}" if goes_on else comment
        yield kind, name, before, comment


def read_structs(source, headers):
    structs = {}
    for header in headers:
        text = (source / header).read_text()
        namespace = re.search(r"^namespace ([\w:]+) \{", text, re.MULTILINE)[1]
        for name, base, body in STRUCT.findall(text):
            structs[name] = Struct(name, base.split("::")[-1], namespace, header, list(with_beginnings(fields_of(body))))
    return structs


def range_of(comment):
    """(low, high, open_low, open_high) as C++; what the comment does not say in numbers is infinite."""
    low, high, open_low, open_high = "-kInfinity", "kInfinity", False, False
    between = re.search(r"(?:in |, |^)([\[(])" + NUMBER + r", " + NUMBER + r"([\])])", comment)
    to = re.search(NUMBER + r" to " + NUMBER + r"(?:\.|$)", comment)
    if between:
        return between[2], between[3], between[1] == "(", between[4] == ")"
    if to:
        return to[1], to[2], False, False
    for sign, value in re.findall(r"(>=|>|<=|<) " + NUMBER + r"(?![\w/])", comment)[:1]:
        if sign[0] == ">":
            low, open_low = value, sign == ">"
        else:
            high, open_high = value, sign == "<"
    return low, high, open_low, open_high


def literal(text):
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def function_of(struct, structs, skipped):
    lines = [f"inline void list_fields(core::ParameterList& list, const std::string& prefix, {struct.name}& p) {{"]
    if struct.base:
        lines.append(f"  list_fields(list, prefix, static_cast<{qualified(structs[struct.base])}&>(p));")
    for kind, name, comment, own in struct.fields:
        if f"{struct.name}.{name}" in skipped:
            continue
        if kind in NUMBERS:
            low, high, open_low, open_high = range_of(own) if range_of(own) != range_of("") else range_of(comment)
            accepted = f"{{{low}, {high}, {str(open_low).lower()}, {str(open_high).lower()}}}"
            lines.append(f"  list.add(prefix + {literal(name)}, p.{name}, {accepted},\n           {literal(comment)});")
        elif kind.split("::")[-1] in structs:
            lines.append(f"  list_fields(list, prefix + {literal(name + '.')}, p.{name});")
    return "\n".join(lines + ["}"])


def qualified(struct):
    return f"{struct.namespace}::{struct.name}"


def in_order(name, structs, done):
    """Structs that a struct needs, itself the last."""
    if name in done or name not in structs:
        return
    struct = structs[name]
    for need in [struct.base, *(kind.split("::")[-1] for kind, *_ in struct.fields)]:
        yield from in_order(need, structs, done)
    if name not in done:
        done.add(name)
        yield struct


def main():
    words = sys.argv[1:]
    skipped = set(words[words.index("--") + 1:]) if "--" in words else set()
    source, output, *wanted = words[:words.index("--")] if "--" in words else words
    headers = list(dict.fromkeys(item.split(":")[0] for item in wanted))
    structs = read_structs(pathlib.Path(source), headers)
    text = ["// Made by cmake/parameter_fields.py of the headers below.", "#pragma once", "#include <limits>", "#include <string>",
            '#include "core/files/parameter_list.hpp"', *(f'#include "{header}"' for header in headers)]
    done = set()
    for item in wanted:
        if item.split(":")[1] not in structs:
            sys.exit(f"parameter_fields: {item}: no such struct there")
        for struct in in_order(item.split(":")[1], structs, done):
            text += [f"namespace {struct.namespace} {{", function_of(struct, structs, skipped),
                     f"}}  // namespace {struct.namespace}"]
    body = "\n".join(text) + "\n"
    pathlib.Path(output).write_text(body.replace("kInfinity", "std::numeric_limits<double>::infinity()"))


if __name__ == "__main__":
    main()
