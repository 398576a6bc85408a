"""What every post-processor does: steps written anew, place by place, the rest as it stands.

A statement keeps its text but for its keyword and its expressions, so comments, names and numbers
stay the student's own. Languages differ in words (`WORDS`), in functions (`FUNCTIONS`), in what the
angles of TRANS mean, in how operators bind, and in a few statements that a post writes itself.
"""

import re
from collections.abc import Callable, Iterator
from typing import ClassVar

from vrts.base.diagnostic import Rule
from vrts.dispatch.posts.expressions_anew import CannotWrite, Expressions, Start, constant
from vrts.lang.dialect import VAL2
from vrts.lang.names import key
from vrts.lang.syntax import expressions, statements
from vrts.lang.vocabulary.lookup import instructions_of

CANNOT_WRITE = Rule("V860", "no-such-word")
LEFT_OUT = Rule("V861", "word-left-out")

_WORD = re.compile(r"[A-Za-z][\w.]*", re.ASCII)
_WORDS_OF_THEIR_OWN: dict[type, str] = {
    statements.SetLocation: "SET",
    statements.HereStatement: "HERE",
    statements.ShiftStatement: "SHIFT",
    statements.PackStatement: "PACK",
}
_NODES = (
    expressions.Number,
    expressions.Text,
    expressions.Name,
    expressions.Element,
    expressions.Application,
    expressions.Prefix,
    expressions.Infix,
    expressions.Parenthesised,
)


