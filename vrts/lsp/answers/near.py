"""What is wrong near a place of a long text that is being typed, before all of it is checked.

What was found in the text before moves along with the edits. Only the program around the place is
compiled, without the others; of one that is long itself, only the lines that are new are read.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from vrts.base.diagnostic import Diagnostic, Edit, Fix, Label
from vrts.base.source import SourceFile, Span
from vrts.lang.compiler import Options, compile_source
from vrts.lang.findings.names.untaught import names_of
from vrts.lang.findings.usage import UNUSED_NAME
from vrts.lang.problems import Problems
from vrts.lang.steps.step_parser import StepParser
from vrts.lsp.answers.checking import family_of, linked
from vrts.lsp.documents.documents import Document
from vrts.lsp.documents.moved import Moved
from vrts.lsp.documents.names import ProgramNames

LONG = 400  # lines of a text that is not checked whole for an answer
MOST = 200  # lines that are compiled or read for one


def is_long(document: Document) -> bool:
    """Return whether a text is too long to be checked whole while somebody waits."""
    return document.source.text.count("\n") > LONG


def near(
    document: Document,
    lines: range,
    before: Document,
    found: Sequence[Diagnostic],
    group: Callable[[], Sequence[Document]],
) -> tuple[Diagnostic, ...] | None:
    """Return what is wrong in some lines of a text; None where too much of them is new.

    Args:
        document: The text.
        lines: Those that are asked about, from 0.
        before: An earlier text of the same buffer.
        found: What was wrong with that.
        group: Return the files that belong together with the text.
    """
    moved = Moved(before.source, document.source)
    changed = moved.changed
    fresh: list[Diagnostic] = []
    compiled: list[range] = []
    for program in document.names.programs:
        own = _lines_of(program, document.source)
        if not _meet(own, changed) or not _meet(own, lines):
            continue
        if len(own) <= MOST:
            fresh += _of_program(document, program, group)
            compiled.append(own)
        else:
            asked = range(max(lines.start, changed.start), min(lines.stop, changed.stop))
            if len(asked) > MOST:
                return None
            fresh += _of_lines(document, program, asked)
    carried = (
        now
        for now in (_carried(one, moved, document.source) for one in found)
        if now is not None and not any(_line(now) in own for own in compiled)
    )
    return (*carried, *fresh)


def _lines_of(program: ProgramNames, source: SourceFile) -> range:
    return range(source.line_of(program.start) - 1, source.line_of(program.end))


def _meet(one: range, other: range) -> bool:
    return one.start < other.stop and other.start < one.stop


def _line(diagnostic: Diagnostic) -> int:
    return -1 if diagnostic.primary is None else diagnostic.primary.span.line - 1


# --- what is new --------------------------------------------------------------------------------


def _of_program(
    document: Document, program: ProgramNames, group: Callable[[], Sequence[Document]]
) -> Iterator[Diagnostic]:
    """Compile a program alone; what the rest of its file tells of names is taken into account."""
    text = document.source.text
    piece = SourceFile(document.source.name, text[program.start : program.end + 1])
    names = document.names
    for one in compile_source(piece, Options(dialect=document.dialect)).diagnostics:
        if one.rule == UNUSED_NAME:
            continue  # it may be used in another program
        family = family_of(one)
        if family:
            known = names.defined_programs if family == "program" else names.defined_variables
            if known.issuperset(names_of(one)):
                continue
        placed = _placed(one, document.source, lambda offset: offset + program.start)
        if placed is not None:
            yield linked(placed, document, group()) if family else placed


def _of_lines(document: Document, program: ProgramNames, lines: range) -> list[Diagnostic]:
    """Read lines alone: what does not depend on any other."""
    problems = Problems(document.source, document.dialect)
    parser = StepParser(problems)
    for line in program.section.lines:
        if document.source.line_of(line.start) - 1 in lines:
            parser.step(line)
    return problems.found


# --- what is known ------------------------------------------------------------------------------


def _carried(diagnostic: Diagnostic, moved: Moved, source: SourceFile) -> Diagnostic | None:
    """Return what was found in a text before where it is now; None: a place of it has changed."""
    return _placed(diagnostic, source, moved.offset)


def _placed(
    diagnostic: Diagnostic, source: SourceFile, offset: Callable[[int], int | None]
) -> Diagnostic | None:
    """Return a diagnostic with its places in another text; None where it lacks one of them."""

    def span(old: Span) -> Span | None:
        start, end = offset(old.start), offset(old.end)
        return None if start is None or end is None else Span(source, start, end)

    def label(old: Label) -> Label | None:
        there = span(old.span)
        return None if there is None else Label(there, old.text)

    def edit(old: Edit) -> Edit | None:
        there = span(old.span)
        return None if there is None else Edit(there, old.replacement)

    primary = None if diagnostic.primary is None else label(diagnostic.primary)
    secondary = tuple(filter(None, map(label, diagnostic.secondary)))
    old_fix = diagnostic.fix
    edits = tuple(filter(None, map(edit, old_fix.edits))) if old_fix is not None else ()
    lacks = (diagnostic.primary is not None) != (primary is not None)
    lacks |= len(secondary) < len(diagnostic.secondary)
    lacks |= old_fix is not None and len(edits) < len(old_fix.edits)
    if lacks:
        return None
    fix = None if old_fix is None else Fix.from_edits(edits, sure=old_fix.sure)
    return replace(diagnostic, primary=primary, secondary=secondary, fix=fix)
