"""Findings of runs as an editor gets them, while texts, tasks, scenes and other files change."""

import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

import pytest

from tests.places import ROOT
from tests.support_lsp import PATIENCE, Client, where
from tests.unit.lsp.begun import Begun

CANS = ROOT / "examples" / "01-cans-on-bases"
TOO_FAST = """.PROGRAM main
        DRIVE 2, 45, 100
        DRIVE 3, 30, 100
        DRIVE 5, 6, 100
        HERE p
        MOVES SHIFT(p BY 0,-400,0)
.END
"""
ENDLESS = """.PROGRAM main
        x = 0
        FOR k = 1 TO 1000000000
            x = x+SQRT(k)
        END
.END
"""

SOMETIMES = """.PROGRAM main
        SPEED 50 ALWAYS
        MOVE #PPOINT(0,-30,90,0,0,0)
        IF SIG(1001) THEN
          MOVE #PPOINT(0,10,90,0,0,0)
        END
        READY
.END
"""
WHOLE = {"start": {"line": 0, "character": 0}, "end": {"line": 99, "character": 0}}

Found = list[dict[str, Any]]


def has(code: str, start: str = "") -> Callable[[Found], bool]:
    return lambda found: any(d["code"] == code and d["message"].startswith(start) for d in found)


def has_not(code: str) -> Callable[[Found], bool]:
    return lambda found: not any(d["code"] == code for d in found)


def the(code: str, found: Found) -> dict[str, Any]:
    (one,) = [d for d in found if d["code"] == code]
    return one


def offered(client: Client, place: dict[str, Any]) -> dict[str, Any]:
    """Return the action for a finding: a speed is worked out after the finding is told."""
    asked: dict[str, Any] = {"range": place, "context": {"diagnostics": []}}
    while not (found := client.about("codeAction", "a.v2", **asked)):
        client.said_next("textDocument/publishDiagnostics")  # more is known: ask again
    return found[0]


@pytest.mark.thorough
def test_the_action_sets_a_speed_and_the_finding_is_gone(tmp_path: Path) -> None:
    with Client(tmp_path) as client:
        client.open("a.v2", TOO_FAST)
        finding = the("V302", client.diagnostics("a.v2", has("V302")))
        assert finding["source"] == "vrts verify"
        assert finding["severity"] == 1
        assert finding["codeDescription"]["href"].endswith("V302.md")
        assert "found with the robot alone, at 1.6" in finding["message"]
        line, column = where(TOO_FAST, "MOVES")
        assert finding["range"]["start"] == {"line": line, "character": column}

        action = offered(client, finding["range"])
        assert action["title"].startswith("Set SPEED ")
        (edit,) = action["edit"]["changes"][client.uri("a.v2")]
        start = edit["range"]["start"]
        assert edit["range"]["end"] == start
        at = start["line"], start["character"]
        client.change("a.v2", edit["newText"], at, at)
        client.diagnostics("a.v2", has("V302", "before the last change"))
        assert client.diagnostics("a.v2", has_not("V302")) == []  # verified anew
        assert client.about("inlayHint", "a.v2", range=WHOLE)
        assert client.about("codeAction", "a.v2", range=WHOLE, context={"diagnostics": []}) == []


@pytest.mark.thorough
def test_findings_of_an_earlier_text_say_so_until_there_are_new_ones(tmp_path: Path) -> None:
    with Client(tmp_path) as client:
        client.open("a.v2", TOO_FAST)
        client.diagnostics("a.v2", has("V302"))
        client.change("a.v2", "; a line above\n", (1, 0), (1, 0))
        old = the("V302", client.diagnostics("a.v2", has("V302")))
        assert old["message"].startswith("before the last change: joint 4")
        assert old["severity"] == 3
        assert old["range"]["start"]["line"] == where(TOO_FAST, "MOVES")[0] + 1
        client.diagnostics("a.v2", has("V302", "joint 4"))  # the same again, of the new text

        client.change("a.v2", "        MOVEE", (6, 0), (6, 13))
        found = client.diagnostics("a.v2")
        assert [d["code"] for d in found] == ["V120"]  # what does not compile does not run
        client.change("a.v2", "        MOVE", (6, 0), (6, 13))
        assert client.diagnostics("a.v2") == []  # the line of the finding is another now


