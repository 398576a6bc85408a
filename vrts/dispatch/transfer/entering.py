"""Programs through the line editor, locations through POINT; every answer is looked at."""

from collections.abc import Callable

from vrts.dispatch.allowed import Prompt
from vrts.dispatch.profile_parts import Profile
from vrts.dispatch.steps import Steps
from vrts.dispatch.transfer.held.asking import AT_COMMANDS, expect
from vrts.dispatch.transfer.listed import Place, six_numbers
from vrts.dispatch.transfer.locations import same_place
from vrts.dispatch.transfer.problems import READ_BACK_DIFFERS, stop, unlike, visible
from vrts.dispatch.transfer.talk import Answer, Says
from vrts.pipeline.refused import Refused

_STEP, _INSERT = frozenset({Prompt.STEP}), frozenset({Prompt.INSERT})
_CHANGE, _ASKS = frozenset({Prompt.CHANGE}), frozenset({Prompt.CONFIRM, Prompt.READY})
_MOST_LEFT = 4  # answers until a controller waits for commands again

Told = Callable[[], None]
"""Called after each line that the controller has taken."""


def open_program(talk: Says, profile: Profile, program: Steps, first: int) -> None:
    """Begin to edit a program at a step; the controller holds those before.

    Raises:
        Refused: The controller refuses, or asks for another step.
    """
    form = profile.commands.new if first == 1 else profile.commands.edit
    command = form.format(name=program.name, step=first, formals=program.formals)
    answer = talk.say(command)
    expect(answer, _STEP, profile, command)
    _asked_for(answer, first, command)


def enter_steps(talk: Says, profile: Profile, program: Steps, first: int, told: Told) -> None:
    """Enter a program from a step on, and leave the editor.

    Raises:
        Refused: It refuses a step, or answers unlike its profile. It is then still in its editor.
    """
    for number, row in enumerate(program.rows[first - 1 :], first):
        _enter_step(talk, profile, number, row)
        told()
    leave = profile.commands.leave
    expect(talk.say(leave), frozenset({Prompt.READY}), profile, leave)


def enter_place(talk: Says, profile: Profile, place: Place) -> None:
    """Give a location its value.

    Raises:
        Refused: The controller refuses it, or shows another value.
    """
    command = profile.commands.point.format(name=place.name)
    expect(talk.say(command), _CHANGE, profile, command)
    line = ",".join(place.values)
    shown = six_numbers(expect(talk.say(line), _CHANGE, profile, line))
    if shown is None or not same_place(place, Place(place.name, shown), profile):
        raise stop(
            READ_BACK_DIFFERS,
            f"the controller shows another value of `{place.name}` than was entered",
            f"entered: {' '.join(place.values)}",
            f"shown: {' '.join(shown) if shown else 'no six numbers'}",
        )
    expect(talk.say(""), frozenset({Prompt.READY}), profile, "RETURN")


def delete_program(talk: Says, profile: Profile, name: str) -> None:
    """Delete one program; what it uses stays.

    Raises:
        Refused: The controller refuses.
    """
    command = profile.commands.delete.format(name=name)
    answer = talk.say(command)
    expect(answer, _ASKS, profile, command)
    if answer.at.prompt is Prompt.CONFIRM:
        expect(talk.say("Y"), frozenset({Prompt.READY}), profile, "Y")


def leave(talk: Says, profile: Profile) -> bool:
    """Leave editor and questions without changing anything more; return whether that worked."""
    for _ in range(_MOST_LEFT):
        if talk.at.prompt in AT_COMMANDS:
            return True
        try:
            talk.say(profile.commands.leave if talk.at.prompt is Prompt.STEP else "")
        except Refused:
            return False
    return talk.at.prompt in AT_COMMANDS


def through_insertion(row: str, profile: Profile) -> bool:
    """Return whether the editor would not take a row for a step: blank, or one of its letters."""
    start = row.lstrip()
    alone = not start[1:2] or start[1:2] in " 0123456789"
    letters = profile.commands.letters
    return not start or (start[0].upper() in letters and (alone or start[:2].upper() in _PAIRS))


_PAIRS = frozenset({"TS", "XD", "XY", "XP", "XQ", "XS"})  # commands of two letters


def _enter_step(talk: Says, profile: Profile, number: int, row: str) -> None:
    """Enter a step. RETURN alone comes first: an editor behind its last step asks again.

    If the editor has ended by itself, the prompt for commands comes, and the step, which may be a
    command too (`SIGNAL 1`), is never typed.
    """
    _taken(talk.say(""), _STEP, number, "RETURN", profile)
    if not through_insertion(row, profile):
        _taken(talk.say(row), _STEP, number + 1, row, profile)
        return
    insert = profile.commands.insert
    _taken(talk.say(insert), _INSERT, number, insert, profile)
    _taken(talk.say(row or " "), _INSERT, number + 1, row or " ", profile)
    _taken(talk.say(""), _STEP, number + 1, "RETURN", profile)


def _taken(
    answer: Answer, prompts: frozenset[Prompt], following: int, row: str, profile: Profile
) -> None:
    """Refuse any answer but silence and the question for the step that follows."""
    text = expect(answer, prompts, profile, row)
    if text.strip():
        raise unlike("nothing but the next prompt", text, f"after {visible(row)}")
    _asked_for(answer, following, row)


def _asked_for(answer: Answer, step: int, row: str) -> None:
    if answer.at.step != step:
        raise unlike(f"the question for step {step}", f"step {answer.at.step}", f"after {row!a}")
