"""The names that an author gives."""

from random import Random

from tests.support_likeness.scenes import Job
from tests.support_likeness.students.authors import Author
from tests.support_likeness.students.program import WORDS

LONGEST = 15  # characters of a name that count
TAKEN_TEXT = """
    ABOVE BELOW BASE TOOL OPEN CLOSE MOVE SPEED SET STOP START PAUSE END DO TO OF ON HERE
    READY REST NEST HOME PICK PLACE DRAW DRIVE PACK POINT NULL FRAME DEPART APPRO SIGNAL CALL
    VAL LEFTY RIGHTY FLIP PI SIN COS ABS INT DEST MIN MAX PARK TASK AND OR IF FOR GO IN OUT
"""
TAKEN = WORDS | frozenset(TAKEN_TEXT.split())


class Names:
    """Names of one program: each is given once."""

    def __init__(self, author: Author, job: Job, draw: Random) -> None:
        """Choose the words that this author uses for things."""
        self.author = author
        self.draw = draw
        self.words = {key: draw.choice(ways) for key, ways in author.naming.things.items()}
        self.used = {name.upper() for name, _ in job.frames}
        self.known: dict[str, str] = {}

    def place(self, key: str, given: str) -> str:
        """Return the name of a place: the text's, or an own one."""
        if key not in self.known:
            own = (self.author.own_names and "+" not in key) or not given
            self.known[key] = self.fresh(self._own(key)) if own else self.fresh(given)
        return self.known[key]

    def of(self, word: str) -> str:
        """Return the name of something else, the same each time."""
        if word not in self.known:
            self.known[word] = self.fresh(self.cased(self.words[word]))
        return self.known[word]

    def _own(self, key: str) -> str:
        thing, _, use = key.partition(".")
        kind = thing.rstrip("0123456789")
        number = thing[len(kind) :]
        first = self.words.get(kind, kind)
        if kind in ("corner", "gap", "door", "in", "safe"):
            return self.cased(first + number)
        second = self.words.get(use, use)
        join = "_" if "_" not in first + second else ""
        match self.author.name_form:
            case 0:
                name = f"{first}{number}{join}{second}"
            case 1:
                name = f"{second}{join}{first}{number}"
            case 2:
                name = f"{first}{number}"
            case 3:
                name = f"{first}{number}.{second}"
            case 4:
                name = f"{second}{number}" if number else f"{second}{join}{first}"
            case 5:
                name = f"p{len(self.known) + 1}"
            case 6:
                name = f"{first[:3]}{second[:3]}{number}"
            case _:
                name = f"{first}{second.capitalize()}{number}"
        return self.cased(name)

    def cased(self, name: str) -> str:
        """Return a name as this author writes names."""
        match self.author.name_case:
            case "upper":
                return name.upper()
            case "title":
                return name[:1].upper() + name[1:]
            case "camel":
                first, *rest = name.split("_")
                return first + "".join(part.capitalize() for part in rest)
            case _:
                return name.lower()

    def fresh(self, name: str) -> str:
        """Return a name that nothing else has, within what counts of it."""
        name = name[: LONGEST - 2]
        base, k = name, 1
        while name.upper() in self.used or name.upper() in TAKEN or not name:
            k += 1
            name = f"{base or 'x'}{k}" if not base[-1:].isdigit() else f"{base}_{k}"
        self.used.add(name.upper())
        return name
