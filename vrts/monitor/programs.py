"""The text of the programs in memory, and what becomes of it.

The controller executes modules; the operator lists, edits and stores text. A program with a bad
line is kept and listed, and is not executable.
"""

import re
from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.base.pose import Pose
from vrts.base.source import SourceFile
from vrts.ir.module import Program
from vrts.ir.values import Value
from vrts.lang.compiler import Compilation, Options, compile_sources
from vrts.lang.dialect import Dialect
from vrts.lang.typed.entry import bad_steps, references
from vrts.lang.writing.layout import GUTTER, program_text

_ROW = re.compile(r"(?P<label>\d{1,5}(?![\w.])|[a-z][\w.]*:)?(?P<blanks>[ \t]*)(?P<code>.*)", re.S)
_WORD = re.compile(r"[A-Za-z][\w.]{0,14}", re.ASCII)
_LABEL = 7  # columns of a label in a listing
_DATA = "memory.lc"  # name under which variables in memory are shown to the compiler


class StoredProgram(NamedTuple):
    """One program of the memory."""

    name: str
    header: str  # `.PROGRAM name(a, b)`
    lines: tuple[str, ...]  # one a step
    modified: bool = False  # since it was loaded or stored
    bad: frozenset[int] = frozenset()  # steps that cannot be read
    faults: tuple[Diagnostic, ...] = ()  # why it is not executable
    program: Program | None = None  # as executed; None: not executable

    @property
    def text(self) -> str:
        """The program as a file has it."""
        return "\n".join((self.header, *self.lines, ".END", ""))


Programs = Mapping[str, StoredProgram]


def compiled(
    program: StoredProgram, others: Programs, variables: Mapping[str, Value], dialect: Dialect
) -> StoredProgram:
    """Return a program checked and translated, with what it refers to in view."""
    bad = bad_steps(program.lines, dialect, frozenset(others))
    source = SourceFile(program.name, program.text)
    found = in_view(source, program.lines, others, variables, dialect)
    own = found.module.programs.get(program.name) if found.module is not None else None
    faults = tuple(d for d in found.diagnostics if d.is_error)
    return program._replace(bad=bad, faults=faults if own is None else (), program=own)


def in_view(
    source: SourceFile,
    lines: tuple[str, ...],
    programs: Programs,
    variables: Mapping[str, Value],
    dialect: Dialect,
) -> Compilation:
    """Return a source compiled with what its lines refer to, or alone if that disagrees."""
    options = Options(dialect, typed=True)
    called = reachable(references(lines, dialect).programs, programs, dialect)
    others = [programs[name] for name in sorted(called) if name != source.name]
    beside = [SourceFile(other.name, other.text) for other in others if other.program is not None]
    words = {word.lower() for file in (source, *beside) for word in _WORD.findall(file.text)}
    data = _declarations({n: v for n, v in variables.items() if n.partition("[")[0] in words})
    if data:
        beside.append(SourceFile(_DATA, data))
    found = compile_sources([source, *beside], options)
    if found.module is None and not any(_concerns(d, source) for d in found.diagnostics):
        return compile_sources([source], options)
    own = tuple(d for d in found.diagnostics if _concerns(d, source))
    return Compilation(found.module, own, found.dialect, source)


def reachable(names: Iterable[str], programs: Programs, dialect: Dialect) -> set[str]:
    """Return the programs of some names, with all that they may call."""
    found: set[str] = set()
    waiting = [name for name in names if name in programs]
    while waiting:
        name = waiting.pop()
        if name not in found:
            found.add(name)
            waiting += references(programs[name].lines, dialect).programs & programs.keys()
    return found


def listed(program: StoredProgram, dialect: Dialect, numbers: Iterable[int]) -> str:
    """Return steps of a program as LISTP shows them: `    3.  100    CLOSEI`."""
    there = [number for number in numbers if 0 < number <= len(program.lines)]
    rows = canonical(program, dialect) if there else ()
    return "".join(
        f"{_listed_row(number, rows[number - 1], bad=number in program.bad)}\n" for number in there
    )


def listing(program: StoredProgram, dialect: Dialect) -> str:
    """Return a whole program as LISTP shows it."""
    steps = listed(program, dialect, range(1, len(program.lines) + 1))
    return f"{program.header}\n{steps}.END\n"


def canonical(program: StoredProgram, dialect: Dialect) -> tuple[str, ...]:
    """Return the steps of a program in the layout of files, bad ones as they are."""
    return _canonical(program.name, program.header, program.lines, dialect)


@lru_cache(64)
def _canonical(name: str, header: str, lines: tuple[str, ...], dialect: Dialect) -> tuple[str, ...]:
    text = program_text(SourceFile(name, StoredProgram(name, header, lines).text), dialect)
    return tuple(text[name].split("\n")[1 : len(lines) + 1]) if name in text else lines


def step_text(program: StoredProgram, number: int, dialect: Dialect) -> str:
    """Return one step without label and indentation; empty when there is none."""
    if not 0 < number <= len(program.lines):
        return ""
    row = _ROW.match(canonical(program, dialect)[number - 1])
    return row["code"].strip() if row is not None else ""


def _listed_row(number: int, row: str, *, bad: bool) -> str:
    match = _ROW.match(row)
    assert match is not None  # everything in it may be missing
    label, code = match["label"] or "", match["code"].rstrip()
    column = len(label) + len(match["blanks"].expandtabs(GUTTER))
    indent = 0 if bad else max(column - GUTTER, 0) // 2
    mark = "?" if bad else ""
    return f"{number:5d}.  {label:<{_LABEL}}{' ' * indent}{mark}{code}".rstrip()


def _concerns(found: Diagnostic, source: SourceFile) -> bool:
    return found.primary is None or found.primary.span.source is source


def _declarations(variables: Mapping[str, Value]) -> str:
    """Return data sections that tell the compiler what kind each variable has."""
    poses = {_element(n) for n, v in variables.items() if isinstance(v, Pose)}
    reals = {_element(n) for n, v in variables.items() if isinstance(v, float)}
    rows = [".LOCATIONS", *(f"{name} 0 0 0" for name in sorted(poses)), ".END"] if poses else []
    rows += [".REALS", *(f"{name} 0" for name in sorted(reals)), ".END"] if reals else []
    return "".join(f"{row}\n" for row in rows)


def _element(name: str) -> str:
    """Return a name, and of an array its first element."""
    base, bracket, _ = name.partition("[")
    return f"{base}[0]" if bracket else base
