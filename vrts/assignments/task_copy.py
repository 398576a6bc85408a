"""A new task that begins as a copy of an example: its goals, times and reference."""

from pathlib import Path

from vrts.assignments.new_files import quoted
from vrts.assignments.task_folder import reference_of
from vrts.base.source import SourceFile
from vrts.base.toml.reading import read_toml
from vrts.pipeline.files import SCENE_FILE, TASK_FILE, find_example, read_bytes, read_toml_source


def example_folder(origin: str | None) -> Path | None:
    """Return the folder of an example with a task and a reference; None for anything else."""
    folder = None if origin is None else find_example(origin)
    if folder is None or not (folder / TASK_FILE).is_file() or reference_of(folder) is None:
        return None
    return folder


def copied_task(folder: Path, title: str | None) -> bytes:
    """Return the task of an example, set in the scene beside it, with another title if given."""
    source = read_toml_source(folder / TASK_FILE)
    top, _ = read_toml(source)
    section = None if top is None else top.table("task")
    assert section is not None, "examples are read before they are copied"
    places = [(section.value_span("scene"), f'"{SCENE_FILE}"')]
    if title is not None and "title" in section:
        places.append((section.value_span("title"), quoted(title)))
    text = source.text
    for span, value in sorted(places, reverse=True):
        text = text[: span.start] + value + text[span.end :]
    assert read_toml(SourceFile(TASK_FILE, text))[0] is not None
    return text.encode()


def copied_reference(folder: Path) -> bytes:
    """Return the reference of an example."""
    place = reference_of(folder)
    assert place is not None
    return read_bytes(place)
