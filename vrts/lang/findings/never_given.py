"""Names that nothing gives a value: what their writer most likely meant instead."""

import re
from collections.abc import Callable
from typing import NamedTuple

from vrts.ir.values import Type
from vrts.lang.findings.names.untaught import TEACH, teaches
from vrts.lang.meaning.resolve import Resolver
from vrts.lang.meaning.scope import Entry, Place
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.steps.idioms.hand import parted_word
from vrts.lang.steps.misread.foreign.inputs import NAMES, input_at
from vrts.lang.syntax.expressions import Expression, Infix, Name, Parenthesised, Prefix
from vrts.lang.vocabulary.functions import FOREIGN_FUNCTIONS
from vrts.lang.vocabulary.instructions import INSTRUCTIONS

_FORMAT = re.compile(r"[FIGE]\d+(\.\d+)?", re.IGNORECASE)
_ELSEWHERE = {  # names that other languages give a value, and what VAL-II has
    "high": "ON",
    "low": "OFF",
    "yes": "TRUE",
    "no": "FALSE",
    "toc": "TIMER(1)",
}
_NOTHING = frozenset({"none", "nil", "nan", "undefined", "null", "empty"})  # of other languages
_COMPARED = re.compile(r"(?P<of>[$#]?[A-Za-z][\w.]*(?:\[[^\]]*\])?)[ \t]*(?P<sign>==|<>)[ \t]*$")
_JOINT = re.compile(r"(?:j|jt|joint|axis|a|axe|gelenk)[_.]?([1-6])")
_NAMED = re.compile(r"[$#]?[A-Za-z][\w.]*", re.ASCII)
_SIGNAL = re.compile(r"(?P<kind>[A-Z]+)[_.]?(?P<number>\d+)", re.IGNORECASE)
_OF_SIGNALS = re.compile(r"\b(SIGNAL|SIG|REACTI?)\b[^;]*$", re.IGNORECASE)
_OF_A_NUMBER = frozenset({"IGNORE", "LOCK", "SIGNAL", "REACT", "REACTI", "SPEED", "DELAY"})
_FIRST = re.compile(r"[ \t]*(?:\d+[ \t]+)?(?P<word>[A-Za-z]+)[ \t]+-?", re.ASCII)
_VALUES = frozenset({"rnd", "rand", "clock", "random"})  # of other languages, bare
_FIRST_INPUT = 1001
_JOINT_ANGLES = re.compile(
    r"[ \t]*[A-Za-z][\w.]*[ \t]*=?"
    r"(?P<values>(?:[ \t]*,?[ \t]*[-+]?[.\d]+(?![.\d])){6})[ \t\r]*",
    re.ASCII,
)
_A_NUMBER = re.compile(r"[-+]?(?:\d+(?:\.\d*)?|\.\d+)")
_PROGRAM = re.compile(r"\.PROGRAM", re.IGNORECASE | re.ASCII)
_BLOCK = re.compile(
    r"^[ \t]*(?:\d+[ \t]+)?(?P<word>FOR|IF|WHILE|CASE|END)\b(?P<rest>"
    r"(?:[ \t]+(?P<counter>[A-Za-z][\w.]*)[ \t]*=(?!=))?.*)$",
    re.IGNORECASE | re.MULTILINE,
)
_SHORT = 2  # letters of names that count
_JOINTS = 6
_FULL_TURN = 360.0
_NEAREST = 300.0  # [mm] from the shoulder, where hardly any arm brings its tool [assumed]
_INPUTS = frozenset({"I", "IN", "DI", "X", "INPUT", "E"})
_OUTPUTS = frozenset({"O", "OUT", "DO", "Y", "OUTPUT", "DOUT", "A", "Q"})
_COORDINATES = {"x": "DX", "y": "DY", "z": "DZ"}
_ANGLES = frozenset({"o", "a", "t", "rx", "ry", "rz"})


class Guess(NamedTuple):
    """What helps, and what to write at which place where that is clear."""

    help: str
    at: Place
    instead: str | None = None


