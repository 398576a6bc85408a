"""How long a class code is, and what guesses at it are answered, in memory."""

import asyncio
from fractions import Fraction
from pathlib import Path

import pytest

from vrts.live.entrance import guessing
from vrts.live.entrance.by_hand import fresh_code
from vrts.live.entrance.class_code import UNREAD, ClassCode, Guess, keep_code, kept_code
from vrts.live.entrance.guessing import BUDGET, GROWTH, SHORTEST, budget, codes, length_after
from vrts.live.entrance.ways_in import WaysIn
from vrts.live.store.database import Database
from vrts.live.tokens import LETTERS, grouped, new_code

MILLIONTH = Fraction(1, 1_000_000)
FASTEST = 1000  # guesses a second, more than the server answers
TERM_S = 200 * 86_400


def test_all_guesses_that_are_ever_answered_find_a_code_with_less_than_a_millionth() -> None:
    """What the manual promises, of the real constants."""
    assert len(LETTERS) == len(set(LETTERS)) == 31
    assert guessing.chance() < MILLIONTH
    assert float(guessing.chance()) == pytest.approx(5.58e-7, rel=1e-3)


def test_a_term_of_guessing_as_fast_as_can_be_makes_the_code_longer_a_few_times() -> None:
    wrong = FASTEST * TERM_S
    assert length_after(wrong) - SHORTEST == 4
    spent, chance = 0, Fraction(0)
    for length in range(SHORTEST, length_after(wrong) + 1):
        guesses = min(budget(length), wrong - spent)
        chance += Fraction(guesses, codes(length) - guesses)
        spent += guesses
    assert spent == wrong
    assert chance < MILLIONTH


def test_codes_grow_where_a_budget_is_used_up() -> None:
    assert length_after(0) == length_after(BUDGET - 1) == SHORTEST
    assert length_after(BUDGET) == SHORTEST + 1
    assert length_after(BUDGET + GROWTH * BUDGET - 1) == SHORTEST + 1
    assert length_after(BUDGET + GROWTH * BUDGET) == SHORTEST + 2
    assert guessing.left_after(0) == BUDGET
    assert guessing.left_after(BUDGET + 5) == GROWTH * BUDGET - 5


def test_who_is_right_is_right_whatever_others_typed() -> None:
    text = new_code(SHORTEST)
    code = ClassCode(text, BUDGET - 3)
    others = [other for other in ("A" * SHORTEST, "B" * SHORTEST, "C" * SHORTEST) if other != text]
    assert code.guess(others[0]) is Guess.WRONG
    assert code.guess(others[1]) is Guess.WRONG
    assert code.guess(f" {text[:3].lower()} {text[3:6]}-{text[6:]}") is Guess.RIGHT
    assert not code.used_up
    assert code.guess(others[0]) is Guess.WRONG
    assert code.used_up
    code.replace(code.fresh())
    assert len(code.text) == SHORTEST + 1
    assert code.guess(text) is Guess.FORMER, "who typed it is told to look at the wall"
    assert code.guess(code.text) is Guess.RIGHT
    assert not code.used_up


def test_a_code_that_is_renewed_by_hand_has_no_budget_of_its_own() -> None:
    code = ClassCode(new_code(SHORTEST), 0)
    for _ in range(3):
        assert code.guess("Z" * SHORTEST) is Guess.WRONG
        code.replace(code.fresh())
    assert code.wrong == 3
    assert len(code.text) == SHORTEST


@pytest.mark.parametrize("typed", ["", "ABCDEF", "ABCDEFGH0", "I" * SHORTEST, "é" * SHORTEST])
def test_what_can_never_be_right_is_not_counted(typed: str) -> None:
    code = ClassCode("ABCDEFGHJ", 0)
    assert code.guess(typed) is Guess.NO_CODE
    assert code.wrong == 0
    assert ClassCode("", 0).guess("ABCDEFGHJ") is Guess.NO_CODE, "where there is no code"


def test_the_code_stands_in_a_file_for_its_owner_only(tmp_path: Path) -> None:
    assert kept_code(tmp_path) == ""
    keep_code(tmp_path, "ABCDEFGHJ")
    (path,) = tmp_path.iterdir()
    assert path.stat().st_mode & 0o777 == 0o600
    assert kept_code(tmp_path) == "ABCDEFGHJ"
    keep_code(tmp_path, "")
    assert list(tmp_path.iterdir()) == []


def test_a_code_that_root_writes_is_the_folders_owners(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    given: list[tuple[int, int]] = []

    def gives(_: int, user: int, group: int) -> None:
        given.append((user, group))

    monkeypatch.setattr("os.fchown", gives)
    monkeypatch.setattr("os.geteuid", lambda: 0)
    keep_code(tmp_path, "ABCDEFGHJ")
    owner = tmp_path.stat()
    assert given == [(owner.st_uid, owner.st_gid)]
    monkeypatch.setattr("os.geteuid", lambda: 1000)
    keep_code(tmp_path, "ABCDEFGHJ")
    assert len(given) == 1


def test_a_code_that_cannot_be_read_is_not_known_now(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuses(*_: object) -> str:
        raise PermissionError

    keep_code(tmp_path, "ABCDEFGHJ")
    monkeypatch.setattr(Path, "read_text", refuses)
    assert kept_code(tmp_path) == UNREAD
    code = ClassCode(UNREAD, 0)
    assert code.guess("ABCDEFGHJ") is Guess.NO_CODE


def test_a_server_keeps_its_code_while_the_file_cannot_be_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def work() -> tuple[str, str, str]:
        database = Database(tmp_path / "live.sqlite")
        ways = WaysIn(tmp_path, database, "", has_code=True)
        await ways.open()
        before = ways.code.text
        renewed = await database.do(lambda connection: fresh_code(tmp_path, connection, 1.0))
        with monkeypatch.context() as patched:
            patched.setattr(Path, "read_text", refuses)
            await ways.look()
            kept = ways.code.text
        await ways.look()
        database.close()
        assert ways.code.text == renewed
        return before, kept, renewed

    def refuses(*_: object) -> str:
        raise PermissionError

    before, kept, renewed = asyncio.run(work())
    assert before == kept != renewed


@pytest.mark.parametrize(
    ("code", "shown"),
    [
        ("ABCDEFGHJ", "ABC-DEF-GHJ"),
        ("ABCDEFGHJK", "ABC-DEF-GHJK"),
        ("ABCDEFGHJKM", "ABC-DEFG-HJKM"),
        ("ABCDEFGHJKMN", "ABC-DEF-GHJ-KMN"),
        ("", ""),
    ],
)
def test_codes_are_shown_in_groups(code: str, shown: str) -> None:
    assert grouped(code) == shown
