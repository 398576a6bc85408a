"""The JSON schema that OASIS gives for SARIF, as a check."""

import json
from typing import Any

from jsonschema import Draft7Validator

from tests.places import TESTS

SCHEMA = TESTS / "data" / "sarif-2.1.0.schema.json"

_validator: Any = Draft7Validator(json.loads(SCHEMA.read_text("utf-8")))


def schema_errors(log: object) -> list[str]:
    """Return what the schema finds wrong in a SARIF log: where, and what."""
    return [f"{error.json_path}: {error.message}" for error in _validator.iter_errors(log)]
