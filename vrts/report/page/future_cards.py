"""What goes wrong in some future, as cards: its story, and the scenario that shows it."""

from collections.abc import Sequence

from vrts.check.verdict import Answer
from vrts.prove.proof import Proof, Wronged
from vrts.report.page.html import Child, Markup, element, prose
from vrts.report.plain import capital, one_line
from vrts.report.proof_words import counted, counts, headline, scenario_of, story

MOST_FOUND = 6  # cards
MOST_ROWS = 12  # of a story
MOST_LISTED = 40  # of a list

ANSWERS = {
    Answer.HOLDS: "holds",
    Answer.VIOLATED: "violated",
    Answer.UNDETERMINED: "undetermined",
}


def futures_section(proof: Proof) -> Markup:
    """Return the section of a page that is about one run of the same program."""
    return element(
        "section",
        element("h2", "Every future"),
        element("p", answer_mark(proof.answer), " ", prose(headline(proof)), ".", class_="lead"),
        *cards(proof.found),
        element("details", element("summary", "What was looked at"), *spoken_of(proof)),
        id="futures",
        class_="futures",
    )


def answer_mark(answer: Answer) -> Markup:
    """Return an answer as a word that stands out."""
    return element("b", ANSWERS[answer], class_=f"answer-{answer.value}")


def cards(found: Sequence[Wronged], acts: Sequence[Child] = ()) -> list[Markup]:
    """Return a card for each future that goes wrong, as far as they are shown.

    Args:
        found: What goes wrong, the shortest future first.
        acts: What can be done with each, as far as there is something.
    """
    given = [*acts, *[None] * len(found)]
    shown = [
        card(number, one, act)
        for number, (one, act) in enumerate(zip(found[:MOST_FOUND], given, strict=False), 1)
    ]
    left = len(found) - len(shown)
    return [*shown, element("p", f"{counted(left, 'more finding')} not shown.")] if left else shown


def card(number: int, one: Wronged, act: Child = None) -> Markup:
    """Return the card of a future that goes wrong."""
    rows = story(one)
    if len(rows) > MOST_ROWS:
        left = len(rows) - MOST_ROWS
        middle = (rows[MOST_ROWS - 2][0], "", f"and {left} more decisions")
        rows = [*rows[: MOST_ROWS - 2], middle, rows[-1]]
    steps = [
        element(
            "li",
            element("span", f"{time_s:.3f} s", class_="t"),
            element("span", prose(capital(one_line(what)))),
            element("span", where, class_="line") if where else None,
            class_="wrong" if k == len(rows) - 1 else None,
        )
        for k, (time_s, where, what) in enumerate(rows)
    ]
    return element(
        "article",
        element("h3", f"{number}. ", prose(capital(one_line(one.headline)))),
        element("ol", *steps, class_="story"),
        element(
            "details",
            element("summary", "The scenario in which it happens"),
            element("pre", scenario_of(one), class_="scenario", tabindex="0"),
        ),
        act,
        class_="future",
        id=f"future-{number}",
    )


def spoken_of(proof: Proof) -> list[Markup]:
    """Return over what the answer speaks, in lists."""
    covered = proof.covered
    grows = [f"`{one.name}` in `{one.program}`" for one in proof.unbounded]
    dead = [f"{one.program} {one.step}: {one.reason}" for one in covered.dead]
    parts = (
        ("Not looked at", proof.open),
        ("For every choice of", covered.quantified),
        ("Within", covered.bounded),
        ("Tried at some values only", covered.sampled),
        ("Taken for granted", covered.assumed),
        ("Grows without bound while the program goes on", grows),
        ("Steps that no future executes", dead),
    )
    lists = [_listed(title, rows) for title, rows in parts if rows]
    return [
        element("p", f"{counts(proof)}.", class_="counts"),
        element("div", *lists, class_="spoken"),
    ]


def _listed(title: str, rows: Sequence[str]) -> Markup:
    items = [element("li", prose(one_line(row))) for row in rows[:MOST_LISTED]]
    if len(rows) > MOST_LISTED:
        items.append(element("li", f"and {len(rows) - MOST_LISTED} more"))
    return element("div", element("h3", title), element("ul", *items))
