"""Carries out commands: one line does one thing, and tells what, and where it stands then."""

from vrts.debug.editing.futures import gave_up
from vrts.debug.evaluating import CannotTell
from vrts.debug.near import near_words
from vrts.debug.scripted import changing, going, looking, marking, stopping
from vrts.debug.scripted.places import place_of
from vrts.debug.scripted.session import Deed, Done, Refusal, Row, Session, is_assigned

DEEDS: dict[str, Deed] = {
    **going.DEEDS,
    **stopping.DEEDS,
    **looking.DEEDS,
    **marking.DEEDS,
    **changing.DEEDS,
}


def carry_out(session: Session, line: str) -> Done:
    """Carry out a command; the debugger stays as it is where the command is refused.

    Raises:
        KeyboardInterrupt: It was stopped; everything is as it was before.
    """
    done = Done(line.strip())
    word, _, rest = done.command.partition(" ")
    deed = DEEDS.get(word.lower())
    try:
        with session.debugger.whole():
            if deed is None or session.console.reads_on or is_assigned(done.command):
                session.enter(done.command, done)
            else:
                deed(session, rest.strip(), done)
    except (Refusal, CannotTell) as problem:
        done.ok = False
        done.said += str(problem).strip().split("\n")
        if deed is None and not session.console.reads_on:
            done.said += _meant(word)
    gone = gave_up(session.debugger.take_gone())
    if gone:
        done.said.append(gone)
    log = session.debugger.log
    done.log = [Row(one.instant.time_s, "log", one.text) for one in log]
    log.clear()
    done.place = place_of(session.debugger, process=session.process)
    return done


def _meant(word: str) -> list[str]:
    near = near_words(word.lower(), DEEDS)
    return [f"did you mean a command{near}"] if near else []