def guess(resolver: Resolver, entry: Entry, at: Place, like: Callable[[], str | None]) -> Guess:
    """Return what was meant by a name without a value, read first at a place.

    Args:
        resolver: What is known of all names.
        entry: The name.
        at: Its first use.
        like: Finds the name with a value that is most like it.
    """
    name, upper = entry.name, entry.name.upper()
    location = entry.type in (Type.POSE, Type.JOINTS)
    written = _NAMED.match(resolver.problems.source.text, at[0], at[1])
    alone = (at[0], written.end()) if written is not None else at  # without its subscript
    hand = _hand(resolver.problems, at)
    if hand is not None:
        return hand
    if name.endswith("."):
        meant = name.rstrip(".")
        return Guess(f"the `.` belongs to the name: take it out, and write `{meant}`", at, meant)
    pointed = resolver.scope.entries.get(f"{name}.")
    if pointed is not None and pointed.writes:
        return Guess(f"take the point out of `{pointed.name}`: it belongs to the name", at)
    if entry.values and only_of_itself(entry):
        first = '""' if name[0] == "$" else "0"
        return Guess(f"give it its first value before, as in `{name} = {first}`", at)
    special = (
        _format(resolver.problems, at)
        or _signal(resolver.problems, at)
        or (_input(resolver.problems, at) if name in NAMES else None)
    )
    if special is not None:
        return special
    nothing = _asked_for_nothing(resolver.problems, at) if name in _NOTHING else None
    if nothing is not None:
        return nothing
    joint = _JOINT.fullmatch(name)
    if joint is not None and _drives(resolver.problems, at):
        return Guess(f"a joint is a number: write `{joint[1]}`", at, joint[1])
    if name in _ELSEWHERE:
        return Guess(f"write `{_ELSEWHERE[name]}`", at, _ELSEWHERE[name])
    other = _other_sign(resolver, entry)
    if other:
        line = _line_of_joints(resolver, other) if name[0] == "#" else 0
        if line:
            help_ = f"write `{name}` in line {line}: its six numbers look like joint angles"
            return Guess(help_, at)
        help_ = f"did you mean `{other}`? `{name}` and `{other}` are two locations"
        return Guess(help_, at, other)
    if name in resolver.scope.programs and not (location and not teaches(resolver.problems)):
        asked = None if location else _asked_for(resolver.problems, at)
        if asked is not None:
            return asked
        help_ = f"`{name}` is a program: write `CALL {name}` on a line of its own"
        return Guess(help_, at)
    part = part_of_location(resolver, entry)
    if part is not None:
        of, function = part
        why = "a `.` is a letter of names, and takes nothing out of a location"
        if not function:
            return Guess(f"{why}: `DX({of})`, `DY({of})`, `DZ({of})` do, and no angles", at)
        return Guess(f"write `{function}({of})`: {why}", at, f"{function}({of})")
    string = resolver.scope.entries.get(f"${name}") if name[0] not in "$#" else None
    if string is not None and string.writes and not location:
        return Guess(
            f"did you mean `${name}`? The name of a string begins with `$`", alone, f"${name}"
        )
    number = resolver.scope.entries.get(name[1:]) if name[0] == "$" else None
    if number is not None and number.writes and number.type is not Type.STRING:
        (first, *_) = sorted(number.writes)
        line = resolver.problems.source.line_of(first[0])
        help_ = f"write `{name}` in line {line} too: `{number.name}` without `$` is a number"
        return Guess(help_, at)
    counted = "" if location else _counted(resolver.problems, name, at)
    if counted:
        help_ = f"did you mean `{counted}`, which this FOR counts?"
        return Guess(help_, at, counted)
    if name in FOREIGN_FUNCTIONS and not location and name in _VALUES:
        return Guess(FOREIGN_FUNCTIONS[name], at)
    meant = like()
    if meant is not None:
        return Guess(f"did you mean `{meant}`?", alone, meant)
    if location and upper in INSTRUCTIONS and _stands_alone(upper):
        return _written_alone(resolver.problems, upper, at)
    if location:
        return Guess(TEACH, at)
    if _is_typed(resolver.problems, at) and entry.type is not Type.STRING:
        help_ = f'for text write `"{name}"`, between double quotes; '
        return Guess(f"{help_}else give it a value before it is used", at)
    return Guess("give it a value before it is used", at)


