"""Over what a proof speaks, in plain sentences."""

from collections.abc import Iterator

from vrts.engine.code.values.operands import number_of
from vrts.engine.futures.keys import Clocks
from vrts.engine.futures.since import OLD_S
from vrts.engine.programs.outside import Kind
from vrts.ir import instructions as ir
from vrts.ir.module import Module
from vrts.prove.environment.environment import (
    Afterwards,
    Answering,
    Environment,
    Held,
    Parts,
    Pulsed,
    Span,
)
from vrts.prove.explore.answers import Tried
from vrts.prove.explore.search import Search
from vrts.prove.proof import Covered, Step


def covered(search: Search, dead: tuple[Step, ...]) -> Covered:
    """Return what a search went through, and over what it speaks."""
    environment = search.environment
    kinds = {question.kind for question in search.asked}
    read = sorted(q.number for q in search.asked if q.kind is Kind.INPUT)
    counts = search.counts
    return Covered(
        states=counts.states,
        decisions=counts.decisions,
        merged=counts.merged,
        ends=counts.ends,
        motion_s=0.0 if search.touches is None else search.touches.motion_s,
        quantified=(
            *(_input(environment, n) for n in read),
            *_analog(search, sampled=False),
            *_others(search, kinds),
        ),
        bounded=_bounded(environment),
        sampled=(*_analog(search, sampled=True), *_sampled(search, kinds)),
        assumed=(
            *_assumed(environment, Kind.INPUT in kinds or Kind.ANALOG in kinds),
            *_typed(search),
            *_timers(search.module),
            *_coarse(search),
            *_order(search),
            *search.never_left,
        ),
        dead=dead,
    )


def _typed(search: Search) -> tuple[str, ...]:
    """Return what is typed where nobody says it."""
    if any(found.numbers for _, found in _free(search)):
        return ("where PROMPT asks for numbers, numbers are typed",)
    return ()


def _timers(module: Module) -> tuple[str, ...]:
    """Return from when timers count that no step sets, where any is read."""
    programs = module.programs.values()
    steps = [step for program in programs for step in program.instructions]
    given = {number_of(step.number) for step in steps if isinstance(step, ir.SetTimer)}
    if Clocks.of(module).timers <= given:
        return ()
    return ("timers that no step sets stand at 0 when the program is executed first",)


def _coarse(search: Search) -> tuple[str, ...]:
    """Return up to which readings the time that has passed is told apart, where it is asked."""
    timers = sorted({held.timer for held in search.keys.since.values()})
    return tuple(
        f"TIMER({n}) is read within {OLD_S:g} s: later its readings are too coarse to be subtracted"
        for n in timers
    )


def _order(search: Search) -> tuple[str, ...]:
    """Return in which order two programs have their turns, where the environment says it."""
    programs = search.module.programs.values()
    begins = any(isinstance(i, ir.StartProcess) for p in programs for i in p.instructions)
    if not begins or search.environment.turns:
        return ()
    return ("in each tick the robot program has its turn before the process control program",)


def _input(environment: Environment, number: int) -> str:
    match environment.inputs.get(number):
        case None:
            return f"input {number}: on or off in every tick in which it is read"
        case Held(on=None):
            return f"input {number}: on or off, and then for ever"
        case Held(on=on):
            return f"input {number}: always {'on' if on else 'off'}"
        case Pulsed(on_s=on_s, off_s=off_s):
            return f"input {number}: on for {_span(on_s)}, off for {_span(off_s)}, in turn"
        case Answering(output=output, on_s=on_s, off_s=off_s):
            return (
                f"input {number}: on {_span(on_s)} after output {output} goes on,"
                f" off {_span(off_s)} after it goes off"
            )


def _analog(search: Search, *, sampled: bool) -> list[str]:
    """Return what analog inputs read, of those of which some values are tried, or all ways."""
    channels = sorted(q.number for q in search.asked if q.kind is Kind.ANALOG)
    tried = [(channel, search.outside.readings.known(channel)) for channel in channels]
    if sampled:
        return [f"analog input {n}, {one.words}" for n, one in tried if one.sampled]
    every = "in every tick in which it is read"
    return [f"analog input {n}: {one.words}, {every}" for n, one in tried if not one.sampled]


