"""The tutorial of the first example tells the truth."""

import re

from tests.golden.tutorial import README, follow, matches


def test_every_command_of_the_tutorial_answers_as_shown() -> None:
    steps = list(follow(README.read_text(encoding="utf-8")))
    assert len(steps) > 10, "the tutorial has lost its commands"
    for step in steps:
        assert step.fits, (
            f"README.md:{step.line}: $ {step.command}\n"
            f"--- shown\n{step.shown}\n--- real\n{step.real}\n"
            "(python -m tests.golden.regenerate writes the real output)"
        )


def test_an_ellipsis_stands_for_any_lines_but_not_for_a_change() -> None:
    assert matches("a\n…\nd\n", "a\nb\nc\nd\n")
    assert matches("a\n…\n", "a\n")
    assert not matches("a\n…\nd\n", "a\nb\nc\ne\n")
    assert not matches("a\n", "a\nb\n")
    assert matches("a\n", "a  \n")


def test_every_picture_of_the_tutorial_exists() -> None:
    pictures = re.findall(r"!\[[^]]+\]\(([^)]+)\)", README.read_text(encoding="utf-8"))
    assert len(pictures) >= 7
    assert [p for p in pictures if not (README.parent / p).is_file()] == []
