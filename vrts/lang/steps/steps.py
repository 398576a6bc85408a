"""One line of a program to a step. A bad line costs one diagnostic and becomes a `Bad` one."""

import re
from functools import cache
from typing import Any

from vrts.base.diagnostic import Rule
from vrts.lang.dialect import Dialect, Precedence
from vrts.lang.grammar.build import builders
from vrts.lang.grammar.lalr import Failure, TableParser
from vrts.lang.grammar.shapes import fits
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.reading.characters import (
    BLANKS,
    INVISIBLE,
    LOOK_ALIKES,
    OPENING_QUOTES,
    SINGLE_QUOTES,
)
from vrts.lang.reading.classify import Head, classify
from vrts.lang.reading.nesting import MAX_NESTING, too_deep
from vrts.lang.reading.splitter import Line
from vrts.lang.reading.tokens import MAX_STRING, tokenise
from vrts.lang.steps.mistakes import explain
from vrts.lang.steps.unknown_words import refuse, structural_word
from vrts.lang.syntax.expressions import Text
from vrts.lang.syntax.program import DataLine, Label, Step
from vrts.lang.syntax.statements import (
    Bad,
    Rest,
    Simple,
    Statement,
)
from vrts.lang.syntax.token import Token
from vrts.lang.vocabulary.instructions import INSTRUCTIONS
from vrts.lang.vocabulary.lookup import instructions_of, look_up

PASTED_CHARACTER = Rule("V108", "pasted-character")
INVALID_LABEL = Rule("V133", "invalid-label")
LARGE_LABEL = Rule("V154", "large-label")
TOLERATED = Rule("V155", "tolerated")
TOO_MANY_WORDS = Rule("V116", "too-many-words")
BLOCK_STEP = Rule("V158", "block-step")

MAX_LABEL = 65535  # [manual language/programs#labels]
MAX_VAL2_LABEL = 32767  # beyond it VAL-II may refuse what V+ takes [assumed]
MAX_SEEN = 4096  # different lines whose tokens are kept
MAX_KEPT = 64  # tokens of such a line
MAX_TOKENS = 1_000_000  # of a file: with more it would not fit into memory
_DIGITS = re.compile(r"\d+")
_LISTED = re.compile(r"\d+\.(?=[ \t]*\?)[ \t]*\?|\d+\.(?=[ \t]|$)")  # `12.  MOVE a` of a listing
_NAMED_LABEL = re.compile(r"(?P<name>[A-Za-z][\w.]*):", re.ASCII)
_NAMES = re.compile(r"[$#]?[A-Za-z][\w.]*", re.ASCII)
_FIRST_WORD = re.compile(r"[A-Za-z][\w.]*", re.ASCII)
_BLOCK_STEP = re.compile(
    r"(?:A[CS][ \t]+)?[A-Z]\w*[ \t]+SPEED\d+[ \t]+ACCU\d+", re.ASCII | re.IGNORECASE
)  # JOINT SPEED9 ACCU1 TIMER0 ... [traps 25]
_COMPONENT = re.compile(r"POINT[ \t]*/", re.IGNORECASE)  # `POINT/X a = b` sets one component
_TEXT_WORDS = frozenset({"TYPE", "STOP", "PAUSE"})  # VAL: text without quotes follows


