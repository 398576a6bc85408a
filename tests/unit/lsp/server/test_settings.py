"""Scene and task files over real pipes: faults, keys, what they mean, and the last good scene."""

import json
import shutil
from pathlib import Path
from queue import Queue
from typing import Any

from tests.places import ROOT
from tests.support_lsp import PATIENCE, Client, where

CANS = ROOT / "examples" / "01-cans-on-bases"


def test_a_task_file_is_checked_completed_and_shown_and_the_last_good_scene_stays(
    tmp_path: Path,
) -> None:
    shutil.copy(CANS / "task.toml", tmp_path)
    text = (CANS / "task.toml").read_text()
    came: Queue[Any] = Queue()
    with Client(tmp_path) as client:
        uri = client.uri("task.toml")

        def told(params: Any) -> None:
            came.put(params)

        def recording() -> Any:
            return client.ask("vrts/recording", uri=uri)["result"]

        client.client.feature("vrts/shown")(told)
        client.tell("vrts/beside")
        client.open("task.toml", text)
        assert client.diagnostics("task.toml") == []
        assert came.get(timeout=PATIENCE).scene.reads
        shown = recording()
        assert len(json.loads(shown.recording)["scene"]["goals"]) == 2
        assert (shown.still, shown.old, shown.version) == (True, False, 1)

        at = where(text, 'base2"')
        items = client.about("completion", "task.toml", at)["items"]
        assert '"base1"' in [item["label"] for item in items]
        about = client.about("hover", "task.toml", where(text, "position_mm = "))
        assert "mm" in about["contents"]["value"]
        symbols = client.about("documentSymbol", "task.toml")
        assert not symbols, "it is no program"

        wrong = text.replace('on = "base2"', 'on = "base7"')
        client.change("task.toml", wrong)
        found = client.diagnostics("task.toml", bool)
        assert found[0]["range"]["start"]["line"] == where(wrong, "base7")[0]
        assert not came.get(timeout=PATIENCE).scene.reads
        kept = recording()
        assert (kept.recording, kept.old) == (shown.recording, True)
        client.change("task.toml", text)
        assert client.diagnostics("task.toml") == []
        assert not recording().old
