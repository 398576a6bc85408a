"""A conversation with a controller: a line is typed, its echo is compared, the answer is awaited.

RETURN is sent only when all that was typed has come back as it was typed. So a character that was
lost, doubled or changed on the line is noticed before the controller acts on it.
"""

import re
import time
from collections.abc import Callable
from typing import NamedTuple, Protocol

from vrts.dispatch.allowed import Prompt, permits
from vrts.dispatch.profile_parts import Profile
from vrts.dispatch.transfer.port import Wire
from vrts.dispatch.transfer.problems import NOT_SENT, WRONG_ECHO, stop, unlike, visible
from vrts.dispatch.transfer.transcript import Transcript
from vrts.pipeline.refused import Refused

_MOST = 4_000_000  # characters of an answer
_LONGEST_ANSWER_S = 900.0  # a large memory, listed at 1200 baud
_TAIL = 300  # characters at the end of an answer in which a prompt may stand
_TRIES = 3  # at a prompt to begin with
_RUBBED = re.compile(r"[\b \n]|\^[UX]")  # what may be shown when a line is taken back


class At(NamedTuple):
    """What the controller waits for."""

    prompt: Prompt
    step: int = 0  # that the editor asks for


class Answer(NamedTuple):
    """What came after RETURN, without the prompt."""

    text: str
    at: At


class Says(Protocol):
    """Somebody to whom a line can be typed."""

    @property
    def at(self) -> At:
        """What is waited for now."""
        ...

    def say(self, text: str, complete: Callable[[str], bool] | None = None) -> Answer:
        """Type a line and return the answer."""
        ...


