"""Commands of any editor: run, verify and debug."""

import asyncio
import shutil
import subprocess
from collections.abc import Callable, Coroutine
from pathlib import Path
from typing import Any, cast

import pytest

from tests.places import ROOT
from tests.unit.lsp.heard import URI, Heard, begun
from vrts.lsp.channel.ordered import Done, Ordered
from vrts.lsp.server.session import Session

CANS = ROOT / "examples" / "01-cans-on-bases"
TEXT = """.PROGRAM main
        READY
.END
.PROGRAM put(n)
        DELAY n
.END
"""
COMMANDS = ["vrts.run", "vrts.verify", "vrts.debug"]
OPENS = {"window": {"showDocument": {"support": True}, "workDoneProgress": True}}
REGISTERS = {"workspace": {"executeCommand": {"dynamicRegistration": True}}}


def talk(
    what: Callable[[Heard], Coroutine[Any, Any, None]], able: dict[str, Any] | None = None
) -> None:
    async def whole() -> None:
        heard = await begun(TEXT, able, runs=True)
        try:
            await what(heard)
        finally:
            heard.session.leave()

    asyncio.run(whole())


def order(heard: Heard, command: str, *arguments: Any) -> str:
    asked = {"command": command, "arguments": list(arguments)}
    return heard.begin_to_ask("workspace/executeCommand", asked)


def says(method: str) -> Callable[[dict[str, Any]], bool]:
    return lambda said: said.get("method") == method


def nothing(_: object) -> None:
    """Verify nothing beside what is tried."""


class Answering:
    """Carries nothing out: what an order was, and an answer to it."""

    def __init__(self, session: Session, done: Done) -> None:
        self.ordered: list[Ordered] = []
        self._done = done
        session.orders.carry_out = self  # type: ignore[method-assign,assignment]

    async def __call__(self, ordered: Ordered) -> Done:
        self.ordered.append(ordered)
        return self._done


def test_an_editor_with_nothing_of_its_own_gets_the_commands() -> None:
    async def what(heard: Heard) -> None:
        provider = heard.said[0]["result"]["capabilities"]["executeCommandProvider"]
        assert provider["commands"] == COMMANDS

    talk(what)


def test_an_editor_that_registers_commands_is_asked_to() -> None:
    async def what(heard: Heard) -> None:
        provider = heard.said[0]["result"]["capabilities"]["executeCommandProvider"]
        assert provider["commands"] == []
        asked = await heard.next(says("client/registerCapability"))
        (one,) = asked["params"]["registrations"]
        assert one["registerOptions"]["commands"] == COMMANDS
        refused = {"code": -32603, "message": "command 'vrts.run' already exists"}
        heard.say({"jsonrpc": "2.0", "id": asked["id"], "error": refused})
        answer = await heard.ask("textDocument/codeLens", {"textDocument": {"uri": URI}})
        assert len(answer["result"]) == 3, "the session goes on"

    talk(what, REGISTERS)


def test_an_editor_with_commands_of_its_own_keeps_them() -> None:
    async def offered(options: Any, *, runs: bool = True) -> list[str]:
        heard = await begun(TEXT, runs=runs, options=options)
        heard.session.leave()
        return heard.said[0]["result"]["capabilities"]["executeCommandProvider"]["commands"]

    assert asyncio.run(offered({"commands": ["vrts.run", 5]})) == COMMANDS[1:]
    assert asyncio.run(offered("odd")) == COMMANDS
    assert asyncio.run(offered(None, runs=False)) == [], "where no program may run"


