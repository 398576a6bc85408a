"""Where an author's places come from: the text, a ruler, a hand that teaches, or arithmetic."""

import re
from random import Random

from tests.support_likeness.scenes import Job, Place
from tests.support_likeness.students.authors import Author
from tests.support_likeness.students.naming import Names
from tests.support_likeness.students.program import Line, Program, Unit, Values, names_of

KEY = re.compile(r"\{([\w.]+)\}")


class Taught:
    """The places of one program: their names, values, and statements that compute some."""

    def __init__(self, author: Author, job: Job, names: Names, draw: Random) -> None:
        """Begin without places; each is made when it is first named."""
        self.a, self.job, self.names, self.draw = author, job, names, draw
        self.places: dict[str, Values] = {}
        self.sets: list[Line] = []  # at the start of the main program, or a call
        self.inits: Unit | None = None
        self.computes = draw.random() < 0.55  # what the text's frames allow
        self.apart = author.computed != "section" and draw.random() < 0.5
        self.safe_name = ""
        self.height = round(draw.gauss(0, 2 * author.taught_mm), 2)  # [mm] of hands at cans

    def safe(self) -> str:
        """Return the name of the place above everything."""
        if not self.safe_name:
            self.safe_name = self.names.place("safe", "safe")
            x, y, z, *turn = self.job.safe
            if self.a.own_safe:
                x += self.draw.choice((0, -60, -40, -20, 10, 20, 40))
                y += self.draw.choice((0, -50, -30, 20, 30, 50))
                z += self.draw.choice((0, 20, 50, 80, 100, 30))
            self.places[self.safe_name] = (x, y, z, turn[0], turn[1], turn[2])
        return self.safe_name

    def name(self, key: str) -> str:
        """Return the name of a place, which exists from now on."""
        known = key in self.names.known
        place = self.job.place(key)
        name = self.names.place(key, place.given)
        if not known:
            self._make(name, place)
        return name

    def above(self, name: str, height: float) -> str:
        """Return the name of a place above one that is taught; empty: it is computed."""
        if name not in self.places:
            return ""
        x, y, z, o, a, t = self.places[name]
        key = f"{name}+{height:g}"
        known = key in self.names.known
        over = self.names.place(key, f"{name[:9]}_up") if not known else self.names.known[key]
        if not known:
            self.places[over] = (x, y, z + height, o, a, t)
        return over

    def values(self, place: Place) -> Values:
        """Return where this author thinks that a place is."""
        a, draw = self.a, self.draw
        x, y, z, *turn = place.values
        use = place.key.partition(".")[2]
        sideways = min(1.0, place.slack_mm / 2.5)
        if a.taught_mm:
            x, y = (round(draw.gauss(v, a.taught_mm * sideways), 2) for v in (x, y))
            over = 0.0 if use == "grip" else 0.8 * draw.random()  # nobody taught into a base
            z = round(z + self.height * place.lifts + over * sideways, 2)
        elif a.rounding_mm and a.own_names:
            unit = a.rounding_mm if place.slack_mm > 2 else 1
            x, y = (unit * round(draw.gauss(v, 0.8 * sideways) / unit) for v in (x, y))
        if place.key.endswith(".way") and place.slack_mm > 5:
            x, y = (v + draw.choice((0, 0, 5, -5, 10, -10)) for v in (x, y))
        if place.lifts:
            z += a.lift_mm
        if place.turns:
            turn[0] = a.turn_deg
        return (x, y, z, turn[0], turn[1], turn[2])

    def _make(self, name: str, place: Place) -> None:
        a = self.a
        if place.made and self.computes:
            made = KEY.sub(lambda m: self.name(m[1]), place.made)
            self._set(Line("SET", [name, made]))
            for frame, values in self.job.frames:
                if frame in made:
                    self.places[frame] = values
            return
        values = self.values(place)
        if a.computed == "trans":
            inner = ",".join(f"{v:g}" for v in values)
            self._set(Line("SET", [name, f"TRANS({inner})"]))
            return
        if a.computed == "shift" and self._shifted(name, place, values):
            return
        self.places[name] = values

    def _shifted(self, name: str, place: Place, values: Values) -> bool:
        """Compute a place from one of the same use, where there is one."""
        use = place.key.partition(".")[2]
        for other in self.job.places:
            known = self.names.known.get(other.key, "")
            if other.key == place.key or not other.key.endswith(use) or known not in self.places:
                continue
            at = self.places[known]
            if at[3:] == values[3:]:
                by = ",".join(
                    f"{round(b - a, 2):g}" for a, b in zip(at[:3], values[:3], strict=True)
                )
                self._set(Line("SET", [name, f"SHIFT({known} BY {by})"]))
                return True
        return False

    def _set(self, line: Line) -> None:
        if self.apart:
            if self.inits is None:
                self.inits = Unit(self.names.of("init"), [], [])
                self.sets.append(Line("CALL", [self.inits.name]))
            self.inits.body.append(line)
        else:
            self.sets.append(line)

    def finish(self) -> None:
        """Put the places into the order of this author."""
        rows = list(self.places.items())
        if self.draw.random() < 0.4:
            self.draw.shuffle(rows)
        elif self.draw.random() < 0.4:
            rows.sort()
        self.places = dict(rows)


def without_unused(program: Program) -> None:
    """Take places out that nothing names."""
    places = program.places
    program.places = {}
    used = {name.upper() for name in names_of(program)}
    program.places = {name: at for name, at in places.items() if name.upper() in used}
