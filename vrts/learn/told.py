"""Lessons and progress as text for a terminal."""

from collections.abc import Sequence
from textwrap import fill

from vrts.learn.library import Bundled
from vrts.learn.progress import Progress
from vrts.report.plain import one_line

WIDTH = 100


def lessons_text(lessons: Sequence[Bundled]) -> str:
    """Return the list of lessons."""
    widest = max(len(one.lesson.title) for one in lessons)
    lines = [
        f"{one.lesson.number}  {one.lesson.title:{widest}}  {one.lesson.minutes:>3} min"
        f"  {len(one.lesson.steps):>2} steps  {one.lesson.about}"
        for one in lessons
    ]
    return "\n".join(
        [
            *map(one_line_of, lines),
            "",
            "Copy one and begin:  vrts learn 1",
            "Then, in its folder: vrts learn next",
        ]
    )


def one_line_of(line: str) -> str:
    """Return a row of the list with its blanks, and nothing that would steer a terminal."""
    return "".join(character if character.isprintable() else " " for character in line)


def progress_text(found: Progress) -> str:
    """Return what is done, what comes next, and what stands in the way."""
    lesson = found.lesson
    count = sum(found.done)
    lines = [f"{one_line(lesson.title)}: {count} of {len(lesson.steps)} steps done"]
    for number, (step, done) in enumerate(zip(lesson.steps, found.done, strict=True), 1):
        sign = "done" if done else "next" if number - 1 == found.next else "    "
        lines.append(f"  {sign}  {number:>2}  {one_line(step.title)}")
    step = found.step
    if step is None:
        return "\n".join([*lines, "", "All steps are done. `vrts learn` lists the other lessons."])
    place = f"; read README.md, {one_line(step.part)}" if step.part else ""
    lines += ["", f"next: {one_line(step.title)} ({step.minutes} min{place})"]
    lines.append(_wrapped(one_line(step.does)))
    lines += [f"  $ {one_line(command)}" for command in step.tries]
    lines += ["", _wrapped(f"not yet: {one_line(found.answer.why)}")]
    if found.answer.hint:
        lines.append(_wrapped(f"hint: {one_line(found.answer.hint)}"))
    return "\n".join(lines)


def _wrapped(text: str) -> str:
    return fill(text, WIDTH, break_long_words=False, break_on_hyphens=False)
