"""What the vocabulary says of a word of the language, without compiling anything."""

from collections.abc import Iterator, Mapping
from functools import cache
from typing import NamedTuple

from vrts.ir.system import PARAMETERS, SWITCHES
from vrts.ir.taken import TAKEN, TAKEN_PARAMETERS, TAKEN_SWITCHES
from vrts.lang.dialect import TITLES
from vrts.lang.vocabulary.commands import COMMANDS
from vrts.lang.vocabulary.function_forms import form_of
from vrts.lang.vocabulary.functions import CONSTANTS, FUNCTIONS
from vrts.lang.vocabulary.instructions import INSTRUCTIONS
from vrts.lang.vocabulary.words import OPERATORS, QUALIFIERS, QUALIFIERS_OF_ONE

_SYSTEM = "2+"  # columns of switches and parameters


class Fact(NamedTuple):
    """One thing that a word is."""

    word: str
    kind: str
    dialects: str  # columns of the vocabulary
    form: str  # how it is written
    about: str
    simulated: bool = True
    robot: bool = False
    breaks: bool = False

    @property
    def text(self) -> str:
        """What is known of it, for a terminal."""
        languages = ", ".join(TITLES[letter] for letter in TITLES if letter in self.dialects)
        rows = [f"{self.word}  ({self.kind} of {languages})", f"  {self.about}"]
        rows.append(f"  write      {self.form}")
        if self.robot:
            rows.append("  needs      the robot: not in process control programs")
        if self.breaks:
            rows.append("  waits      until the arm stands still")
        if not self.simulated:
            rows.append("  in vrts    not simulated: a run stops there")
        return "\n".join(rows)


@cache
def facts() -> Mapping[str, tuple[Fact, ...]]:
    """Return what is known of every word, by the word in capitals."""
    found: dict[str, list[Fact]] = {}
    for fact in _all():
        found.setdefault(fact.word, []).append(fact)
    return {word: tuple(each) for word, each in found.items()}


@cache
def own_words() -> frozenset[str]:
    """Return the words of VAL-II itself."""
    return frozenset(f.word for each in facts().values() for f in each if "2" in f.dialects)


def _all() -> Iterator[Fact]:
    for word in INSTRUCTIONS.values():
        about = (word.dialects, word.usage, word.about, not word.opaque, word.robot, word.breaks)
        yield Fact(word.text, "instruction", *about)
    for word in (*QUALIFIERS.values(), *QUALIFIERS_OF_ONE.values()):
        yield Fact(word.text, "qualifier", word.dialects, word.usage, word.about)
    for word in OPERATORS.values():
        yield Fact(word.text, "operator", word.dialects, word.usage, word.about)
    for signature in FUNCTIONS.values():
        name, form = signature.name.upper(), form_of(signature)
        form = form if signature.parameters else name
        about = (signature.dialects, form, signature.about, not signature.opaque)
        yield Fact(name, "function", *about)
    for name, value in CONSTANTS.items():
        yield Fact(name.upper(), "constant", "2+a", name.upper(), f"{value:.7g}")
    for switch in SWITCHES.values():
        yield Fact(switch.name, "switch", _SYSTEM, f"ENABLE {switch.name}", switch.about)
    for each in PARAMETERS.values():
        yield Fact(each.name, "parameter", _SYSTEM, f"PARAMETER {each.name} = x", each.about)
    for name, dialects in TAKEN_SWITCHES.items():
        yield Fact(name, "switch", dialects, f"ENABLE {name}", TAKEN)
    for name, dialects in TAKEN_PARAMETERS.items():
        yield Fact(name, "parameter", dialects, f"PARAMETER {name} = x", TAKEN)
    for word in COMMANDS.values():
        kind = "command of the monitor"
        yield Fact(word.text, kind, word.dialects, word.usage, word.about, not word.opaque)
