"""Every real is a single-precision number; too large is an error; nothing is infinite or NaN."""

import math
import struct

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import examples
from tests.support_engine import runs, words
from vrts.base.numbers import single
from vrts.engine.run import Run

LARGEST = 3.4028234663852886e38

NUMBERS = st.sampled_from(
    [
        "0",
        "1",
        "-1",
        "0.1",
        "3",
        "1E38",
        "-3E38",
        "1E-38",
        "7.3E-20",
        "16777216",
        "123456.7",
        "n",
        "k",
    ]
)
UNARY = st.sampled_from(
    [
        "-({})",
        "ABS({})",
        "INT({})",
        "FRACT({})",
        "SQR({})",
        "SQRT({})",
        "SIN({})",
        "COS({})",
        "SIGN({})",
        "DX(TRANS({},1,2,3,4,5))",
        "DISTANCE(NULL,TRANS({},0,0,90,-90,0))",
        "DZ(SHIFT(NULL BY ,,{}))",
        "VAL($ENCODE({}))",
        "TIMER(1)*({})",
        "RANDOM*({})",
    ]
)
BINARY = st.sampled_from(
    [
        "({})+({})",
        "({})-({})",
        "({})*({})",
        "({})/({})",
        "({}) MOD ({})",
        "ATAN2({},{})",
        "MAX({},{})",
        "({}) < ({})",
        "DY(TRANS({},{},2,3,4,5):TRANS(1,2,3,4,5,6))",
    ]
)


def one(form: str, x: str) -> str:
    return form.format(x)


def two(form: str, x: str, y: str) -> str:
    return form.format(x, y)


def assigned(place: str, value: str) -> str:
    return f"{place} = {value}"


def larger(inner: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    return st.builds(one, UNARY, inner) | st.builds(two, BINARY, inner, inner)


EXPRESSIONS = st.recursive(NUMBERS, larger, max_leaves=5)
PLACES = st.sampled_from(["n", "k", "m[1]", "m[2]", "m[3,1]"])
STEPS = st.lists(st.builds(assigned, PLACES, EXPRESSIONS), max_size=6)


def is_single(value: float) -> bool:
    return struct.unpack("<f", struct.pack("<f", value))[0] == value and math.isfinite(value)


def reals(run: Run) -> list[float]:
    """Return every real that any variable ever had."""
    found: list[float] = []
    for count in range(run.statements + 1):
        values = run.at_statement(count).variables.values()
        found += [value for value in values if isinstance(value, float)]
    return found


@given(STEPS)
@settings(max_examples=examples(60), deadline=None)
def test_every_real_in_memory_is_single(steps: list[str]) -> None:
    caught = ".PROGRAM next\nRETURNE\n.END\n"
    body = "\n".join(["REACTE next", "n = 1.1", "k = -7", *steps])
    run = runs(body, caught)
    values = reals(run)
    assert len(values) > 2
    assert all(map(is_single, values))


@given(st.lists(EXPRESSIONS, min_size=1, max_size=4))
@settings(max_examples=examples(30), deadline=None)
def test_numbers_passed_to_programs_are_single_too(values: list[str]) -> None:
    caught = ".PROGRAM next\nRETURNE\n.END\n.PROGRAM take(x)\ngot = x\n.END\n"
    body = "\n".join(["REACTE next", "n = 1.1", "k = 0.3", *(f"CALL take({v})" for v in values)])
    assert all(map(is_single, reals(runs(body, caught))))


ROUNDED = [
    ("x = 0.1", single(0.1)),
    ("x = 1/3", single(1 / 3)),
    ("x = 0.1+0.2", single(single(0.1) + single(0.2))),
    ("x = 16777216+1", 16777216.0),
    ("x = 16777217", 16777216.0),
    ("n = 16777216\nk = 1\nx = ABS(n)+ABS(k)", 16777216.0),
    ("n = 16777216\nk = 1\nx = (ABS(n)+ABS(k))+(k-k)", 16777216.0),
    ("x = 1E-30*1E-30", 0.0),
    ("x = SIN(30)", 0.5),
    ("FOR x = 0 TO 1 STEP 0.1\nEND", None),
    ("SET p = TRANS(0.1,0,0,90,-90,0)\nx = DX(p)", single(0.1)),
    ("TIMER 1 = 0.1\nx = TIMER(1)", single(0.1)),
    ("BITS 1,4 = 9\nx = BITS(1,4)", 9.0),
    ("PARAMETER HAND.TIME = 0.1\nx = PARAMETER(HAND.TIME)", single(0.1)),
]


@pytest.mark.parametrize(("body", "value"), ROUNDED)
def test_results_are_rounded_once(body: str, value: float | None) -> None:
    run = runs(body)
    found = run.at(run.horizon_s).variables["x"]
    assert isinstance(found, float)
    assert is_single(found)
    if value is not None:
        assert found == value


OVERFLOWS = [
    "x = 1E38*10",
    "x = 3E38+3E38",
    "x = -3E38-3E38",
    "x = 1E38/0.01",
    "x = SQR(1E20)",
    "x = 1E30\nFOR i = 1 TO 20\nx = x*x\nEND",
    "x = DISTANCE(TRANS(3E38,3E38,0),NULL)",
]


@pytest.mark.parametrize("body", OVERFLOWS)
def test_what_is_too_large_is_an_error(body: str) -> None:
    run = runs(body)
    assert words(run) == ["Arithmetic overflow"]
    assert all(map(is_single, reals(run)))


def test_the_largest_number_is_no_error() -> None:
    run = runs("x = 3.4028234E38\ny = -x\nz = x/10*10")
    assert run.findings == ()
    assert run.at(run.horizon_s).variables["x"] == LARGEST
