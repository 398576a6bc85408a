"""What a client says, message by message: what is wrong gets an answer that says so, and no more.

A request that is not as the protocol wants it is refused with a sentence, and the server goes on.
Only a fault of ours is shown as one, with its traceback on stderr.
"""

import asyncio
import contextvars
import json
import traceback
from collections.abc import Awaitable, Callable, Generator, Mapping
from concurrent.futures import Future
from typing import Any, TypeAlias, cast
from urllib.parse import unquote

from cattrs import transform_error
from lsprotocol import types
from pygls.exceptions import (
    JsonRpcException,
    JsonRpcInternalError,
    JsonRpcInvalidParams,
    JsonRpcInvalidRequest,
    JsonRpcMethodNotFound,
    JsonRpcParseError,
    JsonRpcRequestCancelled,
    JsonRpcServerNotInitialized,
)
from pygls.protocol import LanguageServerProtocol, lsp_method

from vrts.lsp.server.messages.parameters import misfit
from vrts.lsp.server.messages.stream import Broken

MOST_TOLD = 300  # letters of what is wrong
Command: TypeAlias = Callable[[types.ExecuteCommandParams], Awaitable[Any]]
_LISTENED = frozenset({types.SET_TRACE, types.CANCEL_REQUEST, types.PROGRESS})


