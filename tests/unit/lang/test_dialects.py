"""A dialect decides which words count, how operators bind and what angles mean."""

import pytest

from vrts.base.source import SourceFile
from vrts.ir.dump import dump
from vrts.lang.compiler import Compilation, Options, compile_source
from vrts.lang.dialect import AS, DIALECTS, VAL, VAL2, VAL2_PLUS, VPLUS, Dialect, Precedence, titles


def compiled(step: str, dialect: Dialect, precedence: Precedence | None = None) -> Compilation:
    source = SourceFile("main.v2", f".PROGRAM main(p)\n{step}\n.END\n")
    return compile_source(source, Options(dialect, precedence))


def lines(compilation: Compilation) -> str:
    assert compilation.module is not None, compilation.diagnostics
    return dump(compilation.module)


def test_dialects_by_name() -> None:
    assert list(DIALECTS) == ["val2", "val2+", "val", "vplus", "as"]
    assert all(DIALECTS[name].name == name for name in DIALECTS)


def test_each_is_asked_for_what_it_is() -> None:
    assert [d for d in DIALECTS.values() if d.is_as] == [AS]
    assert [d for d in DIALECTS.values() if d.is_val] == [VAL]
    assert [d for d in DIALECTS.values() if d.takes_all] == [VAL2_PLUS]
    assert [d for d in DIALECTS.values() if not d.tolerant] == [VAL2]


def test_words_count_by_the_columns_of_the_vocabulary() -> None:
    assert VAL2.has("2+")
    assert not VAL2.has("+a")
    assert all(VAL2_PLUS.has(letter) for letter in "12+a")


def test_titles_of_columns() -> None:
    assert titles("+") == "V+"
    assert titles("1a") == "VAL and AS"
    assert titles("12+a") == "VAL, VAL-II, V+ and AS"


@pytest.mark.parametrize(
    ("step", "takers"),
    [
        ("MOVE p", [VAL2, VAL2_PLUS, VAL, VPLUS]),
        ("JMOVE p", [VAL2_PLUS, VPLUS, AS]),
        ("CALLS $p", [VAL2_PLUS, VPLUS]),
        ("GOSUB main", [VAL2_PLUS, VAL]),
        ("WAIT SIG(1001)", [VAL2, VAL2_PLUS, VAL, VPLUS, AS]),
        ("READY", [VAL2, VAL2_PLUS, VAL, VPLUS]),
        ("HOME", [VAL2_PLUS, AS]),
    ],
)
def test_a_word_counts_where_it_belongs(step: str, takers: list[Dialect]) -> None:
    takes = [d for d in DIALECTS.values() if compiled(step, d).module is not None]
    assert takes == takers


@pytest.mark.parametrize("dialect", [VAL2, VAL, VPLUS], ids=lambda d: d.name)
def test_a_refusal_names_the_dialect(dialect: Dialect) -> None:
    (said,) = (d for d in compiled("LMOVE p", dialect).diagnostics if d.is_error)
    assert said.rule.code == "V122"
    assert f"a {dialect.title} instruction" in said.headline


def test_the_table_of_ranks_is_an_option() -> None:
    step = "x = 1 == 1 AND 2 == 2"
    table_a, table_b = "(1 == (1 and 2)) == 2", "(1 == 1) and (2 == 2)"
    assert table_a in lines(compiled(step, VAL2))
    assert table_b in lines(compiled(step, AS))
    assert table_b in lines(compiled(step, VAL2, Precedence.B))
    assert table_a in lines(compiled(step, AS, Precedence.A))


@pytest.mark.parametrize(
    ("dialect", "section", "angles"),
    [
        (VAL2, ".LOCATIONS", "20, 10, -60"),
        (VAL2_PLUS, ".LOCATIONS", "20, 10, -60"),
        (VPLUS, ".LOCATIONS", "110, -80, -60"),
        (AS, ".TRANS", "110, -80, -60"),
    ],
    ids=lambda value: value.name if isinstance(value, Dialect) else None,
)
def test_angles_of_data_become_oat(dialect: Dialect, section: str, angles: str) -> None:
    text = f".PROGRAM main()\nBREAK\n.END\n{section}\nq 1 2 3 20 10 -60\n.END\n"
    compilation = compile_source(SourceFile("main.v2", text), Options(dialect))
    assert f"q = trans(1, 2, 3, {angles})" in lines(compilation)
