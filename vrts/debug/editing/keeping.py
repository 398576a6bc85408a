"""A value changed by hand, written back to the one literal of the text that decides it."""

import re
from collections.abc import Callable, Iterator
from difflib import unified_diff
from pathlib import Path
from typing import NamedTuple

from vrts.base.diagnostic import Edit
from vrts.base.mending import with_edits
from vrts.base.oat import components
from vrts.base.pose import Pose
from vrts.base.source import SourceFile, Span
from vrts.base.units import deg
from vrts.debug.branches.tree import Branch, Tree
from vrts.debug.console import Console
from vrts.debug.debugger import Debugger
from vrts.debug.editing.text import take_up
from vrts.debug.evaluating import CannotTell
from vrts.engine.memory.cells import Array, Bound, Cell
from vrts.engine.run import Run
from vrts.engine.statements import statements
from vrts.ir.commands import SetLocal, SetVariable
from vrts.ir.values import Value
from vrts.lang.names import key
from vrts.lang.reading.decoding import decode
from vrts.lang.reading.sections.lines import comment_start
from vrts.pipeline.compiling.fixing import rewritten
from vrts.pipeline.files import CannotRead, read_bytes

_REAL = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:E[+-]?\d+)?"
_NUMBER = re.compile(_REAL, re.IGNORECASE | re.ASCII)
_STEP = re.compile(
    r"\s*(?:(?:SET|POINT)\s+)?(?P<name>[$#]?[A-Za-z][\w.]*(?:\s*\[[\d\s,]*\])?)\s*=\s*(?P<value>.*?)\s*",
    re.IGNORECASE | re.ASCII,
)
_PARTS = re.compile(r"(?:TRANS|#PPOINT)\s*\((?P<inside>[^()]*)\)", re.IGNORECASE)
_CALL = re.compile(
    r"\s*(?:\d+\s+)?CALL\s+[A-Za-z][\w.]*\s*\((?P<inside>[^()]*)\)\s*", re.IGNORECASE | re.ASCII
)
_ARGUMENT = re.compile(r'"[^"]*"|[^\s,"]+(?:\s+[^\s,"]+)*|(?<=,)\s*(?=,)')
_TEXT = re.compile(r'"[^"]*"')
FINE = 1e-9  # numbers nearer than this are written alike


class Kept(NamedTuple):
    """What is to be written."""

    source: SourceFile  # as the present future has it
    edits: tuple[Edit, ...]
    name: str  # of the variable

    @property
    def text(self) -> str:
        """The text as it would be."""
        return with_edits(self.source.text, self.edits)

    @property
    def diff(self) -> list[str]:
        """What would change, as lines of a diff."""
        before, after = self.source.text.splitlines(), self.text.splitlines()
        name = Path(self.source.name).name
        return list(unified_diff(before, after, name, name, lineterm="", n=1))


def kept(tree: Tree, name: str = "") -> Kept:
    """Return the edit that gives a literal the value that somebody gave its variable by hand.

    Args:
        tree: The futures; changes on the way to the present one count, the last first.
        name: Of the variable; empty: the one that was changed last.

    Raises:
        CannotTell: No one literal decides it; the text says what does.
    """
    branch, command = _changed(tree, key(name.replace(" ", "")))
    run = branch.run
    assert command.value is not None
    place: int | None = None  # of an argument
    if isinstance(command, SetLocal):
        bound, place = _local(run, command, branch.forked.finished)
    else:
        bound = next((b for b in run.history.memory.bound if b.name == command.name), None)
    cell = _cell(bound, command)
    inside = f"[{','.join(map(str, command.subscripts))}]" if command.subscripts else ""
    asked, shown = f"{command.name}{inside}", cell.name
    since = [number for number in dict.fromkeys(cell.since) if number <= branch.forked.finished]
    for number in reversed(since):
        if number == 0:
            return _row(tree.current, command, shown)._replace(name=asked)
        found = statements(run.history, number - 1, number)
        span = found[0].cause.span if found else None
        if span is not None and place is not None and _CALL.fullmatch(span.text):
            return _argument(tree.current, span, place, asked, command.value)
        if span is not None:
            return _step(tree.current, span, shown, command.value)._replace(name=asked)
    raise CannotTell(f"no step and no row gives `{asked}` its value: there is no literal to change")


