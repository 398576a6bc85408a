"""The diagnostics of a buffer, with what other files of its group add to it."""

from collections.abc import Sequence
from dataclasses import replace

from vrts.base.diagnostic import Diagnostic, Severity
from vrts.lang.compiler import Options, compile_source
from vrts.lang.findings.names.untaught import UNDEFINED_LOCATION, names_of, told_of
from vrts.lang.findings.usage import UNDEFINED_PROGRAM, UNDEFINED_VARIABLE
from vrts.lsp.documents.documents import Document

_FAMILIES = {
    UNDEFINED_PROGRAM: "program",
    UNDEFINED_LOCATION: "variable",
    UNDEFINED_VARIABLE: "variable",
}


def check(
    document: Document, group: Sequence[Document] = (), *, is_whole: bool = True
) -> tuple[Diagnostic, ...]:
    """Return what is wrong with a buffer.

    Args:
        document: The buffer.
        group: Files that belong together with it. What they define is only noted as coming from
            elsewhere.
        is_whole: Whether all files of the folder are known; else what is missing is only noted.
    """
    if document.refusal is not None:
        return (document.refusal,)
    if not document.source.text.strip():
        return ()
    found = compile_source(document.source, Options(dialect=None)).diagnostics
    return tuple(linked(d, document, group, is_whole=is_whole) for d in found)


def family_of(diagnostic: Diagnostic) -> str:
    """Return which kind of name a diagnostic misses, that another file may have; or nothing."""
    return _FAMILIES.get(diagnostic.rule, "")


def linked(
    diagnostic: Diagnostic, document: Document, group: Sequence[Document], *, is_whole: bool = True
) -> Diagnostic:
    """Return a diagnostic of a buffer with what the other files of its group add to it.

    Args:
        diagnostic: What was found in the buffer alone.
        document: The buffer.
        group: Files that belong together with it.
        is_whole: Whether all files of the folder are known.
    """
    family = family_of(diagnostic)
    names = names_of(diagnostic)
    if not family or not names:
        return diagnostic
    others = [other for other in group if other is not document]
    left = [n for n in names if not any(n in _defined(other, family) for other in others)]
    if left and len(left) < len(names):
        diagnostic = replace(diagnostic, headline=told_of(left))
    for other in others:
        if not left and names[0] in _defined(other, family):
            return replace(
                diagnostic,
                severity=Severity.NOTE,
                notes=(f"`{other.source.name}` has it",),
                help=(f"check both together: `--with {other.source.name}`",),
                fix=None,
            )
    if not is_whole:
        notes = ("the other files of the folder are still being read",)
        return replace(diagnostic, severity=Severity.NOTE, notes=notes, help=(), fix=None)
    return diagnostic


def _defined(document: Document, family: str) -> frozenset[str]:
    names = document.names
    return names.defined_programs if family == "program" else names.defined_variables
