"""One line of a program to a step. A bad line costs one diagnostic and becomes a `Bad` one."""

import re
from functools import cache, cached_property
from typing import Any

from vrts.base.diagnostic import Rule
from vrts.base.made import made
from vrts.lang.dialect import Dialect, Precedence
from vrts.lang.grammar.build import builders
from vrts.lang.grammar.lalr import Failure, TableParser
from vrts.lang.grammar.shapes import fits
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.reading.classify import Head, classify
from vrts.lang.reading.literals import MAX_STRING
from vrts.lang.reading.nesting import MAX_NESTING, too_deep
from vrts.lang.reading.sections.lines import Line
from vrts.lang.reading.tokeniser import tokenise
from vrts.lang.steps.advising.advice import Advice
from vrts.lang.steps.advising.adviser import Line as AdvisedLine
from vrts.lang.steps.habits import Habits
from vrts.lang.steps.kawasaki_forms import (
    BLOCK_WORD,
    monitor_step,
    untouched_word,
    without_component,
)
from vrts.lang.steps.labels import read_label
from vrts.lang.steps.misread.relatives.slips import READABLE, readable_slip
from vrts.lang.steps.mistakes import explain
from vrts.lang.steps.other_forms import INVALID_EXPRESSION
from vrts.lang.steps.repair import Repair
from vrts.lang.steps.tolerated import Odd, Tolerated, completed, unlike
from vrts.lang.steps.trials import Trials
from vrts.lang.steps.unknown_words import refuse, structural_word
from vrts.lang.syntax.expressions import Text
from vrts.lang.syntax.moved import moved
from vrts.lang.syntax.program import DataLine, Label, Step
from vrts.lang.syntax.statements import Bad, Rest, Simple, Statement
from vrts.lang.syntax.token import Token
from vrts.lang.vocabulary.instructions import INSTRUCTIONS
from vrts.lang.vocabulary.lookup import instructions_of, look_up

TOO_MANY_WORDS = Rule("V116", "too-many-words")
BLOCK_STEP = Rule("V158", "block-step")

MOST_DEEP = 2  # trials within trials
MAX_SEEN = 4096  # different steps that are kept
MAX_KEPT = 64  # tokens of such a step
MAX_TOKENS = 1_000_000  # of a file: with more it would not fit into memory
_NAMES = re.compile(r"[$#]?[A-Za-z][\w.]*", re.ASCII)
_LOCALS = re.compile(  # `.x`, `.$x`, and what is meant by `$.x`
    r"(?<![\w.\])])(?:\.(?=[$#]?[A-Za-z])|(?=[$#]\.))(?P<sign>[$#]?)\.?(?P<name>[A-Za-z][\w.]*)",
    re.ASCII,
)
_PARTED = re.compile(r"(?P<sign>[$#])[ \t]+(?P<name>[A-Za-z][\w.]*)", re.ASCII)  # `$ name`
_FIRST_WORD = re.compile(r"[A-Za-z][\w.]*", re.ASCII)
_TEXT_WORDS = frozenset({"TYPE", "STOP", "PAUSE"})  # VAL: text without quotes follows


