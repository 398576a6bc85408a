"""The hidden part of a task: further goals, via points and the like, added for marking only.

`staff/task.toml` is read as if it stood at the end of `task.toml`, so whatever a task may ask for
can be hidden, and is checked in the same way, also against the public part. It cannot change what
students are told: title, scene, times and weights stay as they are.
"""

from collections.abc import Mapping
from dataclasses import fields, replace
from typing import Any, NamedTuple, cast

from vrts.base.diagnostic import Diagnostic, Rule
from vrts.base.source import SourceFile, Span
from vrts.base.toml.appended import Appended
from vrts.base.toml.reading import Table, read_toml
from vrts.check.task.task import Task
from vrts.check.task.task_file import read_task
from vrts.check.variants.model import Variants
from vrts.scene.model import Scene

STAFF_PART = Rule("V664", "staff-part")

PUBLIC_ONLY = ("task", "time", "mark", "late", "exam", "submissions", "settings", "variants")


class WholeTask(NamedTuple):
    """A task with its hidden part."""

    task: Task | None  # None: something is wrong
    hidden: Mapping[str, int]  # how many are hidden of what: "goal", "via", ...
    diagnostics: tuple[Diagnostic, ...]


def read_whole_task(
    public: SourceFile, staff: SourceFile, scene: Scene, name: str | None = None
) -> WholeTask:
    """Return a task with its hidden part; spans and diagnostics point into the right file.

    Args:
        public: What students have of it.
        staff: What is hidden from them.
        scene: What the task is done in.
        name: As for `read_task`.
    """
    open_part, found = read_task(public, scene, name)
    if open_part is None:
        return WholeTask(None, {}, found)
    top, problems = read_toml(staff)
    if top is None:
        return WholeTask(None, {}, problems.in_order())
    for key in top.keys:
        if key in PUBLIC_ONLY or not _header(top, key):
            problems.error(
                STAFF_PART,
                f"`{key}` cannot be hidden from students",
                top.span_of(key),
                help=("write it in the public `task.toml`; hide `[[goal]]`, `[[via]]` and others",),
            )
    hidden = {
        key: len(top.tables(key)) if _header(top, key).startswith("[[") else 1 for key in top.keys
    }
    if problems.any_error:
        return WholeTask(None, {}, problems.in_order())
    home = Appended(public, staff)
    task, told = read_task(home.joined, scene, name)
    moved = tuple(home.diagnostic(d) for d in told)
    if task is None:
        return WholeTask(None, {}, moved)
    whole = replace(_task(task, home), variants=open_part.variants)  # which is never hidden
    return WholeTask(whole, hidden, moved)


def _header(top: Table, key: str) -> str:
    """Return the header of a table, as `[[goal]]`; "" for a plain key."""
    span = top.span_of(key)
    line = span.source.line_text(span.line).strip()
    return line if line.startswith("[") else ""


def _task(task: Task, home: Appended) -> Task:
    """Return a task with the places of whatever it asks for in the right file."""
    changes: dict[str, Any] = {}
    for field in fields(task):
        value: Any = getattr(task, field.name)
        if isinstance(value, tuple) and not isinstance(value, Variants):  # which is never hidden
            items = cast("tuple[Any, ...]", value)
            changes[field.name] = tuple(_item(item, home) for item in items)
    if task.proof is not None:
        span = home.span(task.proof.span)
        hidden = task.proof.hidden or span.source is home.second
        changes["proof"] = replace(task.proof, span=span, hidden=hidden)
    return replace(task, **changes)


def _item(item: Any, home: Appended) -> Any:
    span = getattr(item, "span", None)
    return item._replace(span=home.span(span)) if isinstance(span, Span) else item
