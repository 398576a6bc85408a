"""Proofs made by hand whose trees are drawn, and a page about one."""

from dataclasses import replace

from tests.unit.report.proofs import COVERED, HITS, TEXT, VIOLATED, WAIT
from vrts.check.verdict import Answer
from vrts.prove.environment.environment import Environment
from vrts.prove.proof import Branch, Decided, Proof, What
from vrts.report.page.futures.whole import Explored


def on(time_s: float, number: int = 1001, *, value: bool = True) -> Decided:
    return Decided(time_s, What.INPUT, number, value, WAIT)


def proof(*tree: Branch) -> Proof:
    return Proof(Answer.HOLDS, (), COVERED, tree=tree)


# a wait of a hundred ticks: each of them may end it, and then it goes on as the first did
WAITS = proof(
    Branch(None, None, ""),
    Branch(0, on(0.5), "completed", 2.0),
    *(Branch(0, on(0.528 + 0.028 * k), "merged", 0.556 + 0.028 * k, into=1) for k in range(99)),
)
DEEP = proof(
    Branch(None, None, ""),
    *(Branch(k, on(0.1 + 0.1 * k, value=k % 2 == 0), "") for k in range(600)),
)
FOUND = replace(
    VIOLATED,
    tree=(
        Branch(None, None, "", None),
        Branch(0, HITS.decisions[0], "", None),
        Branch(1, HITS.decisions[1], "error", 3.5),
        Branch(0, on(0.3), "open", 0.4),
    ),
)


def explored(one: Proof, title: str = "lower.v2") -> Explored:
    return Explored(title, "scene <nowhere>", TEXT, one, Environment(title="a & b"), 0.028)
