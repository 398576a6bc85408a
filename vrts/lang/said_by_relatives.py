"""What relatives of VAL-II say and write where it has words of its own.

Messages name VAL-II's words; whoever writes AS gets those of AS instead [AS manual, appendix of
error messages]. The list of V+ could not be read, so there nothing is claimed of what it says.
"""

import re
from dataclasses import replace

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import Span
from vrts.lang.dialect import Dialect

WORDS_IN_AS = {  # that do the same
    "MOVE": "JMOVE",
    "MOVES": "LMOVE",
    "APPRO": "JAPPRO",
    "APPROS": "LAPPRO",
    "DEPART": "JDEPART",
    "DEPARTS": "LDEPART",
    "FLIP": "DWRIST",
    "NOFLIP": "UWRIST",
    "SET": "POINT",
    "TYPE": "PRINT",
    "REACTE": "ONE",
    "CALLS": "SCALL",
}
NAMES_IN_AS = {  # for what is told: TYPE may stay
    **{word: own for word, own in WORDS_IN_AS.items() if word != "TYPE"},
    "READY": "HOME",
    "DELAY": "TWAIT",
    "MMPS": "MM/S",
}
_CODE = re.compile(r"`[^`]*`")
_WORD = re.compile(r"[A-Za-z][\w.]*")
_SAYS = re.compile(r"VAL-II says \*(?P<words>[^*]+)\*")
_OF_AS = {  # by the words of VAL-II: code and words of AS
    "Ambiguous keyword": "P0110 Specify full spelling of command",
    "Branch to undefined label": "E0101",
    "Control structure error": "P0139 Illegal control structure",
    "Division by zero": "E0108 Divided by zero",
    "Duplicate statement label": "P0129 Duplicate statement label",
    "Illegal assignment": "P0118 Illegal variable type",
    "Illegal expression syntax": "P0114 Illegal expression",
    "Illegal in DO": "P0112 Cannot execute with DO command",
    "Illegal in process control program": "E1095",
    "Illegal operator": "P0121 Expected to be a binary operator",
    "Invalid constant": "P0122 Illegal constant",
    "Invalid format specifier": "P0128 Illegal format specifier",
    "Invalid program or variable name": "P0117 Invalid variable (or program) name",
    "Invalid qualifier": "P0123 Illegal qualifier",
    "Invalid statement label": "P0124 Invalid label",
    "Invalid switch": "P0126 Illegal switch name",
    "Missing argument": "P0125 Missing expected character",
    "Missing parenthesis": "P0155 Missing ')'",
    "Mixing of types": "P0150 Variable of different type already exists",
    "Negative square root": "E0114",
    "Program argument mismatch": "P0137 Mismatch of arguments at subroutine call",
    "Unexpected text at end of line": "P0101 Too many arguments",
    "Unknown instruction": "P0109 Invalid statement",
}


_TITLE = "VAL-II"
_OF_ITSELF = re.compile(r"--dialect|declar|setting|reads it as|controller of")  # of VAL-II alone


def step_in_as(text: str) -> str:
    """Return a step, or several lines of them, with the words of AS."""
    return _WORD.sub(lambda found: NAMES_IN_AS.get(found.group(), found.group()), text)


def help_in_as(text: str, written: str) -> str:
    """Return a sentence with the words of AS in its code, but those that the user wrote."""
    own = {word.upper() for word in _WORD.findall(written)}

    def renamed(found: re.Match[str]) -> str:
        return found.group() if found.group() in own else step_in_as(found.group())

    return _CODE.sub(lambda code: _WORD.sub(renamed, code.group()), text)


def in_words_of(dialect: Dialect, found: tuple[Diagnostic, ...]) -> tuple[Diagnostic, ...]:
    """Return diagnostics with what the controller of their dialect says."""
    if not (dialect.is_as or dialect.is_vplus):
        return found
    return tuple(_reworded(dialect, diagnostic) for diagnostic in found)


def _reworded(dialect: Dialect, found: Diagnostic) -> Diagnostic:
    help_ = tuple(_named(dialect, text) for text in found.help)
    if dialect.is_as and found.primary is not None:
        span = found.primary.span
        written = span.source.text[_line_start(span) :].partition("\n")[0]
        help_ = tuple(help_in_as(text, written) for text in help_)
    if help_ == found.help and not any(_TITLE in t for t in (found.headline, *found.notes)):
        return found
    notes: list[str] = []
    for note in found.notes:
        said = _SAYS.fullmatch(note)
        if said is None:
            notes.append(_named(dialect, note))
        elif dialect.is_as and said["words"] in _OF_AS:
            notes.append(f"AS says {_OF_AS[said['words']]}")
    headline = _named(dialect, found.headline)
    return replace(found, headline=headline, notes=tuple(notes), help=help_)


def _line_start(span: Span) -> int:
    return span.source.text.rfind("\n", 0, span.start) + 1


def _named(dialect: Dialect, text: str) -> str:
    """Return a sentence about VAL-II as one about the dialect that is written."""
    return text if _OF_ITSELF.search(text) else text.replace(_TITLE, dialect.title)
