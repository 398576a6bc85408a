"""Commands about marks: places with names, and links to where it stands."""

from vrts.debug.files import LOCKED
from vrts.debug.marks.deeds import KEEP
from vrts.debug.scripted.session import Deed, Done, Refusal, Session


def _told(word: str) -> Deed:
    def deed(session: Session, rest: str, done: Done) -> None:
        if word == "marks" and rest.lower() == KEEP and not session.writes:
            raise Refusal(LOCKED)
        done.tell(session.console.marking.told(word, rest, process=session.process))

    return deed


DEEDS: dict[str, Deed] = {word: _told(word) for word in ("mark", "marks", "unmark", "link")}