def write_back(
    console: Console, debugger: Debugger, found: Kept, write: Callable[[Path, bytes], None]
) -> str:
    """Write a file with the value in it, and go on with the future of its text; return what of it.

    Raises:
        CannotTell: The file is not there, is no more what is being debugged, or cannot be written.
    """
    path = Path(found.source.name)
    try:
        data = read_bytes(path)
    except CannotRead as problem:
        raise CannotTell(f"{problem}: nothing is written") from problem
    there = decode(data, found.source.name)
    if not isinstance(there, SourceFile) or there.text != found.source.text:
        raise CannotTell(f"`{path.name}` has changed on disk: `reload` first; nothing is written")
    try:
        write(path, rewritten(data, found.edits))
    except OSError as problem:
        reason = (problem.strerror or "it failed").lower()
        raise CannotTell(f"`{path.name}` is as it was: {reason}") from problem
    return take_up(console, debugger, {found.source.name: found.text})


def _changed(tree: Tree, name: str) -> tuple[Branch, SetVariable | SetLocal]:
    """Return the last future in which a variable was given a value by hand, and the command."""
    branch = tree.current
    while branch.parent:
        parent = tree.numbered(branch.parent)
        before = parent.run.history.issued
        for timed in branch.run.history.issued:
            command = timed.command
            if timed in before or not isinstance(command, SetVariable | SetLocal):
                continue
            if command.value is None:
                continue
            inside = f"[{','.join(map(str, command.subscripts))}]" if command.subscripts else ""
            if name in ("", f"{command.name}{inside}"):
                return branch, command
        branch = parent
    what = f"`{name}` was not given a value by hand" if name else "no variable was set by hand"
    raise CannotTell(f"{what} on the way to this future: `set x = 5` first")


def _local(run: Run, command: SetLocal, finished: int) -> tuple[Bound | None, int | None]:
    """Return what an argument or AUTO variable stands for, and which argument it is."""
    history = run.history.process if command.process else run.history.robot
    activation = history.trace.activation(finished)
    if activation is None:
        return None, None
    program = run.history.code.programs[activation.program]
    names = [slot.name for slot in (*program.formals, *program.autos)]
    if command.name not in names:
        return None, None
    k = names.index(command.name)
    return activation.slots[k], k if k < len(program.formals) else None


def _cell(bound: Bound | None, command: SetVariable | SetLocal) -> Cell:
    found = bound.elements.get(command.subscripts) if isinstance(bound, Array) else bound
    if not isinstance(found, Cell):
        raise CannotTell(f"`{command.name}` is not there any more")
    return found


def _row(branch: Branch, command: SetVariable | SetLocal, shown: str) -> Kept:
    """Return the edit of a row of data."""
    wanted = (shown.partition("[")[0], command.subscripts)
    rows = [d for d in branch.run.module.data if (d.name, d.subscripts) == wanted]
    if len(rows) != 1:
        raise CannotTell(f"{len(rows)} rows give `{shown}` a value: there is no one literal")
    source, line = rows[0].span.source, rows[0].span.line
    start = source.line_starts[line - 1]
    text = source.line_text(line)
    cut = comment_start(text)
    words = list(re.finditer(r'"[^"]*"|\S+', text if cut < 0 else text[:cut]))
    values = _written(command.value)
    if len(words) != len(values) + 1:
        raise CannotTell(f"line {line} does not give `{shown}` its value in so many numbers")
    return _edited(source, shown, [(start + w.start(), start + w.end()) for w in words[1:]], values)


