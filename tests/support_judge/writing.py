"""Programs for two tasks: two cans to two bases, and a table full of things."""

from typing import NamedTuple

from tests.support_judge.carrying import Hand
from tests.support_judge.deciding import FINE, HEIGHTS, Advice, Mind
from tests.support_judge.people import Person
from tests.support_judge.places import Given, taught
from tests.support_judge.plans import Job, Part, planned
from tests.support_judge.source import Body, Free, Place, Program, Source, Step


class Assignment(NamedTuple):
    """A task as students have it: its places, the lecture's numbers, and what plans are usual."""

    name: str
    given: Given
    lecture: Advice
    plans: dict[str, float]


DOWN = (90.0, 90.0, 0.0)
CANS = Assignment(
    "cans",
    Given(
        objects=((800.0, -450.0, -225.0, *DOWN), (750.0, 450.0, -225.0, *DOWN)),
        goals=((950.0, -130.0, -75.0, *DOWN), (1100.0, 230.0, -125.0, *DOWN)),
        safe=(900.0, 30.0, 100.0, *DOWN),
    ),
    lecture={
        "n approach": "120", "n lift": "200", "n approach goal": "120", "n away": "120",
        "n fine pick": "30", "n fine put": "20", "slow how": "once", "plan": "carry",
        "usual speed": "100", "down pick": "MOVES", "up": "DEPARTS", "away up": "DEPARTS",
        "break before close": "no", "approach pick": "APPRO", "opens first": "yes",
    },
    plans={"carry": 36, "list": 28, "two": 12, "globals": 4, "each": 8, "for": 6, "while": 2,
        "for inside": 4},
)  # fmt: skip
PROJECT = Assignment(
    "project",
    Given(
        objects=tuple((x, -610.0, -225.0, *DOWN) for x in (720.0, 880.0, 1040.0)),
        goals=tuple((690.0, y, z, *DOWN)
            for y, z in ((300.0, -185.0), (450.0, -145.0), (600.0, -105.0))),
        safe=(860.0, -20.0, 160.0, *DOWN),
        more=(
            Place("dish_grip", (730.0, 163.0, -268.0, *DOWN)),
            Place("pizza_grip", (906.16, -286.73, -268.0, 70.0, 60.0, 0.0)),
            Place("stand_mid", (1042.9, 480.0, -133.02, 90.0, 70.0, 0.0)),
        ),
    ),
    lecture={
        "n approach": "100", "n lift": "60", "n approach goal": "100", "n away": "100",
        "n fine pick": "40", "n fine put": "25", "slow how": "once", "plan": "for",
        "usual speed": "100", "down pick": "MOVES", "up": "DEPARTS", "away up": "DEPARTS",
        "over safe": "yes", "approach pick": "APPRO", "opens first": "yes",
        "order": "cans dish pizza",
        "pizza how": "frames", "dish how": "compound", "n pizza approach": "80",
        "n pizza fine": "30", "n pizza lift": "140", "n in speed": "40", "n baked speed": "20",
        "n above stone": "20", "places in a program of their own": "yes", "n dish lift": "250",
    },
    plans={"for": 32, "lift": 14, "carry": 24, "two": 8, "globals": 3, "each": 5, "while": 5,
        "for inside": 4},
)  # fmt: skip
ORDERS = {
    "cans dish pizza": 60, "pizza cans dish": 8, "dish cans pizza": 8, "cans pizza dish": 12,
    "pizza dish cans": 6, "dish pizza cans": 6,
}  # fmt: skip
RIM = Place("rim", (0.0, 103.0, 18.0, 90.0, -90.0, 0.0))
FRAMES = (
    Place("pizza", (1080.0, -350.0, -300.0, 70.0, -90.0, 0.0)),
    Place("stone", (1310.0, 30.0, -220.0, 90.0, -90.0, 0.0)),
)
LEAN = (90.0, 60.0, 0.0)
IN_X, DISH = 1125.0, (1049.06, 583.0, -149.93, 90.0, 70.0, 0.0)


def written_by(mind: Mind, person: Person, task: Assignment) -> Source:
    """Return the program that somebody writes for a task, before any slip."""
    places = taught(mind, person, task.given)
    hand = Hand(mind, person, places)
    jobs = [Job(a.name, b.name) for a, b in zip(places.objects, places.goals, strict=True)]
    if not mind.often("first can first", 0.85):
        jobs.reverse()
    cans = planned(hand, mind.choose("plan", task.plans), tuple(jobs))
    if task.name == "cans":
        main = (*hand.before(*cans.settings), *cans.main, *hand.after())
        programs, more = cans.programs, ()
    else:
        main, programs, more = _project(hand, cans)
    whole = [Program("main", (), main), *programs]
    if mind.often("main last", 0.12):
        whole = [*whole[1:], whole[0]]
    head = _head(mind, person, task)
    return Source(head, tuple(whole), places.all((*task.given.more, *more)))


