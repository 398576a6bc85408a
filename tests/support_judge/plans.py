"""How somebody divides a program that carries several things: in one list, programs, loops."""

from typing import NamedTuple

from tests.support_judge.carrying import Hand
from tests.support_judge.source import Body, Free, Loop, Program, Step

TITLES = (
    "fetch the can and stand it at its goal",
    "moves one can",
    "carry a can",
    "Unterprogramm",
    "transport",
    "pick and place",
    "one can from a to b",
    "subroutine for one can",
    "takes start and goal",
    "",
)


class Job(NamedTuple):
    """Something to be carried: the names of where it is and where it goes."""

    start: str
    goal: str


class Part(NamedTuple):
    """The part of a program that carries things: steps of main, and programs of its own."""

    settings: tuple[Body, ...]  # belongs to the beginning of main
    main: Body
    programs: tuple[Program, ...]


def planned(hand: Hand, plan: str, jobs: tuple[Job, ...]) -> Part:
    """Return how somebody carries things by a plan."""
    words = hand.person.words
    note = hand.rng.choice(TITLES) if hand.rng.random() < hand.person.chatty else ""
    whole = (*hand.fetched(words.start), *hand.set_down(words.goal))
    one = Program(words.carry, (words.start, words.goal), whole, note)
    match plan:
        case "carry":
            calls = tuple((Step("CALL", (words.carry, *job)),) for job in jobs)
            return Part((), (Free(calls),), (one,))
        case "lift":
            inside = (*hand.fetched(words.start, words.lift), *hand.set_down(words.goal))
            lifts = [
                hand.mind.choose(
                    "n lift", {"60": 30, "100": 20, "80": 15, "150": 15, "120": 10, "200": 10}
                )
            ] * len(jobs)
            calls = tuple(
                (Step("CALL", (words.carry, *job, up)),)
                for job, up in zip(jobs, lifts, strict=True)
            )
            parameters = (words.start, words.goal, words.lift)
            return Part((), (Free(calls),), (one._replace(parameters=parameters, body=inside),))
        case "two":
            fetch = Program(words.fetch, (words.start,), hand.fetched(words.start), note)
            put = Program(words.put, (words.goal,), hand.set_down(words.goal))
            calls = tuple(
                (Step("CALL", (words.fetch, job.start)), Step("CALL", (words.put, job.goal)))
                for job in jobs
            )
            return Part((), (Free(calls),), (fetch, put))
        case "globals":
            calls = tuple(
                (
                    Step("SET", (words.start, job.start)),
                    Step("SET", (words.goal, job.goal)),
                    Step("CALL", (words.carry,)),
                )
                for job in jobs
            )
            return Part((), (Free(calls),), (one._replace(parameters=()),))
        case "each":
            each = tuple(
                Program(f"{words.carry}{n}", (), _inline(hand, job, str(n)))
                for n, job in enumerate(jobs, 1)
            )
            calls = tuple((Step("CALL", (program.name,)),) for program in each)
            return Part((), (Free(calls),), each)
        case "for" | "while" | "for inside":
            return _looped(hand, plan, jobs, one)
        case _:
            blocks = tuple(
                (*_heading(hand, n), *_inline(hand, job, str(n))) for n, job in enumerate(jobs, 1)
            )
            return Part((), (Free(blocks),), ())


def _looped(hand: Hand, plan: str, jobs: tuple[Job, ...], one: Program) -> Part:
    words = hand.person.words
    kind = "WHILE" if plan == "while" else "FOR"
    set_up = tuple(
        (
            Step("SET", (f"{words.first}[{n}]", job.start)),
            Step("SET", (f"{words.last}[{n}]", job.goal)),
        )
        for n, job in enumerate(jobs, 1)
    )
    at = f"[{words.turn}]"
    if plan == "for inside":
        body = (*hand.fetched(words.first + at), *hand.set_down(words.last + at))
        programs: tuple[Program, ...] = ()
    else:
        body = (Step("CALL", (words.carry, words.first + at, words.last + at)),)
        programs = (one,)
    loop = Loop(kind, words.turn, str(len(jobs)), body)
    if hand.mind.often("places in a program of their own", 0.3):
        teach = Program("places", (), (Free(set_up),))
        return Part(((Step("CALL", ("places",)),),), (loop,), (teach, *programs))
    return Part((), (Free(set_up), loop), programs)


def _heading(hand: Hand, n: int) -> Body:
    style = hand.mind.choose("heading", {"none": 45, "can": 25, "line": 15, "nr": 15})
    said = {"can": f"can {n}", "line": f"---- can{n} ----", "nr": f"{n}. Dose"}
    return (Step(";", (), said[style]),) if style in said else ()


def _inline(hand: Hand, job: Job, which: str) -> Body:
    return (*hand.fetched(job.start, which=which), *hand.set_down(job.goal, which=which))
