"""The walk-through for authors tells the truth, from an empty folder to marks."""

import pytest

from tests.golden.authoring import WALK, in_an_empty_folder
from tests.golden.tutorial import follow

LONGEST = 600  # lines: five pages are text, the rest is files, and what commands answer


@pytest.mark.thorough
def test_every_command_of_the_walk_through_answers_as_shown() -> None:
    steps = in_an_empty_folder(lambda text, folder: list(follow(text, folder)))
    for word in ("new scene", "scene check", "new task", "task check", "task pack", "grade"):
        assert any(step.command.startswith(f"vrts {word}") for step in steps), word
    for step in steps:
        assert step.fits, (
            f"07-own-assignment/README.md:{step.line}: $ {step.command}\n"
            f"--- shown\n{step.shown}\n--- real\n{step.real}\n"
            "(python -m tests.golden.authoring writes the real output)"
        )
    assert len(WALK.read_text(encoding="utf-8").splitlines()) <= LONGEST
