"""What imports what in the package, found in its source: for tests of how it is built.

Imports within functions and under `TYPE_CHECKING` count like any other.
"""

import ast
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import NamedTuple

from tests.places import ROOT

STUBS = "stubs"  # of third-party libraries: nothing imports them


class Import(NamedTuple):
    """One import statement's claim on one module."""

    target: str  # dotted name of the module, or of a library's
    line: int  # counted from 1
    deferred: bool  # within a function


@cache
def modules(root: Path = ROOT, package: str = "vrts") -> Mapping[str, Path]:
    """Return every module of a package by its dotted name; a folder goes by its own name."""
    found: dict[str, Path] = {}
    for path in sorted((root / package).rglob("*.py")):
        parts = path.relative_to(root).with_suffix("").parts
        if STUBS not in parts:
            found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


def imports(path: Path, known: Mapping[str, Path]) -> list[Import]:
    """Return the imports of a file; `known` tells modules from names within modules."""
    return list(_imports(ast.parse(path.read_text("utf-8")), known, deferred=False))


def _imports(node: ast.AST, known: Mapping[str, Path], *, deferred: bool) -> Iterator[Import]:
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.Import):
            for alias in child.names:
                yield Import(alias.name, child.lineno, deferred)
        elif isinstance(child, ast.ImportFrom) and child.module is not None:
            for alias in child.names:
                inner = f"{child.module}.{alias.name}"
                yield Import(inner if inner in known else child.module, child.lineno, deferred)
        function = isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda)
        yield from _imports(child, known, deferred=deferred or function)


@cache
def graph() -> Mapping[str, frozenset[str]]:
    """Return which modules of vrts each module of vrts imports."""
    known = modules()
    return {
        name: frozenset(i.target for i in imports(path, known) if i.target in known) - {name}
        for name, path in known.items()
    }


def siblings(edges: Mapping[str, frozenset[str]], folder: str) -> dict[str, frozenset[str]]:
    """Return which modules and folders in a folder import which beside them."""
    found: dict[str, set[str]] = {}
    start = folder + "."
    for name, targets in edges.items():
        if name.startswith(start):
            own = name.removeprefix(start).split(".")[0]
            inside = {t.removeprefix(start).split(".")[0] for t in targets if t.startswith(start)}
            found.setdefault(own, set()).update(inside - {own})
    return {name: frozenset(targets) for name, targets in found.items()}


def circles(edges: Mapping[str, frozenset[str]]) -> list[list[str]]:
    """Return the groups of names that lead to one another, each sorted [Tarjan1972]_."""
    order: dict[str, int] = {}
    low: dict[str, int] = {}
    waiting: list[str] = []
    found: list[list[str]] = []

    def visit(name: str) -> None:
        order[name] = low[name] = len(order)
        waiting.append(name)
        for target in edges.get(name, ()):
            if target not in order:
                visit(target)
                low[name] = min(low[name], low[target])
            elif target in waiting:
                low[name] = min(low[name], order[target])
        if low[name] == order[name]:
            place = waiting.index(name)
            group = waiting[place:]
            del waiting[place:]
            if len(group) > 1:
                found.append(sorted(group))

    for name in edges:
        if name not in order:
            visit(name)
    return found
