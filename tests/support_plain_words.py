"""What users read: pages, comments of files that they get, and texts in the code but docstrings."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from tests.places import ROOT

PROSE = (
    *("README.md", "CHANGELOG.md", ".github/**/*.md", ".github/**/*.yml"),
    *("examples/**/*.md", "examples/**/*.toml", "scenes/**/*.toml"),
    *("vrts/pages/*.md", "vrts/manual/**/*.md", "vrts/schemas/*.json"),
)
SHOWN_BY_BROWSERS = ("vrts/web/**/*.js", "vrts/web/**/*.html")
CALLS_OF_CLICK = ("command", "group")  # whose docstrings are help texts


class Read(NamedTuple):
    """A piece of text that users read."""

    place: str
    text: str


def texts(likely: re.Pattern[str]) -> Iterator[Read]:
    """Return what users read of every file in which a pattern occurs at all."""
    for path in _files(*PROSE):
        whole = path.read_text("utf-8")
        if likely.search(whole):
            name = path.relative_to(ROOT)
            yield from (Read(f"{name}:{n}", t) for n, t in enumerate(whole.splitlines(), 1))
    for path in _files("vrts/**/*.py"):
        whole = path.read_text("utf-8")
        if likely.search(whole):
            yield from in_code(whole, str(path.relative_to(ROOT)))
    for path in _files(*SHOWN_BY_BROWSERS):
        whole = path.read_text("utf-8")
        if "vendor" not in path.parts and likely.search(whole):
            name = path.relative_to(ROOT)
            for n, line in enumerate(whole.splitlines(), 1):
                if not line.strip().startswith(("//", "*", "/*")):
                    yield Read(f"{name}:{n}", line.split(" // ")[0])


def in_code(code: str, name: str) -> Iterator[Read]:
    """Return the texts of a module: its strings but docstrings, and help texts of commands."""
    tree = ast.parse(code)
    silent: set[int] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
            first = node.body[0] if node.body else None
            if isinstance(first, ast.Expr) and not _is_help(node):
                silent.add(id(first.value))
    for node in ast.walk(tree):
        if not isinstance(node, ast.Constant) or id(node) in silent:
            continue
        if isinstance(node.value, str) and " " in node.value:
            yield Read(f"{name}:{node.lineno}", node.value)


def _is_help(node: ast.AST) -> bool:
    """Return whether click shows the docstring of a function."""
    decorators = node.decorator_list if isinstance(node, ast.FunctionDef) else []
    called = (d.func if isinstance(d, ast.Call) else d for d in decorators)
    return any(isinstance(c, ast.Attribute) and c.attr in CALLS_OF_CLICK for c in called)


def _files(*patterns: str) -> Iterator[Path]:
    for pattern in patterns:
        yield from sorted(path for path in ROOT.glob(pattern) if path.is_file())
