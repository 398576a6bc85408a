"""What an operator of an environment may type in one run: always the first that it allows."""

from dataclasses import replace

from vrts.base.stack import deep_stack
from vrts.engine.futures.future import begin, command, decide, happened, tick
from vrts.engine.memory.records import INSTANT
from vrts.engine.programs.outside import Kind
from vrts.ir.commands import Execute
from vrts.ir.module import Module
from vrts.prove.certify.memory import Memory
from vrts.prove.environment.environment import Environment
from vrts.prove.explore.frontier import Future
from vrts.prove.explore.outside import Outside
from vrts.scene.model import Scenario, Scene

MOST = 200  # answers; a program that asks on and on gets no more


@deep_stack()
def with_answers(
    module: Module, scene: Scene, scenario: Scenario, environment: Environment, entry: str
) -> Scenario:
    """Return a scenario that also says what is typed once its own answers are used up.

    Args:
        module: The programs.
        scene: Where the robot stands.
        scenario: What comes from outside.
        environment: What may be typed.
        entry: The program that is executed.
    """
    if environment.answers is None:
        return scenario
    outside = Outside(environment, module, scene.robot.arm.tick)
    machine = begin(module, scene, scenario, answers=True)
    command(machine, Execute(entry))
    typed: list[str] = []
    while len(typed) < MOST and machine.now < scenario.limits.time_s + INSTANT:
        question = tick(machine)
        happened(machine)
        if question is not None:
            assert question.kind is Kind.ANSWER
            future = Future(0, machine, None, 0, {}, outside.behaviours.begin(), None, Memory())
            ways = outside.ways(future, question)
            if not ways:
                break
            decide(machine, question, ways[0].value)
            typed.append(str(ways[0].value))
        elif not machine.robot.running and machine.next_command_s is None:
            break
    return replace(scenario, answers=(*scenario.answers, *typed))
