"""The tutorials of the examples tell the truth."""

import re
from pathlib import Path

import pytest

from tests.golden.examples import EXAMPLES
from tests.golden.tutorial import follow, matches

each_example = pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: example.name)
LARGEST = 300_000  # bytes of a picture


def readme(example: Path) -> str:
    return (example / "README.md").read_text(encoding="utf-8")


@pytest.mark.thorough
@each_example
def test_every_command_of_a_tutorial_answers_as_shown(example: Path) -> None:
    steps = list(follow(readme(example), example))
    assert len(steps) > (10 if example == EXAMPLES[0] else 2), "the tutorial has lost its commands"
    for step in steps:
        assert step.fits, (
            f"{example.name}/README.md:{step.line}: $ {step.command}\n"
            f"--- shown\n{step.shown}\n--- real\n{step.real}\n"
            "(python -m tests.golden.regenerate writes the real output)"
        )


def test_an_ellipsis_stands_for_any_lines_but_not_for_a_change() -> None:
    assert matches("a\n…\nd\n", "a\nb\nc\nd\n")
    assert matches("a\n…\n", "a\n")
    assert not matches("a\n…\nd\n", "a\nb\nc\ne\n")
    assert not matches("a\n", "a\nb\n")
    assert matches("a\n", "a  \n")


@each_example
def test_every_picture_of_a_tutorial_exists_and_is_small(example: Path) -> None:
    pictures = re.findall(r"!\[[^]]+\]\(([^)]+)\)", readme(example))
    assert len(pictures) >= (7 if example == EXAMPLES[0] else 2)
    assert [p for p in pictures if not (example / p).is_file()] == []
    assert [p for p in pictures if (example / p).stat().st_size >= LARGEST] == []
