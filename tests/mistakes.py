"""How well messages serve beginners: `python -m tests.mistakes`, over `tests/data/mistakes`.

Compiles every program with a mistake and asks: does the first message stand in the right place,
name the cause, and help; are there as many as causes; do the edits make the program that was meant?

--failures   also every case that fails, what fails of it, and what the compiler said
FAMILY ...   only families (or cases) whose name begins so
"""

import re
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from tests.support_mistakes import Mistake, Right, mistakes, right
from vrts.base.diagnostic import Diagnostic, Edit, Severity
from vrts.base.mending import edits_of, mendable, with_edits
from vrts.base.source import SourceFile
from vrts.ir.dump import dump
from vrts.lang.compiler import Compilation, Options, compile_source
from vrts.lang.dialect import Dialect

ROUNDS = 3  # of edits: one may make room for another
COLUMNS = ("place", "cause", "help", "count", "all", "edit", "severity")
STEP = re.compile(r"^(\s*\d+)\s+\d+", re.M)  # index and step of an instruction
QUOTED = re.compile(r"`([^`]*)`")
LONG = 5  # letters: so long a word may have another ending
SHORT = re.compile(  # words of the language that are words of English, too
    "if|do|to|of|by|end|any|for|set|not|and|or|mod|sig|int|val|in|is|on|off|i|f|n|s|o"
)
REMOVE = "remove"  # stands for every way to say so
REMOVED = r"\b(?:remove|delete|drop|without|(?:take|leave)\b.{0,30}\bout)\b"


@dataclass(frozen=True, slots=True)
class Outcome:
    """What holds of the messages about one mistake."""

    place: bool
    cause: bool
    help: bool
    count: bool
    edit: bool | None  # None where no repair is certain
    severity: bool

    @property
    def all(self) -> bool:
        """Whether a beginner is told all that there is to tell, once."""
        return self.place and self.cause and self.help and self.count


class Score(NamedTuple):
    """How many of how many cases hold, by column."""

    held: dict[str, int]
    of: dict[str, int]

    def percent(self, column: str) -> float:
        """Return the share of a column; 100 where nothing was asked."""
        return 100.0 * self.held[column] / self.of[column] if self.of[column] else 100.0


def compiled(text: str, dialect: Dialect | None = None) -> Compilation:
    """Return what compiling a text as VAL-II yields, or in another dialect."""
    return compile_source(SourceFile("main.v2", text), Options(dialect))


def told_once(text: str) -> tuple[Diagnostic, str]:
    """Return the one message about a file, and its first program's body after certain edits."""
    compilation = compiled(text)
    (found,) = said(compilation)
    assert compilation.source is not None
    edits = edits_of(mendable(compilation.source, [found]))
    return found, with_edits(text, edits).split("\n.END")[0].partition("\n")[2]


def said(found: Compilation) -> list[Diagnostic]:
    """Return the errors and warnings, first in the text first, errors before warnings of a line."""
    loud = [d for d in found.diagnostics if d.severity is not Severity.NOTE]
    return sorted(loud, key=lambda d: (_line(d), not d.is_error))


def not_simulated(found: Diagnostic) -> bool:
    """Whether a message is of a word that the simulator does not carry out: right ones have it."""
    return found.severity is Severity.WARNING and found.headline.endswith("is not simulated")


def judge(mistake: Mistake) -> Outcome:
    """Return what holds of the messages about a mistake."""
    found = compiled(mistake.wrong, mistake.dialect)
    messages = [d for d in said(found) if mistake.dialect is None or not not_simulated(d)]
    if not messages:
        nothing = False if mistake.certain else None
        return Outcome(False, False, False, False, nothing, False)
    first = messages[0]
    helps = _help(first)
    told = "\n".join((first.headline, *_labels(first), *first.notes, helps))
    return Outcome(
        place=_line(first) in mistake.lines,
        cause=names_one(told, mistake.about),
        help=names_one(helps, mistake.help),
        count=len(messages) in mistake.count,
        edit=mends(mistake) if mistake.certain else None,
        severity=first.severity.value in mistake.severities,
    )


def mends(mistake: Mistake) -> bool:
    """Return whether the edits of all messages make the program that was meant."""
    meaning = _meaning(compiled(mistake.meant, mistake.dialect))
    text = mistake.wrong
    for _ in range(ROUNDS):
        found = compiled(text, mistake.dialect)
        if meaning is not None and _meaning(found) == meaning:
            return True
        text = _edited(text, edits_of(said(found)))
    return meaning is not None and _meaning(compiled(text, mistake.dialect)) == meaning