def _written_alone(problems: Problems, word: str, at: Place) -> Guess:
    """`MOVE READY`: an instruction where MOVE takes its location."""
    text = problems.source.text
    begin = text.rfind("\n", 0, at[0]) + 1
    found = re.fullmatch(r"[ \t\d]*(?P<word>MOVES?[ \t]+)", text[begin : at[0]], re.IGNORECASE)
    help_ = f"{word} is an instruction: write it alone"
    if found is None or text[at[1] :].partition("\n")[0].partition(";")[0].strip():
        return Guess(help_, at)
    return Guess(help_, (begin + found.start("word"), at[1]), word)


def only_of_itself(entry: Entry) -> bool:
    """Return whether a variable gets its values from itself alone: `n = n+1`, and no `n = 0`."""
    if entry.slot is not None or entry.passed or entry.changed or entry.array is not None:
        return False
    if not entry.values or len(entry.values) != len(entry.writes) or entry.asked:
        return False
    return all(_reads(value, entry.name) for value in entry.values)


def _asked_for_nothing(problems: Problems, at: Place) -> Guess | None:
    """`IF found == None`: whether a variable has a value."""
    text = problems.source.text
    found = _COMPARED.search(text[text.rfind("\n", 0, at[0]) + 1 : at[0]])
    if found is None:
        return None
    instead = f"DEFINED({found['of']})"
    if found["sign"] == "==":
        instead = f"NOT {instead}"
    return Guess(
        f"to ask whether it has a value write `{instead}`",
        (at[0] - len(found.group()), at[1]),
        instead,
    )


def _counted(problems: Problems, name: str, at: Place) -> str:
    """Return the variable of the FOR around a place, where a short name is surely meant for it."""
    if len(name) > _SHORT or not name.isalpha():
        return ""
    text = problems.source.text
    begins = [found.start() for found in _PROGRAM.finditer(text, 0, at[0])]
    above = text[begins[-1] + 1 if begins else 0 : at[0]]
    open_: list[str] = []
    for found in _BLOCK.finditer(above):
        word = found["word"].upper()
        if word == "END":
            del open_[-1:]
        elif word != "IF" or "GOTO" not in found["rest"].upper():
            open_.append(found["counter"] or "")
    counters = [counter for counter in open_ if counter]
    return counters[0] if len(counters) == 1 and len(counters[0]) <= _SHORT else ""


def _drives(problems: Problems, at: Place) -> bool:
    """Whether a name stands where DRIVE takes its joint."""
    text = problems.source.text
    line = text[text.rfind("\n", 0, at[0]) + 1 : at[0]]
    return re.fullmatch(r"[ \t]*(?:\d+[ \t]+)?DRIVE[ \t]+", line, re.IGNORECASE) is not None


def _reads(value: Expression, name: str) -> bool:
    match value:
        case Name(text):
            return key(text) == name
        case Parenthesised(inner) | Prefix(_, inner):
            return _reads(inner, name)
        case Infix(_, left, right):
            return _reads(left, name) or _reads(right, name)
        case _:
            return False


def part_of_location(resolver: Resolver, entry: Entry) -> tuple[str, str] | None:
    """Return the location and the function that `pick.z` means, if `pick` is a location.

    The function is empty where the language has none: of angles.
    """
    of, _, part = entry.name.rpartition(".")
    known = resolver.scope.entries.get(of) if of else None
    if known is None or known.type is not Type.POSE or entry.type is Type.POSE:
        return None
    if part in _COORDINATES:
        return of, _COORDINATES[part]
    return (of, "") if part in _ANGLES else None


def _hand(problems: Problems, at: Place) -> Guess | None:
    """`CLOSE I`, which closes the hand by as much as a variable `i` says."""
    source = problems.source
    number = source.line_of(at[0])
    parted = parted_word(source.line_text(number))
    if parted is None:
        return None
    word, begin = parted
    start = source.line_starts[number - 1] + begin
    return Guess(f"did you mean `{word}`? It is one word, and acts at once", (start, at[1]), word)


def _format(problems: Problems, at: Place) -> Guess | None:
    """`TYPE x /F6.2`, which divides by a variable, and `TYPE F6.2, x`."""
    text = problems.source.text
    written = text[at[0] : at[1]]
    if not _is_typed(problems, at) or _FORMAT.fullmatch(written) is None:
        return None
    before = text[: at[0]].rstrip()
    if before.endswith("/"):
        return Guess(f"a format stands before its number, with a comma: `/{written}, x`", at)
    return Guess(f"a format begins with `/`: write `/{written}`", at, f"/{written}")


