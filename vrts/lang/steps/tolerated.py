"""What real files leave out and a controller refuses: read as it was meant, said once a kind."""

import re
from typing import NamedTuple

from vrts.base.diagnostic import Fix, Rule
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.reading.classify import Head
from vrts.lang.steps.advising.open_case import open_words
from vrts.lang.syntax.token import Token
from vrts.lang.vocabulary.instructions import INSTRUCTIONS

_UNTIL = re.compile(r"^[ \t]*(?:\d+[ \t]+)?UNTIL\b", re.IGNORECASE | re.MULTILINE)
_PROGRAM_END = re.compile(r"^[ \t]*\.END\b", re.IGNORECASE | re.MULTILINE)
TOLERATED = Rule("V155", "tolerated")


class Odd(NamedTuple):
    """An odd shape: what is said of it, what helps, and what to write where."""

    says: str
    help: str
    fix: Fix | None = None


class Tolerated:
    """Odd shapes met in a file."""

    def __init__(self) -> None:
        self._places: dict[str, list[tuple[int, int, Fix | None]]] = {}  # by what they are
        self._help: dict[str, str] = {}
        self.count = 0

    def note(self, odd: Odd, start: int, end: int) -> None:
        """Keep that an odd shape stands at a place."""
        self.count += 1
        self._places.setdefault(odd.says, []).append((start, end, odd.fix))
        self._help[odd.says] = odd.help

    def report(self, problems: Problems) -> None:
        """Warn once of each kind of shape that a controller refuses."""
        for what, places in self._places.items():
            more = len(places) - 1
            edits = [edit for _, _, fix in places if fix is not None for edit in fix.edits]
            problems.warning(
                TOLERATED,
                f"{what}: a controller refuses this",
                *places[0][:2],
                notes=(f"{more} more {'place' if more == 1 else 'places'}",) if more else (),
                help=(self._help[what],),
                fix=Fix.from_edits(edits) if edits else None,
                data={"places": len(places)},
            )


def completed(
    tokens: list[Token], head: Head, problems: Problems, program_names: frozenset[str]
) -> tuple[list[Token], Head, Odd | None]:
    """Complete what real files leave out; return also what that was [traps 15 and 27]."""
    word, dialect = head.word, problems.dialect
    last, first = tokens[-1], tokens[0]
    kinds = {token.kind for token in tokens}
    missing = ""
    if dialect.is_vplus:
        return tokens, head, None  # files of V+ leave nothing out
    if word is not None and word.terminal == "IF" and kinds.isdisjoint({"THEN", "GOTO"}):
        missing = "THEN"
    elif word is not None and word.terminal == "WHILE" and "DO" not in kinds:
        if _ends_do(problems.source.text, first.start):
            return tokens, head, None  # as in C: `DO`, and `WHILE condition` at its end
        missing = "DO"
    if missing:
        added = Token(missing, missing, last.end, last.end)
        fix = problems.replace(last.end, last.end, f" {missing}")
        odd = Odd(f"{first.text} without {missing}", f"write {missing} at the end of the line", fix)
        return [*tokens, added], head, odd
    if first.kind != "NAME" or word is not None or head.abbreviates:
        return tokens, head, None
    if dialect.has("a") and _switches(tokens):
        verb = "ENABLE" if last.text.upper() == "ON" else "DISABLE"
        switch = Token("WORDITEMS", verb, first.start, first.start)
        return [switch, *tokens[:-1]], Head(INSTRUCTIONS[verb]), None
    bare = len(tokens) == 1 or (tokens[1].kind == "LPAREN" and last.kind == "RPAREN")
    if bare and key(first.text) in program_names:
        call = Token("CALL", "CALL", first.start, first.start)
        fix = problems.replace(first.start, first.start, "CALL ")
        return [call, *tokens], head, Odd("a program without CALL", "write CALL before it", fix)
    return tokens, head, None


def _ends_do(text: str, at: int) -> bool:
    """Whether a WHILE stands where the UNTIL of a DO belongs: too few of them follow."""
    waiting = open_words(text[:at])
    if waiting[:1] != ["DO"]:
        return False
    rest = _PROGRAM_END.split(text[at:], maxsplit=1)[0]
    return len(_UNTIL.findall(rest)) < waiting.count("DO")


def unlike(text: str, at: int, tokens: list[Token], problems: Problems) -> Odd | None:
    """Return what is said of `!=`, which real files of AS have for `<>`."""
    for token in tokens:
        if token.text == "<>" and text[token.start - at : token.end - at] == "!=":
            fix = problems.replace(token.start, token.end, "<>")
            return Odd("`!=` where the manual of AS has `<>`", "write `<>`", fix)
    return None


def _switches(tokens: list[Token]) -> bool:
    """Whether a step of AS turns switches on or off: `CP, QTOOL OFF`."""
    *names, state = tokens
    kinds = ["NAME" if at % 2 == 0 else "COMMA" for at in range(len(names))]
    named = len(names) % 2 == 1 and [token.kind for token in names] == kinds
    return named and state.text.upper() in ("ON", "OFF")
