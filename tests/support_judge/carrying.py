"""How somebody fetches a thing and sets it down, step by step."""

from random import Random

from tests.support_judge.deciding import FINE, HEIGHTS, LIFTS, USUAL, Mind
from tests.support_judge.people import SAYS, Person, remark
from tests.support_judge.places import Taught
from tests.support_judge.source import Body, Free, Step


class Hand:
    """The habits of one person with the hand: the same in all that they write."""

    def __init__(self, mind: Mind, person: Person, places: Taught) -> None:
        self.mind, self.person, self.places = mind, person, places
        self.rng: Random = mind.rng
        self.usual = mind.choose("usual speed", USUAL)
        self.variables = mind.often("heights as variables", 0.2)

    def before(self, *more: Body) -> Body:
        """Return what stands at the beginning of a main program, with pieces of any order."""
        mind, words = self.mind, self.person.words
        pieces: list[Body] = [*more]
        if mind.often("usual speed set", 0.88):
            pieces.append((self._step("SPEED", f"{self.usual} ALWAYS", about="speed"),))
        if mind.often("opens first", 0.8):
            pieces.append((Step("OPENI"),))
        if self.variables:
            pieces.append((Step("=", (words.above, self._height("approach"))),))
            pieces.append((Step("=", (words.lift, self._lift("lift"))),))
        if mind.often("speed first", 0.75):
            pieces.reverse()
        start = (self._step("MOVE", self.places.safe.name, about="home"),)
        return (Free(tuple(pieces)), *(start if mind.often("starts from safe", 0.65) else ()))

    def after(self) -> Body:
        """Return what stands at its end."""
        out: list[Step] = []
        if self.mind.often("ends at safe", 0.7):
            out.append(self._step("MOVE", self.places.safe.name, about="home"))
        if self.mind.often("says something", 0.45):
            out.append(Step("TYPE", (f'"{self.rng.choice(SAYS)}"',)))
        return tuple(out)

    def fetched(self, place: str, lift: str = "", which: str = "") -> Body:
        """Return the steps that fetch what is at a place; `lift` is an operand of the caller."""
        mind = self.mind
        out: list[Step] = []
        if mind.often("opens each time", 0.22):
            out.append(Step("OPENI"))
        out.append(self._approach("pick", place, "approach", which, "above"))
        out += self._slowly("pick")
        out.append(
            self._step(mind.choose("down pick", {"MOVES": 88, "MOVE": 12}), place, about="down")
        )
        out += self._waits("close")
        out.append(self._step("CLOSEI", about="close"))
        out += self._delays("close")
        out += self._quickly()
        if mind.often("lifts slowly", 0.14):
            out.append(Step("SPEED", (self._fine("lift"),)))
        up = lift or (self.person.words.lift if self.variables else self._lift("lift", which))
        out.append(self._step(mind.choose("up", {"DEPARTS": 80, "DEPART": 20}), up, about="up"))
        return tuple(out)

    def set_down(self, place: str, which: str = "") -> Body:
        """Return the steps that set down what is held."""
        mind, places = self.mind, self.places
        out: list[Step] = []
        if places.over is not None:
            out.append(Step(mind.choose("over", {"MOVE": 80, "MOVES": 20}), (places.over.name,)))
        elif mind.often("over safe", 0.22):
            out.append(Step("MOVE", (places.safe.name,)))
        out.append(self._approach("put", place, "approach goal", which, "over"))
        out += self._slowly("put")
        out.append(
            self._step(mind.choose("down put", {"MOVES": 92, "MOVE": 8}), place, about="set")
        )
        out += self._waits("open")
        out.append(self._step("OPENI", about="open"))
        out += self._delays("open")
        out += self._quickly()
        if self.variables and mind.often("same away", 0.7):
            away = self.person.words.above
        elif mind.often("away as approached", 0.45):
            away = self._height("approach goal", which)
        else:
            away = self._height("away", which)
        out.append(
            self._step(mind.choose("away up", {"DEPARTS": 75, "DEPART": 25}), away, about="away")
        )
        return tuple(out)

    def _approach(self, key: str, place: str, height: str, which: str, about: str) -> Step:
        word = self.mind.choose(f"approach {key}", {"APPRO": 85, "APPROS": 15})
        said = self.person.words.above if self.variables else self._height(height, which)
        return self._step(word, place, said, about=about)

    def _height(self, key: str, which: str = "") -> str:
        if key == "approach goal" and self.mind.often("one height", 0.5):
            key = "approach"
        if which and not self.mind.often("same for all", 0.85):
            key += which
        return self.mind.choose(f"n {key}", HEIGHTS)

    def _lift(self, key: str, which: str = "") -> str:
        if which and not self.mind.often("same for all", 0.85):
            key += which
        return self.mind.choose(f"n {key}", LIFTS)

    def _fine(self, key: str) -> str:
        if self.mind.often("one fine speed", 0.4):
            key = "all"
        return self.mind.choose(f"n fine {key}", FINE)

    def _slowly(self, key: str) -> list[Step]:
        how = self.mind.choose("slow how", {"once": 55, "always": 20, "never": 25})
        if how == "never" or not self.mind.often(f"slow {key}", 0.85):
            return []
        fine = self._fine(key) + (" ALWAYS" if how == "always" else "")
        return [self._step("SPEED", fine, about="speed")]

    def _quickly(self) -> list[Step]:
        how = self.mind.choose("slow how", {"once": 55, "always": 20, "never": 25})
        return [Step("SPEED", (f"{self.usual} ALWAYS",))] if how == "always" else []

    def _waits(self, key: str) -> list[Step]:
        return [Step("BREAK")] if self.mind.often(f"break before {key}", 0.2) else []

    def _delays(self, key: str) -> list[Step]:
        if not self.mind.often(f"delay after {key}", 0.16):
            return []
        time = self.mind.choose(
            "n delay", {"0.5": 40, "1": 30, "0.2": 15, "0.3": 8, "0.1": 4, "0.25": 3}
        )
        return [Step("DELAY", (time,))]

    def _step(self, word: str, *operands: str, about: str = "") -> Step:
        return Step(word, operands, remark(self.rng, self.person, about) if about else "")