def names_one(text: str, words: Sequence[str]) -> bool:
    """Return whether a text says one of some words, as the README beside the cases has it."""
    quoted = "\n".join(QUOTED.findall(text))
    return any(_has(text, quoted, word) for word in words)


def score(outcomes: Sequence[Outcome]) -> Score:
    """Return how many outcomes hold, by column."""
    asked = {c: [v for o in outcomes if (v := getattr(o, c)) is not None] for c in COLUMNS}
    return Score({c: sum(v) for c, v in asked.items()}, {c: len(v) for c, v in asked.items()})


def false_warnings(programs: Sequence[Right]) -> list[tuple[Right, Diagnostic]]:
    """Return the right programs of which the compiler complains, and its first complaint.

    That the simulator does not carry out a word is true, and no complaint of the program.
    """
    messages = ((program, said(compiled(program.text))) for program in programs)
    complaints = ((one, [d for d in found if not not_simulated(d)]) for one, found in messages)
    return [(program, found[0]) for program, found in complaints if found]


def _line(found: Diagnostic) -> int:
    return found.primary.span.line if found.primary is not None else 0


def _labels(found: Diagnostic) -> list[str]:
    labels = ([found.primary] if found.primary is not None else []) + list(found.secondary)
    return [label.text for label in labels]


def _help(found: Diagnostic) -> str:
    edit = [f"`{edit.replacement}`" for edit in edits_of([found])]
    return "\n".join((*found.help, *edit))


def _has(text: str, quoted: str, word: str) -> bool:
    if word == REMOVE:
        return re.search(REMOVED, text, re.I) is not None
    if not any(map(str.isalnum, word)):
        return word in quoted
    end = "" if len(word) >= LONG else r"(?!\w)"
    pattern = rf"(?<!\w){re.escape(word)}{end}"
    if SHORT.fullmatch(word):
        return bool(re.search(rf"\b{word.upper()}\b", text) or re.search(pattern, quoted, re.I))
    return re.search(pattern, text, re.I) is not None


def _edited(text: str, edits: Sequence[Edit]) -> str:
    end = len(text)
    for edit in sorted(edits, key=lambda edit: edit.span.start, reverse=True):
        if edit.span.end <= end:
            text = text[: edit.span.start] + edit.replacement + text[edit.span.end :]
            end = edit.span.start
    return text


def _meaning(found: Compilation) -> str | None:
    return STEP.sub(r"\1", dump(found.module)) if found.module is not None else None


def _row(name: str, outcomes: Sequence[Outcome]) -> str:
    got = score(outcomes)
    shares = (
        f"{got.percent(column):9.1f}" if got.of[column] else " " * 8 + "-" for column in COLUMNS
    )
    return f"{name:26}{len(outcomes):5}{''.join(shares)}"


def _failure(mistake: Mistake, outcome: Outcome) -> str:
    lost = [c for c in COLUMNS if c != "all" and getattr(outcome, c) is False]
    lines = [f"\n{mistake.family}/{mistake.name}: {', '.join(lost)}"]
    for found in said(compiled(mistake.wrong, mistake.dialect)):
        lines.append(f"  {_line(found)}: {found.severity.value}: {found.headline}")
        lines += [f"     help: {line}" for line in _help(found).splitlines()]
    expected = "/".join(map(str, sorted(mistake.lines)))
    lines.append(f"  expected at {expected}: {' | '.join(mistake.about)}")
    lines.append(f"     help: {' | '.join(mistake.help)}")
    return "\n".join(lines)


def main(arguments: Sequence[str]) -> None:
    """Print the score of every family, and of all."""
    chosen = tuple(a for a in arguments if not a.startswith("--"))
    cases = [m for m in mistakes() if not chosen or m.family.startswith(chosen) or m.name in chosen]
    outcomes = {mistake: judge(mistake) for mistake in cases}
    print(f"{'family':26}{'cases':>5}{''.join(f'{column:>9}' for column in COLUMNS)}")
    for family in sorted({mistake.family for mistake in cases}):
        print(_row(family, [o for m, o in outcomes.items() if m.family == family]))
    print(_row("all families", list(outcomes.values())))
    programs = right()
    blamed = false_warnings(programs)
    print(f"\nright programs of which the compiler complains: {len(blamed)} of {len(programs)}")
    if "--failures" in arguments:
        for mistake, outcome in outcomes.items():
            if not outcome.all or outcome.edit is False or not outcome.severity:
                print(_failure(mistake, outcome))
        for program, found in blamed:
            print(f"\nright/{program.family}/{program.name} {_line(found)}: {found.headline}")


if __name__ == "__main__":
    main(sys.argv[1:])
