"""Verifications in processes of their own: what is shown of them while buffers change."""

import asyncio
import signal
from collections.abc import Callable, Coroutine
from contextlib import suppress
from typing import Any, NamedTuple

from vrts.lsp.channel.findings import Finding, carried
from vrts.lsp.channel.verification import (
    CPU_S,
    Answer,
    Asked,
    answer_of,
    line_of,
    stopped,
)
from vrts.lsp.documents.documents import Document
from vrts.lsp.documents.setting_files import Stamp
from vrts.lsp.server.background.own_process import OwnProcess

DELAY_S = 0.5  # after a check has found no error, before the program is run
PATIENCE_S = 60.0  # for a verification, whatever it does
AT_ONCE = 2  # verifications


class Subject(NamedTuple):
    """What a verification depends on; documents are compared by identity."""

    document: Document
    others: tuple[Document, ...]  # that belong together with it
    stamp: Stamp  # of the files of its setting


class _Known(NamedTuple):
    subject: Subject
    answer: Answer


class Verifications:
    """One verification at a time for each buffer; what was typed meanwhile makes a new one."""

    def __init__(
        self,
        begin: Callable[[Coroutine[Any, Any, None]], asyncio.Task[None]],
        tell: Callable[[Document], None],
    ) -> None:
        """Take how to begin work in the background, and whom to tell what is new.

        Args:
            begin: Starts a coroutine.
            tell: Called when more is known about a buffer.
        """
        self._begin = begin
        self._tell = tell
        self._known: dict[str, _Known] = {}
        self._going: dict[str, tuple[Subject, asyncio.Task[None]]] = {}
        self._slots = asyncio.Semaphore(AT_ONCE)
        self.are_shown = False  # beside the text, too

    def want(self, subject: Subject) -> None:
        """Verify something soon, unless that is known or under way."""
        path = subject.document.path
        known, going = self._known.get(path), self._going.get(path)
        if going is not None and going[0] == subject:
            return
        self.cancel(path)
        if known is None or known.subject != subject or not known.answer.is_whole:
            self._going[path] = subject, self._begin(self._run(subject))

    def answer(self, document: Document) -> Answer:
        """Return what is known of a text itself; nothing while another one is verified."""
        known = self._known.get(document.path)
        going = self._going.get(document.path)
        if known is None or known.subject.document is not document:
            return Answer()
        return known.answer if going is None or going[0] == known.subject else Answer()

    def is_whole(self, document: Document) -> bool:
        """Return whether all is known of a text."""
        return self.answer(document).is_whole

    def findings(self, document: Document) -> tuple[Finding, ...]:
        """Return what to show in a text: what was found in it, or in the one before."""
        found = self.answer(document).findings
        known = self._known.get(document.path)
        if found or known is None or self.answer(document).is_whole:
            return found
        return carried(known.answer.findings, known.subject.document.source, document.source)

    def cancel(self, path: str) -> None:
        """End the verification of a buffer."""
        going = self._going.pop(path, None)
        if going is not None:
            going[1].cancel()

    def forget(self, path: str) -> None:
        """Forget a buffer."""
        self.cancel(path)
        self._known.pop(path, None)

    def stop(self) -> None:
        """End all verifications."""
        for path in list(self._going):
            self.cancel(path)

    async def _run(self, subject: Subject) -> None:
        await asyncio.sleep(DELAY_S)
        document, others, _ = subject
        called = any(document.names.defined_programs & o.names.missing_programs for o in others)
        texts = tuple((other.path, other.source.text) for other in others)
        asked = Asked(document.path, document.source.text, texts, called, self.are_shown)
        async with self._slots:
            await self._verify(subject, asked)
        if self._going.get(document.path, (None,))[0] is subject:
            del self._going[document.path]

    async def _verify(self, subject: Subject, asked: Asked) -> None:
        answer = Answer()
        with OwnProcess("vrts.lsp.runs.verifying") as process, suppress(TimeoutError):
            async with asyncio.timeout(PATIENCE_S):  # what it has said by then counts
                async for line in process.answers(line_of(asked)):
                    answer = answer_of(line)
                    if not answer.is_whole:
                        self._learn(subject, answer)
        if not answer.is_whole:
            answer = stopped(asked, answer, _why(process.status))
        self._learn(subject, answer)

    def _learn(self, subject: Subject, answer: Answer) -> None:
        known = self._known.get(subject.document.path)
        if answer.shown is None and known is not None and known.subject == subject:
            answer = answer._replace(shown=known.answer.shown)  # it is told once
        self._known[subject.document.path] = _Known(subject, answer)
        self._tell(subject.document)


def _why(status: int | None) -> str:
    if status is not None and status < 0:
        bounds = (getattr(signal, "SIGXCPU", None), signal.SIGTERM)
        if -status in (*bounds, getattr(signal, "SIGKILL", None)):
            return f"after {CPU_S} s of processor time, or {PATIENCE_S:.0f} s in all"
    return "by a fault in vrts: the log of the editor shows it"
