#!/usr/bin/python3
"""The package: its stub names what there is and with the same arguments, everything says what it is, the example runs."""
import ast
import csv
import inspect
import pathlib
import subprocess
import sys
import unittest

import lookout
import numpy as np
from support import PROGRAM, SOURCE, Case

FOLDER = pathlib.Path(lookout.__file__).parent
MESSAGE = "_t"  # How the names of the messages' types end; lcm-gen wrote them.
WORDS = {"__init__", "__len__", "__iter__", "__next__"}  # Of the names with underscores, those that are a stub's business.


def stub():
    """{name: node} of all that the stub declares or takes from a module."""
    names = {}
    for node in ast.parse((FOLDER / "__init__.pyi").read_text()).body:
        if isinstance(node, ast.ImportFrom) and node.level:
            names.update({alias.asname: node for alias in node.names})
        elif isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            names[node.name] = node
        elif isinstance(node, ast.AnnAssign) and not (node.target.id[0] == "_" and node.target.id[1] != "_"):
            names[node.target.id] = node
    return names


def members(node):
    """{name: node} of a class in the stub."""
    return {part.target.id if isinstance(part, ast.AnnAssign) else part.name: part for part in node.body}


def arguments(function):
    """(name, default as text or None) of each argument."""
    names = [argument.arg for argument in function.args.args if argument.arg != "self"]
    defaults = [ast.unparse(default) for default in function.args.defaults]
    return list(zip(names, [None] * (len(names) - len(defaults)) + defaults))


def signature(function):
    """The same as the running module has it: the first line of its docstring."""
    head = function.__doc__.splitlines()[0].replace("<", "'").replace(">", "'").replace("-'", "->")
    return arguments(ast.parse(f"def {head}: ...").body[0])


def own_names():
    return [name for name in lookout.__all__ if not name.endswith(MESSAGE) and name != "__version__"]


def own_classes():
    return {name: getattr(lookout, name) for name in own_names() if inspect.isclass(getattr(lookout, name))}


class StubTest(Case):
    def test_names_are_those_of_the_package(self):
        self.assertEqual(set(stub()), set(lookout.__all__))
        self.assertTrue((FOLDER / "py.typed").exists())

    def test_members_are_those_of_the_classes(self):
        for name, kind in own_classes().items():
            there = {member for member in vars(kind) if member[0] != "_" or member in WORDS}
            declared = set(members(stub()[name]))
            if "__init__" not in declared:
                there.discard("__init__")  # pybind11's own, of a class that is not made in Python.
                with self.assertRaises(TypeError, msg=name):
                    kind()
            self.assertEqual(declared, there, name)

    def test_arguments_and_defaults_are_those_of_the_functions(self):
        checked = 0
        for name in own_names():
            node, thing = stub()[name], getattr(lookout, name)
            functions = members(node) if isinstance(node, ast.ClassDef) else {"": node}
            for member, function in functions.items():
                is_function = isinstance(function, ast.FunctionDef) and not function.decorator_list
                if is_function and not member.startswith("__") or member == "__init__":
                    runtime = getattr(thing, member) if member else thing
                    self.assertEqual(arguments(function), signature(runtime), f"{name}.{member}")
                    checked += 1
        self.assertGreater(checked, 25)

    def test_properties_that_can_be_set_are_attributes(self):
        for name, kind in own_classes().items():
            for member, node in members(stub()[name]).items():
                descriptor = vars(kind)[member]
                if isinstance(descriptor, property):
                    self.assertEqual(isinstance(node, ast.AnnAssign), descriptor.fset is not None, f"{name}.{member}")


class DocstringTest(Case):
    def test_everything_says_what_it_is(self):
        self.assertIn("docs/python.md", lookout.__doc__)
        for name in own_names():
            thing = getattr(lookout, name)
            if isinstance(thing, np.dtype):
                continue
            self.assertTrue(self.text_of(thing), name)
            for member, part in vars(thing).items() if inspect.isclass(thing) else ():
                if not member.startswith("_"):
                    self.assertTrue(self.text_of(part), f"{name}.{member}")

    @staticmethod
    def text_of(thing):
        """A docstring without the signature that pybind11 sets before it."""
        text = inspect.getdoc(thing) or ""
        return text.partition("\n")[2].strip() if callable(thing) and not inspect.isclass(thing) else text.strip()

    def test_arrays_say_their_shape_and_what_is_measured_its_unit(self):
        for name in ("Scan.bearings", "Scan.ranges", "Image.ranges", "Recording.times", "TrackedRun.times"):
            kind, member = name.split(".")
            self.assertRegex(vars(getattr(lookout, kind))[member].__doc__, r"\(\w+,\) \[(m|rad|us)\]")
        for function in (lookout.ospa, lookout.score, lookout.Scan):
            self.assertRegex(function.__doc__, r"\(\w+,( 2)?\)")
            self.assertRegex(function.__doc__, r"\[(m|rad|us)\]")


class PackageTest(Case):
    def test_is_of_the_programs_release(self):
        said = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, check=True).stdout
        self.assertIn(lookout.__version__, said)

    def test_holds_the_messages_types_too(self):
        self.assertEqual(lookout.track_t.decode(lookout.track_t().encode()).id, 0)

    def test_the_messages_need_neither_numpy_nor_the_compiled_module(self):
        code = "import sys, lookout; lookout.track_t(); print([name in sys.modules for name in ('numpy', 'lookout._lookout')])"
        said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
        self.assertEqual(said.strip(), "[False, False]")
        with self.assertRaisesRegex(AttributeError, "nobody"):
            lookout.nobody

    def test_the_example_draws_the_curves(self):
        words = [sys.executable, SOURCE / "examples/figure22.py", "--duration", "6", "--runs", "2", "--out", self.folder]
        subprocess.run(words, check=True, capture_output=True)
        with open(self.folder / "figure22.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 12)  # 6 s, two scans a second.
        for row in rows:  # Of one run total^2 = localisation^2 + cardinality^2; of means no more than the bound.
            for method in ("csht", "kalman"):
                self.assertLessEqual(float(row[f"{method}_localization"]), float(row[f"{method}_total"]) + 1e-5)
                self.assertLessEqual(float(row[f"{method}_total"]), 20.0)
        self.assertGreater((self.folder / "figure22.png").stat().st_size, 1000)


if __name__ == "__main__":
    unittest.main()
