"""A log that is full: nothing of it is cut, nothing more is done, and everybody is told."""

from pathlib import Path
from typing import Any

from tests.support_live import Browser, LiveServer
from vrts.live import administration

LONG = (
    ".PROGRAM long()\n" + "; a remark that fills the log with what nobody reads\n" * 3700 + ".END\n"
)


def answered(browser: Browser, lease: str, action: str, **fields: Any) -> dict[str, Any]:
    """Give a command; return the result, or why it was refused."""
    return browser.answer(browser.command(lease, action, **fields))


def test_a_full_log_refuses_commands_but_no_panic(tmp_path: Path) -> None:
    folder = tmp_path / "live"
    with LiveServer(folder, "--log-quota", "1", scenes=("cans-on-bases",)) as server:
        boss = server.join(server.supervisor())
        boss.wait("state")
        lease = boss.take_control()
        given, answer = 0, dict[str, Any]()
        while given < 8:
            answer = answered(boss, lease, "upload", name="long.v2", text=LONG)
            if answer["type"] == "result":
                given += 1
            elif answer["code"] == "log":
                break
            else:
                assert answer["code"] == "rate"
                for _ in range(50):  # frames: a second of the server's time
                    boss.take()
        assert 4 < given < 7
        assert "full" in answer["text"]
        assert "choose the scene again" in answer["help"]
        boss.quiet(0.5)
        said = [message["text"] for message in boss.came if message["type"] == "chat"]
        assert any("log of this session is full" in text for text in said)
        assert answered(boss, lease, "line", line="DO READY")["code"] == "log"
        assert answered(boss, lease, "line", line="ABORT")["type"] == "result"
        boss.send("panic")
        boss.wait("result", lambda m: m["of"] == 0)

        boss.send("set_scene", scene="cans-on-bases")
        boss.wait("state", lambda m: m["scene_url"] != "" and m["state"] is not None)
        assert answered(boss, lease, "line", line="WHERE")["type"] == "result"
    assert not [found.text for found in administration.verify_logs(folder) if found.wrong]
