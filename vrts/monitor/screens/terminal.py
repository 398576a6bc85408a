"""The monitor at a terminal: real time, history, completion.

The clock is given from outside; simulated time follows it, and what programs write appears above
the line that is being typed.
"""

import asyncio
import sys
from collections.abc import Iterable
from pathlib import Path

from prompt_toolkit import PromptSession
from prompt_toolkit.completion import CompleteEvent, Completer, Completion
from prompt_toolkit.document import Document
from prompt_toolkit.history import FileHistory, History, InMemoryHistory
from prompt_toolkit.patch_stdout import patch_stdout

from vrts.monitor.completion import completions
from vrts.monitor.dialogue import Dialogue
from vrts.monitor.pace import BEAT, Clock, Pace
from vrts.report.plain import plain_text


class _Names(Completer):
    def __init__(self, dialogue: Dialogue) -> None:
        self._dialogue = dialogue

    def get_completions(
        self, document: Document, complete_event: CompleteEvent
    ) -> Iterable[Completion]:
        monitor = self._dialogue.monitor
        if not monitor.at_commands:
            return
        line = document.text_before_cursor
        for word in completions(line, monitor.desk, self._dialogue.state):
            yield Completion(word, start_position=-_common(line, word))


def _common(line: str, word: str) -> int:
    """Return how much of a word has been typed."""
    for length in range(min(len(word), len(line)), 0, -1):
        if line.lower().endswith(word[:length].lower()):
            return length
    return 0


def converse(dialogue: Dialogue, clock: Clock, history: Path | None) -> None:
    """Read lines until the end of input (Ctrl-D).

    Args:
        dialogue: What is driven.
        clock: Returns real time [s].
        history: A file for the lines typed; None keeps them for this time only.
    """
    kept: History = InMemoryHistory() if history is None else FileHistory(str(history))
    asyncio.run(_Conversation(dialogue, clock, kept).run())


class _Conversation:
    def __init__(self, dialogue: Dialogue, clock: Clock, history: History) -> None:
        self._dialogue = dialogue
        self._pace = Pace(dialogue, clock)
        self._begun = ""  # a line that a program has begun to write
        self._session: PromptSession[str] = PromptSession(
            self._message,
            history=history,
            completer=_Names(dialogue),
            complete_while_typing=False,
        )

    def _message(self) -> str:
        return self._begun + self._dialogue.prompt

    async def run(self) -> None:
        with patch_stdout(raw=True):
            beat = asyncio.create_task(self._beat())
            try:
                while await self._line():
                    pass
            finally:
                beat.cancel()

    async def _line(self) -> bool:
        try:
            line = await self._session.prompt_async()
        except KeyboardInterrupt:
            self._begun = ""
            self._show(self._dialogue.interrupt())
            return True
        except EOFError:
            return False
        self._begun = ""
        self._show(self._pace.catch_up())
        self._show(self._dialogue.enter(line))
        return True

    async def _beat(self) -> None:
        shown = ""
        while True:
            await asyncio.sleep(BEAT)
            self._show(self._pace.catch_up())
            if self._message() != shown:
                shown = self._message()
                self._session.app.invalidate()

    def _show(self, text: str) -> None:
        """Write whole lines above the prompt; the rest stands before what is typed."""
        lines, _, self._begun = (self._begun + plain_text(text)).rpartition("\n")
        if lines or text.endswith("\n"):
            sys.stdout.write(f"{lines}\n")
            sys.stdout.flush()
