"""One client: its buffers, and what is asked about them while they change."""

import asyncio
import os
import traceback
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

from lsprotocol import types
from pygls.lsp.server import LanguageServer
from pygls.uris import from_fs_path, to_fs_path

from vrts import __version__
from vrts.base.diagnostic import Diagnostic
from vrts.lsp.checking import check
from vrts.lsp.documents import Document, Documents
from vrts.lsp.linking import group
from vrts.lsp.server.diagnostics import converted
from vrts.lsp.server.places import Places

Result = TypeVar("Result")

DELAY_S = 0.15  # after the last key, before a buffer is checked


class Session(LanguageServer):
    """The server, which serves one client."""

    def __init__(self) -> None:
        super().__init__("vrts", __version__)  # pyright: ignore[reportUnknownMemberType]
        self.documents = Documents()
        self._uris: dict[str, str] = {}  # of open buffers, as the client writes them
        self._checks: dict[str, asyncio.Task[None]] = {}
        self._found: dict[str, tuple[Document, tuple[Diagnostic, ...]]] = {}
        self._worker = ThreadPoolExecutor(1, "check")  # one: answers come first

    # --- buffers --------------------------------------------------------------------------------

    def opened(self, uri: str) -> None:
        """Take a buffer as it is now; check it and the others of its folder soon."""
        path = path_of(uri)
        self._uris[path] = uri
        self.documents.put(path, self.workspace.get_text_document(uri).source)
        folder = os.path.dirname(path)
        for other in self.documents.open:
            if os.path.dirname(other) == folder:
                self._check_soon(other)

    def closed(self, uri: str) -> None:
        """Forget a buffer, and what was said about it."""
        path = path_of(uri)
        self.documents.close(path)
        self._uris.pop(path, None)
        self._found.pop(path, None)
        task = self._checks.pop(path, None)
        if task is not None:
            task.cancel()
        self.text_document_publish_diagnostics(types.PublishDiagnosticsParams(uri, []))

    def document(self, uri: str) -> Document:
        """Return a buffer; an empty one where the client asks for what it has not opened."""
        path = path_of(uri)
        return self.documents.open.get(path) or Document(path, "")

    def group(self, document: Document) -> list[Document]:
        """Return the files that belong together with a buffer, itself first."""
        return group(document, self.documents.beside(document.path))

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
        return Places(document.source, str(self.workspace.position_encoding or "utf-16"))

    def folders(self) -> list[str]:
        """Return the folders that the client has opened."""
        found = [to_fs_path(uri) for uri in self.workspace.folders]
        root = self.workspace.root_path
        return [folder for folder in (*found, root) if folder]

    # --- work in the background -----------------------------------------------------------------

    async def aside(self, work: Callable[[], Result]) -> Result:
        """Do work in the thread that checks, so that answers need not wait for it."""
        return await asyncio.get_running_loop().run_in_executor(self._worker, work)

    async def diagnostics_of(self, document: Document) -> tuple[Diagnostic, ...]:
        """Return what is wrong with a buffer, as told last, or worked out now."""
        known = self._found.get(document.path)
        return known[1] if known and known[0] is document else await self._checked(document)

    async def _checked(self, document: Document) -> tuple[Diagnostic, ...]:
        def work() -> tuple[Diagnostic, ...]:
            return check(document, self.group(document))

        found = await self.aside(work)
        if self.documents.open.get(document.path) is document:
            self._found[document.path] = document, found
        return found

    def leave(self) -> None:
        """End what goes on in the background."""
        for task in self._checks.values():
            task.cancel()
        self._worker.shutdown(wait=False, cancel_futures=True)

    def _check_soon(self, path: str) -> None:
        running = self._checks.get(path)
        if running is not None:
            running.cancel()
        task = asyncio.get_running_loop().create_task(self._check(path))
        task.add_done_callback(report_fault)
        self._checks[path] = task

    async def _check(self, path: str) -> None:
        await asyncio.sleep(DELAY_S)
        document = self.documents.open.get(path)
        if document is None:
            return
        version = self.version_of(document)
        found = await self._checked(document)
        if self.documents.open.get(path) is not document:
            return  # there is another text by now
        places = self.places(document)
        shown = [converted(diagnostic, self.uri(document), places) for diagnostic in found]
        self.text_document_publish_diagnostics(
            types.PublishDiagnosticsParams(self.uri(document), shown, version)
        )


def report_fault(task: asyncio.Task[None]) -> None:
    """Show a fault of ours: nobody waits for the end of a check."""
    problem = None if task.cancelled() else task.exception()
    if problem is not None:
        traceback.print_exception(problem)


def path_of(uri: str) -> str:
    """Return the path of a file; the address itself where it is in no file."""
    path = to_fs_path(uri) if uri.startswith("file:") else None
    return os.path.normpath(path) if path else uri
