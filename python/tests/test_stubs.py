"""The type stubs describe the compiled module, and everything in it says what it is."""

import ast
import inspect
import re
import unittest

import aisle
from aisle import _aisle
from support import SOURCE

STUBS = ast.parse((SOURCE / "python" / "aisle" / "_aisle.pyi").read_text())


def public_names(members):
    return {name for name in members if not name.startswith("_") or name in ("__len__", "__getitem__", "__next__")}


def parameters(function):
    arguments = function.args
    return [argument.arg for argument in arguments.args + arguments.kwonlyargs]


def documented_parameters(docstring):
    """Of the signature in the first line: "drive(navigator: object, world: str = '', *, ...) -> ...". """
    inside = docstring.splitlines()[0].partition("(")[2].rpartition(") ->")[0]
    return re.findall(r"(?:^|, )(\w+):", inside)


class Stubs(unittest.TestCase):
    def setUp(self):
        self.classes = {node.name: node for node in STUBS.body if isinstance(node, ast.ClassDef)}
        self.functions = {node.name: node for node in STUBS.body if isinstance(node, ast.FunctionDef)}

    def test_name_what_is_there(self):
        members = {name: value for name, value in vars(_aisle).items() if not name.startswith("_")}
        self.assertEqual({name for name, value in members.items() if inspect.isclass(value)}, set(self.classes))
        self.assertEqual({name for name, value in members.items() if callable(value)},
                         set(self.classes) | set(self.functions))

    def test_name_every_member(self):
        for name, stub in self.classes.items():
            stubbed = {node.name for node in stub.body if isinstance(node, ast.FunctionDef)}
            self.assertEqual(public_names(vars(getattr(_aisle, name))), public_names(stubbed), name)

    def test_name_every_parameter(self):
        for name, stub in self.functions.items():
            self.assertEqual(documented_parameters(getattr(_aisle, name).__doc__), parameters(stub), name)
        for name, stub in self.classes.items():
            for node in stub.body:
                is_property = any(ast.unparse(mark) == "property" for mark in node.decorator_list)
                if node.name in public_names([node.name]) | {"__init__"} and not is_property:
                    documentation = getattr(getattr(_aisle, name), node.name).__doc__
                    self.assertEqual(documented_parameters(documentation)[-len(parameters(node)) + 1 :] if
                                     len(parameters(node)) > 1 else [], parameters(node)[1:], f"{name}.{node.name}")


class Package(unittest.TestCase):
    def test_offers_what_is_compiled(self):
        compiled = {name for name in vars(_aisle) if not name.startswith("_")}
        self.assertTrue(compiled <= set(aisle.__all__))
        self.assertEqual(aisle.__version__, (SOURCE / "VERSION").read_text().strip())

    def test_says_what_everything_is(self):
        for name in aisle.__all__:
            if callable(getattr(aisle, name)):
                self.assertTrue(getattr(aisle, name).__doc__, name)

    def test_finds_what_is_shipped(self):
        self.assertIn("l-corridor", aisle.shipped("worlds"))
        self.assertIn("alv-scanner", aisle.shipped("vehicles"))


if __name__ == "__main__":
    unittest.main()
