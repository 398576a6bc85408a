"""`vrts teach` in the browser: one user, one link, and a file that is whole after every RECORD."""

import re
import signal
import subprocess
import sys
import webbrowser
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests.support_commands import Begun
from tests.support_live import PATIENCE, Browser, LiveServer
from vrts.base.source import SourceFile
from vrts.lang.compiler import compile_source
from vrts.live import teaching as teaching_alone
from vrts.live.points import PointsFile
from vrts.live.settings import Settings


class Teaching(LiveServer):
    """`vrts teach` on a free port."""

    def __init__(self, folder: Path) -> None:
        self.output = folder / "points.v2"
        super().__init__(folder)

    def start(self, port: str) -> None:
        words = ("--no-open", "--port", port, "-o", self.output)
        self.process = Begun("teach", "cans-on-bases", *words)
        assert self.process.stderr is not None
        first = self.process.stderr.readline()
        found = re.search(r"http://127\.0\.0\.1:(\d+)/#enter=(\S+)$", first)
        assert found is not None, first + self.process.stderr.read()
        self.port, self.supervisor_token = int(found[1]), found[2]
        self.host = f"127.0.0.1:{self.port}"


@pytest.fixture(scope="module")
def teaching(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Teaching]:
    server = Teaching(tmp_path_factory.mktemp("teaching"))
    with server:
        yield server


def rows(path: Path) -> list[str]:
    return path.read_text().splitlines()


def done(browser: Browser, lease: str, action: str, **fields: object) -> dict[str, object]:
    number = browser.command(lease, action, **fields)
    return browser.wait("result", lambda message: message["of"] == number)["result"]


@pytest.mark.thorough
def test_one_user_records_resets_rewinds_and_leaves_only_the_file(teaching: Teaching) -> None:
    cookie = teaching.supervisor()
    again = teaching.request("POST", "/enter", {"code": teaching.supervisor_token, "name": ""})
    assert again.status == 403, "the link lets in once"
    browser = teaching.join(cookie)
    lease = browser.wait("control", lambda message: message["lease"] != "")["lease"]
    while browser.came[-1]["type"] != "now":
        browser.wait("now")
    assert not teaching.output.exists()

    assert done(browser, lease, "record", name="p1")["accepted"]
    title, first, end = rows(teaching.output)
    assert (title, end) == (".LOCATIONS", ".END")
    assert done(browser, lease, "record", name="#q1")["accepted"]
    refused = done(browser, lease, "record", name="1p")
    assert not refused["accepted"]
    assert len(rows(teaching.output)) == 4

    stepped = done(browser, lease, "step", frame="joint", axis=0, way=1, size=0.1)
    before_s = float(str(stepped["at_s"])) - 0.02
    browser.wait("now", lambda message: abs(message["status"]["joints_rad"][0] - 0.1) < 1e-6)
    assert done(browser, lease, "record", name="p2")["accepted"]
    number = browser.command(lease, "rewind", time_s=before_s)
    state = browser.wait("state")["state"]
    assert abs(state["status"]["joints_rad"][0]) < 1e-6
    assert browser.wait("result", lambda message: message["of"] == number)["result"]["accepted"]
    assert done(browser, lease, "record", name="p3")["accepted"]
    assert done(browser, lease, "reset")["accepted"]

    names = [row.split()[0] for row in rows(teaching.output)]
    assert names == [".LOCATIONS", "p1", "p2", "p3", "#q1", ".END"]
    found = {row.split()[0]: row.split()[1:] for row in rows(teaching.output)}
    assert found["p3"] == found["p1"] == first.split()[1:]
    assert found["p2"] != found["p1"]
    program = ".PROGRAM a()\nMOVE p2\nMOVE #q1\n.END\n" + teaching.output.read_text()
    compiled = compile_source(SourceFile("points.v2", program))
    assert compiled.module is not None
    assert not [d for d in compiled.diagnostics if d.severity.value == "error"]


@pytest.mark.thorough
def test_ctrl_c_ends_it_and_says_what_was_written(tmp_path: Path) -> None:
    server = Teaching(tmp_path)
    with server:
        server.join(server.supervisor()).wait("snapshot")  # everything has begun
        server.process.send_signal(signal.SIGINT)
        assert server.process.wait(PATIENCE) == 130
        assert server.process.stderr is not None
        said = server.process.stderr.read()
        assert "nothing is written" in said
        assert "Traceback" not in said
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("opens", [False, True], ids=["no browser wanted", "none found"])
def test_the_link_and_what_is_lost_are_told_to_whoever_wants_few_words(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, *, opens: bool
) -> None:
    folder = tmp_path / "cell"
    folder.mkdir()

    def served(
        settings: Settings, *_: object, open_link: Callable[[str], None], **__: object
    ) -> None:
        assert settings.recorded is not None
        open_link("http://127.0.0.1/#enter=x")
        settings.recorded("p1 1 2 3 4 5 6")
        folder.rename(tmp_path / "moved")
        settings.recorded("p2 1 2 3 4 5 6")

    def no_browser(_: str) -> bool:
        return False

    monkeypatch.setattr(teaching_alone, "serve", served)
    monkeypatch.setattr(webbrowser, "open", no_browser)
    output, said, warned = folder / "p.v2", list[str](), list[str]()
    told = said.append, warned.append
    count = teaching_alone.teach("cans-on-bases", output, 0, *told, opens=opens)
    assert count == 1
    assert len(warned) == 2
    assert "http://127.0.0.1/#enter=x" in warned[0]
    assert warned[1] == f"cannot write `{output}`: No such file or directory"
    assert f"what is recorded goes into {output}; Ctrl-C ends it" in said


def test_a_location_recorded_again_is_replaced_and_others_stand_in_order(tmp_path: Path) -> None:
    points = PointsFile(tmp_path / "p.v2")
    for row in ("#r 1", "b[10] 2", "b[9] 3", "a 4", "a 5"):
        points.add(row)
    assert rows(points.path) == [".LOCATIONS", "a 5", "b[9] 3", "b[10] 2", "#r 1", ".END"]
    assert len(points) == 4
    assert [path.name for path in tmp_path.iterdir()] == ["p.v2"]


def test_a_file_that_is_there_is_not_replaced_unasked(tmp_path: Path) -> None:
    (tmp_path / "p.v2").write_text("mine")
    words = [sys.executable, "-m", "vrts.cli.main", "teach", "cans-on-bases", "-o", "p.v2"]
    found = subprocess.run(words, capture_output=True, text=True, check=False, cwd=tmp_path)
    assert found.returncode == 2
    assert "`p.v2` is there already" in found.stderr
    assert (tmp_path / "p.v2").read_text() == "mine"
