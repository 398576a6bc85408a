"""Edits that take the cause of a diagnostic away."""

from collections.abc import Iterator
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Fix, Severity
from vrts.lang.findings.usage import UNDEFINED_PROGRAM
from vrts.lang.meaning.structure import MISSING_END
from vrts.lang.reading.sections.misplaced_lines import MISSING_END_LINE
from vrts.lsp.answers.formatting import Edit
from vrts.lsp.documents.documents import Document


class Remedy(NamedTuple):
    """Edits, and what they do in a few words."""

    title: str
    edits: tuple[Edit, ...]
    preferred: bool = True


def remedies(document: Document, diagnostic: Diagnostic) -> Iterator[Remedy]:
    """Return what would take the cause of a diagnostic of a buffer away."""
    fix = diagnostic.fix
    if fix is not None:
        missing = diagnostic.rule == MISSING_END_LINE and not fix.span.text
        title = "Write the missing .END" if missing else _title(fix)
        yield Remedy(title, tuple(Edit(*e.span[1:], e.replacement) for e in fix.edits), fix.sure)
    if diagnostic.rule == MISSING_END:
        yield from _end(document, diagnostic)
    elif diagnostic.rule == UNDEFINED_PROGRAM and diagnostic.severity is not Severity.NOTE:
        name = diagnostic.data.get("name")
        end = len(document.source.text)
        begin = "\n" if document.source.text.endswith("\n") else "\n\n"
        text = f"{begin}.PROGRAM {name}\n.END\n"
        yield Remedy(f"Write a program `{name}`", (Edit(end, end, text),), preferred=False)


def _title(fix: Fix) -> str:
    if len(fix.edits) > 1:
        return f"Mend all {len(fix.edits)} places"
    before, after = fix.span.text, fix.replacement
    if not before:
        return f"Insert `{after.strip()}`" if after.strip() else "Insert a blank"
    if not after:
        return f"Take out `{before.strip()}`" if before.strip() else "Take out blanks"
    return f"Write `{after}` instead of `{before}`"


def _end(document: Document, diagnostic: Diagnostic) -> Iterator[Remedy]:
    """Close a structure where its program ends; a DO would need its condition."""
    if diagnostic.primary is None or not diagnostic.secondary:
        return
    opener = diagnostic.primary.span
    if opener.text[:2].upper() == "DO":
        return
    source = document.source
    line = source.line_text(opener.line)
    column = opener.column - 1
    indent = " " * len(line[:column].expandtabs(8))
    finish = diagnostic.secondary[0].span
    if finish.start == finish.end:
        edit = Edit(finish.end, finish.end, f"\n{indent}END")
    else:
        start = source.line_starts[finish.line - 1]
        edit = Edit(start, start, f"{indent}END\n")
    yield Remedy("Write the missing END", (edit,))
