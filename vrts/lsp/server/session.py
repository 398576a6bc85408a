"""One client: its buffers, and what is asked about them while they change."""

import asyncio
import os
import traceback
from collections.abc import Callable, Coroutine
from concurrent.futures import ThreadPoolExecutor
from typing import Any, TypeVar

from lsprotocol import types
from pygls.exceptions import JsonRpcInvalidParams
from pygls.lsp.server import LanguageServer
from pygls.uris import from_fs_path, to_fs_path

from vrts import __version__
from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.lsp.answers.checking import check
from vrts.lsp.answers.near import is_long, near
from vrts.lsp.channel.findings import Finding
from vrts.lsp.documents.documents import Document, Documents
from vrts.lsp.documents.linking import group
from vrts.lsp.documents.setting_files import setting_stamp
from vrts.lsp.server.background.mending import Mending
from vrts.lsp.server.background.ordering import Orders
from vrts.lsp.server.background.reaching import Reaching
from vrts.lsp.server.background.reading import Reading
from vrts.lsp.server.background.settings import Looked, SettingFile, SettingFiles
from vrts.lsp.server.background.verifying import Subject, Verifications
from vrts.lsp.server.background.watching import watch
from vrts.lsp.server.diagnostics import converted, converted_finding
from vrts.lsp.server.messages.protocol import MOST_TOLD, Protocol
from vrts.lsp.server.places import Places
from vrts.lsp.server.scenarios import Scenarios

Result = TypeVar("Result")

DELAY_S = 0.15  # after the last key, before a buffer is checked


