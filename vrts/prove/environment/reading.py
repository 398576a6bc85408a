"""Reads an environment file: what may come from outside while a program executes.

Everything may be left out. An input of which nothing is said is free: it may be on or off in every
tick in which the program looks at it. Times are in seconds, lengths in millimetres.

    title = "the conveyor cell"

    [[inputs]]
    signal = 1001
    is = "free"                     # the same as not naming it

    [[inputs]]
    signal = 1002
    is = "held"                     # it never changes
    state = "off"                   # or "on", or "either": it is not known which

    [[inputs]]
    signal = 1003
    is = "pulsed"                   # off at first, then it goes on and off
    on_s = [0.1, 0.5]               # how long each stay lasts; one number: at least so long
    off_s = [1.0]

    [[inputs]]
    signal = 1004
    is = "answers"                  # it follows an output of the controller
    output = 1
    on_s = [0.2, 3.0]               # how much later
    off_s = [0.2, 3.0]

    [[analog]]
    channel = 1
    range = [0, 2047]               # what it may read, in any tick; or counts = [0, 350], a list

    [prompts]                       # what may be typed at PROMPT, each time
    answers = ["1", "2", "5"]       # or range = [0, 5], with whole = true for whole numbers only

    [random]
    draws = [0, 0.5, 0.99]          # what RANDOM may draw

    [hand]
    misses = true                   # each closing of the hand may grip or miss

    [operator]
    speeds = [100, 50]              # monitor speeds [%], one for a whole future
    stops = ["proceed", "retry", "nothing"]   # what may follow a stop in any tick

    [execute]
    again = true                    # with the memory it left, until the state repeats
    times = 5                       # but no more often than that
    parts = "put back"              # what becomes of them before: or "left", "taken"

    [programs]                      # where two programs execute
    first = "robot program"         # in every tick; as usual "either", in each tick again

    [[never]]                       # a property of your own; also [[always]]
    title = "output 3 only while the hand is closed"
    signals = [3]                   # on; -3 is off
    hand = "not closed"             # "open", "closed", or "not" and one of them; "holding", "empty"
    still = false                   # the arm stands still, or moves
    step = "main:12"                # program, and the step that it has come to
    region_mm = { from = [0, 0, 0], to = [100, 100, 100] }   # where the tool is, at each tick

    [[always]]
    title = "after 1001 the arm stands within half a second"
    after = 1001                    # counted from when it goes on (-1001: off)
    within_s = 0.5
    still = true
"""

import hashlib
import re
from math import inf
from types import MappingProxyType

from vrts.base.diagnostic import Diagnostic, Label, Rule
from vrts.base.source import SourceFile
from vrts.base.source import Span as Place
from vrts.base.toml.reading import Table, read_toml
from vrts.prove.environment.analog import read_counts
from vrts.prove.environment.environment import (
    Afterwards,
    Again,
    Answering,
    Answers,
    Behaviour,
    Environment,
    Held,
    Property,
    Pulsed,
    Quantifier,
    Span,
)
from vrts.scene.model import Parts
from vrts.scene.reading.scenario_file import FASTEST, LONGEST_ANSWER, SLOWEST
from vrts.scene.reading.scenario_signals import (
    DRIVEN_TWICE,
    FIRST_INPUT,
    LAST_INPUT,
    TOO_MANY,
    read_region,
)

SPAN_BACKWARD = Rule("V561", "span-backward")
NO_CONDITION = Rule("V562", "property-without-condition")
NO_ANSWERS = Rule("V563", "answers-unclear")

KINDS = ("free", "held", "pulsed", "answers")
FIRST = ("either", "robot program")
HANDS = ("open", "closed", "not open", "not closed", "holding", "empty")
LONGEST_S = 60.0  # any span: each is followed tick by tick
MOST_OUTPUT = 32
MOST_SIGNAL = 2032
MOST_AGAIN = 1_000
MOST_LISTED = 50  # answers, draws, speeds, properties, inputs
LARGEST = 1e6
LONGEST_TITLE = 200
STEP = re.compile(r"([\w.]{1,64}):([1-9][0-9]{0,5})")


def read_environment(source: SourceFile) -> tuple[Environment | None, tuple[Diagnostic, ...]]:
    """Return the environment that a file describes, or None, with all there is to say about it.

    The scenario in it is the usual one: start, sensors and faults are not the file's to say.
    """
    top, problems = read_toml(source)
    found = None if top is None else _environment(top, source)
    diagnostics = problems.in_order()
    return (None if problems.any_error else found), diagnostics


