"""Which steps of a lesson are done, and which comes next."""

from pathlib import Path
from typing import NamedTuple

from vrts.learn.lesson import DONE, Answer, Lesson, ProgramWish, Step
from vrts.learn.looking import Looking


class Progress(NamedTuple):
    """How far somebody is in a lesson."""

    lesson: Lesson
    done: tuple[bool, ...]  # beside `lesson.steps`
    next: int | None  # index of the first step that is not done; None: all are
    answer: Answer  # why that is not done

    @property
    def step(self) -> Step | None:
        """The step that comes next."""
        return None if self.next is None else self.lesson.steps[self.next]


def progress(lesson: Lesson, folder: Path) -> Progress:
    """Return how far the files of a folder are.

    A program grows from step to step, so a step is done, too, when a later one about the same file
    is. Each step is looked at by what is in the folder now; nothing is remembered between calls.
    """
    looking = Looking(folder)
    answers = [looking.at(step.wish) for step in lesson.steps]
    done = [answer.done for answer in answers]
    latest: set[str] = set()  # files of which a later step is done
    for index in reversed(range(len(done))):
        wish = lesson.steps[index].wish
        if not isinstance(wish, ProgramWish):
            continue
        done[index] |= wish.file in latest
        if done[index]:
            latest.add(wish.file)
    first = next((index for index, is_done in enumerate(done) if not is_done), None)
    answer = DONE if first is None else answers[first]
    return Progress(lesson, tuple(done), first, answer)
