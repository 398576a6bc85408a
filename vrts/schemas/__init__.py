"""JSON Schemas of the files that people write, made by `python -m tests.schemas`.

In: the name of a kind of file. Out: its schema as text.
Data beside this file: nothing here reads scenes or tasks.
"""

from fnmatch import fnmatchcase
from pathlib import Path, PurePath

FOLDER = Path(__file__).parent
KINDS = ("scene", "lab", "task", "scenario", "environment", "columns")
FILES = {  # how files are called that a schema is of; others say `#:schema` in their first line
    "scene": ("scene.toml",),
    "lab": ("lab.toml", "*-lab.toml"),
    "task": ("task.toml",),
    "scenario": ("scenario.toml", "*-scenario.toml"),
    "environment": ("environment.toml", "*-environment.toml"),
    "columns": ("columns.toml", "*-columns.toml"),
}


def kind_of(path: str) -> str | None:
    """Return the kind of a file by its name, one of `KINDS`; None: its name tells none."""
    name = PurePath(path).name
    return next((k for k, names in FILES.items() if any(fnmatchcase(name, n) for n in names)), None)


def input_schema(kind: str) -> str:
    """Return the JSON Schema, draft 4, of a kind of file, one of `KINDS`."""
    return (FOLDER / f"{kind}.schema.json").read_text("utf-8")
