"""A session driven by hand, with a clock that goes on only when it is told to."""

from collections.abc import Iterable
from pathlib import Path
from typing import TypeVar

from vrts.live.actions import Action, Typed
from vrts.live.session.channel.entries import Entry
from vrts.live.session.channel.messages import BEAT, Act, Done, FromSession, Halt, News, Start
from vrts.live.session.live_session import Session
from vrts.live.session.setting import setting_of
from vrts.live.session.views.frame import PoseFrame, unpacked

N = TypeVar("N", bound=News)


class Driven:
    """A session, its clock, and everything it has said."""

    def __init__(
        self,
        folder: Path,
        scene: str = "cans-on-bases",
        quota: int = 1_000_000,
        task: str = "",
        history: int = 64_000_000,
    ) -> None:
        self.clock_s = 1000.0
        self.news: list[FromSession] = []
        self.frames: list[PoseFrame] = []
        self.start = Start(7, str(folder), scene, task, quota=quota, history=history)
        self.log: list[Entry] = []
        self.session = Session(self.start, setting_of(self.start), self._hear, self._clock)
        self._given: dict[int, Act | Halt] = {}
        self._count = 0

    def act(self, action: Action, owner: str = "ada") -> int:
        """Give an action now; return its reference."""
        ref = self._next()
        order = Act(ref, self.session.now_s, owner, action)
        self._given[ref] = order
        self.session.take(order)
        return ref

    def halt(self) -> int:
        """Press the panic button."""
        ref = self._next()
        order = Halt(ref, self.session.now_s)
        self._given[ref] = order
        self.session.take(order)
        return ref

    def forget(self) -> None:
        """Keep nothing of what was heard and given."""
        for heard in (self.news, self.frames, self.log, self._given):
            heard.clear()

    def run(self, seconds: float, beat_s: float = BEAT) -> None:
        """Let time pass, beat by beat."""
        end_s = self.clock_s + seconds
        while self.clock_s < end_s - 1e-9:
            self.clock_s = min(self.clock_s + beat_s, end_s)
            self.session.beat()

    def typed(self, *lines: str, seconds: float = 0.1) -> str:
        """Type lines, with some time after each; return what the terminal shows."""
        before = len(self.news)
        for line in lines:
            self.act(Typed(line))
            self.run(seconds)
        return "".join(n.text for n in self.news[before:] if type(n).__name__ == "Output")  # type: ignore[union-attr]

    def done(self, ref: int) -> Done:
        """Return what became of an order."""
        return next(n for n in self.said(Done) if n.ref == ref)

    def said(self, kind: type[N]) -> list[N]:
        """Return the news of a kind."""
        return [n for n in self.news if isinstance(n, kind)]

    def texts(self, kind: type[N]) -> Iterable[str]:
        """Return the texts of the news of a kind."""
        return [n.text for n in self.said(kind)]  # type: ignore[attr-defined]

    def _next(self) -> int:
        self._count += 1
        return self._count

    def _hear(self, message: News | bytes) -> None:
        if isinstance(message, bytes):
            self.frames.append(unpacked(message))
            return
        self.news.append(message)  # type: ignore[arg-type]
        if isinstance(message, Done) and message.counts:
            self.log.append(Entry(message.at_s, self._given[message.ref]))

    def _clock(self) -> float:
        return self.clock_s
