"""The JSON Schemas of the files that marking writes, and of proofs over every future."""

from typing import Any

import msgspec

from vrts.marking.result import Result
from vrts.marking.row import Class
from vrts.marking.similarity.ranking import Ranking
from vrts.report.formats.futures_schema import Futures

SCHEMAS: dict[str, tuple[type, str]] = {
    "result": (Result, "Result of one VAL-II submission marked by vrts"),
    "class": (Class, "Marks of a class"),
    "similarity": (Ranking, "Programs of a class that are alike"),
    "futures": (Futures, "Every future of a VAL-II program, as `vrts prove` found it"),
}


def schema(name: str) -> dict[str, Any]:
    """Return a JSON Schema (draft 2020-12) by its name in `SCHEMAS`."""
    kind, title = SCHEMAS[name]
    found = msgspec.json.schema(kind)
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": title, **found}
