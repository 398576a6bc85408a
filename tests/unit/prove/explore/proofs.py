"""Programs of a few lines, and what is proven of them."""

from functools import cache

from tests.support_programs import compiled, program
from vrts.check.verdict import Answer
from vrts.ir.module import Module
from vrts.prove.asking import Asking
from vrts.prove.environment.environment import Environment
from vrts.prove.proof import Proof, Wrong, Wronged
from vrts.prove.prove import prove
from vrts.scene.default import robot_alone

ALONE = robot_alone()
FREE = Environment()


@cache
def module_of(body: str) -> Module:
    return compiled(program(body))


def proven(body: str, environment: Environment = FREE, asking: Asking | None = None) -> Proof:
    """Return what is proven of the lines of one program."""
    return prove(module_of(body), ALONE, environment, asking or Asking(), entry="main")


def only(proof: Proof) -> Wronged:
    """Return the one thing that goes wrong."""
    assert proof.answer is Answer.VIOLATED
    assert len(proof.found) == 1, [one.headline for one in proof.found]
    return proof.found[0]


def wrongs(proof: Proof) -> list[tuple[Wrong, int]]:
    """Return what goes wrong, and at which steps."""
    return [(one.wrong, one.cause.step if one.cause is not None else 0) for one in proof.found]