def _span(span: Span) -> str:
    if span.least == span.most:
        return f"{span.least:g} s"
    if span.most == float("inf"):
        return f"{span.least:g} s or longer"
    return f"{span.least:g} to {span.most:g} s"


def _others(search: Search, kinds: set[Kind]) -> list[str]:
    environment, found = search.environment, list[str]()
    if Kind.ANSWER in kinds and environment.answers is not None and environment.answers.texts:
        texts = ", ".join(f'"{text}"' for text in environment.answers.texts)
        found.append(f"answers to PROMPT: each of {texts}, every time")
    answers = search.outside.answers
    if Kind.ANSWER in kinds and answers.numbers and not answers.sampled:
        first, last = answers.numbers[0], answers.numbers[-1]
        found.append(f"answers to PROMPT: every whole number from {first:g} to {last:g}")
    for where, each in _free(search):
        if each.apart is not None:
            words = [f"{number:g}" for number in each.apart]
            found.append(f"answers to PROMPT at {where}: every number{_apart(words)}")
        elif each.texts:
            words = [f'"{text}"' for text in each.texts[:-1]]  # the last stands for all others
            found.append(f"answers to PROMPT at {where}: every text{_apart(words)}")
    if Kind.TURN in kinds:
        found.append(
            "two programs: either has its turn first, in every tick in which it may matter"
        )
    if len(environment.speeds) > 1:
        speeds = ", ".join(f"{speed:g}" for speed in environment.speeds)
        found.append(f"monitor speed: {speeds} %, one for a whole future")
    if environment.stops:
        ways = " or ".join(
            sorted(after.value for after in Afterwards if after in environment.stops)
        )
        found.append(f"the operator: one stop in any tick in which the arm moves, then {ways}")
    return found


def _free(search: Search) -> Iterator[tuple[str, Tried]]:
    """Yield each PROMPT at which whatever the program can tell apart was typed."""
    for (name, index), found in search.outside.free.asked.items():
        if found is not None:
            step = search.module.programs[name].origins[index].step
            yield f"step {step} of `{name}`", found


def _apart(words: list[str]) -> str:
    if not words:
        return ", as nothing depends on it"
    listed = " and ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)
    return f", told apart by {listed}"


def _bounded(environment: Environment) -> tuple[str, ...]:
    most = environment.again.most
    if most == 0:
        return ("the program is executed once",)
    if most is None:
        return ()
    return (f"the program is executed at most {most + 1} times",)


def _sampled(search: Search, kinds: set[Kind]) -> tuple[str, ...]:
    environment, found = search.environment, list[str]()
    if Kind.ANSWER in kinds and search.outside.answers.sampled:
        found.append(f"answers to PROMPT, {search.outside.answers.sampled}")
    found += [
        f"answers to PROMPT at {where}, {each.sampled}"
        for where, each in _free(search)
        if each.sampled
    ]
    if Kind.RANDOM in kinds:
        draws = ", ".join(f"{value:g}" for value in environment.random)
        found.append(f"RANDOM: {draws} only")
    if environment.stops:
        found.append("after a stop the operator goes on as soon as the arm stands, or never")
    return tuple(found)


def _assumed(environment: Environment, inputs: bool) -> tuple[str, ...]:
    found: list[str] = []
    if inputs:
        found.append("inputs for which a program waits come eventually")
    if environment.speeds == (100.0,):
        found.append("the monitor speed is 100 %")
    if not environment.stops:
        found.append("the operator never stops the program")
    if not environment.misses:
        found.append("the hand never misses what stands between its fingers")
    if environment.stops or environment.misses:
        found.append("goals are asked for only where nobody stops and no part is missing")
    if environment.again.most != 0:
        words = {
            Parts.PUT_BACK: "everything stands where it stood at first",
            Parts.LEFT: "everything is left as it is",
            Parts.TAKEN: "what was moved elsewhere is taken away",
        }
        found.append(f"before the program is executed again {words[environment.again.parts]}")
    return tuple(found)
