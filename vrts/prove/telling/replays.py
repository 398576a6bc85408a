"""What goes wrong in a future as an ordinary run."""

from vrts.engine.controller import advance, commands_of, start
from vrts.engine.run import Run
from vrts.ir.module import Module
from vrts.prove.proof import Wronged
from vrts.scene.model import Scenario, Scene


def replay(module: Module, scene: Scene, wronged: Wronged, entry: str, beyond_s: float) -> Run:
    """Return the run of the scenario in which something goes wrong.

    Args:
        module: The programs.
        scene: Where the robot stands.
        wronged: What goes wrong.
        entry: The program that is executed.
        beyond_s: How long the run goes on after that [s].
    """
    return run_until(module, scene, wronged.scenario, entry, wronged.time_s + beyond_s)


def run_until(module: Module, scene: Scene, scenario: Scenario, entry: str, until_s: float) -> Run:
    """Return the run of a scenario up to a time.

    Args:
        module: The programs.
        scene: Where the robot stands.
        scenario: What comes from outside.
        entry: The program that is executed.
        until_s: Up to when [s].
    """
    commands = [one for one in commands_of(scenario, entry) if one.time_s <= until_s]
    return advance(start(module, scene, scenario), until_s, commands, closed=True)