def read_inner(
    source: SourceFile, path: tuple[str, ...]
) -> tuple[Environment | None, tuple[Diagnostic, ...]]:
    """Return the environment that a table of another file is, as `read_environment` does.

    Args:
        source: The file.
        path: Names of the table and of those that it is in: `("prove", "environment")`.
    """
    table, problems = read_toml(source)
    for name in path:
        table = None if table is None else table.table(name)
    found = None if table is None else _environment(table, source)
    diagnostics = problems.in_order()
    return (None if problems.any_error else found), diagnostics


def _environment(top: Table, source: SourceFile) -> Environment:
    title = _title(top, re.split(r"[/\\]", source.name)[-1].removesuffix(".toml"))
    inputs = _inputs(top)
    analog = read_counts(_few(top, "analog"))
    answers = _answers(top.table("prompts"))
    usual = Environment()
    draws = _numbers(top.table("random"), "draws", usual.random, minimum=0.0, below=1.0)
    hand = top.table("hand")
    misses = hand is not None and hand.boolean("misses", default=False)
    if hand is not None:
        hand.finish()
    speeds, stops = _operator(top.table("operator"), usual)
    again = _again(top.table("execute"))
    turns = _turns(top.table("programs"))
    kinds = ((Quantifier.NEVER, "never"), (Quantifier.ALWAYS, "always"))
    properties = tuple(
        one
        for quantifier, key in kinds
        for table in _few(top, key)
        if (one := _property(table, quantifier)) is not None
    )
    top.finish()
    return Environment(
        title=title,
        inputs=MappingProxyType(inputs),
        analog=analog,
        answers=answers,
        random=draws,
        speeds=speeds,
        stops=stops,
        again=again,
        misses=misses,
        turns=turns,
        properties=properties,
        digest=hashlib.sha256(source.text.encode()).hexdigest(),
    )


def _title(table: Table, default: str) -> str:
    title = table.string("title", default or "environment")
    return " ".join(title.split())[:LONGEST_TITLE]


def _few(table: Table, key: str) -> tuple[Table, ...]:
    """Return the tables `[[key]]`; of too many none is read."""
    tables = table.tables(key)
    return tables if _count(table, len(tables), key, table.span_of(key)) else ()


def _count(table: Table, count: int, what: str, span: Place) -> bool:
    if count > MOST_LISTED:
        table.problems.error(
            TOO_MANY,
            f"{count:,} {what} are too many",
            span,
            f"an environment may have {MOST_LISTED}",
            data={"count": count, "most": MOST_LISTED},
        )
    return count <= MOST_LISTED


# --- inputs ---------------------------------------------------------------------------------------


def _inputs(top: Table) -> dict[int, Behaviour]:
    found: dict[int, Behaviour] = {}
    places: dict[int, Place] = {}
    for table in _few(top, "inputs"):
        signal = table.integer("signal", minimum=FIRST_INPUT, maximum=LAST_INPUT, required=True)
        behaviour = _behaviour(table)
        table.finish()
        if signal is None:
            continue
        if signal in places:
            table.problems.error(
                DRIVEN_TWICE,
                f"two entries are about input {signal}",
                table.value_span("signal"),
                secondary=(Label(places[signal], "the other one"),),
                help=("leave out one of the two",),
                data={"signal": signal},
            )
            continue
        places[signal] = table.value_span("signal")
        if behaviour is not None:
            found[signal] = behaviour
    return found


def _behaviour(table: Table) -> Behaviour | None:
    kind = table.string("is", choices=KINDS, required=True)
    if kind == "held":
        state = table.string("state", choices=("on", "off", "either"), required=True)
        return None if state is None else Held({"on": True, "off": False}.get(state))
    if kind not in ("pulsed", "answers"):
        return None
    output = None
    if kind == "answers":
        output = table.integer("output", minimum=1, maximum=MOST_OUTPUT, required=True)
    on_s, off_s = _span(table, "on_s"), _span(table, "off_s")
    if on_s is None or off_s is None:
        return None
    if kind == "pulsed":
        return Pulsed(on_s, off_s)
    return None if output is None else Answering(output, on_s, off_s)


def _span(table: Table, key: str) -> Span | None:
    numbers = table.numbers(key, count=(1, 2), minimum=0.0, maximum=LONGEST_S, required=True)
    if numbers is None:
        return None
    least, most = numbers[0], (numbers[1] if len(numbers) > 1 else inf)
    if least <= most and most > 0.0:
        return Span(least, most)
    table.problems.error(
        SPAN_BACKWARD,
        f"`{key}` ends before it begins" if least > most else f"`{key}` lasts for no time",
        table.value_span(key),
        f"{least:g} s to {most:g} s",
        help=("give the shortest time first, then the longest",),
        data={"least_s": least, "most_s": most},
    )
    return None