@pytest.mark.thorough
def test_files_that_change_on_disk_are_looked_at_again(tmp_path: Path) -> None:
    scene = tmp_path / "scene.toml"
    shutil.copy(ROOT / "scenes" / "cans-on-bases" / "scene.toml", scene)
    task = (CANS / "task.toml").read_text("utf-8")
    text = (CANS / "submissions" / "hits-base.v2").read_text("utf-8")
    with Client(tmp_path) as client:
        client.open("a.v2", text)
        client.diagnostics("a.v2")
        (tmp_path / "task.toml").write_text(task.replace("cans-on-bases", "scene.toml"), "utf-8")
        contact = the("V400", client.diagnostics("a.v2", has("V400", "the held")))
        assert "found in the scene `" in contact["message"]

        good = scene.read_text("utf-8")
        scene.write_text("nonsense", "utf-8")
        refused = the("V798", client.diagnostics("a.v2", has("V798")))
        assert "scene.toml:1" in refused["message"]
        scene.write_text(good, "utf-8")
        client.diagnostics("a.v2", has("V400", "the held"))

        client.open("b.v2", ".PROGRAM main\n        CALL put\n.END\n")
        client.diagnostics("b.v2", has("V206"))
        (tmp_path / "c.v2").write_text(".PROGRAM put\n        READY\n.END\n", "utf-8")
        noted = the("V206", client.diagnostics("b.v2", lambda d: "c.v2` has it" in str(d)))
        assert noted["severity"] == 3
        (tmp_path / "c.v2").unlink()
        client.diagnostics("b.v2", lambda d: "c.v2` has it" not in str(d))


def test_no_run_outlives_its_text_its_buffer_or_its_server(tmp_path: Path) -> None:
    with Begun(tmp_path / "begun") as begun:
        client = Client(tmp_path, server=begun.server)
        client.open("a.v2", ENDLESS)
        first = begun.next()
        client.change("a.v2", ENDLESS + "; more")
        first.wait(PATIENCE)
        second = begun.next()
        client.close("a.v2")
        second.wait(PATIENCE)
        client.open("a.v2", ENDLESS)
        third = begun.next()
        client.process.kill()  # not even a chance to say goodbye
        third.wait(PATIENCE)
        client.gone()


@pytest.mark.thorough
def test_a_verification_that_is_killed_is_told_and_the_server_lives(tmp_path: Path) -> None:
    with Begun(tmp_path / "begun") as begun, Client(tmp_path, server=begun.server) as client:
        client.open("a.v2", ENDLESS)
        begun.next().kill()
        told = the("V797", client.diagnostics("a.v2", has("V797")))
        assert "was stopped after 20 s of processor time" in told["message"]
        assert told["range"]["start"] == {"line": 0, "character": 9}
        client.change("a.v2", TOO_FAST)
        client.diagnostics("a.v2", has("V302"))


@pytest.mark.thorough
def test_a_future_that_goes_wrong_links_to_its_scenario(tmp_path: Path) -> None:
    (tmp_path / "task.toml").write_text((CANS / "task.toml").read_text("utf-8"), "utf-8")
    (tmp_path / "a-scenario.toml").write_text("mine", "utf-8")
    with Client(tmp_path) as client:
        client.open("a.v2", SOMETIMES)
        finding = the("V560", client.diagnostics("a.v2", has("V560", "for some inputs: robot")))
        (link,) = finding["relatedInformation"]
        uri: str = link["location"]["uri"]
        file = Path(unquote(urlsplit(uri).path))
        assert "signal = 1001" in file.read_text("utf-8")
        assert f"`vrts verify a.v2 --scenario {file}`" in link["message"]
        actions = client.about("codeAction", "a.v2", range=WHOLE, context={"diagnostics": []})
        (kept,) = [action for action in actions if action.get("edit")]
        created, written = kept["edit"]["documentChanges"]
        assert created["kind"] == "create"
        assert created["uri"] == client.uri("a-scenario-2.toml"), "the other one is not lost"
        assert written["edits"][0]["newText"] == file.read_text("utf-8")
    assert not file.parent.exists(), "the server takes its files away"
