"""What becomes of the class code when another one cannot be kept."""

import asyncio
import sqlite3
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from vrts.cli.main import vrts
from vrts.live.entrance import by_hand
from vrts.live.entrance.class_code import Guess, kept_code
from vrts.live.entrance.ways_in import WaysIn
from vrts.live.settings import DATABASE
from vrts.live.store import links
from vrts.live.store.database import Database, opened
from vrts.live.tokens import digest, grouped


def fails(*_: Any, **__: Any) -> None:
    raise sqlite3.OperationalError("database or disk is full")


def test_a_code_that_cannot_be_kept_is_not_shown(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def work() -> None:
        database = Database(tmp_path / DATABASE)
        ways = WaysIn(tmp_path, database, "", has_code=True)
        await ways.open()
        before, shown = ways.code.text, list[str]()
        ways.changed = lambda: shown.append(ways.code.text)
        with monkeypatch.context() as broken:
            broken.setattr(links, "replace_code", fails)
            for none in (False, True):
                with pytest.raises(sqlite3.OperationalError):
                    await ways.renew_code(none=none)
        assert ways.code.text == shown[-1] == kept_code(tmp_path) == before
        assert await ways.guess(before) is Guess.RIGHT
        await ways.renew_code()
        assert ways.code.text == kept_code(tmp_path) != before
        assert await database.do(links.code_now) == digest(ways.code.text)
        database.close()

    asyncio.run(work())


def test_all_that_a_command_is_to_do_is_done_or_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    connection = opened(tmp_path / DATABASE)
    code = by_hand.fresh_code(tmp_path, connection, 1.0)
    (way,) = links.links(connection, 2.0)
    words = ["serve", "--folder", str(tmp_path), "--renew-code", "--supervisor-link"]
    with monkeypatch.context() as broken:
        broken.setattr(by_hand, "supervisor_link", fails)
        said = CliRunner().invoke(vrts, words)
    assert said.exit_code != 0
    assert "class code" not in said.output
    said = CliRunner().invoke(vrts, [*words, "--end-way", "nothing"])
    assert (said.exit_code, "there is no way in called" in said.stderr) == (1, True)
    assert links.links(connection, 2.0) == [way], "as it was"
    assert kept_code(tmp_path) == code
    said = CliRunner().invoke(vrts, words)
    assert said.exit_code == 0, said.output
    assert f"class code: {grouped(kept_code(tmp_path))}" in said.stdout
    assert [found.supervisor for found in links.links(connection, 2.0)] == [False, True]
    assert links.code_now(connection) == digest(kept_code(tmp_path)) != digest(code)
    connection.close()


def test_a_database_of_a_later_version_is_named_in_one_sentence(tmp_path: Path) -> None:
    connection = opened(tmp_path / DATABASE)
    connection.execute("PRAGMA user_version=1000")
    connection.close()
    for option in ("--ways-in", "--renew-code"):
        said = CliRunner().invoke(vrts, ["serve", "--folder", str(tmp_path), option])
        assert said.exit_code == 2
        assert "was written by a later vrts" in said.stderr