# --- what people do -------------------------------------------------------------------------------


def _answers(section: Table | None) -> Answers | None:
    if section is None:
        return None
    texts = section.strings("answers", ()) or ()
    ends = section.numbers("range", count=2, minimum=-LARGEST, maximum=LARGEST)
    whole = section.boolean("whole", default=False)
    section.finish()
    if not _count(section, len(texts), "answers", section.span_of("answers")):
        return None
    wrong = [text for text in texts if len(text) > LONGEST_ANSWER or not text.isprintable()]
    if (ends is None) is not bool(texts) or wrong or (ends is not None and ends[0] > ends[1]):
        section.problems.error(
            NO_ANSWERS,
            "it is not clear what may be typed at PROMPT",
            section.span,
            help=('give either `answers = ["1", "2"]`, a line each, or `range = [0, 5]`',),
        )
        return None
    return Answers(texts) if ends is None else Answers((), ends[0], ends[1], whole)


def _numbers(
    section: Table | None, key: str, default: tuple[float, ...], *, minimum: float, below: float
) -> tuple[float, ...]:
    """Return a list of different numbers of a section that has no other key."""
    if section is None:
        return default
    found = section.numbers(key, default, minimum=minimum, maximum=below)
    section.finish()
    return _different(section, key, found, default, below)


def _different(
    section: Table,
    key: str,
    found: tuple[float, ...] | None,
    default: tuple[float, ...],
    below: float = inf,
) -> tuple[float, ...]:
    if not found or not _count(section, len(found), key, section.span_of(key)):
        return default
    return tuple(dict.fromkeys(number for number in found if number < below)) or default


def _operator(
    section: Table | None, usual: Environment
) -> tuple[tuple[float, ...], frozenset[Afterwards]]:
    if section is None:
        return usual.speeds, usual.stops
    speeds = section.numbers("speeds", usual.speeds, minimum=SLOWEST, maximum=FASTEST)
    stops = section.names("stops", choices=[after.value for after in Afterwards])
    section.finish()
    chosen = _different(section, "speeds", speeds, usual.speeds)
    return chosen, frozenset(map(Afterwards, stops))


def _again(section: Table | None) -> Again:
    if section is None:
        return Again()
    again = section.boolean("again", default=True)
    times = section.integer("times", minimum=1, maximum=MOST_AGAIN)
    parts = section.string("parts", Parts.PUT_BACK.value, choices=[part.value for part in Parts])
    section.finish()
    return Again(times if again else 0, Parts(parts))


def _turns(section: Table | None) -> bool:
    """Return whether either of two programs may go on first in a tick."""
    if section is None:
        return True
    first = section.string("first", FIRST[0], choices=FIRST)
    section.finish()
    return first == FIRST[0]


# --- properties -----------------------------------------------------------------------------------


def _property(table: Table, quantifier: Quantifier) -> Property | None:
    title = _title(table, f"{quantifier.value} …")
    signals = table.numbers("signals", (), minimum=-MOST_SIGNAL, maximum=MOST_SIGNAL) or ()
    hand = table.string("hand", choices=HANDS)
    still = table.boolean("still")
    written = table.string("step")
    region = read_region(table) if "region_mm" in table else None
    after = table.integer("after", minimum=-MOST_SIGNAL, maximum=MOST_SIGNAL)
    within_s = table.number("within_s", minimum=0.0, maximum=LONGEST_S)
    table.finish()
    step = None if written is None else STEP.fullmatch(written)
    found = Property(
        quantifier,
        title,
        tuple(int(number) for number in signals),
        hand,
        region,
        None if step is None else (step[1].lower(), int(step[2])),
        still,
        after,
        within_s,
    )
    return found if _says_something(table, found, written) else None


def _says_something(table: Table, one: Property, step: str | None) -> bool:
    """Return whether a property can be looked at; report it if not."""
    lacks: list[str] = []
    if not any((one.signals, one.hand, one.region, one.step, one.still is not None)):
        lacks.append("it has no condition: give `signals`, `hand`, `still`, `step` or `region_mm`")
    if step is not None and one.step is None:
        lacks.append("`step` is a program and a number: `main:12`")
    if (one.after is None) is not (one.within_s is None):
        lacks.append("`after` and `within_s` belong together")
    if any(number == 0 for number in (*one.signals, 1 if one.after is None else one.after)):
        lacks.append("there is no signal 0")
    for words in lacks:
        table.problems.error(
            NO_CONDITION, f"`{one.title}` cannot be looked at", table.span, help=(words,)
        )
    return not lacks