class StepParser:
    """Parses the lines of one source."""

    def __init__(
        self,
        problems: Problems,
        precedence: Precedence | None = None,
        *,
        depth: int = 0,
        trials: Trials | None = None,
    ) -> None:
        """Parse for a collection of problems; `depth` counts trials within trials."""
        self.problems = problems
        self.precedence = precedence
        self.depth = depth
        self.trials = trials or Trials()
        self.habits = Habits()
        self.dialect = problems.dialect
        self.parser = TableParser(builders(problems, precedence or self.dialect.precedence))
        self.program_names: frozenset[str] = frozenset()
        self.seen: dict[str, tuple[int, int, Statement]] = {}  # by text: place, tokens, tree
        self.token_count = 0
        self.named_labels = self.dialect.has("a")
        self.whole_lines = _whole_line_words(self.dialect)
        self.tolerated = Tolerated()
        self.block_steps: list[tuple[int, int]] = []  # lines of AS block steps

    @cached_property
    def advice(self) -> Advice:
        """What explains lines that are no steps; most trials need none."""
        repair = Repair(self.dialect, self._tried, self._tried_plainly)
        return Advice(self.problems, repair, self.habits)

    def step(self, line: Line) -> Step:
        """Return the step of a line of a program."""
        self.trials.begin_line()
        if "advice" in self.__dict__:  # something was explained above
            if line.start < self.advice.continued.joined_to:
                return Step(line.number, None, None)
            if self.advice.comments.open_comment:
                self.advice.comments.inside_comment(line.start, line.end, line.text)
                return Step(line.number, None, Bad(None, (), line.start, line.end))
        number, text, at, _ = line
        label: Label | None = None
        if self.named_labels or text[0].isdecimal():
            label, text, at = read_label(line, self.problems, self.tolerated)
        seen = self.seen.get(text)
        if seen is not None:
            before, count, statement = seen
            if self.token_count + count <= MAX_TOKENS:
                self.token_count += count
                return made(Step, (number, label, moved(statement, at - before)))
        statement = self._statement(text, at) if text else None
        return Step(line.number, label, statement)

    def let_go(self) -> None:
        """Let go of the advice: it knows its parser, a ring that only the collector would find."""
        self.__dict__.pop("advice", None)

    def report_block_steps(self) -> None:
        """Warn of the block steps of AS: one message for a file."""
        if not self.block_steps:
            return
        more = len(self.block_steps) - 1
        self.problems.warning(
            BLOCK_STEP,
            "a block step of AS is not simulated",
            *self.block_steps[0],
            "a run stops when it gets here",
            notes=(
                *((f"{more} more in this file",) if more else ()),
                "block steps are another language of the Kawasaki controller",
            ),
            help=("write the motion as an AS step: `JMOVE` or `LMOVE` to the joints in `#[...]`",),
            data={"steps": more + 1},
        )

    def data(self, line: Line, more: tuple[Line, ...] = ()) -> DataLine | Failure | None:
        """Return a line of a data section, with lines that carry it on; None when reported."""
        tokens: list[Token] = []
        for part in (line, *more):
            found = tokenise(part.text, part.start, self.problems)
            if not found:
                return None
            tokens += found
        plain = [t._replace(kind="NAME") if t.kind == "WORD" else t for t in tokens]
        return self.parser.parse("data", plain)

    def expression(self, text: str, at: int) -> Any:
        """Return an expression that stands alone; None when it was reported."""
        tokens = tokenise(text, at, self.problems)
        if not tokens:
            return None
        node = self.parser.parse("expression", operands_only(tokens))
        if isinstance(node, Failure):
            explain(self.problems, operands_only(tokens), node, None)
            return None
        return node

    # --- statements -----------------------------------------------------------------------------

    def _statement(self, text: str, at: int) -> Statement | None:
        """Return the statement of a line; explain it where it is none."""
        mark = len(self.problems.found)
        looks = len(self.problems.look_alikes)
        count, noted = self.token_count, self.tolerated.count + len(self.block_steps)
        node = self._read(text, at)
        told = len(self.problems.found) > mark or len(self.problems.look_alikes) > looks
        if not isinstance(node, Bad) or not told or self.depth > MOST_DEEP:
            if not told and noted == self.tolerated.count + len(self.block_steps):
                self._keep(text, at, self.token_count - count, node)
            return node
        finish = self.problems.source.text.find("\n", at + len(text))
        raw = self.problems.source.text[at : finish if finish >= 0 else None].rstrip()
        line = AdvisedLine(text, at, raw, node.word)
        if len(self.problems.look_alikes) > looks:  # pasted characters: told by themselves
            advised = self.advice.comments.comment(line, mark)
        else:
            advised = self.advice.explain(line, mark)
        if advised is None:
            return node
        del self.problems.look_alikes[looks:]
        names = names_in(raw) if ";" in raw else node.names  # `INPUT "How many"; n`
        return node._replace(word=advised.word, meant=advised.meant, names=names)

    def _keep(self, text: str, at: int, tokens: int, node: Statement | None) -> None:
        """Keep a step of which there was nothing to say: most stand in a program more than once."""
        if node is None or isinstance(node, Bad) or tokens >= MAX_KEPT:
            return
        if len(self.seen) < MAX_SEEN:
            self.seen[text] = (at, tokens, node)

    def _tried(self, problems: Problems, text: str) -> Statement | None:
        """Return a text as a step, tried out apart from the file."""
        return self._apart(problems, text, self.depth + 1)

    def _tried_plainly(self, problems: Problems, text: str) -> Statement | None:
        """Return a text as a step, tried out apart from the file and without advice."""
        return self._apart(problems, text, MOST_DEEP + 1)

    def _apart(self, problems: Problems, text: str, depth: int) -> Statement | None:
        if not self.trials.take():
            return Bad(None, (), 0, len(text))
        parser = StepParser(problems, self.precedence, depth=depth, trials=self.trials)
        parser.program_names = self.program_names
        node = parser._statement(text, 0)
        parser.let_go()
        return node

    def _read(self, text: str, at: int) -> Statement | None:
        first = text.split(None, 1)[0]
        if self.dialect.has("a"):
            untouched = untouched_word(text)
            if untouched == BLOCK_WORD:
                self.block_steps.append((at, at + len(text)))
            if untouched is not None:
                return Rest(untouched, names_in(text), at, at + len(text))
            plain = without_component(text)
            if plain is not None:
                node, end = self._read(plain, at), at + len(text)
                return node if isinstance(node, Bad) else Rest("POINT", names_in(text), at, end)
        if first.upper() in self.whole_lines:
            whole = self._unparsed(text, at)
            if whole is not None:
                return None if isinstance(whole, _Comment) else whole
        if self.token_count > MAX_TOKENS:
            return Bad(None, (), at, at + len(text))
        classified = self.tokens(text, at)
        if classified is None:
            match = _FIRST_WORD.match(text)
            word = match.group().upper() if match else None
            return Bad(word, names_in(text), at, at + len(text))
        tokens, head = classified
        self._counted(tokens)
        odd: Odd | None = None
        if self.dialect.tolerant:
            tokens, head, odd = completed(tokens, head, self.problems, self.program_names)
            if odd is None and "!=" in text:
                odd = unlike(text, at, tokens, self.problems)
        node: Any = None
        if self._slip(text, at, head.word.text if head.word is not None else first.upper()):
            node = None
        elif not refuse(self.problems, tokens, head, self.program_names):
            node = self.parser.parse("step", tokens)
            if isinstance(node, Failure):
                explain(self.problems, tokens, node, head.word)
                node = None
            elif not self._fits(node, head, len(tokens)):
                node = None
        if isinstance(node, Rest):
            return node._replace(names=names_in(text))
        if node is not None and odd is not None:
            self.tolerated.note(odd, tokens[0].start, tokens[-1].end)
        if node is None:
            return Bad(structural_word(tokens, head), names_in(text), at, at + len(text))
        return node

    def _slip(self, text: str, at: int, word: str) -> bool:
        """Whether a step is a mistake of V+ or AS that the grammar takes; report it."""
        if word not in READABLE:
            return False
        says = readable_slip(text, self.dialect)
        if says:
            self.problems.error(INVALID_EXPRESSION, says, at, at + len(text))
        return bool(says)

    def _counted(self, tokens: list[Token]) -> None:
        before = self.token_count
        self.token_count += len(tokens)
        if before <= MAX_TOKENS < self.token_count:
            self.problems.error(
                TOO_MANY_WORDS,
                f"there are more than {MAX_TOKENS:,} words and signs up to here",
                tokens[0].start,
                tokens[-1].end,
                notes=("what follows is not read",),
                help=("check that this is a program, or split the file",),
            )

    def _fits(self, node: Any, head: Head, length: int) -> bool:
        """Whether the dialect takes a step, and its expressions are not too deep."""
        if length > MAX_NESTING and too_deep(self.problems, node):
            return False
        return fits(self.problems, node, head.word)

    def tokens(self, text: str, at: int) -> tuple[list[Token], Head] | None:
        """Return the tokens of a statement; None when one was reported."""
        raw = tokenise(text, at, self.problems)
        return classify(raw, self.dialect) if raw else None

    def _unparsed(self, text: str, at: int) -> "Bad | Rest | Simple | _Comment | None":
        """Return a step whose operands are not expressions: opaque ones, REMARK, texts of VAL."""
        first = _FIRST_WORD.match(text)
        if first is None:
            return None
        end = at + len(text)
        match = look_up(first.group(), self.dialect)
        word, rest = match.word, text[first.end() :].lstrip()
        if word is None or rest[:1] == "=" or (rest[:1] == "[" and "=" in rest):
            return None
        if word.terminal == "REST":
            if word.text == "REMARK":
                return _COMMENT
            given = word.text == "MC" and self.dialect.is_as
            if given and not monitor_step(text, at, self.problems):
                return Bad(word.text, names_in(rest), at, end)
            return Rest(word.text, names_in(rest), at, end)
        if self.dialect.is_val and word.text in _TEXT_WORDS and rest and rest[0] not in '"$/':
            start = end - len(rest)
            return Simple(word.text, (Text(rest[:MAX_STRING], start, end),), at, end)
        return None


@cache
def _whole_line_words(dialect: Dialect) -> frozenset[str]:
    """Return every spelling of the words whose operands are not parsed."""
    words = [w for w in instructions_of(dialect).values() if w.terminal == "REST"]
    words += [INSTRUCTIONS[text] for text in _TEXT_WORDS if dialect.is_val]
    return frozenset(word.text[:k] for word in words for k in range(1, len(word.text) + 1))


class _Comment:
    """Stands for a step that is nothing but a comment."""


_COMMENT = _Comment()


def operands_only(tokens: list[Token]) -> list[Token]:
    """Return tokens with every word that is not an operator as a name."""
    classified, _ = classify([Token("LPAREN", "(", 0, 0), *tokens])
    return classified[1:]


def names_in(text: str) -> tuple[str, ...]:
    """Return what could be names in a piece of text."""
    found = dict.fromkeys(key(name) for name in _NAMES.findall(text))
    for match in _PARTED.finditer(text):
        found[match["sign"] + key(match["name"])] = None
    if "." in text:
        for match in _LOCALS.finditer(text):
            found[f"{match['sign']}.{key(match['name'])}"] = None
    return tuple(found)
