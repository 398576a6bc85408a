"""What real files leave out and a controller refuses: read as it was meant, said once a kind."""

from vrts.base.diagnostic import Rule
from vrts.lang.dialect import Dialect
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.reading.classify import Head
from vrts.lang.syntax.token import Token
from vrts.lang.vocabulary.instructions import INSTRUCTIONS

TOLERATED = Rule("V155", "tolerated")


class Tolerated:
    """Odd shapes met in a file."""

    def __init__(self) -> None:
        self._places: dict[str, list[tuple[int, int]]] = {}  # by what they are

    def note(self, what: str, start: int, end: int) -> None:
        """Keep that an odd shape stands at a place."""
        self._places.setdefault(what, []).append((start, end))

    def report(self, problems: Problems) -> None:
        """Warn once of each kind of shape that a controller refuses."""
        for what, places in self._places.items():
            more = len(places) - 1
            problems.warning(
                TOLERATED,
                f"{what}: a controller refuses this",
                *places[0],
                notes=(f"{more} more {'place' if more == 1 else 'places'}",) if more else (),
                help=("`--dialect val2` shows how VAL-II wants it",),
                data={"places": len(places)},
            )


def completed(
    tokens: list[Token], head: Head, dialect: Dialect, program_names: frozenset[str]
) -> tuple[list[Token], Head, str]:
    """Complete what real files leave out; return also what that was [traps 15 and 27]."""
    word = head.word
    last, first = tokens[-1], tokens[0]
    kinds = {token.kind for token in tokens}
    missing = ""
    if dialect.is_vplus:
        return tokens, head, ""  # files of V+ leave nothing out
    if word is not None and word.terminal == "IF" and kinds.isdisjoint({"THEN", "GOTO"}):
        missing = "THEN"
    elif word is not None and word.terminal == "WHILE" and "DO" not in kinds:
        missing = "DO"
    if missing:
        added = Token(missing, missing, last.end, last.end)
        return [*tokens, added], head, f"{first.text} without {missing}"
    if first.kind != "NAME" or word is not None or head.abbreviates:
        return tokens, head, ""
    if dialect.has("a") and _switches(tokens):
        verb = "ENABLE" if last.text.upper() == "ON" else "DISABLE"
        switch = Token("WORDITEMS", verb, first.start, first.start)
        return [switch, *tokens[:-1]], Head(INSTRUCTIONS[verb]), ""
    bare = len(tokens) == 1 or (tokens[1].kind == "LPAREN" and last.kind == "RPAREN")
    if bare and key(first.text) in program_names:
        call = Token("CALL", "CALL", first.start, first.start)
        return [call, *tokens], head, "a program without CALL"
    return tokens, head, ""


def _switches(tokens: list[Token]) -> bool:
    """Whether a step of AS turns switches on or off: `CP, QTOOL OFF`."""
    *names, state = tokens
    kinds = ["NAME" if at % 2 == 0 else "COMMA" for at in range(len(names))]
    named = len(names) % 2 == 1 and [token.kind for token in names] == kinds
    return named and state.text.upper() in ("ON", "OFF")
