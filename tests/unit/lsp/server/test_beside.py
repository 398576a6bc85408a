"""What an editor is told that shows more beside the text, over real pipes."""

import asyncio
import json
import shutil
from pathlib import Path
from queue import Queue
from typing import Any

import pytest

from tests.places import ROOT
from tests.support_lsp import PATIENCE, Client
from tests.unit.lsp.server.messages.test_bad_words import TOLD, begun

CANS = ROOT / "examples" / "01-cans-on-bases"


@pytest.mark.thorough
def test_mark_and_recording_follow_the_text_once_somebody_asks(tmp_path: Path) -> None:
    shutil.copy(CANS / "task.toml", tmp_path)
    right = (CANS / "solution.v2").read_text()
    wrong = (CANS / "submissions" / "hits-base.v2").read_text()
    came: Queue[Any] = Queue()
    with Client(tmp_path) as client:

        def told(params: Any) -> None:
            came.put(params)

        client.client.feature("vrts/shown")(told)

        def shown(version: int) -> Any:
            while True:
                news = came.get(timeout=PATIENCE)
                if news.version == version and hasattr(news, "shown"):
                    assert news.uri == client.uri("a.v2")
                    return news.shown

        client.tell("vrts/beside")
        client.open("a.v2", right)
        found = shown(1)
        assert (found.mark, found.ready, found.reasons) == ("10.0 / 10", True, [])
        recording = client.ask("vrts/recording", uri=client.uri("a.v2"))["result"]
        assert not json.loads(recording[0])["contacts"]
        assert recording[1] == 1, "the version of the text"
        client.change("a.v2", wrong)
        assert client.ask("vrts/recording", uri=client.uri("a.v2"))["result"] is None, "it is old"
        found = shown(2)
        assert not found.ready
        assert found.reasons
        assert client.ask("vrts/recording", uri=5)["error"]["message"].endswith("of a buffer")
        assert "error" in client.ask("vrts/recording", uri="file:///nowhere.v2")


def test_what_was_found_in_a_text_before_is_not_told_of_the_present_one() -> None:
    async def told() -> list[str]:
        heard = await begun()
        heard.tell("vrts/beside", {})
        session, uri = heard.session, TOLD["textDocument/didOpen"]["textDocument"]["uri"]
        before = session.document(uri)
        assert session.told_beside is not None
        session.told_beside(before)
        changes = [{"text": ".PROGRAM other\n.END\n"}]
        about = {"uri": uri, "version": 2}
        heard.tell("textDocument/didChange", {"textDocument": about, "contentChanges": changes})
        session.told_beside(before)
        found = [said["params"]["uri"] for said in heard.said if said.get("method") == "vrts/shown"]
        session.leave()
        return found

    assert len(asyncio.run(told())) == 1
