"""Runs that ask for a marker read only files that can hold it, and no such file is left out."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests import marked
from tests.marked import mark_laws, may_hold


@pytest.mark.parametrize(
    ("text", "thorough", "live"),
    [
        ("def test_sum(): ...", False, False),
        ("@pytest.mark.thorough\ndef test_sum(): ...", True, False),
        ("from hypothesis import given", True, False),
        ("from tests.laws import first", True, False),
        ("pytestmark = pytest.mark.live", False, True),
    ],
)
def test_a_file_says_what_it_may_hold(
    tmp_path: Path, text: str, *, thorough: bool, live: bool
) -> None:
    file = tmp_path / "test_file.py"
    file.write_text(text)
    assert may_hold("thorough and not live", file) is thorough
    assert may_hold("live", file) is live
    assert may_hold("not live and not thorough", file)
    assert may_hold("", file)


def test_what_is_no_file_of_tests_is_always_read(tmp_path: Path) -> None:
    (tmp_path / "conftest.py").write_text("")
    assert may_hold("live", tmp_path / "conftest.py")


@given(st.none())
def law(nothing: None) -> None:
    assert nothing is None


def item(request: pytest.FixtureRequest, path: Path, test: object) -> pytest.Item:
    """Return a test that stands in a file."""
    parent = pytest.Module.from_parent(request.session, path=path)  # pyright: ignore[reportUnknownMemberType]
    return pytest.Function.from_parent(parent, name="law", callobj=test)  # pyright: ignore[reportUnknownMemberType]


@pytest.mark.parametrize("test", [law, lambda: None])
def test_a_mark_of_which_a_file_says_no_word_is_refused(
    request: pytest.FixtureRequest, tmp_path: Path, test: object
) -> None:
    file = tmp_path / "test_silent.py"
    file.write_text("")
    found = item(request, file, test)
    if test is not law:
        found.add_marker("live")
    with pytest.raises(pytest.UsageError, match=r"test_silent\.py: law is (thorough|live); say so"):
        mark_laws([found])


def test_laws_are_thorough_where_all_examples_are_tried(
    request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    file = tmp_path / "test_law.py"
    file.write_text("from hypothesis import given")
    found = item(request, file, law)
    monkeypatch.setattr(marked, "ALL", False)
    mark_laws([found])
    assert found.get_closest_marker("thorough") is None
    monkeypatch.setattr(marked, "ALL", True)
    mark_laws([found])
    assert found.get_closest_marker("thorough") is not None
