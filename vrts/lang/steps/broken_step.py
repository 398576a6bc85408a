"""A step that does not parse: what came before, what is in the way, and what was wanted."""

from typing import NamedTuple

from vrts.lang.grammar.lalr import Failure
from vrts.lang.problems import Problems
from vrts.lang.syntax.token import Token
from vrts.lang.vocabulary.word import Word

OPERANDS = frozenset({"NAME", "NUMBER", "STRING", "STRINGNAME", "JOINTNAME", "LPAREN", "PREFIX"})
ARGUMENT_SAYS = "VAL-II says *Missing argument*"
TEXT_SAYS = "VAL-II says *Unexpected text at end of line*"


class BrokenStep(NamedTuple):
    """The tokens of a step, and where they stop making sense."""

    problems: Problems
    tokens: list[Token]
    failure: Failure
    wanted: frozenset[str]  # kinds of tokens that could have come next
    word: Word | None  # the instruction, where one is known

    @property
    def here(self) -> Token | None:
        """The token in the way, or None at the end of the step."""
        at = self.failure.at
        return self.tokens[at] if at < len(self.tokens) else None

    @property
    def before(self) -> Token | None:
        """The last token that made sense."""
        return self.tokens[self.failure.at - 1] if self.failure.at else None

    @property
    def inside(self) -> bool:
        """Whether the token in the way stands within parentheses or brackets."""
        tokens = self.tokens[: self.failure.at]
        opened = sum(t.kind in ("LPAREN", "LBRACKET") for t in tokens)
        return opened > sum(t.kind in ("RPAREN", "RBRACKET") for t in tokens)


def outside(tokens: list[Token]) -> list[Token]:
    """Return the tokens outside all parentheses and brackets."""
    depth = 0
    outside: list[Token] = []
    for token in tokens:
        if token.kind in ("LPAREN", "LBRACKET"):
            depth += 1
        elif token.kind in ("RPAREN", "RBRACKET"):
            depth -= 1
        elif depth == 0:
            outside.append(token)
    return outside
