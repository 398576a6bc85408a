"""The words of the language: what each is, and how far vrts goes with it.

The state of a word is found out, not noted: a step that uses it is compiled, and the engine is
asked about the instructions and functions that come of it.
"""

from collections.abc import Iterator
from typing import NamedTuple

from vrts.base.source import SourceFile
from vrts.engine.extent import evaluates, simulates
from vrts.ir import instructions as ir
from vrts.ir.module import Module
from vrts.ir.system import PARAMETERS, SWITCHES
from vrts.ir.values import Type
from vrts.lang.command import parse_command
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import AS, DIALECTS, TITLES, VAL, VAL2, VPLUS, Dialect
from vrts.lang.vocabulary.commands import COMMANDS
from vrts.lang.vocabulary.functions import CONSTANTS, FUNCTIONS, Signature
from vrts.lang.vocabulary.instructions import INSTRUCTIONS
from vrts.lang.vocabulary.lookup import look_up
from vrts.lang.vocabulary.word import Word
from vrts.lang.vocabulary.words import OPERATORS, QUALIFIERS

RUNS = "runs"  # compiled and simulated
COMPILES = "compiles"  # a run stops where it is reached: not simulated yet
OPAQUE = "opaque"  # a run stops where it is reached: never simulated
KNOWN = "known"  # told apart from others, nothing more yet

KINDS = (
    "instruction",
    "qualifier",
    "operator",
    "function",
    "constant",
    "switch",
    "parameter",
    "command",
)

_NATIVE = {"2": VAL2, "+": VPLUS, "a": AS, "1": VAL}
_SAMPLES = {  # where the usage needs company to be a program
    "IF": "IF n THEN\nEND",
    "ELSE": "IF n THEN\nELSE\nEND",
    "END": "IF n THEN\nEND",
    "WHILE": "WHILE n DO\nEND",
    "DO": "DO\nUNTIL n",
    "UNTIL": "DO\nUNTIL n",
    "FOR": "FOR i = 1 TO n STEP 2\nEND",
    "CASE": "CASE n OF\nVALUE 1:\nEND",
    "VALUE": "CASE n OF\nVALUE 1:\nEND",
    "ANY": "CASE n OF\nANY\nEND",
    "SCASE": 'SCASE $s OF\nSVALUE "a":\nEND',
    "SVALUE": 'SCASE $s OF\nSVALUE "a":\nEND',
    "GOTO": "GOTO 10\n10 READY",
    "GRASP": "GRASP 10, 10\n10 READY",
    "IFSIG": "IFSIG 1 THEN 10\n10 READY",
    "EXIT": "DO\nEXIT 1\nUNTIL n",
    "NEXT": "DO\nNEXT 1\nUNTIL n",
    "TYPE": 'TYPE "text", value',
    "ATTACH": "ATTACH (0)",
    "DETACH": "DETACH (0)",
    "WRITE": 'WRITE (4) "text"',
}
_ARGUMENTS = {"r": "1", "s": '"a"', "p": "p", "l": "p", "v": "v[1]", "$": "$s", "f": "1"}
_TARGETS = {
    Type.REAL: "x = ",
    Type.STRING: "$x = ",
    Type.POSE: "SET q = ",
    Type.JOINTS: "SET #q = ",
}
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


def entries(dialect: Dialect | None = None, kind: str | None = None) -> tuple[Entry, ...]:
    """Return the words of a dialect, or of all; of one kind, or of all."""
    return tuple(
        entry
        for entry in _all(kind)
        if dialect is None or dialect.has(entry.dialects) or not entry.dialects
    )


def _all(kind: str | None) -> Iterator[Entry]:
    makers = {
        "instruction": lambda: (_instruction(word) for word in INSTRUCTIONS.values()),
        "qualifier": lambda: (_part("qualifier", word) for word in QUALIFIERS.values()),
        "operator": lambda: (_part("operator", word) for word in OPERATORS.values()),
        "function": lambda: (_function(signature) for signature in FUNCTIONS.values()),
        "constant": lambda: (
            Entry("constant", name.upper(), "12+a", name.upper(), f"{value:g}", RUNS)
            for name, value in CONSTANTS.items()
        ),
        "switch": lambda: (
            Entry("switch", s.name, "12+a", f"ENABLE {s.name}", s.about, COMPILES)
            for s in SWITCHES.values()
        ),
        "parameter": lambda: (
            Entry("parameter", p.name, "12+a", f"PARAMETER {p.name} = value", p.about, COMPILES)
            for p in PARAMETERS.values()
        ),
        "command": lambda: (_command(word) for word in COMMANDS.values()),
    }
    for name, make in makers.items():
        if kind in (None, name):
            yield from sorted(make(), key=lambda entry: entry.word.lstrip("$#"))


# --- states ---------------------------------------------------------------------------------------