def test_an_order_is_about_a_buffer_and_what_came_of_it_is_shown() -> None:
    async def what(heard: Heard) -> None:
        orders = Answering(heard.session, Done(0, "short", "all of it\n"))
        number = order(heard, "vrts.run", URI, "Main")
        begins = await heard.next(says("window/workDoneProgress/create"))
        heard.say({"jsonrpc": "2.0", "id": begins["id"], "result": None})
        shown = await heard.next(says("window/showDocument"))
        file = Path(shown["params"]["uri"].removeprefix("file://"))
        assert file.read_text("utf-8") == "all of it\n"
        assert not shown["params"]["external"]
        heard.say({"jsonrpc": "2.0", "id": shown["id"], "result": {"success": True}})
        result = (await heard.answer(number))["result"]
        assert result == {"status": 0, "text": "all of it\n", "uri": shown["params"]["uri"]}
        told = await heard.next(says("window/showMessage"))
        assert told["params"] == {"type": 3, "message": "short"}
        assert orders.ordered == [Ordered("run", URI, TEXT, "Main")]

    talk(what, OPENS)


def test_where_the_editor_opens_nothing_a_message_tells_all() -> None:
    async def what(heard: Heard) -> None:
        Answering(heard.session, Done(1, "short", "all\nof it\n"))
        await heard.answer(order(heard, "vrts.verify"))  # of the buffer that was changed last
        told = (await heard.next(says("window/showMessage")))["params"]
        assert told["type"] == 2
        assert told["message"].startswith("all\nof it\nfile://")
        Answering(heard.session, Done(0, "short", "text", "<html>"))
        result = (await heard.answer(order(heard, "vrts.debug", URI, "main")))["result"]
        assert result["uri"].endswith(".html")
        assert result["launch"]["entry"] == "main"

    talk(what)


@pytest.mark.parametrize(
    ("command", "arguments", "why"),
    [
        ("vrts.none", [], "there is no command `vrts.none` here; there are: vrts.run, "),
        ("vrts.run", [5], "takes the address of a buffer and the name of a program"),
        ("vrts.run", [URI, "main", 3], "takes the address of a buffer"),
        ("vrts.run", ["file:///nowhere.v2"], "`file:///nowhere.v2` is not open"),
        ("vrts.run", [URI, "nowhere"], "there is no program `nowhere` in untitled:a.v2: main, put"),
        ("vrts.run", [URI, "put"], "`put` takes arguments: name one that calls it"),
    ],
)
def test_arguments_are_checked(command: str, arguments: list[Any], why: str) -> None:
    async def what(heard: Heard) -> None:
        error = (await heard.answer(order(heard, command, *arguments)))["error"]
        assert error["code"] == -32602
        assert why in error["message"]

    talk(what)


@pytest.mark.parametrize("by", ["request", "progress"])
def test_an_order_that_is_cancelled_ends_its_process(
    by: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    begun_ones: list[subprocess.Popen[bytes]] = []
    real = subprocess.Popen

    def begin(*words: Any, **more: Any) -> Any:
        one: subprocess.Popen[bytes] = cast("Any", real)(*words, **more)
        begun_ones.append(one)
        return one

    async def what(heard: Heard) -> None:
        monkeypatch.setattr(subprocess, "Popen", begin)
        asked = {"command": "vrts.verify", "arguments": [URI], "workDoneToken": "mine"}
        number = heard.begin_to_ask("workspace/executeCommand", asked)
        await heard.next(says("$/progress"))
        while not begun_ones:
            await asyncio.sleep(0)
        if by == "request":
            heard.tell("$/cancelRequest", {"id": number})
        else:
            heard.tell("window/workDoneProgress/cancel", {"token": "mine"})
        assert (await heard.answer(number))["error"]["code"] == -32800
        assert begun_ones[0].returncode is not None
        kinds = [s["params"]["value"]["kind"] for s in heard.said if says("$/progress")(s)]
        assert kinds == ["begin", "end"]

    talk(what)


def test_a_whole_verification(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    shutil.copy(CANS / "task.toml", tmp_path)
    text = (CANS / "submissions" / "hits-base.v2").read_text("utf-8")

    async def what(heard: Heard) -> None:
        heard.session.verifications.stop()
        monkeypatch.setattr(heard.session.verifications, "want", nothing)  # beside it
        uri = (tmp_path / "a.v2").as_uri()
        heard.open(uri, text)
        result = (await heard.answer(order(heard, "vrts.verify", uri, "main")))["result"]
        assert result["status"] == 1
        assert result["text"].startswith("7.0 / 10  a.v2")

    talk(what)
