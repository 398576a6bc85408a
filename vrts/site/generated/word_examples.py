"""The example of a word: a case of the spec where there is one, else a step that uses the word.

The cases are executed by `tests/spec`, with what the page shows of them. The steps are those by
which `vrts support` finds out how far vrts goes with a word; a test executes them.
"""

import re
from pathlib import Path
from typing import NamedTuple

from vrts.lang.dialect import DIALECTS
from vrts.lang.vocabulary.functions import FUNCTIONS
from vrts.lang.vocabulary.instructions import INSTRUCTIONS
from vrts.lang.vocabulary.words import OPERATORS, QUALIFIERS, QUALIFIERS_OF_ONE
from vrts.report.support import Entry
from vrts.report.word_samples import (
    function_sample,
    instruction_sample,
    native,
    operator_sample,
    qualifier_sample,
)
from vrts.site.generated.spec_cases import (
    MOST_LINES,
    Dialogue,
    SpecCase,
    dialogues,
    run_cases,
)

_ANYWHERE = {"GOTO", "OF", "THEN", "TO", "STEP", "DO"}  # instructions that need not come first


class Cases(NamedTuple):
    """Everything that examples are chosen from."""

    runs: tuple[SpecCase, ...]
    dialogues: tuple[Dialogue, ...]


def all_cases(spec: Path) -> Cases:
    """Read the folder `tests/spec`."""
    return Cases(run_cases(spec), dialogues(spec))


def case_of(entry: Entry, cases: Cases) -> SpecCase | None:
    """Return the shortest case that shows a word, one whose heading names it before others."""
    shown = [case for case in cases.runs if _shows(case, entry)]
    return min(shown, key=lambda case: _rank(case, entry), default=None)


def dialogue_of(entry: Entry, cases: Cases) -> Dialogue | None:
    """Return the shortest conversation in which a command is given."""
    shown = [found for found in cases.dialogues if entry.word in found.commands]
    return min(
        shown,
        key=lambda found: (not _names(found.title, entry.word), len(found.transcript)),
        default=None,
    )


def sample_of(entry: Entry) -> str:
    """Return steps that use a word."""
    if entry.kind == "instruction":
        return instruction_sample(INSTRUCTIONS[entry.word])
    if entry.kind == "function":
        return function_sample(FUNCTIONS[entry.word.lower()])
    if entry.kind == "operator":
        return operator_sample(OPERATORS[entry.word])
    if entry.kind == "constant":
        return f"x = {entry.word}"
    if entry.kind == "qualifier":
        return qualifier_sample({**QUALIFIERS_OF_ONE, **QUALIFIERS}[entry.word])
    return entry.usage


def sample_program(entry: Entry) -> tuple[str, str]:
    """Return a program around these steps, and the name of its dialect."""
    steps = sample_of(entry)
    indented = "\n".join(_indented(line) for line in steps.splitlines())
    head = ".PROGRAM main(v[], $v[])" if re.search(r"\$?v\[", steps) else ".PROGRAM main"
    return f"{head}\n{indented}\n.END\n", native(entry.dialects).name


def _indented(line: str) -> str:
    label = re.match(r"(\d+) (.*)", line)
    return f"{label[1]:<8}{label[2]}" if label else f"        {line}"


def _shows(case: SpecCase, entry: Entry) -> bool:
    if case.lines > MOST_LINES or not set(DIALECTS[case.dialect].letters) & set(entry.dialects):
        return False
    if entry.kind == "instruction" and entry.word not in _ANYWHERE:
        return entry.word in case.firsts
    if entry.kind in ("function", "operator", "constant", "qualifier"):
        return entry.word in case.words and not (
            entry.kind == "function" and _first_only(case, entry)
        )
    return entry.word in case.words


def _first_only(case: SpecCase, entry: Entry) -> bool:
    """Return whether a word stands nowhere but at the beginning of steps: there it is another."""
    found = re.findall(rf"(?<![\w.$#]){re.escape(entry.word)}(?![\w.])", case.program)
    first = re.findall(rf"^\s*(?:\d+\s+)?{re.escape(entry.word)}(?![\w.])", case.program, re.M)
    return len(found) <= len(first)


def _rank(case: SpecCase, entry: Entry) -> tuple[bool, bool, int, int, str]:
    stops = any(kind == "error" for kind, _, _ in case.parts)
    return (not _names(case.title, entry.word), stops, len(case.words), case.lines, case.where)


def _names(title: str, word: str) -> bool:
    return re.search(rf"(?<![\w.]){re.escape(word)}(?![\w.])", title) is not None
