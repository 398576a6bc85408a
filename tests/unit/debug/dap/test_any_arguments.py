"""Whatever a client sends: an answer or a refusal for people, never a fault, and it goes on."""

import random
from pathlib import Path
from typing import Any

import pytest

from tests.laws import first
from tests.unit.debug.test_debugger import TEXT
from vrts.debug.dap.adapter import Adapter
from vrts.debug.dap.arguments import BadRequest, Fields
from vrts.debug.dap.going import GOING
from vrts.debug.dap.seeing import SEEING
from vrts.debug.dap.stopping import STOPPING

COMMANDS = sorted(
    {*GOING, *SEEING, *STOPPING, "initialize", "configurationDone", "restart", "cancel"}
)
WORDS = """
threadId frameId variablesReference name value expression context source path line lines breakpoints
condition hitCondition logMessage filters dataId targetId granularity start count levels startFrame
arguments requestId endLine program linesStartAt1 format
"""
NAMES = WORDS.split()
ODD: tuple[Any, ...] = (
    None, True, -1, 0, 1, 2, 10**12, 1.5, float("nan"), "", "n", "a", "SIG(3)", "1/0", "x" * 300,
    "\ud800", "\0", "/", "n == 1", ">= 2", "{n} {", [], {}, [1], [{}], [{"line": 5}],
    [{"line": 5, "condition": "1/0", "hitCondition": "%0"}], [{"dataId": "n"}],
    [{"dataId": "n @ twice 9"}], {"path": "/nowhere"}, {"path": 5}, 100_000, 199_999, 200_000,
)  # fmt: skip


@pytest.mark.parametrize("seed", first(2, range(20)))
def test_any_arguments_are_answered_or_refused(seed: int, tmp_path: Path) -> None:
    program = tmp_path / "loop.v2"
    program.write_text(TEXT)
    adapter = Adapter(lambda name, body: None)
    adapter.answer("initialize", Fields({}))
    adapter.answer("launch", Fields({"program": str(program), "dialect": "val2+"}))
    chance = random.Random(seed)
    refused: list[str] = []
    here = (*ODD, {"path": str(program)})
    for _ in range(150):
        command = chance.choice(COMMANDS)
        arguments: dict[str, Any] = {
            name: chance.choice(here) for name in chance.sample(NAMES, chance.randrange(6))
        }
        if chance.random() < 0.5:
            arguments["source"] = {"path": str(program)}
        sent = chance.choice(here) if chance.random() < 0.05 else arguments
        try:
            answer = adapter.answer(command, Fields(sent))
            adapter.gone(answer)
        except BadRequest as problem:
            refused.append(str(problem))
    assert all(refused)
    assert adapter.answer("threads", Fields({})).body["threads"]
