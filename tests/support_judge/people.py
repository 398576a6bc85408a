"""What people call things, what they write beside their steps, and whose hand it is."""

from random import Random
from typing import NamedTuple

from tests.support_judge.layout import Layout, some_layout

NAMES = [
    "Anna",
    "Ben",
    "Cara",
    "David",
    "Emil",
    "Fatima",
    "Goran",
    "Hanna",
    "Ivo",
    "Jana",
    "Karl",
    "Lea",
    "Milan",
    "Nina",
    "Omar",
    "Petra",
    "Quirin",
    "Rosa",
    "Simon",
    "Tina",
    "Ugur",
    "Vera",
    "Wei",
    "Xenia",
    "Yusuf",
    "Zoe",
]
FAMILIES = [
    "Adler",
    "Bauer",
    "Cech",
    "Dorn",
    "Eder",
    "Fuchs",
    "Gruber",
    "Huber",
    "Ilic",
    "Jung",
    "Kern",
    "Lang",
    "Mayr",
    "Novak",
    "Ortner",
    "Pichler",
    "Reiter",
    "Steiner",
    "Thaler",
    "Urban",
    "Vogel",
    "Wolf",
    "Zauner",
    "Berger",
    "Koller",
    "Moser",
    "Winkler",
    "Haas",
]


class Words(NamedTuple):
    """Names that go together in one person's programs."""

    carry: str
    start: str
    goal: str
    fetch: str
    put: str
    lift: str
    above: str
    over: str
    turn: str
    first: str
    last: str
    speed: str


VOCABULARY = (
    Words("carry", "start", "goal", "fetch", "put", "rise", "h", "over", "i", "from", "goal", "sp"),
    Words("move_can", "a", "b", "pick", "place", "up", "height", "mid", "i", "src", "dst", "v"),
    Words(
        "transport",
        "von",
        "nach",
        "holen",
        "ablegen",
        "hub",
        "hoehe",
        "oben",
        "k",
        "start",
        "ziel",
        "tempo",
    ),
    Words(
        "pickplace",
        "pickpos",
        "placepos",
        "pick",
        "place",
        "lift",
        "offs",
        "via",
        "n",
        "p",
        "q",
        "slow",
    ),
    Words(
        "bring", "here1", "there", "grab", "release", "raise", "dist", "wp", "i", "get", "put", "sl"
    ),
    Words("sub1", "p1", "p2", "sub2", "sub3", "d2", "d1", "p0", "j", "a", "b", "s"),
    Words(
        "can_move",
        "grip_pos",
        "put_pos",
        "get_can",
        "put_can",
        "z_up",
        "z_app",
        "point1",
        "nr",
        "grip",
        "drop",
        "v_slow",
    ),
    Words(
        "umsetzen",
        "quelle",
        "ziel",
        "greifen",
        "setzen",
        "anheben",
        "abst",
        "zwi",
        "z",
        "qu",
        "zi",
        "langsam",
    ),
    Words(
        "do_can",
        "from_loc",
        "to_loc",
        "do_pick",
        "do_place",
        "dep",
        "app",
        "safe2",
        "cnt",
        "fr",
        "to_",
        "fine",
    ),
    Words(
        "handle",
        "loc1",
        "loc2",
        "take",
        "leave",
        "high",
        "low",
        "between",
        "i",
        "loc",
        "tgt",
        "slw",
    ),
)
REMARKS = {
    "above": (
        "above the can",
        "go over it",
        "approach",
        "quickly above",
        "drueber fahren",
        "nicht direkt hin",
        "first stop above",
        "pre-grasp",
    ),
    "down": (
        "straight down",
        "gently down",
        "down slowly",
        "gerade runter",
        "to the part",
        "now down",
        "careful here",
    ),
    "close": (
        "grip",
        "close the hand",
        "take it",
        "zugreifen",
        "close and wait",
        "grab!",
        "got it",
    ),
    "up": (
        "straight up",
        "lift",
        "up again",
        "wieder hoch",
        "clear of the bases",
        "high enough?",
        "retract with can",
    ),
    "over": (
        "above the base",
        "over the goal",
        "ueber dem ziel",
        "to the base",
        "fast move",
        "other side",
    ),
    "set": (
        "set it down",
        "lower it",
        "slowly, can in hand",
        "absetzen",
        "last bit",
        "to the final place",
    ),
    "open": ("let go", "release", "open", "loslassen", "now it stands", "hand open again"),
    "away": ("back up", "away", "leave it", "weg", "clear", "retreat"),
    "speed": ("speed", "fast", "in percent", "tempo", "default speed", "not too fast"),
    "home": ("safe place", "home", "go to safe", "sicher", "start from above", "wait here"),
}
SAYS = (
    "done",
    "Done.",
    "ready",
    "finished",
    "fertig",
    "all cans placed",
    "Program finished",
    "OK",
    "end of program",
    "Both done",
    "task complete",
    "bye",
    "job done!",
    "everything in place",
    "Fertig!",
    "the end",
)


class Person(NamedTuple):
    """Somebody who hands in a program."""

    name: str
    layout: Layout
    words: Words
    chatty: float  # share of lines with a remark
    given_names: bool  # keeps the names of places that came with the task


def some_person(rng: Random) -> Person:
    """Return somebody of their own."""
    main = rng.choices(VOCABULARY, [9.0, *([1.0] * (len(VOCABULARY) - 1))])[0]
    words = distinct(Words(*(_word(rng, main, at) for at in range(len(main)))))
    return Person(
        name=f"{rng.choice(NAMES)} {rng.choice(FAMILIES)}",
        layout=some_layout(rng),
        words=words,
        chatty=rng.choices([0.0, 0.15, 0.4, 0.8], [35, 30, 25, 10])[0],
        given_names=rng.random() < 0.6,
    )


def _word(rng: Random, main: Words, at: int) -> str:
    """Return a name of one's usual ones, of somebody else's, or a variant that few have."""
    if rng.random() < (0.8 if main is VOCABULARY[0] else 0.5):
        return main[at]
    word = rng.choice(VOCABULARY)[at]
    if rng.random() < 0.6:
        return word
    return rng.choice(
        (f"{word}1", f"my_{word}", f"{word}x", f"{word[:3]}_{rng.choice('abcpxz')}", word[:2] * 2)
    )


def distinct(words: Words) -> Words:
    """Return names of which no two are alike."""
    seen: list[str] = []
    for word in words:
        while word in seen:
            word += "2"
        seen.append(word)
    return Words(*seen)


def remark(rng: Random, person: Person, about: str) -> str:
    """Return what a person writes beside a step, most often nothing."""
    return rng.choice(REMARKS[about]) if rng.random() < person.chatty else ""
