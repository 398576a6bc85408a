"""What is wrong with a robot, as JSON."""

from collections.abc import Mapping, Sequence

import msgspec

from vrts.base.units import DEG, MM
from vrts.report.formats.diagnostic_json import diagnostic_json
from vrts.validate.identify.causes import Cause
from vrts.validate.identify.identified import Identified, Number, Remaining
from vrts.validate.identify.words import name_of, unit_of
from vrts.validate.reports.identified_schema import IdentifiedForm
from vrts.validate.reports.identified_text import sentence

FORMAT = 1
TITLE = "What is wrong with a robot, as `vrts validate --identify` found it"
DECIMALS = 6


def identified_json(found: Identified) -> Mapping[str, object]:
    """Return the answer as a document."""
    return {
        "format": FORMAT,
        "sentence": sentence(found),
        "fits": found.fits,
        "causes": [_number(number) for number in found.numbers],
        "clock": {
            "add_s": _round(found.clock_s),
            "half_95_s": _round(found.clock_half_s),
            "own_rests": found.own_rests,
        },
        "cannot_be_told_apart": [[name_of(a), name_of(b)] for a, b in found.pairs],
        "not_seen": [name_of(cause) for cause in found.silent],
        "left_over": [_left(r) for r in found.remaining],
        "log": {
            "name": found.log,
            "sha256": found.sha256,
            "synthetic": found.synthetic,
            "rows": found.rows,
        },
        "diagnostics": [diagnostic_json(d) for d in found.findings],
    }


def identified_schema() -> Mapping[str, object]:
    """Return the JSON Schema (draft 2020-12) of the answer for one log."""
    found = msgspec.json.schema(IdentifiedForm)
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": TITLE, **found}


def _number(number: Number) -> dict[str, object]:
    unit = unit_of(number.cause.kind)
    return {
        "kind": number.cause.kind.value,
        "name": name_of(number.cause),
        "unit": unit.name,
        "value": _round(number.value / unit.size),
        "low_95": _round(number.low / unit.size),
        "high_95": _round(number.high / unit.size),
        "as_well": [_names(group) for group in number.alike],
    }


def _names(group: Sequence[Cause]) -> list[str]:
    return [name_of(cause) for cause in group]


def _left(r: Remaining) -> dict[str, object]:
    unit, name = (DEG, "deg") if r.joint else (MM, "mm")
    return {
        "channel": r.name.lower(),
        "unit": name,
        "clock_alone_rms": _round(r.before / unit),
        "rms": _round(r.after / unit),
        "pattern_rms": _round(r.patterned / unit),
    }


def _round(value: float) -> float:
    return round(value, DECIMALS) + 0.0
