"""The first version of an environment file: what may come from outside into a program."""

from collections.abc import Iterator
from typing import NamedTuple

from vrts.engine.code.values.operands import number_of
from vrts.engine.machine.forever.nodes import all_nodes, tops
from vrts.engine.machine.forever.touches import signals_looked_at
from vrts.engine.programs.signals import INPUTS
from vrts.ir import instructions as ir
from vrts.ir.expressions import Apply, Function
from vrts.ir.module import Module
from vrts.ir.ranges import ANALOG_INPUTS, LEAST_COUNT, MOST_COUNT

MOST_STEPS = 4  # told of one input

HEAD = """\
# What may come from outside while `{name}` executes:
#
#   vrts prove {name} --environment environment.toml
#
# Everything that is not said here is free: an input may be on or off in every tick in which the
# program looks at it. Say only what is always true in your cell; every word makes the proof weaker.
# Remove the `#` of what is true. Times are in seconds.

title = "The cell of {name}"
"""
INPUT = """
# {where}
[[inputs]]
signal = {signal}
is = "free"
# is = "held"                     # it never changes
# state = "off"                   # or "on", or "either": it is not known which
# is = "pulsed"                   # off at first, then on and off; how long each of them lasts:
# on_s = [0.1, 0.5]
# off_s = [1.0]                   # one number: at least so long
{answers}"""
ANSWERS = """\
# is = "answers"                  # it follows an output of the controller, after this time:
# output = {output}
# on_s = [0.2, 3.0]
# off_s = [0.2, 3.0]
"""
ANALOG = """
# {where}
[[analog]]
channel = {channel}
range = [{least}, {most}]           # counts that it may read, in any tick
# counts = [0, 350]               # instead of the range: only these
"""
PROMPTS = """
# The program asks at {where}. Every answer is tried, every time.
[prompts]
answers = ["0", "1", "2"]
# range = [0, 5]                  # instead of answers: numbers, tried at some values
# whole = true                    # whole numbers only: all of them are tried
"""
RANDOM = """
# RANDOM draws one of these. Between them nothing is proven.
[random]
draws = [0, 0.5, 0.9999]
"""
HAND = """
[hand]
misses = false                    # true: each closing of the hand may grip or miss
"""
PROGRAMS = """
[programs]
first = "either"                  # may change in each tick; or always the "robot program"
"""
TAIL = """
[operator]
speeds = [100]                    # monitor speeds [%], one for a whole future
# stops = ["proceed", "retry", "nothing"]   # what may follow a stop, in any tick

[execute]
again = false                     # true: EXECUTE again, with the memory that the last one left
# times = 5                       # at most so often; without it until the state repeats
# parts = "put back"              # what happens to them before that: or "left", "taken"

# What must never be, or always. See `vrts explain V562`.
# [[never]]
# title = "output 3 only while the hand is closed"
# signals = [3]                   # on; -3 is off
# hand = "not closed"             # "open", "closed", or "not" and one of them; "holding", "empty"
"""


class Read(NamedTuple):
    """What a program reads from outside, and where."""

    inputs: dict[int, list[str]]
    analog: dict[int, list[str]]
    prompts: list[str]
    random: bool
    hand: bool
    two: bool  # programs
    outputs: list[int]  # that it sets


def new_environment(name: str, module: Module) -> str:
    """Return an environment file in which everything that a program reads is free.

    Args:
        name: Of the program's file.
        module: Its programs.
    """
    read = read_by(module)
    output = read.outputs[0] if read.outputs else 1
    parts = [HEAD.format(name=name)]
    for signal, places in sorted(read.inputs.items()):
        where = f"read at {listed(places)}"
        answers = ANSWERS.format(output=output)
        parts.append(INPUT.format(signal=signal, where=where, answers=answers))
    for channel, places in sorted(read.analog.items()):
        where = f"read at {listed(places)}"
        ends = {"least": LEAST_COUNT, "most": MOST_COUNT}
        parts.append(ANALOG.format(where=where, channel=channel, **ends))
    if read.prompts:
        parts.append(PROMPTS.format(where=listed(read.prompts)))
    if read.random:
        parts.append(RANDOM)
    if read.hand:
        parts.append(HAND)
    if read.two:
        parts.append(PROGRAMS)
    return "".join([*parts, TAIL])


def read_by(module: Module) -> Read:
    """Return what the programs of a module read from outside, and where."""
    found = Read({}, {}, [], random=False, hand=False, two=False, outputs=[])
    random = hand = two = False
    for program in module.programs.values():
        for instruction, origin in zip(program.instructions, program.origins, strict=True):
            place = f"{program.name} {origin.step}"
            for signal in _inputs(instruction):
                places = found.inputs.setdefault(signal, [])
                if place not in places:
                    places.append(place)
            for channel in _channels(instruction):
                found.analog.setdefault(channel, []).append(place)
            if isinstance(instruction, ir.Prompt) and place not in found.prompts:
                found.prompts.append(place)
            two |= isinstance(instruction, ir.StartProcess)
            hand |= isinstance(instruction, ir.Grasp | ir.MoveHand)
            random |= any(node.function is Function.RANDOM for node in _asked(instruction))
            found.outputs.extend(n for n in _outputs(instruction) if n not in found.outputs)
    return found._replace(random=random, hand=hand, two=two)


def _asked(instruction: ir.Instruction) -> Iterator[Apply]:
    for top in tops(instruction):
        yield from (node for node in all_nodes(top) if isinstance(node, Apply))


def _inputs(instruction: ir.Instruction) -> set[int]:
    """Return the inputs that an instruction looks at, of those whose numbers are written."""
    found: set[int] = set()
    for node in _asked(instruction):
        found |= signals_looked_at(node) or set()
    if isinstance(instruction, ir.React):
        found.add(abs(number_of(instruction.signal) or 0))
    return found.intersection(INPUTS)


def _channels(instruction: ir.Instruction) -> set[int]:
    """Return the analog inputs that an instruction looks at, of those whose numbers are written."""
    applied = (node for node in _asked(instruction) if node.function is Function.ADC)
    numbers = {number_of(node.arguments[0]) for node in applied}
    return {number for number in numbers if number is not None and number in ANALOG_INPUTS}


def _outputs(instruction: ir.Instruction) -> list[int]:
    if not isinstance(instruction, ir.Signal):
        return []
    numbers = [number_of(signal) for signal in instruction.signals]
    return [n for n in numbers if n is not None and n > 0]


def listed(places: list[str]) -> str:
    """Return steps in words, the first of many."""
    more = len(places) - MOST_STEPS
    return ", ".join(places[:MOST_STEPS]) + (f" and {more} more" if more > 0 else "")
