"""Environment files: what they say, and what is said of those that are wrong."""

import re
import textwrap
from importlib.resources import files
from math import inf

import pytest

from vrts.base.source import SourceFile
from vrts.prove.environment import reading
from vrts.prove.environment.environment import (
    Afterwards,
    Again,
    Answering,
    Answers,
    Counts,
    Environment,
    Held,
    Property,
    Pulsed,
    Quantifier,
    Span,
)
from vrts.prove.environment.reading import MOST_LISTED, read_environment
from vrts.scene.model import Parts


def read(text: str) -> Environment:
    found, said = read_environment(SourceFile("cell.toml", text))
    assert found is not None, said
    assert said == ()
    return found


def codes(text: str) -> list[str]:
    found, said = read_environment(SourceFile("cell.toml", text))
    assert found is None
    return [d.rule.code for d in said]


def described() -> str:
    """The file that the docstring of the reader shows."""
    assert reading.__doc__ is not None
    return "\n".join(re.findall(r"^    (.*)$", reading.__doc__, re.MULTILINE))


def test_everything_may_be_left_out() -> None:
    found = read("")
    usual = Environment(title="cell", digest=found.digest)
    assert found == usual
    assert len(found.digest) == 64


def test_analog_inputs_read_a_range_or_a_list() -> None:
    found = read(
        "[[analog]]\nchannel = 1\nrange = [0, 9]\n[[analog]]\nchannel = 8\ncounts = [7, -7, 7]\n"
    )
    assert found.analog == {1: Counts(0, 9), 8: Counts(-7, 7, (-7, 7))}


@pytest.mark.parametrize(
    ("lines", "code"),
    [
        ("range = [0, 9]", "V603"),
        ("channel = 0\nrange = [0, 9]", "V605"),
        ("channel = 1", "V565"),
        ("channel = 1\ncounts = []", "V565"),
        ("channel = 1\nrange = [9, 0]", "V565"),
        ("channel = 1\nrange = [0, 9]\ncounts = [1]", "V565"),
        ("channel = 1\nrange = [0, 9.5]", "V565"),
        ("channel = 1\nrange = [0, 9, 10]", "V604"),
        ("channel = 1\ncounts = [2048]", "V605"),
        ("channel = 1\ncounts = [1]\n[[analog]]\nchannel = 1\ncounts = [1]", "V474"),
    ],
)
def test_what_is_wrong_with_an_analog_input_is_told(lines: str, code: str) -> None:
    assert code in codes(f"[[analog]]\n{lines}\n")


def test_the_manual_shows_the_same_file() -> None:
    page = files("vrts").joinpath("manual", "understand", "futures.md").read_text("utf-8")
    assert f"```text\n{described_whole()}\n```" in page


def described_whole() -> str:
    """The same with its empty lines."""
    assert reading.__doc__ is not None
    return textwrap.dedent(reading.__doc__[reading.__doc__.index("    title =") :]).strip()


def test_the_file_that_is_described_says_what_it_shows() -> None:
    found = read(described())
    assert found.title == "the conveyor cell"
    assert dict(found.inputs) == {
        1002: Held(on=False),
        1003: Pulsed(Span(0.1, 0.5), Span(1.0, inf)),
        1004: Answering(1, Span(0.2, 3.0), Span(0.2, 3.0)),
    }
    assert found.answers == Answers(("1", "2", "5"))
    assert found.random == (0.0, 0.5, 0.99)
    assert found.misses
    assert found.speeds == (100.0, 50.0)
    assert found.stops == frozenset(Afterwards)
    assert found.again == Again(5, Parts.PUT_BACK)
    never, always = found.properties
    assert never.region is not None
    assert never._replace(region=None) == Property(
        Quantifier.NEVER,
        "output 3 only while the hand is closed",
        signals=(3,),
        hand="not closed",
        step=("main", 12),
        still=False,
    )
    assert (always.after, always.within_s, always.still) == (1001, 0.5, True)


@pytest.mark.parametrize(
    ("written", "again"),
    [
        ("", Again(0)),
        ("[execute]", Again(None)),
        ("[execute]\nagain = false", Again(0)),
        ('[execute]\ntimes = 3\nparts = "left"', Again(3, Parts.LEFT)),
    ],
)
def test_how_often_a_program_is_executed_again(written: str, again: Again) -> None:
    assert read(written).again == again


def test_numbers_of_a_range_may_be_typed() -> None:
    assert read("[prompts]\nrange = [0, 5]\nwhole = true").answers == Answers((), 0.0, 5.0, True)


INPUT = "[[inputs]]\nsignal = 1001\n"


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (INPUT + 'is = "free"\n' + INPUT + 'is = "free"', "V474"),
        (INPUT + 'is = "pulsed"\non_s = [2, 1]\noff_s = [1]', "V561"),
        (INPUT + 'is = "pulsed"\non_s = [0, 0]\noff_s = [1]', "V561"),
        ('[[never]]\ntitle = "x"', "V562"),
        ('[[never]]\nstill = true\nstep = "main"', "V562"),
        ("[[always]]\nstill = true\nafter = 1001", "V562"),
        ("[[always]]\nsignals = [0]", "V562"),
        ("[prompts]", "V563"),
        ('[prompts]\nanswers = ["1"]\nrange = [0, 1]', "V563"),
        ("[prompts]\nrange = [1, 0]", "V563"),
        ('[prompts]\nanswers = ["a\\nb"]', "V563"),
        ("[[inputs]]\nsignal = 1001\nis = 'free'\n" * (MOST_LISTED + 1), "V480"),
    ],
)
def test_what_is_wrong_is_told_once(text: str, code: str) -> None:
    assert codes(text) == [code]


@pytest.mark.parametrize(
    "text",
    [
        INPUT,
        INPUT + 'is = "fre"',
        INPUT + 'is = "held"',
        INPUT + 'is = "answers"\non_s = [1]\noff_s = [1]',
        INPUT + 'is = "pulsed"\non_s = [1, 1e9]\noff_s = [1]',
        "[[inputs]]\nsignal = 3\nis = 'free'",
        "[execute]\ntimes = 0",
        "[operator]\nspeeds = [0]",
        '[operator]\nstops = ["go"]',
        "[random]\ndraws = [-1]",
        "unknown = 1",
        "title = ",
    ],
)
def test_what_cannot_be_read_is_refused(text: str) -> None:
    assert codes(text)


@pytest.mark.parametrize("code", ["V561", "V562", "V563"])
def test_the_example_of_a_page_triggers_its_code(code: str) -> None:
    page = files("vrts").joinpath("pages", f"{code}.md").read_text("utf-8")
    example = re.search(r"```toml\n(.*?)```", page, re.DOTALL)
    assert example is not None
    assert codes(example[1]) == [code]