def native(dialects: str) -> Dialect:
    """Return the dialect in which a word is at home."""
    return next(dialect for letter, dialect in _NATIVE.items() if letter in dialects)


def sample(word: Word) -> str:
    """Return the steps of a program that uses an instruction."""
    return _SAMPLES.get(word.text, word.usage)


def function_sample(signature: Signature) -> str:
    """Return a step that uses a function."""
    arguments = [_ARGUMENTS.get(code[0], "CP") for code in signature.parameters]
    if signature.name == "parameter":
        arguments[0] = "HAND.TIME"
    if signature.name == "$unpack":
        arguments[0] = "$v[1]"
    if signature.name == "instr":
        arguments = ["1", '"abc"', '"b"']
    inner = ",".join(arguments)
    if signature.by is not None:
        inner = f"{arguments[0]} BY {','.join(arguments[1:])}"
    call = f"({inner})" if signature.parameters else ""
    return f"{_TARGETS[signature.result]}{signature.name.upper()}{call}"


def compiled(steps: str, dialect: Dialect) -> Module | None:
    """Return the module of a program with some steps."""
    text = f".PROGRAM main(v[], $v[])\n{steps}\n.END\n"
    return compile_source(SourceFile("sample", text), Options(dialect)).module


def _instruction(word: Word) -> Entry:
    module = compiled(sample(word), native(word.dialects))
    state = KNOWN if module is None else _state(word, module)
    return Entry(
        "instruction",
        word.text,
        word.dialects,
        word.usage,
        word.about,
        state,
        _shortest(word),
        word.robot,
        word.breaks,
    )


def _state(word: Word, module: Module) -> str:
    code = module.programs["main"].instructions[:-1]
    own = [i for i in code if not isinstance(i, _COMPANY)] or list(code)
    if any(isinstance(instruction, ir.Opaque) for instruction in own):
        return OPAQUE
    return RUNS if all(simulates(instruction) for instruction in own) else COMPILES


def _function(signature: Signature) -> Entry:
    usage = function_sample(signature).partition("= ")[2]
    simulated = RUNS if evaluates(signature.function) else COMPILES
    state = OPAQUE if signature.opaque else simulated
    name = signature.name.upper()
    return Entry("function", name, signature.dialects, usage, signature.about, state)


def _part(kind: str, word: Word) -> Entry:
    return Entry(kind, word.text, word.dialects, word.usage, word.about, RUNS)


def _command(word: Word) -> Entry:
    command, _ = parse_command(SourceFile("command", f"{word.text} main"))
    state = KNOWN if command is None else RUNS
    return Entry("command", word.text, word.dialects, word.usage, word.about, state)


def _shortest(word: Word) -> str:
    """Return the shortest spelling that VAL-II takes for an instruction."""
    if not word.in_val2 or word.full:
        return ""
    for length in range(1, len(word.text)):
        found = look_up(word.text[:length]).word
        if found is not None and found.text == word.text:
            return word.text[:length]
    return ""


# --- text -----------------------------------------------------------------------------------------


def table(found: tuple[Entry, ...]) -> str:
    """Return a table of words, one line each, with what the marks mean below."""
    words = max(len(entry.word) for entry in found)
    languages = max(len(entry.languages) for entry in found)
    rows: list[str] = []
    kind = ""
    for entry in found:
        if entry.kind != kind:
            kind = entry.kind
            rows += ["", f"{kind}s"] if rows else [f"{kind}s"]
        marks = ("R" if entry.robot else " ") + ("B" if entry.breaks else " ")
        rows.append(
            f"  {entry.word:<{words}}  {entry.state:<8}  {marks}  "
            f"{entry.languages:<{languages}}  {entry.about}".rstrip()
        )
    rows += [
        "",
        "R moves or sets up the robot, so not in process control programs; B waits for the arm",
        "runs: compiled and simulated; compiles: a run stops there, not simulated yet;",
        "opaque: a run stops there, never simulated; known: told apart, not read yet",
    ]
    return "\n".join(rows)


def card(entry: Entry) -> str:
    """Return all that is known of one word."""
    rows = [f"{entry.word}  ({entry.kind} of {entry.languages})", f"  {entry.about}"]
    rows.append(f"  write      {entry.usage}")
    if entry.shortest:
        rows.append(f"  shortest   {entry.shortest}")
    if entry.robot:
        rows.append("  marks      [R] for the robot: not in process control programs")
    if entry.breaks:
        rows.append("  marks      breaks continuous path: waits until the arm stands still")
    rows.append(f"  in vrts    {entry.state}")
    return "\n".join(rows)


def as_json(found: tuple[Entry, ...]) -> dict[str, object]:
    """Return words for JSON."""
    return {
        "schema": "vrts.support/1",
        "words": [{**entry._asdict(), "languages": entry.languages.split(", ")} for entry in found],
    }


__all__ = ["DIALECTS", "KINDS", "Entry", "as_json", "card", "entries", "table"]
