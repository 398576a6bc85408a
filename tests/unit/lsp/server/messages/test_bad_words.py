"""Whatever a client says, it gets an answer, and the next good question is answered right."""

import asyncio
import copy
import io
import random
from collections.abc import Iterable
from typing import Any, cast

import pytest

from tests.unit.lsp.heard import TEXT, URI, Heard, begun
from vrts.lsp.server.messages.stream import Broken, Messages
from vrts.lsp.server.serving import session_with_features

ROUNDS = 12  # for each method
AT = {"textDocument": {"uri": URI}, "position": {"line": 1, "character": 14}}
RANGE = {"start": {"line": 0, "character": 0}, "end": {"line": 9, "character": 0}}
ASKED: dict[str, dict[str, Any]] = {
    "textDocument/hover": AT,
    "textDocument/completion": AT | {"context": {"triggerKind": 1}},
    "textDocument/signatureHelp": AT,
    "textDocument/definition": AT,
    "textDocument/references": AT | {"context": {"includeDeclaration": True}},
    "textDocument/documentHighlight": AT,
    "textDocument/prepareRename": AT,
    "textDocument/rename": AT | {"newName": "other"},
    "textDocument/documentSymbol": {"textDocument": {"uri": URI}},
    "textDocument/foldingRange": {"textDocument": {"uri": URI}},
    "textDocument/codeLens": {"textDocument": {"uri": URI}},
    "textDocument/formatting": {
        "textDocument": {"uri": URI},
        "options": {"tabSize": 8, "insertSpaces": True},
    },
    "textDocument/rangeFormatting": {
        "textDocument": {"uri": URI},
        "range": RANGE,
        "options": {"tabSize": 8, "insertSpaces": True},
    },
    "textDocument/codeAction": {
        "textDocument": {"uri": URI},
        "range": RANGE,
        "context": {"diagnostics": []},
    },
    "textDocument/inlayHint": {"textDocument": {"uri": URI}, "range": RANGE},
    "textDocument/semanticTokens/full": {"textDocument": {"uri": URI}},
    "textDocument/semanticTokens/full/delta": {
        "textDocument": {"uri": URI},
        "previousResultId": "1",
    },
    "textDocument/semanticTokens/range": {"textDocument": {"uri": URI}, "range": RANGE},
    "workspace/symbol": {"query": "ma"},
    "workspace/executeCommand": {"command": "vrts.none", "arguments": [URI, "main"]},
    "codeAction/resolve": {"title": "nothing", "data": URI},
}
TOLD: dict[str, dict[str, Any]] = {
    "textDocument/didOpen": {
        "textDocument": {"uri": URI, "languageId": "val2", "version": 1, "text": TEXT}
    },
    "textDocument/didChange": {
        "textDocument": {"uri": URI, "version": 2},
        "contentChanges": [{"text": TEXT}],
    },
    "textDocument/didClose": {"textDocument": {"uri": "untitled:b.v2"}},
    "$/cancelRequest": {"id": 3},
    "workspace/didChangeWorkspaceFolders": {"event": {"added": [], "removed": []}},
}
ODD: tuple[Any, ...] = (
    *(None, True, -1, 0, 2**31, 10**30, 1.5, float("nan"), "", "x", "\x00", "\ud800", [], {}),
    *([None], {"line": 1}, "file:///no/such/file.v2", "file:///a%00b", "http://[", "http://x/y"),
    *("file:////etc\x00/passwd", "untitled:other", [[[[]]]], "a" * 5_000, "\U0001f916"),
)
REFUSED = {-32602, -32803, -32600}  # parameters, a request refused for a reason, a message