def _project(hand: Hand, cans: Part) -> tuple[Body, tuple[Program, ...], tuple[Place, ...]]:
    dish, dish_places, dish_programs = _dish(hand, cans)
    bake, bake_places = _bake(hand)
    programs = [*cans.programs, *dish_programs]
    if hand.mind.often("pizza in a program", 0.7):
        name = hand.mind.choose(
            "name bake", {"bake": 50, "pizza1": 15, "do_pizza": 15, "backen": 10, "oven1": 10}
        )
        programs.append(Program(name, (), bake))
        bake = (Step("CALL", (name,)),)
    parts = {"cans": cans.main, "dish": dish, "pizza": bake}
    order = hand.mind.choose("order", ORDERS).split()
    settings = (*cans.settings, (Step("SIGNAL", ("1",)),))
    main = (*hand.before(*settings), Free(tuple(parts[one] for one in order)), *hand.after())
    return main, tuple(programs), (*dish_places, *bake_places)


def _dish(hand: Hand, cans: Part) -> tuple[Body, tuple[Place, ...], tuple[Program, ...]]:
    mind, words = hand.mind, hand.person.words
    how = mind.choose("dish how", {"compound": 55, "set": 25, "taught": 20})
    goal = {"compound": "stand_mid:rim", "set": "dish_put", "taught": "dish_put"}[how]
    first: Body = (Step("SET", ("dish_put", "stand_mid:rim")),) if how == "set" else ()
    new = Place("dish_put", DISH) if how == "taught" else RIM
    lift = mind.choose("n dish lift", {"250": 40, "200": 20, "300": 20, "220": 10, "280": 10})
    carry = next((one for one in cans.programs if one.name == words.carry and one.parameters), None)
    if carry is not None and mind.often("dish by the same program", 0.7):
        more = (lift,) if len(carry.parameters) == 3 else ()
        return (*first, Step("CALL", (carry.name, "dish_grip", goal, *more))), (new,), ()
    body = (*first, *hand.fetched("dish_grip", lift), *hand.set_down(goal, "dish"))
    if mind.often("dish in a program", 0.5):
        return (Step("CALL", ("dish",)),), (new,), (Program("dish", (), body),)
    return body, (new,), ()


def _bake(hand: Hand) -> tuple[Body, tuple[Place, ...]]:
    mind, safe = hand.mind, hand.places.safe.name
    how = mind.choose("pizza how", {"frames": 50, "shift": 25, "taught": 25})
    above = mind.choose("n above stone", {"20": 45, "15": 15, "25": 15, "30": 15, "10": 5, "18": 5})
    back = mind.choose("n back", {"305": 55, "300": 25, "310": 12, "304": 4, "308": 4})
    inside = {0: "in", 1: "oven_in", 2: "in1", 3: "rein", 4: "inside"}[_pick(mind, "name in")]
    door = {0: "door", 1: "before", 2: "front", 3: "tuer", 4: "d0"}[_pick(mind, "name door")]
    baked = {0: "baked", 1: "pizza_put", 2: "oven0", 3: "stein", 4: "end0"}[
        _pick(mind, "name baked")
    ]
    first: list[Step] = []
    places: list[Place] = []
    z = -188.0
    if how == "frames":
        first.append(Step("SET", ("hold", "INVERSE(pizza):pizza_grip")))
        first.append(Step("SET", (baked, "stone:hold")))
        places += FRAMES
    else:
        places.append(Place(baked, (IN_X, 30.0, z, *LEAN)))
    if how == "taught":
        places.append(Place(inside, (IN_X, 30.0, z + float(above), *LEAN)))
        places.append(Place(door, (IN_X - float(back), 30.0, z + float(above), *LEAN)))
    else:
        first.append(Step("SET", (inside, f"SHIFT({baked} BY 0,0,{above})")))
        first.append(Step("SET", (door, f"SHIFT({inside} BY -{back},0,0)")))
    out = [*first]
    if mind.often("pizza from safe", 0.7):
        out.append(Step("MOVE", (safe,)))
    out.append(Step("APPRO", ("pizza_grip", mind.choose("n pizza approach", HEIGHTS))))
    out += _slow(mind, "pizza fine")
    out += [Step("MOVES", ("pizza_grip",)), Step("CLOSEI")]
    out.append(
        Step(
            "DEPARTS",
            (
                mind.choose(
                    "n pizza lift",
                    {"140": 20, "150": 30, "100": 15, "120": 15, "200": 10, "160": 10},
                ),
            ),
        )
    )
    out.append(Step(mind.choose("to the door", {"MOVES": 70, "MOVE": 30}), (door,)))
    if mind.often("stops at the door", 0.75):
        out.append(Step("BREAK"))
    out += [*_slow(mind, "in speed"), Step("MOVES", (inside,))]
    out += [*_slow(mind, "baked speed"), Step("MOVES", (baked,)), Step("OPENI")]
    out.append(Step("DEPARTS", (mind.choose("n out", HEIGHTS),)))
    return tuple(out), tuple(places)


def _slow(mind: Mind, key: str) -> list[Step]:
    return (
        [Step("SPEED", (mind.choose(f"n {key}", FINE),))] if mind.often(f"sets {key}", 0.8) else []
    )


def _pick(mind: Mind, key: str) -> int:
    return int(mind.choose(key, {"0": 60, "1": 10, "2": 10, "3": 10, "4": 10}))


def _head(mind: Mind, person: Person, task: Assignment) -> tuple[str, ...]:
    style = mind.choose("head", {"none": 40, "name": 25, "both": 20, "start": 15})
    title = {"cans": "Two cans and two bases on a table", "project": "Final project"}[task.name]
    lines = {"none": (), "name": (person.name,), "both": (title, person.name), "start": (title,)}
    return lines[style]
