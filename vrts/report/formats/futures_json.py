"""A proof over every future as JSON, for programs. Times in s, rounded by the shared rule."""

from collections.abc import Mapping
from types import MappingProxyType

from vrts.engine.memory.events import Cause
from vrts.prove.proof import Branch, Decided, Proof, Wronged
from vrts.report.formats.diagnostic_json import Json
from vrts.report.proof_words import decision, headline
from vrts.report.quantities import seconds

FUTURES_SCHEMA = "vrts.futures/1"


NO_LEAVES: Mapping[int, str] = MappingProxyType({})


def futures_json(
    title: str,
    proof: Proof,
    scenarios: tuple[str, ...] = (),
    leaves: Mapping[int, str] = NO_LEAVES,
) -> Json:
    """Return all that is known about the futures of a program.

    Args:
        title: Of the program.
        proof: What was found.
        scenarios: The text of a scenario file for each finding, as far as there are any.
        leaves: The same for branches of the tree that end, by number.
    """
    covered = proof.covered
    texts = [*scenarios, *[None] * (len(proof.found) - len(scenarios))]
    return {
        "schema": FUTURES_SCHEMA,
        "title": title,
        "answer": proof.answer.value,
        "headline": headline(proof),
        "found": [_wronged(*one) for one in zip(proof.found, texts, strict=True)],
        "open": list(proof.open),
        "unbounded": [
            {"name": one.name, "program": one.program, **_cause(one.cause)}
            for one in proof.unbounded
        ],
        "covered": {
            "states": covered.states,
            "decisions": covered.decisions,
            "merged": covered.merged,
            "ends": covered.ends,
            "motion_s": seconds(covered.motion_s),
            "quantified": list(covered.quantified),
            "bounded": list(covered.bounded),
            "sampled": list(covered.sampled),
            "assumed": list(covered.assumed),
            "dead": [one._asdict() for one in covered.dead],
        },
        "tree": [_branch(one, leaves.get(k)) for k, one in enumerate(proof.tree)],
    }


def _wronged(one: Wronged, scenario: str | None) -> Json:
    return {
        "wrong": one.wrong.value,
        "headline": one.headline,
        "time_s": seconds(one.time_s),
        **_cause(one.cause),
        "decisions": [_decided(decided) for decided in one.decisions],
        "confirmed": one.confirmed,
        "scenario": scenario,
    }


def _decided(one: Decided) -> Json:
    return {
        "time_s": seconds(one.time_s),
        "what": one.what.value,
        "number": one.number,
        "value": one.value,
        "words": decision(one),
        **_cause(one.cause),
    }


def _branch(one: Branch, scenario: str | None) -> Json:
    decided = None if one.decided is None else _decided(one.decided)
    ended_s = None if one.ended_s is None else seconds(one.ended_s)
    return {
        "parent": one.parent,
        "decided": decided,
        "ends": one.ends,
        "ended_s": ended_s,
        "into": one.into,
        "scenario": scenario,
    }


def _cause(cause: Cause | None) -> Json:
    if cause is None:
        return {"program": None, "step": None, "line": None}
    return {"program": cause.program, "step": cause.step, "line": cause.span.line}
