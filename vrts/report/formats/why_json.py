"""Chains of causes as JSON, as far as a reader may be told."""

from collections.abc import Sequence

from vrts.check.rules.hints import Hints
from vrts.report.assessment import Assessment
from vrts.report.formats.diagnostic_json import Json
from vrts.report.quantities import seconds
from vrts.why.chain import Chain, line, words

WHY_SCHEMA = "vrts.why/1"


def chains_json(a: Assessment, chains: Sequence[Chain], level: Hints) -> Json:
    """Return a document of chains."""
    return {
        "schema": WHY_SCHEMA,
        "id": a.identifier,
        "title": a.title,
        "hints": level.name.lower(),
        "chains": [
            {
                "effect": chain.effect,
                "kind": chain.kind or None,
                "because": links_json(chain, level),
            }
            for chain in chains
        ],
    }


def links_json(chain: Chain, level: Hints) -> list[Json]:
    """Return the links of a chain, what came last first; none where nothing may be told."""
    if level is Hints.NOTHING:
        return []
    return [
        {
            "time_s": None if link.time_s is None else seconds(link.time_s),
            "line": None if link.span is None else link.span.line,
            "says": words(link, level),
            "sentence": line(link, level),
        }
        for link in chain.links
    ]