class Protocol(LanguageServerProtocol):
    """The protocol of one client."""

    def __init__(self, *args: Any) -> None:
        """Begin with a client that has said nothing yet."""
        super().__init__(*args)  # pyright: ignore[reportUnknownMemberType]
        self.is_begun = False  # `initialize` was answered
        self.commands: dict[str, Command] = {}  # by their names: who carries them out
        self.status: int | None = None  # to exit with, once the client has said `exit`

    @property
    def is_shut_down(self) -> bool:
        """Whether the client has said `shutdown`."""
        return bool(self._shutdown)

    def take(self, said: bytes | Broken) -> None:
        """Carry out a message, or say what is wrong with it."""
        if isinstance(said, Broken):
            self._refuse(None, JsonRpcParseError(said.why))
            return
        try:
            message: Any = json.loads(said)
        except (ValueError, RecursionError) as problem:
            told = str(problem)[:MOST_TOLD]
            self._refuse(None, JsonRpcParseError(f"the message is no JSON: {told}"))
            return
        object_ = cast("dict[str, Any]", message if isinstance(message, dict) else {})
        if object_.get("jsonrpc") != self.VERSION:
            why = 'a message is an object with `"jsonrpc": "2.0"`'
            self._refuse(None, JsonRpcInvalidRequest(why))
            return
        try:
            contextvars.copy_context().run(self._take, object_)
        except Exception:  # a fault of ours: shown, and the next message is carried out
            traceback.print_exc()

    def _take(self, message: dict[str, Any]) -> None:
        asked = message.get("id")
        method = message.get("method")
        if isinstance(asked, bool) or not isinstance(asked, int | str | None):
            why = "the `id` of a request is a whole number or a text"
            self._refuse(None, JsonRpcInvalidRequest(why))
        elif "method" in message and not isinstance(method, str):
            self._refuse(asked, JsonRpcInvalidRequest("the `method` of a message is a text"))
        elif isinstance(method, str) and "id" in message and asked is not None:
            self._request(asked, method, message)
        elif isinstance(method, str):
            self._notification(method, message)
        elif asked is not None and asked in self._result_types:  # a question of ours
            self._answered(asked, message)

    def _request(self, asked: int | str, method: str, message: dict[str, Any]) -> None:
        try:
            self._may(method)
            params = self._params(method, message)
        except JsonRpcException as refusal:
            self._refuse(asked, refusal)
            return
        self._handle_request(asked, method, params)

    def _notification(self, method: str, message: dict[str, Any]) -> None:
        if method != types.EXIT and (not self.is_begun or self._shutdown):
            return  # as the protocol says: dropped
        if method not in _LISTENED and not self._knows(method):
            return
        try:
            params = self._params(method, message)
        except JsonRpcException as refusal:
            self._complain(str(refusal))
            return
        self._handle_notification(method, params)

    def _may(self, method: str) -> None:
        """Say what speaks against a request at this time, or against its method."""
        if self._shutdown:
            raise JsonRpcInvalidRequest(f"`{method}` came after `shutdown`")
        if method == types.INITIALIZE and self.is_begun:
            raise JsonRpcInvalidRequest("`initialize` came before")
        if method != types.INITIALIZE and not self.is_begun:
            raise JsonRpcServerNotInitialized(f"`{method}` came before `initialize`")
        if not self._knows(method):
            raise JsonRpcMethodNotFound(f"there is no method `{method[:MOST_TOLD]}` here")

    def _knows(self, method: str) -> bool:
        manager: Any = self.fm
        return method in manager.builtin_features or method in manager.features

    def _params(self, method: str, message: Mapping[str, Any]) -> Any:
        """Return parameters as the types of the protocol.

        Raises:
            JsonRpcInvalidParams: They are not as the protocol wants them.
        """
        if method not in types.METHOD_TO_TYPES:
            return message.get("params")  # one of ours, who looks itself
        wanted: Any = types.METHOD_TO_TYPES[method][2]  # type: ignore[index]
        if wanted is None:
            return None  # whatever comes with it
        params: Any = message.get("params")
        strict: Any = params
        if method == types.INITIALIZE and isinstance(params, dict) and "capabilities" in params:
            strict = {**cast("dict[str, Any]", params), "capabilities": {}}  # clients differ there
        try:
            why = misfit(strict, wanted)
            if not why:
                return self._converter.structure(params, wanted)
        except RecursionError:
            why = "what is asked is nested too deeply"
        except Exception as problem:  # whatever the converter meets: it is about what was said
            why = "; ".join(_plain(each) for each in transform_error(problem))
        raise JsonRpcInvalidParams(f"`{method}`: {why[:MOST_TOLD]}")

    def _answered(self, asked: int | str, message: dict[str, Any]) -> None:
        """Take the answer to a question of ours."""
        wanted = self._result_types.pop(asked)
        future = self._request_futures.get(asked)
        if future is None or future.done():
            self._request_futures.pop(asked, None)
            return  # nobody waits for it any more
        error = message.get("error")
        if isinstance(error, dict):
            told = cast("dict[str, Any]", error)
            code = told.get("code")
            number = code if isinstance(code, int) else JsonRpcException.CODE
            self._request_futures.pop(asked)
            future.set_exception(JsonRpcException(str(told.get("message")), number))
            return
        try:
            whole = {"id": asked, "jsonrpc": self.VERSION, "result": message.get("result")}
            found = self._converter.structure(whole, wanted).result if wanted else None
        except Exception:
            self._request_futures.pop(asked)
            future.set_exception(JsonRpcException("the client answered something else"))
            return
        self._handle_response(asked, found)

    def _handle_cancel_notification(self, msg_id: Any) -> None:
        """Cancel a request; one that has been answered meanwhile is no matter."""
        future = self._request_futures.pop(msg_id, None)
        if future is not None:
            future.cancel()

    # --- answers --------------------------------------------------------------------------------

    def _send_handler_result(self, future: Future[Any], *, msg_id: int | str) -> None:
        self._request_futures.pop(msg_id, None)
        try:
            result = future.result()
        except (asyncio.CancelledError, JsonRpcRequestCancelled):
            self._refuse(msg_id, JsonRpcRequestCancelled("the client cancelled it"))
        except JsonRpcException as refusal:
            self._refuse(msg_id, refusal)
        except Exception as fault:
            traceback.print_exception(fault)
            why = f"a fault in vrts: {traceback.format_exception_only(fault)[-1].strip()}"
            self._refuse(msg_id, JsonRpcInternalError(why))
        else:
            self.is_begun |= isinstance(result, types.InitializeResult)
            self._send_response(msg_id, result)

    def _check_handler_result(self, future: Future[Any]) -> None:
        fault = None if future.cancelled() else future.exception()
        if isinstance(fault, JsonRpcException):
            self._complain(str(fault))
        elif fault is not None:
            traceback.print_exception(fault)

    def _refuse(self, asked: int | str | None, why: JsonRpcException) -> None:
        if asked is not None:
            self._send_response(asked, None, why.to_response_error())
            return
        error = {"code": why.code, "message": why.message}
        self._send_data({"jsonrpc": self.VERSION, "id": None, "error": error})

    def _complain(self, why: str) -> None:
        """Tell of a notification that is not carried out: nothing answers it."""
        if self.is_begun:
            message = types.ShowMessageParams(types.MessageType.Warning, f"vrts: {why}")
            self.notify(types.WINDOW_SHOW_MESSAGE, message)

    # --- the life of a session ------------------------------------------------------------------

    @lsp_method(types.SHUTDOWN)
    def lsp_shutdown(self, *_: object) -> Generator[Any, Any, None]:
        """End all work; nothing is answered from now on."""
        self._shutdown = True
        own = self.msg_id
        for asked, future in list(self._request_futures.items()):  # each takes itself away
            if asked != own:
                future.cancel()
        manager: Any = self.fm
        handler = manager.features.get(types.SHUTDOWN)
        if handler is not None:
            yield handler, (None,), {}

    @lsp_method(types.EXIT)
    def lsp_exit(self, *_: object) -> Generator[Any, Any, None]:
        """End: well where the client has said `shutdown` before."""
        self.status = 0 if self._shutdown else 1
        yield from ()

    @lsp_method(types.TEXT_DOCUMENT_DID_CHANGE)
    def lsp_text_document__did_change(
        self, params: types.DidChangeTextDocumentParams
    ) -> Generator[Any, Any, None]:
        """Change a buffer, if it is open."""
        self.need_open(types.TEXT_DOCUMENT_DID_CHANGE, params.text_document.uri)
        change: Callable[..., Generator[Any, Any, None]] = super().lsp_text_document__did_change
        yield from change(params)

    @lsp_method(types.WORKSPACE_EXECUTE_COMMAND)
    async def lsp_workspace__execute_command(  # pyright: ignore[reportIncompatibleMethodOverride]
        self, params: types.ExecuteCommandParams
    ) -> Any:
        """Carry out a command; cancelling the request cancels it."""
        command = self.commands.get(params.command)
        if command is None:
            listed = ", ".join(self.commands) or "none"
            told = params.command[:MOST_TOLD]
            raise JsonRpcInvalidParams(f"there is no command `{told}` here; there are: {listed}")
        return await command(params)

    def need_open(self, method: str, uri: str) -> None:
        """Refuse what is about a buffer that is not open.

        Raises:
            JsonRpcInvalidParams: It is not.
        """
        if unquote(uri) not in self.workspace.text_documents:
            raise JsonRpcInvalidParams(f"`{method}`: `{uri[:MOST_TOLD]}` is not open")


def _plain(told: str) -> str:
    """Return what the converter says without its word for the whole."""
    return told.replace(" @ $.", " at ").replace(" @ $", "")
