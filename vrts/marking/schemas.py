"""The JSON Schemas of the files that marking writes, and of proofs over every future."""

from typing import Any

import msgspec

from vrts.marking.by_hand.decisions.listing import Listing
from vrts.marking.by_hand.decisions.records import Line
from vrts.marking.result import Result
from vrts.marking.row import Class
from vrts.marking.similarity.ranking import Ranking
from vrts.report.formats.debug_schema import Debugged
from vrts.report.formats.futures_schema import Futures

SCHEMAS: dict[str, tuple[Any, str]] = {
    "result": (Result, "Result of one VAL-II submission marked by vrts"),
    "class": (Class, "Marks of a class"),
    "similarity": (Ranking, "Programs of a class that are alike"),
    "decisions": (Line, "A line of a grader's file in `staff/decisions`, after the first"),
    "decided": (Listing, "What `vrts grade decisions --format json` prints"),
    "futures": (Futures, "Every future of a VAL-II program, as `vrts prove` found it"),
    "debug": (Debugged, "A line of what `vrts debug --json` prints: what one command did"),
}


def schema(name: str) -> dict[str, Any]:
    """Return a JSON Schema (draft 2020-12) by its name in `SCHEMAS`."""
    kind, title = SCHEMAS[name]
    found = msgspec.json.schema(kind)
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": title, **found}