def _step(branch: Branch, span: Span, shown: str, value: Value) -> Kept:
    """Return the edit of a step that gives a variable one literal."""
    found = _STEP.fullmatch(span.text)
    source = _source(branch, span)
    where = f"line {span.line} `{span.text.strip()}`"
    if found is None or key(found["name"].replace(" ", "")) != shown:
        raise CannotTell(f"`{shown}` comes from {where}: no literal decides it alone")
    begin = span.start + found.start("value")
    inside = _PARTS.fullmatch(found["value"])
    if inside is not None:
        begin = begin + inside.start("inside")
        pieces = [(begin + m.start(), begin + m.end()) for m in _operands(inside["inside"])]
    else:
        pieces = [(begin, span.start + found.end("value"))]
    values = _written(value)
    literal = all(
        _NUMBER.fullmatch(source.text[a:b]) or _TEXT.fullmatch(source.text[a:b]) for a, b in pieces
    )
    if not literal or len(pieces) != len(values):
        raise CannotTell(f"{where} works `{shown}` out: no literal decides it alone")
    return _edited(source, shown, pieces, values)


def _argument(branch: Branch, span: Span, place: int, shown: str, value: Value) -> Kept:
    """Return the edit of an argument that a CALL gives as a literal."""
    source, found = _source(branch, span), _CALL.fullmatch(span.text)
    where = f"line {span.line} `{span.text.strip()}`"
    listed = list(_ARGUMENT.finditer(found["inside"])) if found is not None else []
    values = _written(value)
    if found is None or place >= len(listed):
        raise CannotTell(f"{where} gives `{shown}` its value: no literal decides it alone")
    begin = span.start + found.start("inside")
    piece = (begin + listed[place].start(), begin + listed[place].end())
    given = source.text[slice(*piece)]
    if len(values) != 1 or not (_NUMBER.fullmatch(given) or _TEXT.fullmatch(given)):
        raise CannotTell(f"{where} gives `{shown}` the value of `{given}`: that is no literal")
    return _edited(source, shown, [piece], values)


def _source(branch: Branch, span: Span) -> SourceFile:
    """Return the text of a step, as the present future has it."""
    programs = branch.run.module.programs.values()
    named = (p.span.source for p in programs if p.span.source.name == span.source.name)
    source = next(named, None)
    if source is None or source.text != span.source.text:
        raise CannotTell("the text has changed since: set the value again")
    return source


def _operands(text: str) -> Iterator[re.Match[str]]:
    return re.finditer(r"[^\s,]+(?:\s+[^\s,]+)*", text)


def _edited(
    source: SourceFile, shown: str, pieces: list[tuple[int, int]], values: list[str]
) -> Kept:
    edits = tuple(
        Edit(Span(source, a, b), new)
        for (a, b), new in zip(pieces, values, strict=True)
        if not _same(source.text[a:b], new)
    )
    if not edits:
        raise CannotTell(f"the text gives `{shown}` this value already")
    return Kept(source, edits, shown)


def _same(old: str, new: str) -> bool:
    if not _NUMBER.fullmatch(old):
        return old == new
    return not new.startswith('"') and abs(float(old) - float(new)) < FINE


def _written(value: Value | None) -> list[str]:
    """Return a value as literals: one, or six of a place, in mm and degrees."""
    if isinstance(value, str):
        if '"' in value or "\n" in value:
            raise CannotTell("such a text cannot be written as a literal")
        return [f'"{value}"']
    if isinstance(value, Pose):
        return [_number(number) for number in components(value)]
    if isinstance(value, tuple):
        return [_number(deg(joint)) for joint in value]
    assert value is not None
    return [_number(value)]


def _number(value: float) -> str:
    for digits in (0, 1, 2, 3, 6):
        if abs(round(value, digits) - value) < FINE:
            return f"{round(value, digits) + 0.0:.{digits}f}"
    return repr(float(value))
