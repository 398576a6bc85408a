"""Laws of STORE: what is written is read back, and written again byte for byte."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.places import ROOT
from vrts.base.numbers import single
from vrts.base.oat import components
from vrts.base.pose import Pose
from vrts.base.source import SourceFile
from vrts.ir.module import Datum
from vrts.lang.compiler import Compilation, Options, compile_source
from vrts.lang.decimals import degrees_text, metres, millimetres_text, radians, single_text
from vrts.lang.dialect import DIALECTS, VAL2, VPLUS, Dialect
from vrts.lang.writing.store import store_text

PROGRAMS = [
    path.read_text("utf-8")
    for folder in ("tests/golden/lang", "examples/01-cans-on-bases")
    for path in sorted((ROOT / folder).glob("*.v2"))
]
NUMBERS = st.floats(-1e5, 1e5)
ANGLES = st.floats(-180.0, 180.0) | st.sampled_from([0.0, 90.0, -90.0, 180.0, -180.0, 89.99996])


def load(text: str, dialect: Dialect = VAL2) -> Compilation:
    return compile_source(SourceFile("a.lc", text), Options(dialect))


def store(compilation: Compilation, *, exact: bool = False) -> str:
    assert compilation.module is not None, compilation.diagnostics
    assert compilation.source is not None
    return store_text(compilation.source, compilation.module, compilation.dialect, exact=exact)


def values(compilation: Compilation) -> dict[tuple[str, tuple[int, ...]], Datum]:
    assert compilation.module is not None, compilation.diagnostics
    return {(d.name, d.subscripts): d for d in compilation.module.data}


@pytest.mark.parametrize("text", PROGRAMS)
def test_programs(text: str) -> None:
    first = load(text)
    once = store(first)
    second = load(once)
    assert store(second) == once
    assert second.module is not None
    assert first.module is not None
    assert sorted(second.module.programs) == sorted(first.module.programs)
    for name, program in first.module.programs.items():
        again = second.module.programs[name]
        assert len(again.instructions) == len(program.instructions)
        assert again.steps == program.steps


LINES = st.lists(
    st.tuples(
        st.integers(0, 40),
        st.sampled_from("xyz"),
        st.tuples(NUMBERS, NUMBERS, NUMBERS, ANGLES, ANGLES, ANGLES),
    ),
    min_size=1,
    max_size=6,
)


@given(LINES, st.sampled_from(sorted(DIALECTS.values())))
def test_locations(lines: list[tuple[int, str, tuple[float, ...]]], dialect: Dialect) -> None:
    rows = [f"{name}{n} {' '.join(map(repr, six))}" for n, name, six in lines]
    joints = [f"#{name}{n} {' '.join(map(repr, six))}" for n, name, six in lines]
    first = load("\n".join([".LOCATIONS", *rows, *joints, ".END", ""]), dialect)
    once = store(first)
    second = load(once, dialect)
    assert store(second) == once
    for place, datum in values(first).items():
        again = values(second)[place].value
        if isinstance(datum.value, Pose):
            assert isinstance(again, Pose)
            assert components(again)[:3] == pytest.approx(components(datum.value)[:3], abs=6e-5)
            turn = zip(again.rotation, datum.value.rotation, strict=True)
            assert all(math.isclose(a, b, abs_tol=3e-6) for a, b in turn)


@given(LINES)
def test_exact_locations_come_back_bit_for_bit(
    lines: list[tuple[int, str, tuple[float, ...]]],
) -> None:
    rows = [f"{name}{n} {' '.join(map(repr, six))}" for n, name, six in lines]
    joints = [f"#{name}{n} {' '.join(map(repr, six))}" for n, name, six in lines]
    first = load("\n".join([".LOCATIONS", *rows, *joints, ".END", ""]))
    second = load(store(first, exact=True))
    assert store(second, exact=True) == store(first, exact=True)
    for place, datum in values(first).items():
        assert values(second)[place].value == datum.value


@given(st.floats(width=32, allow_nan=False, allow_infinity=False))
def test_reals_come_back_exactly_with_the_fewest_digits(value: float) -> None:
    text = single_text(value)
    assert single(float(text)) == value
    digits = text.lstrip("-0.").replace(".", "").split("E")[0].rstrip("0")
    assert len(digits) <= 9
    shorter = f"{value:.{max(len(digits) - 1, 1)}g}"
    assert len(digits) <= 1 or single(float(shorter)) != value
    read = load(f".REALS\nx {text}\n.END\n")
    assert values(read)["x", ()].value == value


@given(st.floats(-1e4, 1e4))
def test_every_double_has_a_text(value: float) -> None:
    assert metres(millimetres_text(value)) == value
    assert radians(degrees_text(value)) == value


TEXT = st.text(
    st.characters(min_codepoint=32, max_codepoint=126, exclude_characters='"'), max_size=128
)


@given(st.dictionaries(st.integers(0, 99), TEXT, min_size=1, max_size=5))
def test_strings_come_back_exactly(texts: dict[int, str]) -> None:
    rows = [f'$s[{n}] "{text}"' for n, text in texts.items()]
    first = load("\n".join([".STRINGS", *rows, ".END", ""]))
    once = store(first)
    assert store(load(once)) == once
    assert {place[1][0]: d.value for place, d in values(load(once)).items()} == texts


def test_layout() -> None:
    text = """\
.PROGRAM zebra
moves P
.END
.REALS
n 5
pitch 25.4
tab[0] 1e6
.END
.STRINGS
$msg PART READY
.END
.PROGRAM alpha(x)
type X
.END
.LOCATIONS
#safe 0 -90 90 0 0 0
p = 500, 200, 100, 90, 90, -0
q 1 2 3
.END
"""
    assert (
        store(load(text))
        == """\
.PROGRAM alpha(x)
        TYPE x
.END
.PROGRAM zebra
        MOVES p
.END
.LOCATIONS
p               500.0000 200.0000 100.0000 90.0000 90.0000 0.0000
q               1.0000 2.0000 3.0000 90.0000 -90.0000 0.0000
#safe           0.0000 -90.0000 90.0000 0.0000 0.0000 0.0000
.END
.REALS
n               5
pitch           25.4
tab[0]          1000000
.END
.STRINGS
$msg            "PART READY"
.END
"""
    )


def test_other_angles() -> None:
    stored = store(load(".LOCATIONS\np 1 2 3 20 100 -60\n.END\n", VPLUS))
    assert (
        stored
        == ".LOCATIONS\np               1.0000 2.0000 3.0000 20.0000 100.0000 -60.0000\n.END\n"
    )
