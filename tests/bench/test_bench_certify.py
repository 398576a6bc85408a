"""Motion of futures certified: seconds of it a second, and what following a tick costs.

Run by hand: `python -m pytest tests/bench/test_bench_certify.py -s -p no:xdist`.
"""

import time

import pytest

from tests.places import ROOT
from tests.support_programs import compiled
from vrts.base.stack import deep_stack
from vrts.engine.futures.future import begin, command, decide, happened, tick
from vrts.engine.futures.keys import Key, Keys
from vrts.engine.machine.machine import Machine
from vrts.ir.commands import Execute
from vrts.pipeline.scenes import load_scene
from vrts.prove.certify.certifier import Certifier
from vrts.prove.certify.memory import Memory
from vrts.scene.model import Scenario

BATCH_S = 60.0  # of motion that waits
EXAMPLES = {
    "cans-on-bases": ROOT / "examples" / "01-cans-on-bases" / "solution.v2",
    "final-project": ROOT / "examples" / "04-final-project" / "solution.v2",
}
REACTING = "REACTI 1001, away\n        OPENI"
AWAY = ".PROGRAM away\nDEPARTS 60\nMOVE safe\nHALT\n.END\n"


@pytest.mark.parametrize("scene", EXAMPLES)
@deep_stack()
def test_bench_reaction_at_every_tick(scene: str) -> None:
    """A reaction in every tick of an example, each going its own way from there."""
    text = EXAMPLES[scene].read_text("utf-8").replace("OPENI", REACTING, 1)
    module = compiled(text.replace(".LOCATIONS", AWAY + ".LOCATIONS"))
    where = load_scene(scene).scene
    machine = begin(module, where, Scenario(), frozenset({1001}))
    command(machine, Execute(module.main or ""))
    keys, seen, certifier = Keys(module), set[Key](), Certifier(where)
    waiting: list[tuple[Machine, Memory]] = [(machine, Memory())]
    ticks, futures, follows, certifies, told = 0, 0, 0.0, 0.0, 0
    begun = time.process_time()
    while waiting:
        machine, memory = waiting.pop()
        while machine.robot.running or machine.last_tick < 0:
            question = tick(machine)
            if question is not None:
                other = machine.copy()
                decide(other, question, True)
                decide(machine, question, False)
                waiting.append((other, memory))
                continue
            before = time.process_time()
            memory = certifier.follow(memory, machine, happened(machine), ticks)
            follows += time.process_time() - before
            ticks += 1
            key = keys.of(machine, memory.state(machine))
            if key in seen:
                break
            seen.add(key)
        else:
            certifier.finish(memory, machine, ticks)
            futures += 1
        if certifier.waiting_s > BATCH_S:
            before = time.process_time()
            told += len(certifier.certify()[0])
            certifies += time.process_time() - before
    before = time.process_time()
    told += len(certifier.certify()[0])
    certifies += time.process_time() - before
    seconds = time.process_time() - begun
    print(
        f"\n{scene}: {ticks} ticks, {futures} ends, {certifier.motion_s:.0f} s of motion certified"
        f" in {certifies:.2f} s ({certifier.motion_s / certifies:.0f} a second), followed in"
        f" {1e6 * follows / ticks:.0f} us a tick, {told} touches; {seconds:.1f} s of all"
    )
