"""The words of the language: what each is, and how far vrts goes with it.

The state of a word is found out, not noted: a step that uses it is compiled, and the engine is
asked about the instructions and functions that come of it.
"""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from vrts.engine.code.steps.extent import simulates
from vrts.engine.code.values.known_functions import evaluates
from vrts.ir import instructions as ir
from vrts.ir.module import Module
from vrts.ir.system import PARAMETERS, SWITCHES
from vrts.ir.taken import TAKEN, TAKEN_PARAMETERS, TAKEN_SWITCHES
from vrts.lang.dialect import TITLES, Dialect
from vrts.lang.vocabulary.commands import COMMANDS
from vrts.lang.vocabulary.functions import CONSTANTS, FUNCTIONS, Signature
from vrts.lang.vocabulary.instructions import INSTRUCTIONS
from vrts.lang.vocabulary.lookup import look_up
from vrts.lang.vocabulary.word import Word
from vrts.lang.vocabulary.words import OPERATORS, QUALIFIERS, QUALIFIERS_OF_ONE
from vrts.report.word_samples import (
    NATIVE,
    compiled,
    function_sample,
    home,
    instruction_sample,
    native,
    operator_sample,
    parameter_sample,
    qualifier_sample,
    switch_sample,
)

RUNS = "runs"  # compiled and simulated
COMPILES = "compiles"  # a run stops where it is reached: not simulated yet
OPAQUE = "opaque"  # a run stops where it is reached: never simulated
KNOWN = "known"  # told apart from others, nothing more yet

_COMPANY = (ir.Jump, ir.JumpIf, ir.BeginFor, ir.TestFor, ir.NextFor, ir.BeginCase, ir.TestCase)


class Entry(NamedTuple):
    """What is known of one word."""

    kind: str
    word: str
    dialects: str  # columns of the vocabulary
    usage: str
    about: str
    state: str
    shortest: str = ""  # in VAL-II; empty: not abbreviated
    robot: bool = False
    breaks: bool = False

    @property
    def languages(self) -> str:
        """Names of the languages that have the word."""
        return ", ".join(TITLES[letter] for letter in TITLES if letter in self.dialects)


def entries(
    dialect: Dialect | None = None, kind: str | None = None, word: str | None = None
) -> tuple[Entry, ...]:
    """Return the words of a dialect, or of all; of one kind, or of all; one word, or all."""
    return tuple(e for e in _all(kind, word) if dialect is None or dialect.has(e.dialects))


def _all(kind: str | None, word: str | None) -> Iterator[Entry]:
    def of(known: Iterable[Word]) -> Iterator[Word]:
        return (each for each in known if word in (None, each.text))

    def named(known: Iterable[str]) -> Iterator[str]:
        return (each for each in known if word in (None, each.upper()))

    functions = (f for f in FUNCTIONS.values() if word in (None, f.name.upper()))
    qualifiers = (*QUALIFIERS.values(), *QUALIFIERS_OF_ONE.values())
    makers: dict[str, Iterator[Entry]] = {
        "instruction": map(_instruction, of(INSTRUCTIONS.values())),
        "qualifier": map(_qualifier, of(qualifiers)),
        "operator": map(_operator, of(OPERATORS.values())),
        "function": map(_function, functions),
        "constant": map(_constant, named(CONSTANTS)),
        "switch": map(_switch, named((*SWITCHES, *TAKEN_SWITCHES))),
        "parameter": map(_parameter, named((*PARAMETERS, *TAKEN_PARAMETERS))),
        "command": map(_command, of(COMMANDS.values())),
    }  # made when asked for
    for name, made in makers.items():
        if kind in (None, name):
            yield from sorted(made, key=lambda entry: entry.word.lstrip("$#"))


# --- one entry of each kind -----------------------------------------------------------------------


def _instruction(word: Word) -> Entry:
    sample = instruction_sample(word)
    state = _state(compiled(sample, home(sample, word.dialects)))
    about = (word.dialects, word.usage, word.about)
    shortest = _shortest_instruction(word)
    return Entry("instruction", word.text, *about, state, shortest, word.robot, word.breaks)


def _qualifier(word: Word) -> Entry:
    sample = qualifier_sample(word)
    state = _state(compiled(sample, native(word.dialects)))
    usage = next(line for line in sample.splitlines() if f" {word.text}" in line)
    return Entry("qualifier", word.text, word.dialects, usage, word.about, state)


def _operator(word: Word) -> Entry:
    state = _state(compiled(operator_sample(word), native(word.dialects)))
    return Entry("operator", word.text, word.dialects, word.usage, word.about, state)


def _function(signature: Signature) -> Entry:
    usage = function_sample(signature).partition("= ")[2]
    simulated = RUNS if evaluates(signature.function) else COMPILES
    state = OPAQUE if signature.opaque else simulated
    name = signature.name.upper()
    return Entry("function", name, signature.dialects, usage, signature.about, state)


def _constant(name: str) -> Entry:
    text = name.upper()
    modules = {letter: compiled(f"x = {text}", dialect) for letter, dialect in NATIVE.items()}
    dialects = "".join(letter for letter in TITLES if modules[letter] is not None)
    state = _state(modules[dialects[0]])
    return Entry("constant", text, dialects, text, f"{CONSTANTS[name]:.7g}", state)


def _switch(name: str) -> Entry:
    known = SWITCHES.get(name)
    dialects = TAKEN_SWITCHES[name] if known is None else FUNCTIONS["switch"].dialects
    sample = switch_sample(name, dialects)
    state = _state(compiled(sample, native(dialects)))
    about = TAKEN if known is None else known.about
    return Entry("switch", name, dialects, sample, about, state)


def _parameter(name: str) -> Entry:
    known = PARAMETERS.get(name)
    dialects = TAKEN_PARAMETERS[name] if known is None else FUNCTIONS["parameter"].dialects
    sample = parameter_sample(name)
    state = _state(compiled(sample, native(dialects)))
    about = TAKEN if known is None else known.about
    return Entry("parameter", name, dialects, sample, about, state)


def _command(word: Word) -> Entry:
    state = OPAQUE if word.opaque else RUNS  # a test holds the monitor to it
    shortest = _shortest_command(word, COMMANDS.values())
    return Entry("command", word.text, word.dialects, word.usage, word.about, state, shortest)


# --- states and abbreviations ---------------------------------------------------------------------


def _state(module: Module | None) -> str:
    """Return how far vrts goes with the steps of a sample."""
    if module is None:
        return KNOWN
    code = module.programs["main"].instructions[:-1]
    own = [i for i in code if not isinstance(i, _COMPANY)] or list(code)
    if any(isinstance(instruction, ir.Opaque) for instruction in own):
        return OPAQUE
    return RUNS if all(simulates(instruction) for instruction in own) else COMPILES


def _shortest_instruction(word: Word) -> str:
    """Return the shortest spelling that VAL-II takes for an instruction."""
    if not word.in_val2 or word.full:
        return ""
    for length in range(1, len(word.text)):
        found = look_up(word.text[:length]).word
        if found is not None and found.text == word.text:
            return word.text[:length]
    return ""


def _shortest_command(word: Word, commands: Iterable[Word]) -> str:
    """Return the shortest beginning that no other command has."""
    if word.shortest:
        return word.shortest
    others = [other.text for other in commands if other is not word]
    for length in range(1, len(word.text)):
        start = word.text[:length]
        if not any(other.startswith(start) for other in others):
            return start
    return ""
