"""Which file uses which: imports wherever they stand, names in strings, words of commands, data.

Paths are relative to the checkout, with slashes. What is found is what a reader of the text would
find; what a test does by other ways (a listing of a whole folder) is told by the folder's name.
"""

import ast
import json
import re
import subprocess
from collections import defaultdict
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import PurePosixPath
from typing import NamedTuple

from tests.places import ROOT, TESTS

KEPT = TESTS / "__pycache__" / "uses.json"  # what was read of files that are as they were
DOTTED = re.compile(r"\b(?:vrts|tests)(?:\.\w+)+")
PART = re.compile(r"[^/\s,:]+")
LONGEST = 300  # letters of a string that may name a file or a command
OF_SCRIPTS = re.compile(r"""(?:\bfrom|\bimport|\bsrc=|\bhref=)\s*\(?["']([^"']+)["']""")
COMMANDS = "vrts/cli/main.py"  # loads the commands by their names
CALLERS = {  # what a test takes to call a command
    "vrts.cli.main",
    "tests.support_commands",
    "tests.support_pty",
    "tests.golden.tutorial",
    "tests.unit.cli.test_commands",
}
COMMON = {"__init__.py", "README.md"}  # names that say nothing


class Told(NamedTuple):
    """What a module names."""

    imports: list[str]  # dotted, with the name that is taken
    dotted: list[str]  # in strings
    parts: list[str]  # of short strings: between slashes and blanks


def files() -> list[str]:
    """Return the files that Git knows, or that it could be told of."""
    command = ["git", "ls-files", "-co", "--exclude-standard"]
    said = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout
    return sorted({name for name in said.splitlines() if (ROOT / name).is_file()})


@cache
def uses() -> dict[str, frozenset[str]]:
    """Return what each file uses, itself not among it."""
    names = files()
    known = frozenset(names)
    told = _told([name for name in names if name.endswith(".py")])
    named = _by_name(names)
    found: dict[str, frozenset[str]] = {}
    for name in names:
        if name in told:
            of = frozenset(_of_python(name, told[name], known, named))
        elif name.endswith((".js", ".html", ".css")):
            of = frozenset(_of_script(name, known))
        else:
            of = frozenset[str]()
        found[name] = of - {name}
    return found


@cache
def used_by() -> dict[str, frozenset[str]]:
    """Return which files use a file."""
    found: dict[str, set[str]] = defaultdict(set)
    for name, of in uses().items():
        for other in of:
            found[other].add(name)
    return {name: frozenset(users) for name, users in found.items()}


def imports_of(text: str) -> set[str]:
    """Return the import statements of a module, each as it would be written."""
    tree = ast.parse(text)
    return {ast.unparse(n) for n in ast.walk(tree) if isinstance(n, ast.Import | ast.ImportFrom)}


def _told(names: list[str]) -> dict[str, Told]:
    """Return what modules name; only those that were changed are read."""
    kept: dict[str, list[object]] = json.loads(KEPT.read_text()) if KEPT.exists() else {}
    found: dict[str, list[object]] = {}
    for name in names:
        state = (ROOT / name).stat()
        stamp: list[object] = [state.st_mtime_ns, state.st_size]
        row = kept.get(name)
        found[name] = row if row and row[:2] == stamp else [*stamp, *_read(name)]
    if found != kept:
        KEPT.parent.mkdir(exist_ok=True)
        KEPT.write_text(json.dumps(found))
    return {name: Told(*row[2:]) for name, row in found.items()}  # pyright: ignore[reportArgumentType]


def _read(name: str) -> Told:
    imports: set[str] = set()
    dotted: set[str] = set()
    parts: set[str] = set()
    for node in ast.walk(ast.parse((ROOT / name).read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            imports |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module is not None:
            imports |= {f"{node.module}.{alias.name}" for alias in node.names}
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            dotted |= set(DOTTED.findall(node.value))
            if len(node.value) < LONGEST:
                parts |= set(PART.findall(node.value))
    ours = (one for one in imports if one.startswith(("vrts", "tests")))
    return Told(sorted(ours), sorted(dotted), sorted(parts))


def _by_name(names: list[str]) -> dict[str, set[str]]:
    """Return what is no Python, by its name and by those of the folders that hold it."""
    found: dict[str, set[str]] = defaultdict(set)
    for name in names:
        path = PurePosixPath(name)
        if path.suffix == ".py" or path.parts[0] not in ("vrts", "tests", "examples", "scenes"):
            continue
        if path.name not in COMMON:
            found[path.name].add(name)
        for part in path.parts[1:-1]:
            found[part].add(name)
        found[".".join(path.parts[:-1])].add(name)
    return found


def _of_python(
    name: str, told: Told, known: frozenset[str], named: dict[str, set[str]]
) -> Iterator[str]:
    for dotted in (*told.imports, *told.dotted):
        yield from _module(dotted, known)
    for part in (*told.dotted, *told.parts):
        yield from named.get(part, ())
    if name.startswith("tests/"):
        for folder in PurePosixPath(name).parents:
            if (settings := f"{folder}/conftest.py") in known:
                yield settings
        if name != "tests/support_commands.py":
            yield from _commands(told, known)


def _module(dotted: str, known: frozenset[str]) -> Iterator[str]:
    """Return the file of a module, or of the module that holds a name."""
    parts = dotted.split(".")
    for length in range(len(parts), max(0, len(parts) - 3), -1):
        base = "/".join(parts[:length])
        for file in (f"{base}.py", f"{base}/__init__.py"):
            if file in known:
                yield file
                return


def _commands(told: Told, known: frozenset[str]) -> Iterable[str]:
    """Return the commands that a test calls, by their names; all, where it names none."""
    taken = (*told.imports, *told.dotted)
    if not any(one == c or one.startswith(c + ".") for one in taken for c in CALLERS):
        return ()
    every = [n for n in known if re.fullmatch(r"vrts/cli/(?:\w+/)*\w+_command\.py", n)]
    called = [n for n in every if PurePosixPath(n).stem.removesuffix("_command") in told.parts]
    return (COMMANDS, *(called or every))


def _of_script(name: str, known: frozenset[str]) -> Iterator[str]:
    text = (ROOT / name).read_text(encoding="utf-8", errors="replace")
    for found in OF_SCRIPTS.findall(text):
        parts: list[str] = []
        for part in (*PurePosixPath(name).parent.parts, *PurePosixPath(found).parts):
            if part == "..":
                parts = parts[:-1]
            elif part != ".":
                parts.append(part)
        if (path := "/".join(parts)) in known:
            yield path
