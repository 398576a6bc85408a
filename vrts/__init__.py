"""Compiler, simulator and verifier for VAL-II robot programs.

A dozen names, stable from version to version; units stand in names:

    import vrts

    found = vrts.verify("prog.v2", task="task.toml")
    print(found.mark, found.cause)
    found.run.joints([0.0, 1.5]).deg

`compile`, `run`, `verify`, `mark`, `why`, `prove` and `certificate` take a program, as a path or as
text; `scene` and `task` read what it runs in; `Run` and `Assessment` are what comes of it; wrong
input is a `VrtsError`. They are loaded when they are first used: `import vrts` loads nothing.
"""

# What is loaded later is there all the same.
# pyright: reportUnsupportedDunderAll=false

import sys
from importlib import import_module
from types import ModuleType
from typing import Any

__version__ = "0.1.0"

__all__ = [
    "Assessment",
    "Run",
    "VrtsError",
    "certificate",
    "compile",
    "mark",
    "prove",
    "run",
    "scene",
    "task",
    "verify",
    "why",
]

_HOMES = {  # where each name is defined; `__init__.pyi` tells type checkers the same
    "Assessment": "vrts.api.assessments",
    "Run": "vrts.api.runs",
    "VrtsError": "vrts.api.errors",
    "certificate": "vrts.api.certificates",
    "compile": "vrts.api.programs",
    "mark": "vrts.api.verifying",
    "prove": "vrts.api.proofs",
    "run": "vrts.api.runs",
    "scene": "vrts.api.scenes",
    "task": "vrts.api.scenes",
    "verify": "vrts.api.verifying",
    "why": "vrts.api.causes",
}
_ROOMS = ("prove", "scene", "why")  # names that are folders of vrts, too


def _public(name: str) -> Any:
    return getattr(import_module(_HOMES[name]), name)


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'vrts' has no attribute '{name}'")
    found = _public(name)
    if name in _ROOMS:  # loading it has loaded the folder: that is called
        return import_module(f"vrts.{name}")
    globals()[name] = found
    return found


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})


class _Room(ModuleType):
    """A folder of vrts that is called like a public function, and may be called as one."""

    def __call__(self, *args: Any, **given: Any) -> Any:
        return self._function(*args, **given)

    @property
    def _function(self) -> Any:
        return _public(self.__name__.rpartition(".")[2])

    @property
    def __signature__(self) -> Any:
        return import_module("inspect").signature(self._function)


class _Package(ModuleType):
    """Makes the rooms callable when they are loaded."""

    def __setattr__(self, name: str, value: object) -> None:
        if name in _ROOMS and isinstance(value, ModuleType):
            value.__class__ = _Room
        super().__setattr__(name, value)


sys.modules[__name__].__class__ = _Package
