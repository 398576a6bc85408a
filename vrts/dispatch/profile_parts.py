"""A profile, part by part: what is particular to one kind of controller."""

import re
from typing import NamedTuple

from vrts.lang.dialect import DIALECTS, Dialect

NOT_TRIED = "not tried on hardware"


class Serial(NamedTuple):
    """The line."""

    baud: int
    data_bits: int
    parity: str  # "none", "even" or "odd"
    stop_bits: int
    flow: str  # "none", "xonxoff" or "rtscts"


class Typing(NamedTuple):
    """How lines are typed, and how they come back."""

    end_of_line: str
    cancel: str  # the control character that takes back what is typed of a line
    echo: str  # "same", or "upper": in upper case
    character_delay_s: float  # after each character
    line_delay_s: float  # before each line


class Patience(NamedTuple):
    """How long silence is borne."""

    echo_s: float  # while what was typed comes back
    reply_s: float  # while the controller answers
    hold_s: float  # while the controller holds the line (Ctrl-S)
    quiet_s: float  # of silence that show that a prompt is not the beginning of something


class Prompts(NamedTuple):
    """The last characters before the controller waits; any end of a line counts as LF."""

    ready: re.Pattern[str]  # no program executes
    running: re.Pattern[str] | None  # one does; None: this controller does not tell
    step: re.Pattern[str]  # the editor asks for step (?P<step>)
    insert: re.Pattern[str]  # for a step before it
    change: re.Pattern[str]  # for new components of a location
    confirm: re.Pattern[str]  # whether it is to go on


class Commands(NamedTuple):
    """What is typed; `{name}`, `{step}` and `{formals}`, such as `(a, $b)`, are filled in."""

    status: str
    list_program: str
    list_programs: str
    list_locations: str
    list_reals: str
    list_strings: str
    new: str  # begin to edit a program that is not there
    edit: str  # a program at a step
    point: str
    delete: str  # one program
    leave: str  # the editor
    insert: str  # in the editor
    letters: str  # single letters that the editor takes for commands


class Replies(NamedTuple):
    """What answers mean."""

    errors: tuple[re.Pattern[str], ...]  # one of them at the start of a line: it was refused
    absent: re.Pattern[str]  # an error that says that there is none of this name
    executing: re.Pattern[str]  # in what STATUS says: a program executes


class Profile(NamedTuple):
    """One kind of controller."""

    name: str
    title: str
    tried: bool  # on hardware, by somebody
    dialect: str  # a key of DIALECTS
    lacks: tuple[str, ...]  # words of the dialect that this controller has not
    line_length: int  # characters of a line as typed, at most
    name_length: int  # characters of a name, at most
    memory_bytes: int | None  # for programs and data; None: not known
    length_decimals: int  # with which LISTL prints mm
    angle_decimals: int  # with which LISTL prints degrees
    serial: Serial
    typing: Typing
    patience: Patience
    prompts: Prompts
    commands: Commands
    replies: Replies
    digest: str  # sha256 of the file's text
    text: str = ""  # of the file

    @property
    def language(self) -> Dialect:
        """The dialect itself."""
        return DIALECTS[self.dialect]

    @property
    def warning(self) -> str:
        """What is to be said before it is used; empty when it has been tried."""
        return "" if self.tried else f"the profile `{self.name}` was {NOT_TRIED}"
