"""Every future of some programs: states, decisions a second, memory, and what merging saves.

Run by hand: `python -m pytest tests/bench/test_bench_futures.py -s -p no:xdist`.
"""

import resource
import time
from typing import NamedTuple

import pytest

from tests.support_programs import compiled, program
from vrts.base.stack import deep_stack
from vrts.engine.futures.future import begin, command, decide, happened, tick
from vrts.engine.futures.keys import Key, Keys
from vrts.engine.programs.signals import INPUTS
from vrts.ir.commands import Execute
from vrts.scene.default import robot_alone
from vrts.scene.model import Scenario

MOST = 200_000  # states
COUNTING = "n = 0\nWHILE n < 1000 DO\nn = n+1\nIF SIG(1001) THEN\nm = 1\nELSE\nm = 2\nEND\nEND\n"
WAITING = "FOR i = 1 TO 400\nWAIT SIG(1001)\nWAIT SIG(-1001)\nEND\n"
MOVING = "MOVE a\n" + "".join(
    f"IF SIG({n}) THEN\nMOVES b\nELSE\nMOVE c\nEND\nMOVE a\nBREAK\n" for n in (1001, 1002)
)
REACTING = "REACTI 1001, gone\nSPEED 20 ALWAYS\nMOVE a\nMOVES b\nMOVES c\nMOVE a\nBREAK\n"
GONE = ".END\n.PROGRAM gone\nMOVE c\nBREAK\nHALT"


class Gone(NamedTuple):
    """What going through all futures of a program took."""

    states: int
    decisions: int
    merged: int
    ends: int
    seconds: float  # of processor time

    def line(self, name: str) -> str:
        rate = self.decisions / self.seconds
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024
        return (
            f"{name:28s} {self.states:6d} states, {self.decisions:5d} decisions, {self.merged:5d}"
            f" merged, {self.ends:4d} ends: {self.seconds:6.2f} s, {rate:6.0f} decisions a second,"
            f" {peak} MB at most so far"
        )


@deep_stack()
def gone_through(body: str) -> Gone:
    module = compiled(program(body))
    machine = begin(module, robot_alone(), Scenario(), frozenset(INPUTS))
    command(machine, Execute("main"))
    keys, seen = Keys(module), set[Key]()
    decisions = merged = ends = 0
    waiting = [machine]
    begun = time.process_time()
    while waiting:
        machine = waiting.pop()
        while True:
            question = tick(machine)
            happened(machine)
            if question is None and not machine.robot.running:
                ends += 1
                break
            key = keys.of(machine, question)
            if key in seen:
                merged += 1
                break
            seen.add(key)
            assert len(seen) < MOST
            if question is not None:
                decisions += 1
                other = machine.copy()
                decide(other, question, True)
                decide(machine, question, False)
                waiting.append(other)
    return Gone(len(seen), decisions, merged, ends, time.process_time() - begun)


@pytest.mark.parametrize(
    ("name", "body"),
    [
        ("counting", COUNTING),
        ("waiting", WAITING),
        ("moving", MOVING),
        ("reacting", REACTING + GONE),
    ],
)
def test_futures_of_programs(name: str, body: str) -> None:
    print("\n" + gone_through(body).line(name))


def test_inputs_read_in_sequence_cost_their_number() -> None:
    found: dict[int, Gone] = {}
    for count in (2, 4, 8, 16):
        reads = [
            f"IF SIG({1001 + k}) THEN\nMOVE b\nELSE\nMOVE c\nEND\nMOVE a\nBREAK\n"
            for k in range(count)
        ]
        found[count] = gone_through("".join(reads))
        print("\n" + found[count].line(f"{count} inputs"))
    assert [one.decisions for one in found.values()] == list(found)
