"""Reads `[prove]` of a task: that programs are right whatever comes from outside.

[prove]
environment = "environment.toml"   # what may come: a file beside the task, or a table here
hidden = false                     # true: only those who mark have the file
states = 20000                     # most states that are looked at
points = 3                         # lost when something can go wrong
"""

from fractions import Fraction

from vrts.base.toml.reading import Problems, Table
from vrts.check.rules.proof_demand import COSTS, USUAL_STATES, ProofDemand
from vrts.check.rules.scheme import TOTAL

MOST_STATES = 10_000_000


def read_proof(top: Table, problems: Problems, total: Fraction = TOTAL) -> ProofDemand | None:
    """Return what a task asks about every future; None where it asks nothing.

    The environment is not read here: `[prove.environment]`, too, is left to those who prove.

    Args:
        top: The task.
        problems: Told what is wrong.
        total: A mark is out of so many points.
    """
    section = top.table("prove")
    if section is None:
        return None
    inline = section.holds_table("environment")
    if inline:
        section.table("environment")  # its keys are for those who read it
    file = None if inline else section.string("environment")
    hidden = section.boolean("hidden", default=False)
    states = section.integer("states", USUAL_STATES, minimum=1, maximum=MOST_STATES)
    points = section.fraction("points", total * COSTS, minimum=0, maximum=float(total))
    section.finish()
    return ProofDemand(points, states, section.span, file, inline, hidden)