class StepParser:
    """Parses the lines of one source."""

    def __init__(self, problems: Problems, precedence: Precedence | None = None) -> None:
        self.problems = problems
        self.dialect = problems.dialect
        self.parser = TableParser(builders(problems, precedence or self.dialect.precedence))
        self.program_names: frozenset[str] = frozenset()
        self.seen: dict[str, tuple[int, tuple[Token, ...], Head]] = {}  # by text, with its place
        self.token_count = 0
        self.whole_lines = _whole_line_words(self.dialect)
        self.tolerated: dict[str, list[tuple[int, int]]] = {}  # odd shapes, by what they are
        self.block_steps: list[tuple[int, int]] = []  # lines of AS block steps

    def step(self, line: Line) -> Step:
        """Return the step of a line of a program."""
        label, text, at = self.label(line)
        if text and self.dialect.has("a") and _BLOCK_STEP.match(text):
            self.block_steps.append((at, line.end))
            return Step(line.number, label, Bad(None, (), at, line.end))
        statement = self._statement(text, at) if text else None
        return Step(line.number, label, statement)

    def report_block_steps(self) -> None:
        """Report the block steps of AS met since the last call: one message for a program."""
        if not self.block_steps:
            return
        more = len(self.block_steps) - 1
        self.problems.error(
            BLOCK_STEP,
            "a block step of AS is not read",
            *self.block_steps[0],
            notes=(
                *((f"{more} more in this program",) if more else ()),
                "block steps are another language of the Kawasaki controller",
            ),
            help=("write the motion as an AS step: `JMOVE` or `LMOVE` to the joints in `#[...]`",),
            data={"steps": more + 1},
        )
        self.block_steps = []

    def data(self, line: Line) -> DataLine | Failure | None:
        """Return a line of a data section; None when it was reported."""
        tokens = tokenise(line.text, line.start, self.problems)
        if not tokens:
            return None
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

    # --- labels ---------------------------------------------------------------------------------

    def label(self, line: Line) -> tuple[Label | None, str, int]:
        """Return the label of a line, what follows it, and where that begins."""
        text = line.text
        if text[0].isdecimal():
            return self._number(line)
        if self.dialect.has("a"):
            named = _NAMED_LABEL.match(text)
            if named is not None and named["name"].upper() not in ("ANY", "VALUE"):
                rest = text[named.end() :].lstrip()
                label = Label(key(named["name"]), line.start, line.start + named.end() - 1)
                return label, rest, line.end - len(rest)
        return None, text, line.start

    def _number(self, line: Line) -> tuple[Label | None, str, int]:
        digits = _DIGITS.match(line.text)
        assert digits is not None
        rest = line.text[digits.end() :]
        if rest[:1].isalpha() or rest[:1] == "_":
            return None, line.text, line.start  # `3x = 1`: the tokeniser says what is wrong
        start, end = line.start, line.start + digits.end()
        text = rest.lstrip()
        if rest.startswith("."):
            listed = _LISTED.match(line.text)
            if listed is not None and self.dialect.tolerant:
                self._tolerate("step numbers of a listing", start, line.start + listed.end())
                text = line.text[listed.end() :].lstrip().removesuffix("@").rstrip()
                start = line.start + line.text.index(text, listed.end()) if text else line.end
                relabelled = line._replace(text=text, start=start, end=start + len(text))
                return self.label(relabelled) if text else (None, "", line.end)
            self.problems.error(
                INVALID_LABEL,
                "a label is a whole number followed by a blank",
                start,
                end + 1,
                notes=("VAL-II says *Invalid statement label*",),
                help=("take step numbers of a listing out of the file",),
            )
            text = rest[1:].lstrip()
        elif len(digits.group()) > 5 or int(digits.group()) > MAX_LABEL:
            self.problems.error(
                INVALID_LABEL,
                f"the label {digits.group()[:20]} is too large",
                start,
                end,
                notes=("VAL-II says *Invalid statement label*",),
                help=(f"use a number from 0 to {MAX_LABEL}",),
            )
        else:
            number = int(digits.group())
            if number > MAX_VAL2_LABEL and not self.dialect.tolerant:
                self.problems.warning(
                    LARGE_LABEL,
                    f"the label {number} is larger than {MAX_VAL2_LABEL}",
                    start,
                    end,
                    notes=("V+ takes labels up to 65535; a VAL-II controller may refuse this one",),
                    help=("use a smaller number",),
                )
            return Label(number, start, end), text, line.end - len(text)
        return None, text, line.end - len(text)

    # --- statements -----------------------------------------------------------------------------

    def _statement(self, text: str, at: int) -> Statement | None:
        first = text.split(None, 1)[0]
        if self.dialect.has("a") and _COMPONENT.match(text):
            return Rest("POINT", names_in(text), at, at + len(text))
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
        completed = ""
        if self.dialect.tolerant:
            tokens, head, completed = self._tolerant(tokens, head)
        node: Any = None
        if not refuse(self.problems, tokens, head, self.program_names):
            node = self.parser.parse("step", tokens)
            if isinstance(node, Failure):
                explain(self.problems, tokens, node, head.word)
                node = None
            elif not self._fits(node, head, len(tokens)):
                node = None
        if node is not None and completed:
            self._tolerate(completed, tokens[0].start, tokens[-1].end)
        if node is None:
            return Bad(structural_word(tokens, head), names_in(text), at, at + len(text))
        return node

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
        """Return the tokens of a statement, those of the same text seen before moved to its place.

        Most lines of a program stand in it more than once. None when one was reported.
        """
        seen = self.seen.get(text)
        if seen is not None:
            before, tokens, head = seen
            by = at - before
            return [Token(k, t, a + by, b + by, v) for k, t, a, b, v in tokens], head
        reported = len(self.problems.found) + len(self.problems.look_alikes)
        raw = tokenise(text, at, self.problems)
        if not raw:
            return None
        tokens, head = classify(raw, self.dialect)
        quiet = reported == len(self.problems.found) + len(self.problems.look_alikes)
        if quiet and len(self.seen) < MAX_SEEN and len(tokens) < MAX_KEPT:
            self.seen[text] = (at, tuple(tokens), head)
        return tokens, head

    def _unparsed(self, text: str, at: int) -> "Rest | Simple | _Comment | None":
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
            return Rest(word.text, names_in(rest), at, end)
        if self.dialect.is_val and word.text in _TEXT_WORDS and rest and rest[0] not in '"$/':
            start = end - len(rest)
            return Simple(word.text, (Text(rest[:MAX_STRING], start, end),), at, end)
        return None

    def _tolerant(self, tokens: list[Token], head: Head) -> tuple[list[Token], Head, str]:
        """Complete what real files leave out; return also what that was [traps 15 and 27]."""
        word = head.word
        last, first = tokens[-1], tokens[0]
        kinds = {token.kind for token in tokens}
        missing = ""
        if word is not None and word.terminal == "IF" and kinds.isdisjoint({"THEN", "GOTO"}):
            missing = "THEN"
        elif word is not None and word.terminal == "WHILE" and "DO" not in kinds:
            missing = "DO"
        if missing:
            added = Token(missing, missing, last.end, last.end)
            return [*tokens, added], head, f"{first.text} without {missing}"
        if first.kind != "NAME" or word is not None or head.abbreviates:
            return tokens, head, ""
        switched = last.text.upper() in ("ON", "OFF") and len(tokens) == 2
        if switched and self.dialect.has("a"):
            verb = "ENABLE" if last.text.upper() == "ON" else "DISABLE"
            switch = Token("WORDITEMS", verb, first.start, first.start)
            return [switch, first], Head(INSTRUCTIONS[verb]), ""
        bare = len(tokens) == 1 or (tokens[1].kind == "LPAREN" and last.kind == "RPAREN")
        if bare and key(first.text) in self.program_names:
            call = Token("CALL", "CALL", first.start, first.start)
            return [call, *tokens], head, "a program without CALL"
        return tokens, head, ""

    def _tolerate(self, what: str, start: int, end: int) -> None:
        self.tolerated.setdefault(what, []).append((start, end))


