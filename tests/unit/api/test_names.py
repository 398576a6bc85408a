"""The names of `import vrts`: a dozen, loaded when they are used, callable though folders exist."""

import ast
import doctest
import inspect
import subprocess
import sys
from importlib import import_module
from typing import Any

import pytest

import vrts
from tests.places import ROOT

INSIDE: Any = vrts  # beyond what type checkers are told
HOMES = sorted({f"vrts.api.{path.stem}" for path in (ROOT / "vrts" / "api").glob("*.py")})


def _printed(program: str) -> str:
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True, cwd=ROOT
    )
    return done.stdout.strip()


def test_there_are_a_dozen() -> None:
    assert sorted(vrts.__all__) == [
        *("Assessment", "Run", "VrtsError", "certificate", "compile", "mark", "prove", "run"),
        *("scene", "task", "verify", "why"),
    ]
    assert set(vrts.__all__) <= set(dir(vrts))
    for name in vrts.__all__:
        assert callable(getattr(vrts, name)), name


def test_type_checkers_are_told_the_same() -> None:
    stub = ast.parse((ROOT / "vrts" / "__init__.pyi").read_text("utf-8"))
    told = {
        alias.name: node.module
        for node in stub.body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }
    assert told == INSIDE._HOMES


def test_importing_vrts_loads_nothing_of_it() -> None:
    loaded = "import sys, vrts; print([m for m in sys.modules if m.startswith('vrts.')]"
    assert _printed(f"{loaded}, 'numpy' in sys.modules, 'inspect' in sys.modules)") == (
        "[] False False"
    )


def test_compiling_loads_no_heavy_library() -> None:
    program = (
        "import sys, vrts; vrts.compile('.PROGRAM a()\\n.END\\n'); print('numpy' in sys.modules)"
    )
    assert _printed(program) == "False"


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["scene", "why", "prove"])
def test_a_folder_with_the_name_of_a_function_is_both(name: str) -> None:
    deep = {"scene": "model", "why": "chain", "prove": "proof"}[name]
    first = f"import vrts, inspect; f = vrts.{name}; import vrts.{name}.{deep} as m"
    then = f"import vrts.{name}.{deep} as m, vrts, inspect; f = vrts.{name}"
    for order in (first, then):
        said = _printed(
            f"{order}; print(m.__name__, callable(f), len(inspect.signature(f).parameters))"
        )
        where, is_callable, count = said.split()
        assert (where, is_callable) == (f"vrts.{name}.{deep}", "True")
        assert int(count) >= 3


def test_what_is_not_there_is_said_as_usual() -> None:
    with pytest.raises(AttributeError, match="module 'vrts' has no attribute 'simulate'"):
        getattr(vrts, "simulate")  # noqa: B009 -- pyright knows it is not there


@pytest.mark.parametrize("name", HOMES)
def test_examples_in_the_documentation_are_right(name: str) -> None:
    failed, _ = doctest.testmod(import_module(name))
    assert failed == 0


def test_every_function_has_an_example_and_says_what_goes_wrong() -> None:
    for name in vrts.__all__:
        thing: Any = INSIDE._public(name)
        said = inspect.getdoc(thing) or ""
        if inspect.isfunction(thing):
            assert ">>>" in said, name
            assert "VrtsError" in said, name
            assert thing.__annotations__["return"], name
        for member, value in vars(thing).items() if inspect.isclass(thing) else ():
            if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                assert inspect.getdoc(value), f"{name}.{member}"
