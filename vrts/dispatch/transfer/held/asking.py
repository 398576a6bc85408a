"""Questions to a controller that change nothing: what runs, and what it holds."""

from vrts.dispatch.allowed import Prompt
from vrts.dispatch.profile_parts import Profile
from vrts.dispatch.steps import Steps
from vrts.dispatch.transfer import listed
from vrts.dispatch.transfer.listed import Place
from vrts.dispatch.transfer.problems import (
    CONTROLLER_REFUSES,
    NOT_AT_COMMANDS,
    PROGRAM_RUNNING,
    stop,
    unlike,
    visible,
)
from vrts.dispatch.transfer.talk import Answer, At, Says
from vrts.pipeline.refused import Refused

AT_COMMANDS = frozenset({Prompt.READY, Prompt.RUNNING})


def refuse_unless_at_commands(at: At) -> None:
    """Refuse a controller that waits for something else than a command."""
    if at.prompt in AT_COMMANDS:
        return
    inside = f" (step {at.step})" if at.prompt in (Prompt.STEP, Prompt.INSERT) else ""
    raise stop(
        NOT_AT_COMMANDS,
        "the controller does not wait for a command",
        f"it shows {at.prompt.value}{inside}",
        remedy="end that at the controller's terminal, or let `--resume` leave it",
    )


def refuse_while_running(talk: Says, profile: Profile) -> None:
    """Refuse while a program executes: by the prompt, and by what STATUS says."""
    if talk.at.prompt is not Prompt.RUNNING:
        answer = expect(talk.say(profile.commands.status), AT_COMMANDS, profile, "STATUS")
        if profile.replies.executing.search(answer) is None and talk.at.prompt is Prompt.READY:
            return
    raise stop(
        PROGRAM_RUNNING,
        "a program executes on the controller",
        remedy="let it end, or stop it at the controller's terminal; vrts does not stop programs",
    )


def program_on(talk: Says, profile: Profile, name: str) -> Steps | None:
    """Return a program that the controller holds; None: it holds none of this name."""
    command = profile.commands.list_program.format(name=name)
    answer = talk.say(command, lambda text: _whole(text) or refusal(text, profile) is not None)
    if _is_absent(answer, profile):
        return None
    found = listed.programs(expect(answer, AT_COMMANDS, profile, command))
    if [program.name for program in found] != [name]:
        raise unlike(f"the program `{name}`", answer.text, command)
    return found[0]


def all_programs(talk: Says, profile: Profile) -> tuple[Steps, ...]:
    """Return all programs that the controller holds."""
    command = profile.commands.list_programs
    answer = talk.say(command, _balanced)
    return listed.programs(expect(answer, AT_COMMANDS, profile, command))


def all_places(talk: Says, profile: Profile) -> dict[str, Place]:
    """Return all locations that the controller holds, by name."""
    command = profile.commands.list_locations
    answer = talk.say(command)
    if _is_absent(answer, profile):
        return {}
    found = listed.places(expect(answer, AT_COMMANDS, profile, command))
    return {place.name: place for place in found}


def value_on(talk: Says, profile: Profile, name: str) -> str | None:
    """Return a number or a string that the controller holds, as it prints it; None: it has none."""
    form = profile.commands.list_strings if name[0] == "$" else profile.commands.list_reals
    command = form.format(name=name)
    answer = talk.say(command)
    if _is_absent(answer, profile):
        return None
    return listed.value(expect(answer, AT_COMMANDS, profile, command), name)


def expect(answer: Answer, prompts: frozenset[Prompt], profile: Profile, doing: str) -> str:
    """Return the text of an answer; refuse an error of the controller, and another prompt.

    Raises:
        Refused: With the controller's words, or with the prompt that came.
    """
    words = refusal(answer.text, profile)
    if words is not None:
        raise refused(words, doing)
    if answer.at.prompt not in prompts:
        wanted = " or ".join(sorted(prompt.value for prompt in prompts))
        raise unlike(wanted, answer.at.prompt.value, f"after {visible(doing)}")
    return answer.text


def refused(words: str, doing: str) -> Refused:
    """Return what is raised for an error of the controller, in its words."""
    return stop(
        CONTROLLER_REFUSES, f"the controller says: {words}", f"it was given {visible(doing)}"
    )


def refusal(text: str, profile: Profile) -> str | None:
    """Return the controller's words where an answer is an error, on one line."""
    if any(pattern.search(text) for pattern in profile.replies.errors):
        return " / ".join(line.strip() for line in text.split("\n") if line.strip())[:300]
    return None


def _is_absent(answer: Answer, profile: Profile) -> bool:
    return (
        answer.at.prompt in AT_COMMANDS
        and refusal(answer.text, profile) is not None
        and profile.replies.absent.search(answer.text) is not None
    )


def _whole(text: str) -> bool:
    return ".PROGRAM" in text and _balanced(text)


def _balanced(text: str) -> bool:
    rows = [row.strip().upper() for row in text.split("\n")]
    return sum(row.startswith(".PROGRAM") for row in rows) == rows.count(".END")