class Talk:
    """The conversation over one line; everything that is sent is sent here."""

    def __init__(
        self, wire: Wire, profile: Profile, transcript: Transcript, sleep: Callable[[float], None]
    ) -> None:
        """Begin; nothing is sent yet."""
        self._wire = wire
        self._profile = profile
        self._transcript = transcript
        self._sleep = sleep
        self._at: At | None = None
        self.prompt_missed = False  # after a line: where the controller stands is not known
        self.line_in_doubt = False  # something may stand in it that was not meant
        self._patterns = _patterns(profile)

    @property
    def at(self) -> At:
        """What the controller waits for."""
        assert self._at is not None, "`begin` comes first"
        return self._at

    def begin(self) -> At:
        """Find out what the controller waits for: take back what stands in its line, press RETURN.

        Raises:
            Refused: No prompt of the profile comes.
        """
        patience = self._profile.patience
        heard = ""
        for _ in range(_TRIES):
            heard = (heard + self._drained())[-_TAIL:]
            self._write(self._profile.typing.cancel)
            shown = self._drained()
            heard = (heard + shown)[-_TAIL:]
            if not self._shows_an_empty_line(shown):
                continue  # it has come as something else, which RETURN would carry out
            self._write(self._profile.typing.end_of_line)
            answer, at = self._until_prompt(patience.echo_s, None)
            heard = (heard + answer)[-_TAIL:]
            if at is not None:
                self._at = at
                self.prompt_missed = False
                return at
        raise unlike("one of its prompts", heard, "it shows no prompt after RETURN")

    def say(self, text: str, complete: Callable[[str], bool] | None = None) -> Answer:
        """Type a line and return the answer.

        Args:
            text: The line, without its end.
            complete: Whether an answer is whole; otherwise a prompt in it is not believed.

        Raises:
            Refused: It may not be sent, comes back changed, or no prompt follows.
        """
        if not permits(text, self.at.prompt):
            raise stop(NOT_SENT, f"{visible(text)} is not sent at {self.at.prompt.value}")
        self._sleep(self._profile.typing.line_delay_s)
        self._type(text)
        self._write(self._profile.typing.end_of_line)
        answer, at = self._until_prompt(self._profile.patience.reply_s, complete)
        if at is None:
            self.prompt_missed = True
            raise unlike("one of its prompts", answer, f"no prompt follows {visible(text)}")
        self._at = at
        begins = answer.lstrip(" ")
        if not begins.startswith("\n"):
            raise unlike("the end of the line", answer, f"RETURN after {visible(text)}")
        return Answer(begins[1:], at)

    def take_back(self) -> None:
        """Take back what is typed of a line, and wait until nothing more comes."""
        self._write(self._profile.typing.cancel)
        self._drained()

    def _drained(self) -> str:
        """Return what comes until nothing more does."""
        text = ""
        until = time.monotonic() + self._profile.patience.reply_s
        while came := self._read(self._profile.patience.quiet_s):
            text += came
            if time.monotonic() > until:
                raise unlike("silence", text, "it does not cease to write")
        return text[-_TAIL:]

    def _shows_an_empty_line(self, shown: str) -> bool:
        """Return whether what comes after a line was taken back is nothing typed."""
        rest = _RUBBED.sub("", shown)
        return not rest or self._prompt_at_end(rest) is not None

    # --- typing ---------------------------------------------------------------------------------

    def _type(self, text: str) -> None:
        left_over = self._read(0.0)
        if left_over.strip():
            raise self._changed(text, left_over)
        delay = self._profile.typing.character_delay_s
        for piece in text if delay else (text,):
            self._write(piece)
            self._sleep(delay)
        wanted = text.upper() if self._profile.typing.echo == "upper" else text
        echo = ""
        while len(echo) < len(wanted):
            came = self._read(self._profile.patience.echo_s)
            echo += came
            if not text.startswith(" "):
                echo = echo.lstrip(" ")  # the prompt may end in a blank
            if not came or not wanted.startswith(echo):
                raise self._changed(text, echo)

    def _changed(self, text: str, echo: str) -> Refused:
        self.line_in_doubt = True
        self.take_back()
        ended = "a character has become the end of a line: a part of it may have been taken"
        return stop(
            WRONG_ECHO,
            "what was typed has not come back as it was typed",
            f"typed: {visible(text)}",
            f"came: {visible(echo)}",
            ended if "\n" in echo else "it was taken back before RETURN",
            remedy="check cable, speed and flow control; then go on with `--resume`",
        )

    # --- bytes ----------------------------------------------------------------------------------

    def _until_prompt(
        self, patience_s: float, complete: Callable[[str], bool] | None
    ) -> tuple[str, At | None]:
        """Return what comes before a prompt, and the prompt; None: silence without one."""
        text = ""
        until = time.monotonic() + _LONGEST_ANSWER_S
        while len(text) < _MOST and time.monotonic() < until:
            found = self._prompt_at_end(text)
            whole = found is not None and (complete is None or complete(text[: found[0]]))
            sure = whole and found is not None and found[1].prompt not in _ALSO_BEGINNINGS
            came = (
                "" if sure else self._read(self._profile.patience.quiet_s if whole else patience_s)
            )
            if came:
                text += came
            elif found is None:
                return text, None
            else:
                return text[: found[0]], found[1]
        raise unlike("a prompt", text, "it does not cease to write")

    def _prompt_at_end(self, text: str) -> tuple[int, At] | None:
        first = max(len(text) - _TAIL, 0)
        tail = text[first:]
        for prompt, pattern in self._patterns.items():
            match = pattern.search(tail)
            if match is not None and (first == 0 or match.start() > 0):
                return first + match.start(), At(prompt, _step(match))
        return None

    def _write(self, text: str) -> None:
        data = text.encode("ascii")
        self._transcript.sent(data)
        self._wire.write(data)

    def _read(self, wait_s: float) -> str:
        """Return what has come; empty after silence. LF alone ends lines, NUL fills them."""
        while data := self._wire.read(wait_s):
            self._transcript.received(data)
            text = data.replace(b"\0", b"").replace(b"\r", b"").decode("latin-1")
            if text:
                return text
        return ""


_ALSO_BEGINNINGS = frozenset({Prompt.READY, Prompt.RUNNING})  # `.` begins `.PROGRAM`, too


def _patterns(profile: Profile) -> dict[Prompt, re.Pattern[str]]:
    prompts = profile.prompts
    given = {
        Prompt.CHANGE: prompts.change,
        Prompt.CONFIRM: prompts.confirm,
        Prompt.STEP: prompts.step,
        Prompt.INSERT: prompts.insert,
        Prompt.RUNNING: prompts.running,
        Prompt.READY: prompts.ready,
    }
    return {
        prompt: re.compile(rf"(?:\A|(?<=\n))(?:{pattern.pattern})\Z")
        for prompt, pattern in given.items()
        if pattern is not None
    }


def _step(match: re.Match[str]) -> int:
    found = match.groupdict().get("step")
    return int(found) if found is not None and found.isdigit() and len(found) < 8 else 0