@cache
def _whole_line_words(dialect: Dialect) -> frozenset[str]:
    """Return every spelling of the words whose operands are not parsed."""
    words = [w for w in instructions_of(dialect).values() if w.terminal == "REST"]
    words += [INSTRUCTIONS[text] for text in _TEXT_WORDS if dialect.is_val]
    return frozenset(word.text[:k] for word in words for k in range(1, len(word.text) + 1))


class _Comment:
    """Stands for a step that is nothing but a comment."""


_COMMENT = _Comment()


def report_tolerated(parser: StepParser) -> None:
    """Warn once of each kind of shape that a controller refuses."""
    for what, places in parser.tolerated.items():
        more = len(places) - 1
        parser.problems.warning(
            TOLERATED,
            f"{what}: a controller refuses this",
            *places[0],
            notes=(f"{more} more {'place' if more == 1 else 'places'}",) if more else (),
            help=("`--dialect val2` shows how VAL-II wants it",),
            data={"places": len(places)},
        )


def operands_only(tokens: list[Token]) -> list[Token]:
    """Return tokens with every word that is not an operator as a name."""
    classified, _ = classify([Token("LPAREN", "(", 0, 0), *tokens])
    return classified[1:]


def report_pasted_characters(problems: Problems) -> None:
    """Report all look-alikes of the file by kind: pasting is one cause however many it left."""
    kinds: dict[str, list[int]] = {}
    for character, at in problems.look_alikes:
        kinds.setdefault(_kind(character), []).append(at)
    for kind, places in kinds.items():
        first = places[0]
        character = problems.source.text[first]
        entry = LOOK_ALIKES[character]
        lines = sorted({problems.span(at, at).line for at in places[1:]})
        more = ""
        if len(places) > 1:
            shown = ", ".join(str(n) for n in lines[:8]) + (" ..." if len(lines) > 8 else "")
            count = len(places) - 1
            more = f"{count} more {'place' if count == 1 else 'places'}, in " + (
                f"line {shown}" if len(lines) == 1 else f"lines {shown}"
            )
        shown_character = f"`{character}` is " if character.isprintable() else ""
        problems.error(
            PASTED_CHARACTER,
            f"{shown_character}{entry.name}" if shown_character else f"here is {entry.name}",
            first,
            first + 1,
            _instead(entry.replacement),
            notes=(
                "word processors and web pages put such characters in when text is copied",
                *((more,) if more else ()),
            ),
            help=(_remedy(kind, entry.replacement),),
            fix=problems.replace(first, first + 1, entry.replacement),
            data={"places": len(places)},
        )


def _kind(character: str) -> str:
    if character in OPENING_QUOTES:
        return "quotes"
    if character in SINGLE_QUOTES:
        return "apostrophes"
    if character in BLANKS:
        return "blanks"
    if character in INVISIBLE:
        return "invisible"
    return character


def _instead(replacement: str) -> str:
    if replacement == " ":
        return "a plain blank belongs here"
    return f"`{replacement}` belongs here" if replacement else "nothing belongs here"


def _remedy(kind: str, replacement: str) -> str:
    match kind:
        case "quotes":
            return 'replace every curly quote by the straight `"` of the keyboard'
        case "blanks":
            return "replace it by a blank typed on the keyboard"
        case "invisible":
            return "take it out: delete the characters around it and type them again"
        case _:
            return f"type `{replacement}` instead"


def names_in(text: str) -> tuple[str, ...]:
    """Return what could be names in a piece of text."""
    return tuple(dict.fromkeys(key(name) for name in _NAMES.findall(text)))
