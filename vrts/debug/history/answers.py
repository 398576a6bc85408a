"""Answers to `who`, `next` and `why`: rows with a number each, to jump to."""

from collections.abc import Sequence
from typing import NamedTuple

from vrts.base.pose import Pose
from vrts.base.units import deg, mm
from vrts.debug.frames import Frame
from vrts.debug.history.listed import Listed
from vrts.debug.history.subjects import tracks
from vrts.debug.history.track import Track
from vrts.debug.passages import Instant, at_time, instant_of, statements_at
from vrts.engine.memory.cells import Undefined
from vrts.engine.memory.events import Cause
from vrts.engine.run import Run
from vrts.report.plain import one_line
from vrts.why.asking import Unknown, why_at, why_of
from vrts.why.chain import Chain, Link, shortened
from vrts.why.shown import value, where_of
from vrts.why.slicing.executed import Steps
from vrts.why.stopped import of_step


class Found(NamedTuple):
    """A change of something, and where to go to see it."""

    name: str
    instant: Instant  # right after it, or where it begins
    settled_s: float
    go: Instant  # where a jump leads
    cause: Cause | None
    by: str  # what did it, where no step did, or how
    old: str
    new: str

    @property
    def text(self) -> str:
        """The change in one line."""
        where = f"at {self.instant.time_s:.3f} s"
        if self.settled_s > self.instant.time_s:
            where += f" to {self.settled_s:.3f} s"
        if self.cause is not None:
            span = self.cause.span
            where += (
                f", {self.cause.program} {self.cause.step}, line {span.line} `{span.text.strip()}`"
            )
        if self.by:
            where += f", {self.by}"
        return one_line(f"{where}: {self.old} -> {self.new}")


def who(run: Run, name: str, at: Instant, frame: Frame | None = None) -> list[Found | str]:
    """Return the last change of all that a name stands for, up to an instant; words where none.

    A jump leads before the change: its step comes next there.

    Raises:
        CannotTell: Nothing has this name.
    """
    found: list[Found | str] = []
    for track in tracks(run, name, at, frame):
        k = track.last(at)
        if k is None:
            found.append(f"{track.name} has not changed yet: {_shown(track.read(at), track)}")
        else:
            found.append(_told(track, k, track.before(k)))
    return found


def following(run: Run, name: str, at: Instant, frame: Frame | None = None) -> list[Found | str]:
    """Return the next change of all that a name stands for, after an instant; words where none.

    A jump leads behind the change.

    Raises:
        CannotTell: Nothing has this name.
    """
    found: list[Found | str] = []
    for track in tracks(run, name, at, frame):
        k = track.following(at)
        if k is None:
            found.append(f"{track.name} does not change any more: {_shown(track.read(at), track)}")
        else:
            found.append(_told(track, k, track.after(k)))
    return found


def why(run: Run, name: str | None, at: Instant, frame: Frame | None = None) -> Chain:
    """Return the chain of causes of a value, a thing, an output, or of what the arm does.

    Raises:
        CannotTell: Nothing has this name.
    """
    if name is None:
        return why_at(run, at.time_s)
    try:
        return why_of(run, name, at.time_s, at.finished)
    except Unknown:
        pass
    track = tracks(run, name, at, frame)[0]
    if track.name in ("HERE", "the arm"):
        return why_at(run, at.time_s)
    effect = f"{track.name}: {_shown(track.read(at), track)}"
    k = track.last(at)
    if k is None:
        return shortened(f"{effect}, as at the start", [])
    told = _told(track, k, track.before(k))
    steps = Steps(run)
    span = None if told.cause is None else told.cause.span
    says = f"{told.old} -> {told.new}" + (f", {told.by}" if told.by else "")
    links = [Link(told.instant.time_s, span, says)]
    step = steps.last(told.cause, told.instant.time_s)
    if step is not None:
        links += of_step(steps, step)
    return shortened(effect, links)


def place_of(run: Run, link: Link) -> Instant | None:
    """Return where to stand to see a link of a chain; None for data."""
    if link.time_s is None:
        return None
    time_s = min(max(link.time_s, 0.0), run.horizon_s)
    here = at_time(run, time_s)
    if link.span is None:
        return here
    steps = Steps(run)
    first, last = statements_at(run, time_s)
    for number in range(last, first, -1):
        step = steps.step(number)
        if step is not None and step.cause.span == link.span:
            return instant_of(run, number - 1)
    return here


def _told(track: Track, k: int, go: Instant) -> Found:
    moment, run = track.moments[k], track.run
    cause, by = moment.cause, moment.by
    if moment.number is not None and cause is None:
        step = Steps(run).step(moment.number) if moment.number else None
        cause = None if step is None else step.cause
        if cause is None and not by:
            by = "a command" if moment.number else "given as data"
    data = moment.number == 0
    old = "undefined" if data else _shown(track.read(track.before(k)), track)
    new = _shown(track.read(track.after(k)), track)
    return Found(track.name, moment.instant, moment.settled_s, go, cause, by, old, new)


def _shown(content: object, track: Track) -> str:
    """Return a value in words: lengths in mm, angles in degrees."""
    if track.name == "the opening" and isinstance(content, float):
        return f"{mm(content):.2f} mm"
    if track.name.startswith("joint ") and isinstance(content, float):
        return f"{deg(content):.2f} degrees"
    match content:
        case bool():
            return "on" if content else "off"
        case None:
            return "nothing"
        case (Pose() as pose, str() as lie, str() | None as support):
            return f"{where_of(pose)}, {lie}" + (f" on {support}" if support else "")
        case str() if not track.name.startswith("`") or track.name.endswith("[]`"):
            return content
        case Undefined() | Pose() | str() | float() | int() | tuple():
            return "undefined" if isinstance(content, Undefined) else value(content)  # type: ignore[arg-type]
        case _:
            return str(content)


def rows(found: Sequence[Found | str]) -> tuple[list[Listed], list[Instant]]:
    """Return answers as numbered lines, and where each number leads."""
    lines: list[Listed] = []
    goes: list[Instant] = []
    for each in found:
        if isinstance(each, str):
            lines.append(Listed(each))
            continue
        goes.append(each.go)
        lines.append(Listed(f"{len(goes)}  {each.name} {each.text}", len(goes)))
    return lines, goes
