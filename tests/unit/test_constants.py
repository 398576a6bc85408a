"""Laws have the same examples in every order of tests, whatever is loaded by then."""

import importlib.util
import sys
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests import constants

TRIED = 400  # examples: of twenty values about one is a constant
DEAR = 123_454_321.25  # no module has this


def drawn() -> list[tuple[float, int, str]]:
    """Return the examples of a law."""
    seen: list[tuple[float, int, str]] = []

    @settings(max_examples=TRIED)
    @given(st.floats(1e8, 1e9), st.integers(), st.text())
    def law(number: float, whole: int, text: str) -> None:
        seen.append((number, whole, text))

    law()
    return seen


def test_what_is_loaded_meanwhile_changes_no_example(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = drawn()
    (tmp_path / "meanwhile.py").write_text(f"DEAR = {DEAR}\n")
    spec = importlib.util.spec_from_file_location("meanwhile", tmp_path / "meanwhile.py")
    assert spec is not None
    monkeypatch.setitem(sys.modules, "meanwhile", importlib.util.module_from_spec(spec))
    assert drawn() == before


def test_constants_of_the_list_are_among_the_examples() -> None:
    known = constants.read()
    seen = drawn()
    assert known.strings & {text for _, _, text in seen}
    assert known.integers & {whole for _, whole, _ in seen}


def test_a_list_made_anew_holds_what_modules_hold(tmp_path: Path) -> None:
    (tmp_path / "module.py").write_text(f"DEAR = {DEAR}\nWORD = 'APPRO'\nMANY = 1234\n")
    found = constants.made(tmp_path)
    assert found == constants.Constants(floats={DEAR}, strings={"APPRO"}, integers={1234})
