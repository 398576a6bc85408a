"""The admin page's numbers: for supervisors with an account of their own, bounded, about all."""

import logging
from pathlib import Path

import pytest

from tests.support_live import LiveServer
from vrts.live.administration import last_backup, save_backup
from vrts.live.new_account import add_user
from vrts.live.settings import DATABASE
from vrts.live.store.database import opened
from vrts.live.watching.log_tail import KEPT, LONGEST, LogTail, follow_log
from vrts.live.watching.machine import Machine


@pytest.mark.thorough
def test_only_a_supervisor_with_an_account_sees_how_the_server_is(tmp_path: Path) -> None:
    folder = tmp_path / "live"
    boss = {"user": "Dr. Lee", "password": "correct horse"}
    eva = {"user": "Eva", "password": "correct horse"}
    add_user(folder, boss["user"], boss["password"], supervisor=True)
    add_user(folder, eva["user"], eva["password"], supervisor=False)
    with LiveServer(folder) as server:
        others = ("", server.enter("Anna"), server.supervisor())
        student = server.request("POST", "/login", eva).cookie
        for cookie in (*others, student):
            answer = server.request("GET", "/admin/now", cookie=cookie)
            assert (answer.status, answer.json["code"]) == (403, "role")
        cookie = server.request("POST", "/login", boss).cookie
        now = server.request("GET", "/admin/now", cookie=cookie).json
        assert now["health"]["status"] == "ok"
        assert now["load"]["memory"] > now["load"]["server"] > 10_000_000
        assert [room["name"] for room in now["rooms"]] == ["Class"]
        used = {quota["name"]: quota["used"] for quota in now["quotas"]}
        assert used["Guests"] == 2
        assert used["Database"] > 10_000
        assert now["backup_at"] == 0.0
        save_backup(folder, tmp_path / "copy.sqlite")
        assert server.request("GET", "/admin", cookie="").status == 200, "the page tells nothing"


def test_the_last_copy_is_known_and_a_note_that_was_changed_tells_nothing(tmp_path: Path) -> None:
    opened(tmp_path / DATABASE).close()
    assert last_backup(tmp_path) == (0.0, 0)
    save_backup(tmp_path, tmp_path / "copy.sqlite")
    at, size = last_backup(tmp_path)
    assert at > 1e9
    assert size == (tmp_path / "copy.sqlite").stat().st_size
    (tmp_path / "last-backup.json").write_text('{"at": []}')
    assert last_backup(tmp_path) == (0.0, 0)


def test_the_log_keeps_its_end_visible_and_bounded() -> None:
    tail = follow_log()
    assert follow_log() is not tail
    assert [type(h) for h in logging.getLogger("vrts.live").handlers].count(LogTail) == 1
    for number in range(KEPT + 5):
        tail.handle(logging.LogRecord("x", logging.INFO, "", 0, f"no. {number}", (), None))
    tail.handle(
        logging.LogRecord("x", logging.INFO, "", 0, "\x1b[31m\u202e" + "y" * 9999, (), None)
    )
    assert len(tail.entries) == KEPT
    text = tail.entries[-1].text
    assert len(text) == LONGEST
    assert text.isprintable()
    logging.getLogger("vrts.live").removeHandler(logging.getLogger("vrts.live").handlers[-1])


def test_the_machine_tells_what_is_used(tmp_path: Path) -> None:
    load = Machine(tmp_path).load()
    assert load.processors >= 1
    assert load.memory > load.memory_free > 0
    assert 10_000_000 < load.server < load.memory
    assert load.disk_free > 0
