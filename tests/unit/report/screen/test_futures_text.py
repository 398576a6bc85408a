"""What a terminal says of a proof over every future."""

from dataclasses import replace

from tests.unit.report.proofs import HITS, HOLDS, OPEN, VIOLATED
from vrts.prove.proof import Variable
from vrts.report.proof_words import diagnostic
from vrts.report.screen.futures_text import MOST_FOUND, futures_text


def test_what_holds_says_over_what_it_speaks() -> None:
    assert futures_text("lower.v2", HOLDS, color=False) == (
        "lower.v2: holds\n"
        "Nothing goes wrong, in any future\n"
        "\n"
        "1,234 states, 56 decisions, 1 end; 12.3 s of different motion checked for contacts\n"
        "for every choice of:\n"
        "  input 1001: on or off in every tick\n"
        "taken for granted:\n"
        "  inputs come eventually\n"
        "steps that no future executes:\n"
        "  lower 9: no way leads there"
    )


def test_a_counterexample_is_told_as_a_story() -> None:
    text = futures_text("lower.v2", VIOLATED, color=False)
    assert text.startswith(
        "lower.v2: violated\n"
        "This can go wrong: the robot touches the table, 2.1 mm deep;"
        " 1 other thing can go wrong too\n"
        "\n"
        "error[V560 in-some-future]: in some future: the robot touches the table, 2.1 mm deep\n"
        " --> lower.v2:3:3\n"
    )
    assert "note: at 0.280 s, line 2: input 1001 is on\n" in text
    assert "note: at 1.000 s: the operator types PROCEED\n" in text
    assert "error[V560 in-some-future]: even if nothing comes from outside: `x` is divided" in text


def test_words_from_outside_steer_no_terminal() -> None:
    assert "\x1b" not in futures_text("a\x1b[1m.v2", VIOLATED, color=False)


def test_what_was_not_looked_at_is_said() -> None:
    text = futures_text("lower.v2", OPEN, color=False)
    assert text.startswith("lower.v2: undetermined\nNothing went wrong in the futures")
    assert "not looked at:\n  17 futures: the budget of states is spent" in text


def test_many_findings_are_counted() -> None:
    many = VIOLATED.__class__(VIOLATED.answer, (HITS,) * (MOST_FOUND + 2), VIOLATED.covered)
    assert "2 more findings not shown here" in futures_text("lower.v2", many, color=False)


def test_a_diagnostic_names_the_step_and_how_it_comes_to_that() -> None:
    found = diagnostic(HITS)
    assert found.primary is not None
    assert found.primary.span.text == "MOVES low"
    assert len(found.notes) == len(HITS.decisions)
    assert found.data == {"wrong": "contact", "time_s": 3.5}


def test_variables_that_grow_are_told() -> None:
    grown = replace(HOLDS, unbounded=(Variable("n", "lower", None),))
    text = futures_text("lower.v2", grown, color=False)
    assert "grows without bound while the program goes on:\n  `n` in `lower`" in text
