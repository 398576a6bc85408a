"""The manual's table of what a live server limits, from the code."""

from collections.abc import Iterator
from pathlib import Path

from vrts.live import actions, limits, settings
from vrts.live.callers import frames, patient
from vrts.live.editing import asked, seats
from vrts.live.entrance import entries
from vrts.live.front import browsers, program_pages
from vrts.live.front.sockets import help_socket, socket
from vrts.live.people import naming
from vrts.live.protocol import fields
from vrts.live.rehearsing import begun, offering, talk
from vrts.live.rooms import control, opening, pulse, sessions
from vrts.live.rooms.again import deaths
from vrts.live.rooms.private import branching
from vrts.live.session.channel import messages
from vrts.live.store import accounts, programs, rooms
from vrts.live.store.waiting import journal
from vrts.live.watching import log_tail

HEAD = "| what | how much | what happens then |\n|---|---|---|\n"


def limit_table() -> str:
    """Return the table of limits, from the code."""
    return HEAD + "".join(f"| {what} | {much} | {then} |\n" for what, much, then in _limits())


def _limits() -> Iterator[tuple[str, str, str]]:
    """Yield what is limited, how much of it there may be, and what happens then."""
    defaults = settings.Settings(Path(), ())
    characters = f"{programs.MOST_CHARACTERS:,} characters"
    yield "rooms that a supervisor makes", f"{opening.MOST_ROOMS}", "no more are made"
    yield "private rooms at once", f"{defaults.private_rooms}, one a person", "try again later"
    yield (
        "private rooms that a person begins",
        _rate(limits.BRANCHES),
        f"wait; an empty one ends after {branching.EMPTY_S / 60:.0f} minutes",
    )
    yield (
        "connections",
        f"{limits.ALL_CONNECTIONS}",
        "one of who takes most ends, or one more is refused",
    )
    yield (
        "connections of a person",
        f"{limits.CONNECTIONS}",
        "one that dropped gives way, or one more is refused",
    )
    yield (
        "places in a room",
        f"{limits.PLACES}",
        "who is away for longest gives way, then one of who takes most",
    )
    yield "guests", f"{accounts.GUESTS}", "who needs the place least loses it"
    yield "guests who never joined a room", f"{entries.UNUSED}", "the oldest go"
    yield "letters of a name", f"{naming.LONGEST}", "the rest is cut off"
    yield (
        "help in the editor at once",
        f"{seats.MOST} persons",
        f"who was quiet for {seats.QUIET_S:.0f} s gives way; the editor works without",
    )
    yield (
        "help in the editor without a key",
        f"{help_socket.IDLE_S / 60:.0f} minutes",
        "it ends, and comes back with the next key",
    )
    yield "help that a person begins", _rate(seats.BEGUN), "the editor works without"
    yield (
        "rehearsals at once",
        f"{offering.MOST}, one a person and room",
        f"who was quiet for {offering.QUIET_S:.0f} s gives way; others wait a minute",
    )
    yield "rehearsals that a person begins", _rate(offering.BEGUN), "wait a minute"
    yield "a rehearsal without a question", f"{talk.IDLE_S / 60:.0f} minutes", "it ends"
    yield (
        "computing of a rehearsal",
        f"{begun.RUN_S:.0f} s to run, {begun.CHECK_S:.0f} s for contacts and mark",
        "the page says so",
    )
    yield "a program", f"{actions.LONGEST_PROGRAM:,} characters", "it is refused"
    yield "a text that the editor helps with", f"{asked.LONGEST:,} characters", "no help"
    yield (
        "versions of a person",
        f"{programs.MOST_VERSIONS}, {programs.MOST_OF_A_PROGRAM} of a program, {characters}",
        "the oldest go, never the newest of a program",
    )
    yield (
        "programs that a room shares",
        f"{programs.MOST_OF_A_SHELF}, {programs.MOST_OF_A_ROOM:,} characters",
        "no more are saved there",
    )
    yield (
        "programs of all guests",
        f"{programs.MOST_OF_GUESTS:,} characters",
        "no guest saves more",
    )
    yield "a line of chat", f"{fields.LONGEST_CHAT} characters", "it is refused"
    yield "a note", f"{fields.LONGEST_NOTE} characters", "it is refused"
    yield "chat that late comers see", f"{rooms.HISTORY} lines", "older lines stay in the database"
    yield "a message of a page", f"{fields.LONGEST_MESSAGE // 1024} kB", "the connection ends"
    yield (
        "a saved program on its way",
        f"{program_pages.LONGEST_BODY:,} bytes",
        "it is refused",
    )
    yield (
        "saved programs on their way at once",
        f"{limits.BODIES} of a person, {limits.ALL_BODIES} in all",
        "try again; of all, the slowest of who sends most ends",
    )
    yield "connections that have said nothing yet", f"{limits.UNJOINED}", "the oldest ends"
    yield "connections without a page's line", f"{patient.MOST}", "the oldest that waits ends"
    yield (
        "a request",
        f"its head within {patient.HEAD_S:.0f} s, all within {patient.ANSWER_S / 60:.0f} minutes",
        "the connection ends",
    )
    yield (
        "an answer",
        f"some of it is taken every {patient.STALL_S:.0f} s",
        "the connection ends",
    )
    yield "frames of a connection", _rate(frames.FRAMES), "the connection ends"
    yield "messages of a page", _rate(limits.MESSAGES), "the rest is refused"
    yield (
        "messages beyond that",
        f"{limits.EXCESS}",
        "the connection ends",
    )
    yield "messages that make no sense", f"{socket.MOST_BAD}", "the connection ends"
    yield "lines of chat", _rate(limits.CHAT), "the rest is refused"
    yield "programs sent, saved or fetched", _rate(limits.PROGRAMS), "the rest is refused"
    yield "requests for control", _rate(limits.TURNS), "the rest is refused"
    yield "looks at the past", _rate(limits.LOOKS), "the rest is refused"
    yield "questions of the pointer", _rate(limits.QUESTIONS), "the rest is refused"
    yield "without a command", f"{control.IDLE_S:.0f} s", "control goes to the next"
    yield "control without a connection", f"{control.AWAY_S:.0f} s", "control goes to the next"
    yield (
        "a place without a connection",
        f"{pulse.AWAY_S / 60:.0f} minutes",
        "the person has left the room",
    )
    yield (
        "a held key without a sign of life",
        f"{messages.SILENCE * 1000:.0f} ms",
        "the arm stops",
    )
    yield "sessions that begin at once", f"{sessions.STARTING}", "the others wait"
    yield "deaths of a session in a row", f"{deaths.MOST}", "its room waits for the supervisor"
    yield (
        "log of a session",
        f"{settings.LOG_QUOTA / 1e6:.0f} MB",
        "only panic, until the scene is chosen again",
    )
    yield (
        "records of who came, and of who had control",
        f"{limits.RECORDS:,} a session",
        "the log does not tell it any more",
    )
    yield (
        "records that wait for a full disk",
        f"{journal.MOST:,}; {journal.MOST_WAITING:,} of who came and had control",
        "more are lost, and the room is told how many",
    )
    yield (
        "history older than ten minutes",
        f"{settings.HISTORY_QUOTA / 1e6:.0f} MB a session",
        "the oldest is forgotten; the log has it",
    )
    yield "a log-in", f"{accounts.LOGIN_S / 86_400:.0f} days", "log in again"
    yield "what knows a browser again", f"{browsers.KEPT_S / 86_400:.0f} days", "it is a new one"
    yield "a link into a room", f"{accounts.LINK_S / 86_400:.0f} days", "it lets nobody in"
    yield (
        "a supervisor's link",
        f"{accounts.ONCE_S / 3600:.0f} hours, one entry",
        "it lets nobody in",
    )
    yield (
        "the server's log on the admin page",
        f"{log_tail.KEPT} entries",
        "older ones: the journal",
    )


def _rate(of: tuple[float, float]) -> str:
    """Return a rate in words: so many a second, or seconds for one, and so many at once."""
    rate, burst = of
    steady = f"{rate:g} a second" if rate >= 1 else f"one every {1 / rate:.0f} s"
    return f"{steady}, {burst:.0f} at once"
