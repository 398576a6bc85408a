"""What is done with marks, and links to where somebody stands: lines to show for each word."""

from vrts.debug.debugger import Debugger
from vrts.debug.evaluating import CannotTell
from vrts.debug.history.listed import Listed
from vrts.debug.marks.goals import Goals
from vrts.debug.marks.links import Opener, links
from vrts.debug.marks.marks import Mark, is_there
from vrts.debug.stops.stop import Stop, Why
from vrts.report.plain import one_line

WORDS = ("mark", "marks", "unmark", "link")
KEEP = "keep"


class Marking:
    """Marks and links of one session."""

    def __init__(self, debugger: Debugger, goals: Goals) -> None:
        """Take where it stands, and what keeps the marks."""
        self._debugger, self._goals = debugger, goals
        self.opener: Opener | None = None  # how the run was opened; None: nobody knows

    def told(self, word: str, rest: str, *, process: bool = False) -> list[Listed]:
        """Carry out one of `WORDS`; return what to say.

        Args:
            word: Which.
            rest: What stands behind it.
            process: Whether the step of the process control program is meant.

        Raises:
            CannotTell: It cannot be; the text says why.
        """
        try:
            match word:
                case "mark":
                    return [Listed(self._mark(rest, process=process))]
                case "unmark":
                    return self._unmark(rest)
                case "link":
                    _nothing(rest, word)
                    return [Listed(line) for line in self.links(process=process)]
                case _:
                    return self._marks(rest)
        except OSError as problem:
            reason = (problem.strerror or "it failed").lower()
            raise CannotTell(f"the file of marks cannot be written: {reason}") from problem

    def links(self, *, process: bool) -> list[str]:
        """Return what opens this place."""
        debugger = self._debugger
        cause = debugger.current(process=process)
        return links(self.opener, debugger.first, debugger.run, debugger.at, cause)

    def _mark(self, name: str, *, process: bool) -> str:
        debugger = self._debugger
        if not name:
            raise CannotTell("`mark` takes a name: `mark pick`")
        cause = debugger.current(process=process)
        words = (
            f"{one_line(cause.program)} {cause.step}, line {cause.span.line}"
            if cause
            else "no step"
        )
        known = {mark.name.lower(): mark for mark in self._goals.marks.all()}
        before = known.get(name.lower())
        mark = self._goals.marks.add(debugger.run, name, debugger.at, words, process=process)
        moved = "" if before is None else f"; it was at {before.instant.time_s:.3f} s"
        return f"{_line(mark)}{moved}"

    def _unmark(self, name: str) -> list[Listed]:
        if not name:
            raise CannotTell("`unmark` takes the name of a mark, or `all`")
        self._goals.marks.remove(name)
        return self._marks("")

    def _marks(self, rest: str) -> list[Listed]:
        marks, run = self._goals.marks, self._debugger.run
        if rest.lower() == KEEP:
            kept = f"kept in {marks.keep()}, which is read when this is debugged again"
            return [Listed(kept)]
        _nothing(rest, "marks")
        lines: list[Listed] = []
        goes: list[Stop] = []
        for mark in marks.all():
            if is_there(run, mark):
                goes.append(Stop(mark.instant, Why.GO, f"mark {mark.name}", process=mark.process))
                lines.append(Listed(f"{len(goes):>4} {_line(mark)}", len(goes)))
            else:
                lines.append(Listed(f"   - {_line(mark)}, of another future"))
        self._goals.show(run, goes)
        if marks.problem:
            lines.append(Listed(f"the file of marks is not read: {marks.problem}"))
        return lines or [Listed("no marks")]


def _line(mark: Mark) -> str:
    return f"{mark.name}  {mark.instant.time_s:.3f} s  {mark.words}"


def _nothing(rest: str, word: str) -> None:
    if rest:
        also = ", or `keep`" if word == "marks" else ""
        raise CannotTell(f"`{word}` takes nothing behind it{also}")
