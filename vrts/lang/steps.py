"""One line of a program to a step. A bad line costs one diagnostic and becomes a `Bad` one."""

import re
from typing import Any

from vrts.base.diagnostic import Rule
from vrts.lang.build import builders
from vrts.lang.characters import BLANKS, INVISIBLE, LOOK_ALIKES, OPENING_QUOTES, SINGLE_QUOTES
from vrts.lang.lalr import Failure, TableParser
from vrts.lang.mistakes import explain
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.splitter import Line
from vrts.lang.syntax import Bad, DataLine, Label, Statement, Step, Token
from vrts.lang.tokens import classify, tokenise
from vrts.lang.unknown_words import refuse, structural_word

PASTED_CHARACTER = Rule("V108", "pasted-character")
INVALID_LABEL = Rule("V133", "invalid-label")

MAX_LABEL = 65535  # [val2.md 1.3]
_DIGITS = re.compile(r"\d+")
_NAMES = re.compile(r"[$#]?[A-Za-z][\w.]*", re.ASCII)
_FIRST_WORD = re.compile(r"[A-Za-z]+")


class StepParser:
    """Parses the lines of one source."""

    def __init__(self, problems: Problems) -> None:
        self.problems = problems
        self.parser = TableParser(builders(problems))
        self.program_names: frozenset[str] = frozenset()

    def step(self, line: Line) -> Step:
        """Return the step of a line of a program."""
        label, text, at = self._label(line)
        statement = self._statement(text, at) if text else None
        return Step(line.number, label, statement)

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

    def _label(self, line: Line) -> tuple[Label | None, str, int]:
        digits = _DIGITS.match(line.text)
        if digits is None:
            return None, line.text, line.start
        rest = line.text[digits.end() :]
        if rest[:1].isalpha() or rest[:1] == "_":
            return None, line.text, line.start  # `3x = 1`: the tokeniser says what is wrong
        start, end = line.start, line.start + digits.end()
        text = rest.lstrip()
        if rest.startswith("."):
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
            label = Label(int(digits.group()), start, end)
            return label, text, line.end - len(text)
        return None, text, line.end - len(text)

    def _statement(self, text: str, at: int) -> Statement:
        raw = tokenise(text, at, self.problems)
        if not raw:
            first = _FIRST_WORD.match(text)
            word = first.group().upper() if first else None
            return Bad(word, _names_in(text), at, at + len(text))
        tokens, head = classify(raw, self.problems)
        word = head.word
        bad = Bad(structural_word(tokens, head), _names_in(text), at, at + len(text))
        if refuse(self.problems, tokens, head, self.program_names):
            return bad
        node = self.parser.parse("step", tokens)
        if isinstance(node, Failure):
            explain(self.problems, tokens, node, word)
            return bad
        return node


def operands_only(tokens: list[Token]) -> list[Token]:
    """Return tokens with every word that is not an operator as a name."""
    classified, _ = classify([Token("LPAREN", "(", 0, 0), *tokens], Problems.none())
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
        lines = sorted({problems.source.line_of(at) for at in places[1:]})
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


def _names_in(text: str) -> tuple[str, ...]:
    return tuple(dict.fromkeys(key(name) for name in _NAMES.findall(text)))
