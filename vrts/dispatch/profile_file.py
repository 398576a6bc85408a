"""Reads a profile from TOML; what is wrong is told with its place."""

import hashlib
import re
from collections.abc import Callable

from vrts.base.diagnostic import Rule
from vrts.base.source import SourceFile
from vrts.base.toml.reading import Problems, Table, read_toml
from vrts.dispatch import allowed
from vrts.dispatch.profile_parts import (
    Commands,
    Patience,
    Profile,
    Prompts,
    Replies,
    Serial,
    Typing,
)
from vrts.lang.dialect import DIALECTS
from vrts.pipeline.refused import Refused

BAD_PATTERN = Rule("V830", "bad-pattern")
COMMAND_NOT_SENT = Rule("V831", "command-not-sent")

_BAUDS = (50, 4_000_000)
_LONGEST_WAIT_S = 600.0
_NEVER = re.compile(r"(?!)")  # matches nothing


def read_profile(source: SourceFile) -> Profile:
    """Return the profile that a file holds.

    Raises:
        Refused: The file has errors.
    """
    top, problems = read_toml(source)
    if top is None:
        raise Refused(problems.in_order())
    read = _Reader(problems)
    profile = read.profile(top, source.text)
    if profile is None or problems.any_error:
        raise Refused(problems.in_order())
    return profile


class _Reader:
    def __init__(self, problems: Problems) -> None:
        self.problems = problems

    def profile(self, top: Table, text: str) -> Profile | None:
        """Return a profile; meaningless where problems were found, None where a part is missing."""
        names = ("profile", "limits", "printed", "serial", "typing", "patience")
        parts = {name: top.table(name, required=True) for name in (*names, *_DIALOGUE)}
        top.finish()
        tables = [table for table in parts.values() if table is not None]
        if len(tables) < len(parts):
            return None
        head, limits, printed, serial, typing, patience, prompts, commands, replies = tables
        found = Profile(
            name=_text(head, "name"),
            title=_text(head, "title"),
            tried=bool(head.boolean("tried", required=True)),
            dialect=head.string("dialect", choices=DIALECTS, required=True) or "val2",
            lacks=tuple(word.upper() for word in head.strings("lacks", ()) or ()),
            line_length=_whole(limits, "line_length", 20, 4096),
            name_length=_whole(limits, "name_length", 1, 31),
            memory_bytes=limits.integer("memory_bytes", minimum=1),
            length_decimals=_whole(printed, "length_decimals", 0, 6),
            angle_decimals=_whole(printed, "angle_decimals", 0, 6),
            serial=_serial(serial),
            typing=self._typing(typing),
            patience=Patience(*(_seconds(patience, key) for key in Patience._fields)),
            prompts=self._prompts(prompts),
            commands=self._commands(commands),
            replies=self._replies(replies),
            digest=hashlib.sha256(text.encode()).hexdigest(),
            text=text,
        )
        for table in tables:
            table.finish()
        return found

    def _typing(self, table: Table) -> Typing:
        cancel = _text(table, "cancel")
        if cancel and cancel not in allowed.CANCELS:
            self._not_sent(table, "cancel", "one of " + ", ".join(map(repr, allowed.CANCELS)))
        return Typing(
            end_of_line=table.string("end_of_line", "\r", choices=("\r", "\r\n", "\n")),
            cancel=cancel,
            echo=table.string("echo", "same", choices=("same", "upper")),
            character_delay_s=_seconds(table, "character_delay_s"),
            line_delay_s=_seconds(table, "line_delay_s"),
        )

    def _prompts(self, table: Table) -> Prompts:
        running = self._pattern(table, "running") if "running" in table else None
        return Prompts(
            ready=self._pattern(table, "ready"),
            running=running,
            step=self._pattern(table, "step", group="step"),
            insert=self._pattern(table, "insert", group="step"),
            change=self._pattern(table, "change"),
            confirm=self._pattern(table, "confirm"),
        )

    def _commands(self, table: Table) -> Commands:
        read = {key: _text(table, key) for key in Commands._fields}
        for key, text in read.items():
            fits: Callable[[str], bool] = {
                "leave": allowed.is_letter,
                "insert": allowed.is_letter,
                "letters": str.isalpha,
            }.get(key, allowed.is_command_form)
            if text and not fits(text):
                self._not_sent(table, key, allowed.FORMS)
        return Commands(**read)

    def _replies(self, table: Table) -> Replies:
        texts = table.strings("errors", required=True) or ()
        errors = tuple(self._compiled(table, "errors", text) for text in texts)
        return Replies(errors, self._pattern(table, "absent"), self._pattern(table, "executing"))

    def _pattern(self, table: Table, key: str, *, group: str = "") -> re.Pattern[str]:
        text = table.string(key, required=True)
        if text is None:
            return _NEVER
        found = self._compiled(table, key, text)
        if group and found is not _NEVER and group not in found.groupindex:
            headline = f"`{key}` must say where the number of the step stands"
            help_ = (f"write it as `(?P<{group}>[0-9]+)`",)
            self.problems.error(BAD_PATTERN, headline, table.value_span(key), help=help_)
        return found

    def _compiled(self, table: Table, key: str, text: str) -> re.Pattern[str]:
        try:
            found = re.compile(text, re.MULTILINE)
        except (re.error, OverflowError, RecursionError) as problem:
            headline = f"`{key}` is no regular expression: {problem}"
            self.problems.error(BAD_PATTERN, headline, table.value_span(key))
            return _NEVER
        if found.match(""):
            headline = f"`{key}` matches where nothing stands"
            self.problems.error(BAD_PATTERN, headline, table.value_span(key))
        return found

    def _not_sent(self, table: Table, key: str, known: str) -> None:
        headline = f"`{key}` is not what vrts ever sends to a controller"
        span = table.value_span(key)
        self.problems.error(COMMAND_NOT_SENT, headline, span, notes=(f"it sends {known}",))


_DIALOGUE = ("prompts", "commands", "replies")


def _serial(table: Table) -> Serial:
    return Serial(
        baud=_whole(table, "baud", *_BAUDS),
        data_bits=_whole(table, "data_bits", 7, 8),
        parity=table.string("parity", "none", choices=("none", "even", "odd")),
        stop_bits=_whole(table, "stop_bits", 1, 2),
        flow=table.string("flow", "none", choices=("none", "xonxoff", "rtscts")),
    )


def _text(table: Table, key: str) -> str:
    return table.string(key, required=True) or ""


def _whole(table: Table, key: str, least: int, most: int) -> int:
    return table.integer(key, minimum=least, maximum=most, required=True) or least


def _seconds(table: Table, key: str) -> float:
    return table.number(key, minimum=0.0, maximum=_LONGEST_WAIT_S, required=True) or 0.0