class Post(Expressions):
    """Writes the statements of resolved programs in another language. This one writes VAL-II."""

    name: ClassVar[str]  # as `--to` takes it
    suffix: ClassVar[str]  # of its files
    WORDS: ClassVar[dict[str, str]] = {}  # keyword: how it is spelt here
    LACKS: ClassVar[frozenset[str]] = frozenset()  # keywords, besides those not in the vocabulary
    LEFT_OUT: ClassVar[frozenset[str]] = frozenset()  # settings that may go without one

    def statement(self, node: statements.Statement) -> tuple[str, ...]:
        """Return a statement as steps of this language: one or more; of a comment, one.

        Raises:
            CannotWrite: There is nothing that means the same.
        """
        word = self._keyword(node)
        if word in self.LEFT_OUT:
            self.left_out.append((node.start, node.end, word))
            return (f"; {self.text(node)}",)
        own: Callable[[statements.Statement], tuple[str, ...]] | None = getattr(
            self, f"_write_{word.lower()}", None
        )
        if own is not None:
            return own(node)
        known = self.WORDS.get(word, word) in instructions_of(self.dialect)
        if word and (word in self.LACKS or not known):
            raise self.lacking(node, word)
        if not word and not isinstance(node, statements.Assignment):
            self._first_word(node)
        return (self.rewritten(node),)

    def _first_word(self, node: statements.Statement) -> None:
        """Refuse what is written with a word of its own that only the original has, as IFSIG."""
        begun = _WORD.match(self.source.text, node.start)
        first = "" if begun is None else begun.group().upper()
        if first in instructions_of(self.origin) and first not in instructions_of(self.dialect):
            raise self.lacking(node, first)

    def rewritten(self, node: statements.Statement) -> str:
        """Return the text of a statement with its keyword and expressions in this language."""
        word = self._keyword(node)
        start, head = node.start, ""
        if word:
            written = _WORD.match(self.source.text, node.start)
            assert written is not None
            start, head = written.end(), self.WORDS.get(word, word)
        return head + self._edited(node, start)

    def lacking(self, node: statements.Statement, word: str, remedy: str = "") -> CannotWrite:
        """Return what to raise for a keyword."""
        title = self.dialect.title
        headline = f"{title} has nothing that means {word}"
        return CannotWrite(node.start, node.end, headline, remedy or "write the step without it")

    def _write_halt(self, node: statements.Simple) -> tuple[str, ...]:
        return self._told(node)

    def _write_stop(self, node: statements.Simple) -> tuple[str, ...]:
        return self._told(node)

    def _write_pause(self, node: statements.Simple) -> tuple[str, ...]:
        return self._told(node)

    def _told(self, node: statements.Simple) -> tuple[str, ...]:
        """HALT and its like tell nothing in other languages: what they say is written before."""
        if not any(node.operands) or self.dialect is VAL2:
            return (self.rewritten(node),)
        said = self.WORDS.get("TYPE", "TYPE")
        return (f"{said} {self.listed(node.operands)}", node.word)

    def _write_pcexecute(self, node: statements.Simple) -> tuple[str, ...]:
        return (f"PCEXECUTE {self.started(node)}".rstrip(),)

    def started(self, node: statements.Simple, behind: str = "") -> str:
        """Return the operands of PCEXECUTE, with what stands behind the name of the program."""
        if not node.operands:
            return ""
        program, *more = node.operands
        assert isinstance(program, expressions.Name)
        return key(program.text) + behind + "".join(f", {self.listed((o,))}" for o in more)

    def begun(self, start: Start) -> tuple[str, ...]:
        """Return the steps that set tool and base: no controller knows those of the scene."""
        return (f"TOOL {self.pose(start.X_FT)}", "BASE 0, 0, 0, 0")

    def grasped(self, node: statements.Simple) -> tuple[str, ...]:
        """Return the steps of GRASP for a language without it: close, then look at a signal."""
        _, *label = node.operands
        if self.settled.arm is None or self.settled.arm.holds is None:
            raise self.lacking(
                node, "GRASP", "say which signal tells: `--arm FILE`, `[hand] holds`"
            )
        missing = f"SIG({-self.settled.arm.holds})"
        if label:
            return ("CLOSEI", f"IF {missing} GOTO {self.listed(tuple(label))}")
        said = f'{self.WORDS.get("TYPE", "TYPE")} "nothing is in the hand"'
        return ("CLOSEI", f"IF {missing} THEN", said, "HALT", "END")

    def ready(self, node: statements.Simple, word: str) -> tuple[str, ...]:
        """Return READY of the arm that was simulated, as a motion to its joints."""
        joints = self.mapped(node).joints(self.settled.ready_deg)
        return (f"{word} #PPOINT({', '.join(f'{joint + 0.0:.9g}' for joint in joints)})",)

    def _write_drive(self, node: statements.Simple) -> tuple[str, ...]:
        arm = self.mapped(node)
        if arm.counts_alike:
            return (self.rewritten(node),)
        joint, change, *speed = node.operands
        ours = None if joint is None else constant(joint)
        if ours is None or round(ours) not in arm.order:
            headline = "which joint DRIVE turns is worked out in the run"
            raise CannotWrite(node.start, node.end, headline, "write its number")
        at = arm.order.index(round(ours))
        turn = self.turned(change, arm.sign[at], 0.0)
        return (f"DRIVE {at + 1}, {turn}" + "".join(f", {self.listed((s,))}" for s in speed),)

    def _keyword(self, node: statements.Statement) -> str:
        """Return the keyword of a statement, as VAL-II writes it; empty where it stays."""
        own = _WORDS_OF_THEIR_OWN.get(type(node))
        if own is not None:
            return own
        named = (
            statements.Simple,
            statements.SpeedStatement,
            statements.Setting,
            statements.Give,
            statements.Put,
            statements.ReactStatement,
            statements.Device,
            statements.Declare,
            statements.Rest,
        )
        return node.word if isinstance(node, named) else ""

    def _edited(self, node: statements.Statement, start: int) -> str:
        """Return the text of a statement from an offset on, its expressions written anew."""
        pieces: list[str] = []
        at = start
        for inner in _expressions(node):
            if inner.start < at:
                continue  # BITS and its like name their parts in another order than they stand
            pieces += (self.source.text[at : inner.start], self.expression(inner))
            at = inner.end
        return "".join((*pieces, self.source.text[at : node.end]))


def _expressions(node: statements.Statement) -> Iterator[expressions.Item]:
    """Return the outermost expressions of a statement in the order of the text."""
    found: list[expressions.Item] = []
    waiting: list[object] = list(node)
    while waiting:
        part = waiting.pop()
        if isinstance(part, (*_NODES, expressions.FormatItem)):
            found.append(part)
        elif isinstance(part, tuple):
            waiting.extend(part)  # pyright: ignore[reportUnknownArgumentType]
    return iter(sorted(found, key=lambda item: item.start))
