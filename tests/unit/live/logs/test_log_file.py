"""A session repeated from the log that a real server wrote."""

from pathlib import Path

import msgspec
import pytest

from tests.support_commands import vrts_text
from tests.support_live import LiveServer
from vrts.live.logs.log_file import LogFault, read_log
from vrts.live.places import places_of
from vrts.live.session.again.replay import replay
from vrts.live.session.channel.messages import Start
from vrts.live.session.views.frame import unpacked


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> tuple[bytes, tuple[float, ...]]:
    """Return the log of a session, and the joints at its end."""
    with LiveServer(tmp_path_factory.mktemp("log") / "live") as server:
        anna = server.join(server.enter("Anna"))
        room = anna.wait("welcome")["room"]
        state = anna.wait("snapshot")["state"]
        anna.wait("control")
        if state is None:
            anna.wait("state")
        lease = anna.take_control()
        anna.command(lease, "line", line="DO DRIVE 1,20,100")
        anna.wait("now", lambda m: m["status"]["mode"] == "moving")
        anna.wait("now", lambda m: m["status"]["mode"] == "idle")
        anna.command(lease, "jog", frame="joint", axis=1, way=1, speed=0.5)
        for _ in range(6):
            anna.quiet(0.1)
            anna.command(lease, "keep")
        anna.command(lease, "let_go")
        anna.quiet(1.0)
        anna.command(lease, "line", line="DO DRIVE 1,-60,100")
        anna.wait("now", lambda m: m["status"]["mode"] == "moving")
        anna.send("panic")
        anna.quiet(2.0)
        end = unpacked(anna.frames[-1]).joints
        supervisor = server.supervisor()
        return server.request("GET", f"/log/{room}", cookie=supervisor).body, end


@pytest.mark.thorough
def test_the_same_motion_comes_out(recorded: tuple[bytes, tuple[float, ...]]) -> None:
    log, end = recorded
    (session,) = read_log(log)
    place = places_of((session.scene,))[0]
    last = session.entries[-1].at_s
    run = replay(Start(session.number, "", place.scene), session.entries, until_s=last + 2.0)
    assert run.at(last + 2.0).configuration == pytest.approx(end, abs=1e-6)
    assert abs(end[1] + 1.5707963) > 0.02, "the key moved joint 2"


def test_a_log_that_was_changed_is_refused(recorded: tuple[bytes, tuple[float, ...]]) -> None:
    lines = recorded[0].splitlines()
    with pytest.raises(LogFault, match="text of record"):
        read_log(recorded[0].replace(b"DRIVE 1,20", b"DRIVE 1,21"))
    with pytest.raises(LogFault, match="missing"):
        read_log(b"\n".join(lines[:3] + lines[4:]))
    with pytest.raises(LogFault, match="end of the log"):
        read_log(b"\n".join(lines[:-1]))
    with pytest.raises(LogFault, match="no log"):
        read_log(b"PK\x03\x04")
    n, row = next(
        (n, row)
        for n, row in enumerate(map(msgspec.json.decode, lines))
        if row.get("kind") == "line"
    )
    row["salt"] = row["text"] = None
    with pytest.raises(LogFault, match="purged"):
        read_log(b"\n".join([*lines[:n], msgspec.json.encode(row), *lines[n + 1 :]]))


def test_the_command_prints_what_happened(
    recorded: tuple[bytes, tuple[float, ...]], tmp_path: Path
) -> None:
    log = tmp_path / "log.jsonl"
    log.write_bytes(recorded[0])
    done = vrts_text("replay", log)
    assert done.returncode == 0, done.stderr
    assert "DRIVE 1,20,100" in done.stdout
    assert "the chain is unbroken; session 1 of 1 in cans-on-bases" in done.stderr


def test_the_page_shows_the_session_with_what_was_done_as_a_program(
    recorded: tuple[bytes, tuple[float, ...]], tmp_path: Path
) -> None:
    log, page = tmp_path / "log.jsonl", tmp_path / "session.html"
    log.write_bytes(recorded[0])
    done = vrts_text("replay", log, "--page", "--no-open", "-o", page)
    assert done.returncode == 0, done.stderr
    assert f"wrote {page}" in done.stderr
    text = page.read_text(encoding="utf-8")
    shown = text.split('<div class="program">')[1].split("</div>")[0]
    assert "session" in shown
    assert "DRIVE" in shown or "MOVE" in shown
    assert "unreadable" not in text.split("</header>")[0]
    assert str(tmp_path) not in text