class Session(LanguageServer):
    """The server, which serves one client."""

    def __init__(self, *, runs: bool = True) -> None:
        """Begin; `runs`: whether processes beside it run programs and know an arm."""
        self.runs = runs
        super().__init__("vrts", __version__, protocol_cls=Protocol)  # pyright: ignore[reportUnknownMemberType]
        self.documents = Documents()
        self._uris: dict[str, str] = {}  # of open buffers, as the client writes them
        self._checks: dict[str, asyncio.Task[None]] = {}
        self._watch: asyncio.Task[None] | None = None
        self._lasting: list[asyncio.Task[None]] = []
        self._found: dict[str, tuple[Document, tuple[Diagnostic, ...]]] = {}
        self.reading = Reading(self, self.documents, self._check_folder)
        self.reaching = Reaching()
        self.mending = Mending()
        self.scenarios = Scenarios()
        self.orders = Orders()
        self.latest: str | None = None  # the buffer that was opened or changed last
        self.offers: list[Callable[[types.InitializeParams], None]] = []  # told how a client begins
        self.commands_to_register: list[str] = []
        self.settings = SettingFiles(_background, self._looked, runs=runs)
        self.verifications = Verifications(_background, self._learned)
        self._worker = ThreadPoolExecutor(1, "check")  # one: answers come first
        self.told_beside: Callable[[Document], None] | None = None  # who shows more beside the text
        self.told_looked: Callable[[Looked], None] = lambda _: None  # of a TOML file

    @property
    def followed(self) -> Protocol:
        """What follows the words of the client."""
        assert isinstance(self.protocol, Protocol)
        return self.protocol

    def begin(self, gone: "asyncio.Future[int]") -> None:
        """Take what learns that the client is gone, with the status to exit with."""
        self.gone = gone

    # --- buffers --------------------------------------------------------------------------------

    def opened(self, uri: str) -> None:
        """Take a buffer as it is now; check it and the others of its folder soon."""
        if self._watch is None:
            self._watch = _background(watch(self._open_folders, self._check_folder))
        self.reading.stand_back()
        path = path_of(uri)
        buffer = self.workspace.get_text_document(uri)
        if self.settings.take(path, uri, buffer.source, buffer.version):
            return
        if path not in self._uris:
            self.reading.begin(os.path.dirname(path))
        self._uris[path] = self.latest = uri
        self.documents.put(path, self.workspace.get_text_document(uri).source)
        self._check_folder(os.path.dirname(path))

    def closed(self, uri: str) -> None:
        """Forget a buffer, and what was said about it."""
        path = path_of(uri)
        self.settings.forget(path)
        self.documents.close(path)
        self._uris.pop(path, None)
        if self.latest == uri:
            self.latest = next(reversed(self._uris.values()), None)
        self._found.pop(path, None)
        self.verifications.forget(path)
        task = self._checks.pop(path, None)
        if task is not None:
            task.cancel()
        self.text_document_publish_diagnostics(types.PublishDiagnosticsParams(uri, []))

    def document(self, uri: str) -> Document:
        """Return a buffer.

        Raises:
            JsonRpcInvalidParams: The client has not opened it.
        """
        self.reading.stand_back()
        document = self.documents.open.get(path_of(uri))
        if document is None and self.setting(uri) is not None:
            return Document(path_of(uri), "")  # no program: nothing is to be said of it as one
        if document is None:
            raise JsonRpcInvalidParams(f"`{uri[:MOST_TOLD]}` is not open")
        return document

    def setting(self, uri: str) -> SettingFile | None:
        """Return a buffer with a scene, a task or another TOML file of vrts; None: it is none."""
        return self.settings.open.get(path_of(uri))

    def group(self, document: Document) -> list[Document]:
        """Return the files that belong together with a buffer, itself first, of those read yet."""
        return group(document, self.documents.beside(document.path))

    async def all_read(self, uri: str) -> None:
        """Return when all files of the folder of a buffer are known."""
        await self.reading.whole(os.path.dirname(path_of(uri)))

    def uri(self, document: Document) -> str:
        """Return the address of a file."""
        known = self._uris.get(document.path)
        return known or from_fs_path(document.path) or document.path

    def version_of(self, document: Document) -> int | None:
        """Return the version of an open buffer."""
        uri = self._uris.get(document.path)
        return None if uri is None else self.workspace.get_text_document(uri).version

    def places(self, document: Document) -> Places:
        """Return the positions of a text, as the client counts them."""
        return self.places_in(document.source)

    def places_in(self, source: SourceFile) -> Places:
        """Return the same of any text."""
        return Places(source, str(self.workspace.position_encoding or "utf-16"))

    def folders(self) -> list[str]:
        """Return the folders that the client has opened."""
        found = [to_fs_path(uri) for uri in self.workspace.folders]
        root = self.workspace.root_path
        return [folder for folder in (*found, root) if folder]

    def check_again(self) -> None:
        """Check and verify all buffers anew: something else is wanted of them."""
        for path in self.documents.open:
            self.verifications.forget(path)
            self._check_soon(path)

    def _open_folders(self) -> set[str]:
        """Return the folders that hold open buffers."""
        return {os.path.dirname(path) for path in self.documents.open}

    def _check_folder(self, folder: str) -> None:
        """Check the buffers of a folder again soon: a file there, or a buffer, is another now."""
        for path in self.documents.open:
            if os.path.dirname(path) == folder:
                self._check_soon(path)

    # --- work in the background -----------------------------------------------------------------

    def in_background(self, work: Coroutine[Any, Any, None]) -> None:
        """Begin something that lasts as long as the session, if nothing ends it."""
        self._lasting.append(_background(work))

    async def aside(self, work: Callable[[], Result]) -> Result:
        """Do work in the thread that checks, so that answers need not wait for it."""
        return await asyncio.get_running_loop().run_in_executor(self._worker, work)

    def findings(self, document: Document) -> tuple[Finding, ...]:
        """Return what a verification has against a buffer."""
        return self.verifications.findings(document)

    def shown(self, finding: Finding, document: Document) -> types.Diagnostic:
        """Return a finding as the protocol has it."""

        def other(path: str) -> tuple[str, Places] | None:
            found = self.documents.at(path)
            return None if found is None else (self.uri(found), self.places(found))

        uri, places, link = self.uri(document), self.places(document), self.scenarios.link(finding)
        return converted_finding(finding, uri, places, other, link)

    async def diagnostics_of(self, document: Document) -> tuple[Diagnostic, ...]:
        """Return what is wrong with a buffer, as told last, or worked out now."""
        known = self._found.get(document.path)
        return known[1] if known and known[0] is document else await self._checked(document)

    async def diagnostics_near(
        self, document: Document, first: int, last: int
    ) -> tuple[Diagnostic, ...]:
        """Return at least what is wrong between two offsets of a buffer; soon, also if it is long.

        While a long one is typed that is what was found before, moved along, and what is new there.
        """
        known = self._found.get(document.path)
        if known is not None and known[0] is not document and is_long(document):
            source = document.source
            lines = range(source.line_of(first) - 1, source.line_of(last))
            found = near(document, lines, *known, lambda: self.group(document))
            if found is not None:
                return found
        return await self.diagnostics_of(document)

    async def _checked(self, document: Document) -> tuple[Diagnostic, ...]:
        folder = os.path.dirname(document.path)

        def work() -> tuple[tuple[Diagnostic, ...], Subject, bool]:
            is_whole = self.reading.is_whole(folder)
            group = self.group(document)
            stamp = setting_stamp(document.path) if self.runs else ()
            subject = Subject(document, tuple(group[1:]), stamp)
            return check(document, group, is_whole=is_whole), subject, is_whole

        found, subject, is_whole = await self.aside(work)
        if self.documents.open.get(document.path) is document:
            self._found[document.path] = document, found
            if not is_whole:
                self.reading.begin(folder)
            if _has_error(found) or not is_whole or not self.runs:
                self.verifications.cancel(document.path)
            else:
                self.verifications.want(subject)
        return found

    def leave(self) -> None:
        """End what goes on in the background."""
        self.verifications.stop()
        self.reading.stop()
        self.reaching.stop()
        self.mending.stop()
        self.scenarios.stop()
        self.orders.stop()
        self.settings.stop()
        for task in (*self._checks.values(), self._watch):
            if task is not None:
                task.cancel()
        self._worker.shutdown(wait=False, cancel_futures=True)

    def _check_soon(self, path: str) -> None:
        running = self._checks.get(path)
        if running is not None:
            running.cancel()
        self._checks[path] = _background(self._check(path))

    async def _check(self, path: str) -> None:
        await asyncio.sleep(DELAY_S)
        document = self.documents.open.get(path)
        if document is not None:
            await self._checked(document)
            self._publish(document)

    def _publish(self, document: Document) -> None:
        """Tell the client what is wrong with a buffer, and with its run."""
        known = self._found.get(document.path)
        if self.documents.open.get(document.path) is not document or not known:
            return  # there is another text by now
        if known[0] is not document:
            return  # it is to be checked yet
        uri, places = self.uri(document), self.places(document)
        shown = [converted(diagnostic, uri, places) for diagnostic in known[1]]
        if not _has_error(known[1]):
            shown += [self.shown(finding, document) for finding in self.findings(document)]
        version = self.version_of(document)
        self.text_document_publish_diagnostics(types.PublishDiagnosticsParams(uri, shown, version))

    def _looked(self, looked: Looked) -> None:
        """Tell the client what was found in a TOML file."""
        self.told_looked(looked)

    def _learned(self, document: Document) -> None:
        """Tell the client what a verification has found."""
        self._publish(document)
        if self.told_beside is not None:
            self.told_beside(document)
        workspace = self.client_capabilities.workspace
        hints = workspace.inlay_hint if workspace is not None else None
        if hints is not None and hints.refresh_support:
            self.workspace_inlay_hint_refresh(None)
        lenses = workspace.code_lens if workspace is not None else None
        if lenses is not None and lenses.refresh_support and self.verifications.is_whole(document):
            self.workspace_code_lens_refresh(None)


def _has_error(found: tuple[Diagnostic, ...]) -> bool:
    return any(diagnostic.is_error for diagnostic in found)


def _background(work: Coroutine[Any, Any, None]) -> asyncio.Task[None]:
    """Begin something that nobody waits for."""
    task = asyncio.get_running_loop().create_task(work)
    task.add_done_callback(report_fault)
    return task


def report_fault(task: asyncio.Task[None]) -> None:
    """Show a fault of ours: nobody waits for the end of a check."""
    problem = None if task.cancelled() else task.exception()
    if problem is not None:
        traceback.print_exception(problem)


def path_of(uri: str) -> str:
    """Return the path of a file; the address itself where it is in no file."""
    path = to_fs_path(uri) if uri.startswith("file:") else None
    return os.path.normpath(path) if path else uri
