"""The places somebody teaches: what they are called, and how exactly they were taken over."""

from typing import NamedTuple

from tests.support_judge.deciding import Mind
from tests.support_judge.people import Person
from tests.support_judge.source import Place

OBJECTS = (
    "can{n}_grip",
    "c{n}",
    "can{n}",
    "pick{n}",
    "grip{n}",
    "von{n}",
    "dose{n}",
    "start{n}",
    "p{n}",
    "can{n}pos",
)
GOALS = (
    "base{n}_put",
    "b{n}",
    "base{n}",
    "place{n}",
    "put{n}",
    "nach{n}",
    "sockel{n}",
    "end{n}",
    "q{n}",
    "base{n}pos",
)
SAFES = ("safe", "home", "sicher", "up", "start", "s0", "safepos", "top", "neutral", "park")


class Given(NamedTuple):
    """What the task says of places: where objects stand, where they go, and `safe`."""

    objects: tuple[tuple[float, ...], ...]
    goals: tuple[tuple[float, ...], ...]
    safe: tuple[float, ...]
    more: tuple[Place, ...] = ()  # others that everybody has


class Taught(NamedTuple):
    """What somebody made of them."""

    objects: tuple[Place, ...]
    goals: tuple[Place, ...]
    safe: Place
    over: Place | None  # a place of their own on the way

    def all(self, more: tuple[Place, ...]) -> tuple[Place, ...]:
        """Return the table as it stands in the file."""
        own = (*self.objects, *self.goals, self.safe, *more)
        return own if self.over is None else (*own, self.over)


def taught(mind: Mind, person: Person, given: Given) -> Taught:
    """Return the places of one person."""
    rng = mind.rng
    family = 0 if person.given_names else rng.randrange(1, len(OBJECTS))
    mind.note("name places", family)
    exact = mind.often("places as given", 0.72)

    def near(values: tuple[float, ...], what: str) -> tuple[float, ...]:
        if exact and rng.random() < 0.97:
            return values
        off = (rng.choice((0, 0, 1, -1, 2, -2, 3)), rng.choice((0, 0, 1, -1, 2, -3)))
        down = rng.choice((0, -5, 5, 3, -3, 2, 1, -2))
        mind.note(f"place {what}", (*off, down))
        return (values[0] + off[0], values[1] + off[1], values[2] + down, *values[3:])

    objects = tuple(
        Place(OBJECTS[family].format(n=n), near(values, f"object{n}"))
        for n, values in enumerate(given.objects, 1)
    )
    goals = tuple(
        Place(GOALS[family].format(n=n), near(values, f"goal{n}"))
        for n, values in enumerate(given.goals, 1)
    )
    return Taught(objects, goals, _safe(mind, person, given), _over(mind, person, given))


def _safe(mind: Mind, person: Person, given: Given) -> Place:
    rng, values = mind.rng, given.safe
    if not mind.often("safe as given", 0.6):
        values = (
            values[0] + 10.0 * rng.randint(-6, 4),
            rng.choice((0.0, values[1], 50.0, -50.0, 100.0)),
            values[2] + 10.0 * rng.randint(-5, 8),
            *values[3:],
        )
        mind.note("place safe", values[:3])
    name = "safe" if person.given_names else rng.choices(SAFES, [6, *([1] * (len(SAFES) - 1))])[0]
    return Place(name, values)


def _over(mind: Mind, person: Person, given: Given) -> Place | None:
    if not mind.often("own place between", 0.16):
        return None
    rng = mind.rng
    values = (
        given.safe[0] + 10.0 * rng.randint(-8, 4),
        50.0 * rng.randint(-4, 4),
        given.safe[2] + 10.0 * rng.randint(-10, 3),
        *given.safe[3:],
    )
    mind.note("place between", values[:3])
    return Place(person.words.over + "0", values)
