"""What shows the arm beside the text asks the debug adapter: where it stands, its run, a seek."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support_dap import Client
from tests.unit.debug.dap.test_dap import HITS


@pytest.fixture
def client() -> Iterator[Client]:
    with Client() as made:
        yield made


def test_the_run_is_shown_and_the_debugger_goes_where_it_is_told(client: Client) -> None:
    client.launch(HITS)
    path = str(HITS.resolve())
    first = client.do("vrts.where", path=path)
    assert (first["time"], first["thread"]) == (0.0, 1)
    shown = client.do("vrts.recording", path=path)
    assert shown["future"] == first["future"]
    recording = shown["recording"]
    assert recording["contacts"][0]["text"]
    assert recording["clearance"]
    lines = {line: t for t, line in reversed(recording["run"]["lines"])}
    assert client.go("vrts.seek", time=lines[13] + 0.1)["reason"] == "step"
    assert client.line() == client.do("vrts.where", path=path)["line"]
    assert client.do("vrts.where", path=path)["time"] == pytest.approx(lines[13] + 0.1, abs=0.03)
    client.do("evaluate", expression="SPEED 50", context="repl")
    assert client.do("vrts.where", path=path)["future"] != first["future"]


def test_odd_times_are_refused_and_names_of_others_are_borne(
    client: Client, tmp_path: Path
) -> None:
    client.launch(HITS)
    for odd in (None, "now", True):
        assert not client.ask("vrts.seek", time=odd)["success"]
    client.go("vrts.seek", time=1e6)
    assert client.do("vrts.where", path=str(tmp_path / "no.v2"))["time"] > 5.0
    client.go("vrts.seek", time=-1)
    assert client.do("vrts.where")["time"] == 0.0


def test_another_future_is_given_with_how_long_both_take(client: Client) -> None:
    client.launch(HITS)
    path = str(HITS.resolve())
    recording = client.do("vrts.recording", path=path)["recording"]
    assert {row["name"] for row in recording["locations"] if not row["why"]}
    client.do("evaluate", expression="SPEED 50", context="repl")
    futures = client.do("vrts/branches")["branches"]
    assert [row["current"] for row in futures] == [False, True]
    other = client.do("vrts.other", number=futures[0]["number"])
    assert other["run"]["segments"] == recording["run"]["segments"], "as it was before the change"
    assert other["took"] < other["present"]
    assert "one of: 1, 2" in client.ask("vrts.other", number=7)["message"]
