"""Commands of any editor: run, verify and debug a program, in the scene of its task.

A client whose editor has commands of these names itself says so in its `initializationOptions`,
as `{"commands": [names]}`. One that takes registrations gets the others by one, as VS Code fails
to begin where two give a command.
"""

import asyncio
from collections.abc import AsyncGenerator
from concurrent.futures import Future
from contextlib import asynccontextmanager
from functools import partial
from itertools import count
from typing import Any, cast

from lsprotocol import types
from pygls.exceptions import JsonRpcException, JsonRpcInvalidParams
from pygls.uris import from_fs_path

from vrts.lsp.answers.lenses import COMMANDS
from vrts.lsp.channel.ordered import FAULT, Done, Ordered
from vrts.lsp.documents.documents import Document
from vrts.lsp.server.messages.protocol import MOST_TOLD
from vrts.lsp.server.session import Session

REGISTERED = "vrts-commands"
ANSWER_S = 5.0  # for the client to say that it shows progress
MOST_SHOWN = 20  # lines of a message, where the client opens no file
_numbers = count(1)


def register(session: Session) -> None:
    """Carry out what is ordered."""
    if not session.runs:
        return
    for name in COMMANDS:
        session.followed.commands[name] = partial(_command, session)

    @session.feature(types.INITIALIZED)
    async def initialized(server: Session, params: types.InitializedParams) -> None:
        left = server.commands_to_register
        if not left:
            return
        options = types.ExecuteCommandOptions(left)
        one = types.Registration(REGISTERED, types.WORKSPACE_EXECUTE_COMMAND, options)
        try:
            await server.client_register_capability_async(  # pyright: ignore[reportUnknownMemberType]
                types.RegistrationParams([one])
            )
        except JsonRpcException:
            return  # it has commands of these names

    def offered(params: types.InitializeParams) -> None:
        own = _own(params.initialization_options)
        names = [name for name in COMMANDS if name not in own]
        workspace = params.capabilities.workspace
        able = None if workspace is None else workspace.execute_command
        if able is not None and able.dynamic_registration:
            session.commands_to_register = names
            return
        for name in names:
            session.command(name)(_advertised)

    session.offers.append(offered)


def _advertised(*_: object) -> None:
    """Stand in the list of what the server can do; `Protocol` knows who does it."""


def _own(options: Any) -> list[Any]:
    """Return the commands that the editor has itself."""
    told = cast("dict[str, Any]", options).get("commands") if isinstance(options, dict) else None
    return cast("list[Any]", told) if isinstance(told, list) else []


async def _command(server: Session, params: types.ExecuteCommandParams) -> dict[str, Any]:
    """Carry out a command, show what came of it, and return that."""
    uri, entry = _asked(server, params)
    await server.all_read(uri)
    document = server.document(uri)
    others = tuple((other.path, other.source.text) for other in server.group(document)[1:])
    work = params.command.rpartition(".")[2]
    ordered = Ordered(work, document.path, document.source.text, entry, others)
    title = f"{work} {entry or document.source.name}"
    async with _progress(server, params.work_done_token, title):
        done = await server.orders.carry_out(ordered)
    file = server.orders.written(ordered, done)
    address = from_fs_path(str(file)) or str(file)
    await _show(server, done, address)
    result: dict[str, Any] = {"status": done.status, "text": done.text, "uri": address}
    if work == "debug":
        launch = {"type": "vrts", "request": "launch", "program": document.path}
        result["launch"] = launch | ({"entry": entry} if entry else {})
    return result


def _asked(server: Session, params: types.ExecuteCommandParams) -> tuple[str, str | None]:
    """Return the buffer that a command is about, and the program of it.

    Raises:
        JsonRpcInvalidParams: There is none such.
    """
    given: list[Any] = list(params.arguments or ())
    name = params.command
    uri: Any = given[0] if given else server.latest
    entry: Any = given[1] if len(given) > 1 else None
    if uri is None:
        raise JsonRpcInvalidParams(f"`{name}`: no program is open")
    if len(given) > 2 or not isinstance(uri, str) or not isinstance(entry, str | None):
        raise JsonRpcInvalidParams(
            f"`{name}` takes the address of a buffer and the name of a program in it"
        )
    if entry is not None:
        _need(server.document(uri), entry, name)
    else:
        server.document(uri)
    return uri, entry


def _need(document: Document, entry: str, name: str) -> None:
    """Refuse a program that is not there, or that only another one can call."""
    programs = {p.name: p for p in document.names.programs if p.name}
    found = programs.get(entry.lower())
    if found is None:
        listed = ", ".join(list(programs)[:10]) or "none"
        why = f"there is no program `{entry[:MOST_TOLD]}` in {document.source.name}: {listed}"
        raise JsonRpcInvalidParams(f"`{name}`: {why}")
    if found.formals:
        raise JsonRpcInvalidParams(f"`{name}`: `{entry}` takes arguments: name one that calls it")


async def _show(server: Session, done: Done, address: str) -> None:
    """Show a few lines as a message, and all in a file where the client opens one."""
    window = server.client_capabilities.window
    opens = window is not None and window.show_document is not None and window.show_document.support
    text = done.short
    if not opens:
        rows = done.text.rstrip("\n").split("\n")
        if not done.page and len(rows) <= MOST_SHOWN:
            text = "\n".join(rows)
        text += f"\n{address}"
    kinds = {0: types.MessageType.Info, FAULT: types.MessageType.Error}
    kind = kinds.get(done.status, types.MessageType.Warning)
    server.window_show_message(types.ShowMessageParams(kind, text))
    if opens:
        wanted = types.ShowDocumentParams(address, external=bool(done.page), take_focus=False)
        try:
            async with asyncio.timeout(ANSWER_S):
                await server.window_show_document_async(wanted)  # pyright: ignore[reportUnknownMemberType]
        except (TimeoutError, JsonRpcException):
            server.window_show_message(types.ShowMessageParams(kind, address))


@asynccontextmanager
async def _progress(
    server: Session, token: int | str | None, title: str
) -> AsyncGenerator[None, None]:
    """Show that something goes on, if the client does, and let it be cancelled there."""
    window = server.client_capabilities.window
    progress = server.work_done_progress
    if token is None and window is not None and window.work_done_progress:
        token = f"vrts-order-{next(_numbers)}"
        try:
            async with asyncio.timeout(ANSWER_S):
                await progress.create_async(token)  # pyright: ignore[reportUnknownMemberType]
        except (TimeoutError, JsonRpcException):
            token = None
    if token is None:
        yield
        return
    progress.begin(token, types.WorkDoneProgressBegin(title, cancellable=True))
    task = asyncio.current_task()
    assert task is not None
    tokens = cast("dict[int | str, Future[None]]", cast("Any", progress).tokens)
    stopped = tokens[token]
    stopped.add_done_callback(lambda future: task.cancel() if future.cancelled() else None)
    try:
        yield
    finally:
        progress.end(token, types.WorkDoneProgressEnd())
        if not stopped.done():
            stopped.set_result(None)
        del tokens[token]
