"""Every recipe of the manual does what it shows: its files are written, its commands typed."""

import pytest

from tests.golden.recipes import followed, recipes, text_of

MARKING = {  # a process for each program: long
    *("answer-an-appeal", "change-a-mark", "find-copied-programs", "mark-a-class"),
    *("mark-on-other-machines", "mark-without-names", "marks-into-moodle"),
    *("decide-with-others", "give-each-student-a-variant", "mark-at-the-desk"),
    *("see-who-moves-after-a-repair", "fair-variants", "exam", "unsafe-marks", "late-work"),
    *("bring-it-to-the-robot", "find-what-is-wrong-with-the-robot"),
}
LEAST = 90
LONGEST = 100  # lines: a page that is read in a minute
SHORTEST = 3  # words that others say for it


@pytest.mark.thorough
@pytest.mark.parametrize(
    "recipe",
    [pytest.param(r, marks=pytest.mark.thorough if r in MARKING else ()) for r in recipes()],
)
def test_every_command_of_a_recipe_answers_as_shown(recipe: str) -> None:
    steps = followed(recipe)
    assert steps, "a recipe shows what to type, and what comes of it"
    for step in steps:
        assert step.fits, (
            f"{recipe}.md:{step.line}: $ {step.command}\n"
            f"--- shown\n{step.shown}\n--- real\n{step.real}\n"
            "(python -m tests.golden.recipes writes the real output)"
        )
        assert step.shown.strip(), f"{recipe}.md:{step.line}: shows no output"


def test_recipes_are_short_and_many() -> None:
    assert len(recipes()) >= LEAST
    for recipe in recipes():
        text = text_of(recipe)
        assert len(text.splitlines()) <= LONGEST, recipe
        assert "\nLook up next: " in text, f"{recipe}: says what to look up next"
        keywords = text.partition("keywords: ")[2].partition("\n---")[0]
        assert keywords.count(",") >= SHORTEST, f"{recipe}: says what others call it"
        assert "Traceback" not in text, recipe
        assert "itself failed" not in text, recipe