def _signal(problems: Problems, at: Place) -> Guess | None:
    """`SIGNAL DO5`, `SIG(IN3)`: signals have numbers, and no names."""
    text = problems.source.text
    found = _SIGNAL.fullmatch(text[at[0] : at[1]])
    line = text[text.rfind("\n", 0, at[0]) + 1 : at[0]]
    if found is None or _OF_SIGNALS.search(line) is None:
        return None
    kind, number = found["kind"].upper(), int(found["number"])
    if kind in _INPUTS and number < _FIRST_INPUT:
        number += _FIRST_INPUT - 1
    elif kind not in _OUTPUTS:
        return None
    return Guess(f"signals have numbers: write `{number}`", at, str(number))


def _input(problems: Problems, at: Place) -> Guess | None:
    """`WAIT DI[1]`: an input as an element of an array."""
    found = input_at(problems.source.text, at[0])
    if found is None:
        return None
    help_ = f"an input is asked for by SIG: write `{found.instead}`, as input 1 is signal 1001"
    return Guess(help_, (found.start, found.end), found.instead)


def _asked_for(problems: Problems, at: Place) -> Guess | None:
    """`IGNORE fence`, `LOCK fence`: the name of a program where a number belongs."""
    text = problems.source.text
    name = text[at[0] : at[1]]
    line = text[text.rfind("\n", 0, at[0]) + 1 : at[0]]
    first = _FIRST.fullmatch(line)
    word = INSTRUCTIONS.get(first["word"].upper()) if first is not None else None
    if word is None or word.text not in _OF_A_NUMBER:
        return None
    wanted = f"`{name}` is a program, and {word.text} takes {word.operands[0]}"
    if word.text != "IGNORE":
        return Guess(f"{wanted}: write `{word.usage}`", at)
    behind = rf"^[ \t\d]*REACTI?[ \t]+(?P<signal>-?\d+)[ \t]*,[ \t]*{re.escape(name)}(?![\w.])"
    watched = {found["signal"] for found in re.finditer(behind, text, re.IGNORECASE | re.MULTILINE)}
    if len(watched) != 1:
        return Guess(f"{wanted}: write `IGNORE 1001`, with the number that its REACT names", at)
    (signal,) = watched
    return Guess(f"{wanted}: write `IGNORE {signal}`, as in the REACT of `{name}`", at, signal)


def _other_sign(resolver: Resolver, entry: Entry) -> str:
    """Return `#safe` for `safe`, or the other way round, where only that has a value."""
    name = entry.name[1:] if entry.name[0] == "#" else f"#{entry.name}"
    found = resolver.scope.entries.get(name)
    location = entry.type in (Type.POSE, Type.JOINTS)
    fits = found is not None and found.writes and found.type in (Type.POSE, Type.JOINTS)
    return name if location and fits else ""


def _line_of_joints(resolver: Resolver, name: str) -> int:
    """Return the line of a data section that gives a name what look like six joint angles, or 0.

    The name stands nowhere else: a location that is used is one.
    """
    entry = resolver.scope.entries[name]
    if entry.reads or len(entry.writes) != 1:
        return 0
    source = resolver.problems.source
    (start, _) = entry.writes[0]
    if any(p.start <= start < p.finish[1] for p in resolver.scope.programs.values()):
        return 0
    number = source.line_of(start)
    found = _JOINT_ANGLES.fullmatch(source.line_text(number).partition(";")[0])
    values = [float(v) for v in _A_NUMBER.findall(found["values"])] if found else []
    turned = all(abs(value) <= _FULL_TURN for value in values)
    near = sum(value**2 for value in values[:3]) < _NEAREST**2
    return number if len(values) == _JOINTS and turned and near else 0


def _stands_alone(word: str) -> bool:
    return INSTRUCTIONS[word].terminal in ("WORD0", "SETTING0")


def _is_typed(problems: Problems, place: Place) -> bool:
    """Return whether a name stands alone among what TYPE writes, as a word of a text would."""
    line = problems.source.line_text(problems.source.line_of(place[0]))
    return re.match(r"[ \t]*(\d+[ \t]+)?TYPE[ \t]", line, re.IGNORECASE) is not None
