"""JSON Schemas of the files that people write, made by `python -m tests.schemas`.

In: the name of a kind of file. Out: its schema as text.
Data beside this file: nothing here reads scenes or tasks.
"""

from pathlib import Path

FOLDER = Path(__file__).parent
KINDS = ("scene", "lab", "task", "scenario", "environment", "columns")


def input_schema(kind: str) -> str:
    """Return the JSON Schema, draft 4, of a kind of file, one of `KINDS`."""
    return (FOLDER / f"{kind}.schema.json").read_text("utf-8")
