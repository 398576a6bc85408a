"""The first version of a scenario file: what happens in one run of a program."""

from vrts.assignments.new_environment import listed, read_by
from vrts.ir.module import Module

FIRST_S, EVERY_S = 2.0, 1.0  # when the first input goes on, and how much later each other one

HEAD = """\
# What happens in one run of `{name}`:
#
#   vrts run {name} --scenario {file}
#
# What you leave out is as in a run without a scenario: inputs are off, nothing goes wrong. Write
# the times of your cell, and remove the `#` of what should happen. Lengths are in mm, angles in
# degrees, times in seconds of the run. `vrts schema scenario` describes every key.

title = "A run of {name}"
seed = 0                          # of RANDOM: another number gives other draws
monitor_speed = 100               # the operator's speed [%]

# How the run begins; without it: READY, and the hand closed.
# [start]
# joints_deg = [0, -90, 90, 0, 0, 0]
# hand = "open"                   # or hand_mm = 80
"""
INPUT = """
# {where}
[[inputs]]
signal = {signal}
on_s = [{on}]                      # when it goes on; it is off at first
# off_s = [{off}]                   # when it goes off again
"""
ANALOG = """
# {where}
[[analog]]
channel = {channel}
at_s = [0.0, {on}]                # when it changes
counts = [0, 100]                 # what it reads from then on, each
"""
PROMPTS = """
# The program asks at {where}: a line for each time, in order.
[prompts]
answers = ["1"]
"""
RANDOM = """
# What RANDOM draws first; then the seed decides.
[random]
draws = [0.5]
"""
PROGRAMS = """
# Times of ticks in which the process control program goes first.
# [programs]
# process_first_s = [1.2]
"""
STUCK = """
# An input that does not change any more.
# [[faults]]
# time_s = 1.0
# kind = "input stuck"
# signal = {signal}
# state = "off"                   # or "on"
"""
HAND = """
# The hand lets go of what it holds; or kind = "part missing": the next grip finds nothing.
# [[faults]]
# time_s = 4.0
# kind = "gripper slips"
"""
TAIL = """
# Somebody presses the emergency stop.
# [[faults]]
# time_s = 5.0
# kind = "emergency stop"

# What the operator does at the controller: "stop", "proceed", "retry" or "execute".
# [[operator]]
# time_s = 6.0
# does = "stop"

# When the run is stopped at the latest.
[limits]
time_s = 600
"""


def new_scenario(name: str, module: Module, file: str) -> str:
    """Return a scenario file for a program: all that it reads, each with an example.

    Args:
        name: Of the program's file.
        module: Its programs.
        file: What the scenario's file is called.
    """
    read = read_by(module)
    parts = [HEAD.format(name=name, file=file)]
    on = FIRST_S
    for signal, places in sorted(read.inputs.items()):
        where = f"read at {listed(places)}"
        parts.append(INPUT.format(signal=signal, where=where, on=on, off=on + EVERY_S / 2))
        on += EVERY_S
    for channel, places in sorted(read.analog.items()):
        parts.append(ANALOG.format(where=f"read at {listed(places)}", channel=channel, on=on))
        on += EVERY_S
    if read.prompts:
        parts.append(PROMPTS.format(where=listed(read.prompts)))
    if read.random:
        parts.append(RANDOM)
    if read.two:
        parts.append(PROGRAMS)
    if read.inputs:
        parts.append(STUCK.format(signal=min(read.inputs)))
    if read.hand:
        parts.append(HAND)
    return "".join([*parts, TAIL])