def places(value: Any, at: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """Return where the values of JSON stand, the whole included."""
    found = [at]
    inside: Iterable[tuple[Any, Any]] = ()
    if isinstance(value, dict):
        inside = cast("dict[str, Any]", value).items()
    elif isinstance(value, list):
        inside = enumerate(cast("list[Any]", value))
    for key, held in inside:
        found += places(held, (*at, key))
    return found


def spoiled(params: Any, chosen: random.Random) -> Any:
    """Return parameters with something odd, or nothing, at one place."""
    at = chosen.choice(places(params))
    odd = chosen.choice(ODD)
    if not at:
        return odd
    found = copy.deepcopy(params)
    inner = found
    for key in at[:-1]:
        inner = inner[key]
    if isinstance(inner, dict) and chosen.random() < 0.2:
        del inner[at[-1]]
    else:
        inner[at[-1]] = odd
    return found


def test_bad_parameters_are_answered_and_the_next_good_request_is_right(
    capsys: pytest.CaptureFixture[str],
) -> None:
    async def talk() -> None:
        heard = await begun()
        right = await heard.ask("textDocument/hover", AT)
        assert "location" in right["result"]["contents"]["value"]
        chosen = random.Random(24)
        for method, params in ASKED.items():
            for _ in range(ROUNDS):
                bad = spoiled(params, chosen)
                found = await heard.ask(method, bad)
                if "error" in found:
                    assert found["error"]["code"] in REFUSED, (method, bad, found)
                    assert " " in found["error"]["message"], found
                    assert "data" not in found["error"]
            again = await heard.ask("textDocument/hover", AT)
            assert again["result"] == right["result"], method
        for method, params in TOLD.items():
            for _ in range(ROUNDS):
                heard.tell(method, spoiled(params, chosen))
            heard.tell("textDocument/didOpen", TOLD["textDocument/didOpen"])
            again = await heard.ask("textDocument/hover", AT)
            assert again["result"] == right["result"], method
        heard.session.leave()

    asyncio.run(talk())
    assert capsys.readouterr().err == ""


@pytest.mark.parametrize(
    ("params", "why"),
    [
        (AT | {"position": {"line": -1, "character": 0}}, "position.line is -1"),
        (AT | {"position": None}, "position is null, not an object"),
        (AT | {"position": {"line": "1", "character": 0}}, "position.line is a text, not a whole"),
        (AT | {"textDocument": {"uri": "file:///a%00b"}}, "no address"),
        (AT | {"textDocument": {"uri": "untitled:b"}}, "`untitled:b` is not open"),
        ({"textDocument": {"uri": URI}}, "position is missing"),
        (None, "what is asked is null, not an object"),
    ],
)
def test_a_refusal_is_a_sentence(params: Any, why: str) -> None:
    async def talk() -> dict[str, Any]:
        heard = await begun()
        found = await heard.ask("textDocument/hover", params)
        heard.session.leave()
        return found["error"]

    error = asyncio.run(talk())
    assert error["code"] == -32602
    assert why in error["message"]


def test_a_session_has_a_beginning_and_an_end() -> None:
    async def talk() -> list[int]:
        heard = Heard(session_with_features(runs=False))
        asked: dict[str, Any] = {"processId": None, "rootUri": None, "capabilities": {}}
        codes = [(await heard.ask("textDocument/hover", AT))["error"]["code"]]
        codes.append((await heard.ask("initialize", {"processId": 0}))["error"]["code"])
        codes.append((await heard.ask("initialize", asked | {"processId": -3}))["error"]["code"])
        assert "result" in await heard.ask("initialize", asked)
        codes.append((await heard.ask("initialize", asked))["error"]["code"])
        codes.append((await heard.ask("no/such", None))["error"]["code"])
        assert (await heard.ask("shutdown", None))["result"] is None
        codes.append((await heard.ask("textDocument/hover", AT))["error"]["code"])
        heard.tell("exit", None)
        assert heard.session.followed.status == 0
        return codes

    assert asyncio.run(talk()) == [-32002, -32602, -32602, -32600, -32601, -32600]


def test_a_buffer_of_ten_megabytes_is_told_to_be_too_large() -> None:
    async def talk() -> None:
        heard = await begun()
        large = {"uri": "untitled:c.v2", "languageId": "val2", "version": 1, "text": "x" * 10**7}
        heard.tell("textDocument/didOpen", {"textDocument": large})
        found = await heard.ask("textDocument/documentSymbol", {"textDocument": {"uri": URI}})
        assert [one["name"] for one in found["result"]] == ["main"]
        heard.session.leave()

    asyncio.run(talk())


@pytest.mark.parametrize(
    ("broken", "why"),
    [
        (b"Content-Length: -5\r\n\r\n{}", "`Content-Length: -5` is not a number of bytes"),
        (b"Content-Length: words\r\n\r\n", "`Content-Length: words` is not"),
        (b"Content-Length: 99999999999\r\n\r\n{}", "99999999999 bytes is too large"),
        (b"Content-Length: " + b"9" * 70_000 + b"\r\n\r\n", "is too large"),
        (b"Other: 5\r\n\r\n{}", "lacks `Content-Length`"),
    ],
)
def test_a_broken_header_is_told_and_the_next_message_is_found(broken: bytes, why: str) -> None:
    messages = Messages(io.BytesIO(broken + b"content-length: 2\r\nX: y\r\n\r\n[]"))
    found = messages.next()
    assert isinstance(found, Broken)
    assert why in found.why
    assert messages.next() == b"[]"
    assert messages.next() is None


@pytest.mark.parametrize(
    ("said", "code"),
    [
        (b"{nonsense", -32700),
        (b"\xff\xfe", -32700),
        (b"[" * 100_000, -32700),
        (b"[]", -32600),
        (b'{"id": 1, "method": "shutdown"}', -32600),
        (b'{"jsonrpc": "2.0", "id": [], "method": "shutdown"}', -32600),
        (b'{"jsonrpc": "2.0", "id": 1, "method": 5}', -32600),
    ],
)
def test_what_is_no_message_is_answered(said: bytes, code: int) -> None:
    async def talk() -> dict[str, Any]:
        heard = Heard(session_with_features(runs=False))
        heard.session.followed.take(said)
        return heard.said[0]

    assert asyncio.run(talk())["error"]["code"] == code
