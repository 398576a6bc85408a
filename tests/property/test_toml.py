"""Places in TOML agree with what the standard parser reads; `read_toml` checks that itself."""

import tomllib

from hypothesis import example, given
from hypothesis import strategies as st

from vrts.base.source import SourceFile
from vrts.base.toml.reading import read_toml

KEYS = st.from_regex(r"[a-z][a-z0-9_-]{0,6}", fullmatch=True)
VALUES = st.recursive(
    st.integers(-99, 99).map(str)
    | st.sampled_from(
        ['"text # no comment"', "'literal'", "true", "1.5", '"""two\nlines"""', "[]"]
    ),
    lambda inner: st.lists(inner, max_size=3).map(lambda items: "[" + ", ".join(items) + "]"),
    max_leaves=4,
)
LINES = st.one_of(
    st.tuples(KEYS, VALUES).map(" = ".join),
    st.tuples(KEYS, KEYS, VALUES).map(lambda t: f"{t[0]}.{t[1]} = {t[2]}  # a comment"),
    KEYS.map(lambda k: f"[{k}]"),
    KEYS.map(lambda k: f"[[{k}]]"),
    st.just(""),
)


@given(st.lists(LINES, max_size=12).map("\n".join))
@example('a = {b = 1, "c d" = [1, 2]}\n[x."y z"]\nq = 2024-01-01\n')
def test_what_the_parser_takes_is_read_with_places(text: str) -> None:
    top, problems = read_toml(SourceFile("a.toml", text))
    try:
        expected = tomllib.loads(text)
    except tomllib.TOMLDecodeError:
        assert top is None
        assert len(problems.found) == 1
        return
    assert top is not None
    assert set(top.keys) == set(expected)
    for key in top.keys:
        assert key in top.span_of(key).source.text


@given(st.text(max_size=200))
def test_no_text_makes_it_raise(text: str) -> None:
    top, problems = read_toml(SourceFile("a.toml", text))
    assert (top is None) is bool(problems.found)
