"""The README.md of a task's folder: as it is handed out, and what is to be said about it."""

from pathlib import Path

from vrts.assignments.handed.comments import comment_findings
from vrts.assignments.handed.facts import Fact, facts_of
from vrts.assignments.handed.first_ones import first_ones
from vrts.assignments.handed.from_network import network_findings
from vrts.assignments.handed.prose import contradictions
from vrts.assignments.handed.readme import NAME, differences, marker_findings, part_of, written
from vrts.assignments.handed.task_words import task_words
from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.base.toml.reading import read_toml
from vrts.check.task.task import Task
from vrts.pipeline.files import CannotRead, member_bytes, shown
from vrts.pipeline.refused import Refused
from vrts.pipeline.setting import Setting
from vrts.pipeline.settings import load_task
from vrts.report.plain import one_line

LARGEST = 1_000_000  # bytes


def readme_to_hand_out(folder: Path, public: Setting) -> bytes:
    """Return the README of a task with its part written again; a new one where there is none.

    Args:
        folder: Of the task.
        public: The task without its hidden part.

    Raises:
        CannotRead: It is no text, or too large.
        Refused: The markers of its part are not sound, or the hidden part has errors.
    """
    task = public.task
    assert task is not None
    text = _text(folder / NAME)
    if text is None:
        made = _made(folder, task)
        wrong, text = marker_findings(made), made.text
    else:
        wrong = marker_findings(SourceFile(shown(folder / NAME), text.replace("\r\n", "\n")))
    if wrong:
        raise Refused(wrong)
    words = task_words(task, public.scene, hidden=_has_more(folder))
    return written(text, words).encode()


def handed_findings(folder: Path, public: Setting) -> tuple[Diagnostic, ...]:
    """Return where the words that students get do not say what the task says.

    Args:
        folder: Of the task.
        public: The task without its hidden part.

    Raises:
        CannotRead: The README is no text, or too large.
    """
    task = public.task
    assert task is not None
    words = task_words(task, public.scene, hidden=_has_more(folder))
    facts = facts_of(task, public.scene)
    found = [*_of_description(public, facts), *comment_findings(folder, facts)]
    found += [*network_findings(folder, task)]
    text = _text(folder / NAME)
    if text is None:
        return (*found, *marker_findings(_made(folder, task)))
    source = SourceFile(shown(folder / NAME), text.replace("\r\n", "\n"))
    wrong = marker_findings(source)
    if wrong:
        return (*found, *wrong)
    part = part_of(source.text)
    without = None if part is None else (part.start, part.end)
    return (
        *found,
        *first_ones(differences(source, words, folder), "line"),
        *first_ones(contradictions(source, facts, without), "number"),
    )


def _has_more(folder: Path) -> bool:
    """Return whether marking has hidden checks: in `staff`, or announced by a packed task."""
    whole = load_task(folder, staff=True)
    return whole.hidden > 0 or whole.more > 0


def _made(folder: Path, task: Task) -> SourceFile:
    """Return the page that is made where there is none, without the part that is written."""
    said = f"\n{task.description}\n" if task.description else ""
    name = f"{shown(folder / NAME)} (as made from `title` and `description`)"
    return SourceFile(name, f"# {one_line(task.title)}\n{said}")


def _of_description(public: Setting, facts: tuple[Fact, ...]) -> tuple[Diagnostic, ...]:
    source = public.sources.task
    top = None if source is None else read_toml(source)[0]
    section = None if top is None else top.table("task")
    if source is None or section is None or "description" not in section:
        return ()
    span = section.value_span("description")
    blank = "".join("\n" if c == "\n" else " " for c in source.text[: span.start])
    inside = SourceFile(source.name, blank + source.text[span.start : span.end])
    return tuple(first_ones(contradictions(inside, facts, called="the `description`"), "number"))


def _text(path: Path) -> str | None:
    """Return the text of a file; None where it is not there."""
    if not path.is_file():
        return None
    data = member_bytes(path)
    if len(data) > LARGEST:
        raise CannotRead(f"`{shown(path)}` is too large: more than {LARGEST:,} bytes")
    try:
        return data.decode()
    except UnicodeDecodeError as problem:
        hint = ("save it as UTF-8",)
        raise CannotRead(f"`{shown(path)}` is not UTF-8 text", hint) from problem
