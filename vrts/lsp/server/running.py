"""Code lenses, and inlay hints from a run in a process of its own."""

import asyncio
import json
import sys
from typing import Any

from lsprotocol import types

from vrts.lsp.documents import Document
from vrts.lsp.lenses import lenses
from vrts.lsp.server.session import Session, report_fault
from vrts.lsp.timing import STEP_S, Timing, hint

DELAY_S = 0.7  # after the last key, before a program is run
PATIENCE_S = 60.0  # for a run, whatever it does


def register(session: Session) -> None:
    """Answer what a program does when it runs."""
    runs = Runs(session)

    @session.feature(types.TEXT_DOCUMENT_CODE_LENS)
    def code_lenses(server: Session, params: types.CodeLensParams) -> list[types.CodeLens]:
        document = server.document(params.text_document.uri)
        places = server.places(document)
        uri = params.text_document.uri
        return [
            types.CodeLens(
                places.range(lens.start, lens.end),
                types.Command(lens.title, lens.command, arguments=[uri, lens.entry]),
            )
            for lens in lenses(document)
        ]

    @session.feature(types.TEXT_DOCUMENT_INLAY_HINT)
    def inlay_hints(server: Session, params: types.InlayHintParams) -> list[types.InlayHint]:
        document = server.document(params.text_document.uri)
        places = server.places(document)
        first, last = params.range.start.line, params.range.end.line
        return [
            types.InlayHint(
                places.position(_line_end(document, timing.line)),
                hint(timing),
                tooltip=_tooltip(timing),
                padding_left=True,
            )
            for timing in runs.timings_of(document)
            if first <= timing.line - 1 <= last
        ]

    @session.feature(types.SHUTDOWN)
    def shutdown(server: Session, params: None) -> None:
        runs.stop()


class Runs:
    """One run at a time for each buffer; what was typed meanwhile makes a new one."""

    def __init__(self, session: Session) -> None:
        self.session = session
        self._done: dict[str, tuple[Document, list[Timing]]] = {}
        self._going: dict[str, tuple[Document, asyncio.Task[None]]] = {}

    def timings_of(self, document: Document) -> list[Timing]:
        """Return the motions of a text, if its run is over; else begin it, and tell later."""
        known = self._done.get(document.path)
        if known is not None and known[0] is document:
            return known[1]
        going = self._going.get(document.path)
        if going is None or going[0] is not document:
            if going is not None:
                going[1].cancel()
            task = asyncio.get_running_loop().create_task(self._run(document))
            task.add_done_callback(report_fault)
            self._going[document.path] = document, task
        return []

    def stop(self) -> None:
        """End all runs."""
        for _, task in self._going.values():
            task.cancel()

    async def _run(self, document: Document) -> None:
        await asyncio.sleep(DELAY_S)
        others = [(d.path, d.source.text) for d in self.session.group(document)[1:]]
        asked = {"path": document.path, "text": document.source.text, "others": others}
        process = await asyncio.create_subprocess_exec(
            *(sys.executable, "-m", "vrts.lsp.timing"),
            stdin=asyncio.subprocess.PIPE,
            stdout=asyncio.subprocess.PIPE,
            stderr=asyncio.subprocess.DEVNULL,
        )
        try:
            answer, _ = await asyncio.wait_for(
                process.communicate(json.dumps(asked).encode()), PATIENCE_S
            )
        except TimeoutError:
            answer = b""
        finally:
            if process.returncode is None:
                process.kill()
                await process.wait()
        if self.session.documents.open.get(document.path) is not document:
            return
        found: list[Any] = json.loads(answer) if process.returncode == 0 and answer else []
        self._done[document.path] = (
            document,
            [Timing(line, tuple(ends), *more) for line, ends, *more in found],
        )
        workspace = self.session.client_capabilities.workspace
        hints = workspace.inlay_hint if workspace is not None else None
        if hints is not None and hints.refresh_support:
            self.session.workspace_inlay_hint_refresh(None)


def _line_end(document: Document, line: int) -> int:
    source = document.source
    return source.line_starts[line - 1] + len(source.line_text(line))


def _tooltip(timing: Timing) -> str:
    often = "once" if timing.times == 1 else f"{timing.times} times"
    text = f"takes {timing.takes_s:.2f} s; moves the arm {often}; seconds since the start"
    if timing.clearance_mm is None:
        return text
    return f"{text}; least clearance seen every {STEP_S} s: `vrts verify` proves more"
