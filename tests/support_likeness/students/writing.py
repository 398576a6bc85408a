"""An author writes a program for a task, alone."""

from random import Random

from tests.support_likeness.scenes import Goal, Job
from tests.support_likeness.students.authors import Author
from tests.support_likeness.students.naming import Names
from tests.support_likeness.students.program import Line, Program, Unit
from tests.support_likeness.students.teaching import Taught
from tests.support_likeness.students.years import Year, lecture_units, start_head, start_lines

ARRAYS = ("for", "while", "goto")


class Writer:
    """Writes one program."""

    def __init__(self, author: Author, job: Job, year: Year, seed: object) -> None:
        """Begin with an empty sheet."""
        self.a, self.job, self.year = author, job, year
        self.draw = Random(f"writes {seed}")
        self.names = Names(author, job, self.draw)
        self.starts = self.draw.random() < year.start_share
        self.shape = author.shape
        if self.draw.random() < year.lecture_share:
            self.shape = "lecture"
            self.names.used |= {"CARRY", "FETCH", "DELIVER"}
        self.taught = Taught(author, job, self.names, self.draw)
        self.subs: list[Unit] = []

    def program(self) -> Program:
        """Return the program."""
        a = self.a
        goals = self.goals()
        first, last = self.frame()
        same = [goal for goal in goals if not goal.ways]
        by_array = self.shape in ARRAYS and len(same) > 1
        middle: list[Line] = []
        if by_array:
            own = [goal for goal in goals if goal.ways or goal.part == "dish"]
            cans = [goal for goal in same if goal not in own]
            middle += self.by_array(cans)
            goals = own
        for goal in goals:
            middle += self.head_of(goal) + self.goal(goal)
        if self.job.signal:
            at = (0, len(middle) - len(middle) // 3, len(middle))[a.signal]
            while 0 < at < len(middle) and middle[at].part == middle[at - 1].part:
                at += 1
            middle.insert(at, Line("SIGNAL", ["1"]))
        main = Unit("main", [], first + self.taught.sets + middle + last)
        self.taught.finish()
        head = start_head() if self.starts else self.head()
        units = [main, *self.subs]
        if self.taught.inits is not None:
            units.insert(self.draw.choice((1, len(units))), self.taught.inits)
        roles = {name: key for key, name in self.names.known.items()}
        return Program(units, self.taught.places, head, roles)

    def head(self) -> list[str]:
        """Return what stands at the top."""
        if self.draw.random() > 0.25 + self.a.notes:
            return []
        says = self.a.tongue.says["head"]
        lines = [self.draw.choice(says)]
        if self.draw.random() < 0.4:
            lines.append(f"{self.draw.randrange(1, 29)}.{self.draw.randrange(1, 13)}.")
        if self.draw.random() < 0.3:
            rule = self.draw.choice("-=*#") * self.draw.choice((20, 30, 40))
            lines = [rule, *lines, rule]
        return lines

    def goals(self) -> list[Goal]:
        """Return the goals in the order of this author."""
        goals = list(self.job.goals)
        if self.a.order > 0.55:
            self.draw.shuffle(goals)
        elif self.a.order > 0.4:
            goals.reverse()
        return goals

    def frame(self) -> tuple[list[Line], list[Line]]:
        """Return how the main program begins and ends."""
        a = self.a
        safe = self.safe()
        if self.starts:
            return start_lines(safe)
        first: list[Line] = []
        if a.speeds != "none":
            first.append(self.line("SPEED", [f"{a.fast}", "ALWAYS"], "fast"))
        if a.opens != "each" or self.shape == "lecture":
            first.append(self.line("OPENI", [], "start"))
        self.draw.shuffle(first)
        last: list[Line] = []
        if a.safe in ("ends", "start", "between") or a.approach == "APPROS":
            first.append(self.line("MOVE", [safe], "safe"))
        if a.safe in ("ends", "between"):
            last.append(self.line("MOVE", [safe], "safe"))
        if a.types != "none":
            last.append(Line("TYPE", [f'"{self.draw.choice(a.tongue.says["done"])}"']))
        if self.draw.random() < 0.06:
            last.append(Line("STOP"))
        return first, last

    def safe(self) -> str:
        """Return the name of the place above everything."""
        return self.taught.safe()

    def line(self, word: str, args: list[str], about: str = "", thing: str = "") -> Line:
        """Return a statement, with a comment where this author feels like one."""
        line = Line(word, args)
        if about and self.draw.random() < self.a.notes:
            line.note = self.said(about, thing)
        return line

    def said(self, about: str, thing: str = "") -> str:
        """Return words about something."""
        text = self.draw.choice(self.a.tongue.says[about])
        return text.replace("{}", thing or self.a.tongue.things["can"][0])

    def head_of(self, goal: Goal) -> list[Line]:
        """Return what stands above a goal."""
        a, found = self.a, list[Line]()
        kind = goal.part.rstrip("0123456789")
        thing = self.names.words.get(kind, kind) + goal.part[len(kind) :]
        if self.draw.random() < a.part_notes:
            if a.layout.blank:
                found.append(Line("BLANK", part=goal.part))
            found.append(Line("NOTE", [self.said("part", thing)], part=goal.part))
        if a.types == "each":
            found.append(Line("TYPE", [f'"{self.said("part", thing)}"'], part=goal.part))
        return found

    def goal(self, goal: Goal) -> list[Line]:
        """Return the lines of the main program for one goal."""
        grip, put = self.taught.name(goal.grip), self.taught.name(goal.put)
        lines = self._goal(goal, grip, put)
        for line in lines:
            line.part = goal.part
        return lines

    def _goal(self, goal: Goal, grip: str, put: str) -> list[Line]:
        safe = [Line("MOVE", [self.safe()])] if self.job.wants_safe else []
        if goal.ways:
            lines = self.whole(goal, grip, put)
            if self.shape in ("straight", "globals"):
                return lines
            return self.sub(goal.part, goal, lines)
        match self.shape:
            case "lecture":
                return self.lecture(goal, grip, put)
            case "carry" | "carry_high":
                name = self.names.of("carry")
                more = self.heights(goal) if self.shape == "carry_high" else []
                if not self.known(name):
                    self.subs.append(self.carry(name, goal, bool(more)))
                return [*safe, Line("CALL", [name, grip, put, *more])]
            case "two":
                pick, place = self.names.of("pick"), self.names.of("place")
                if not self.known(pick):
                    start, end = self.names.of("from"), self.names.of("to")
                    self.subs.append(Unit(pick, [start], self.pick(goal, start)))
                    self.subs.append(Unit(place, [end], self.place(goal, end)))
                return [
                    *safe,
                    Line("CALL", [pick, grip]),
                    *self.again(safe),
                    Line("CALL", [place, put]),
                ]
            case "globals":
                name, start, end = (self.names.of(one) for one in ("carry", "from", "to"))
                if not self.known(name):
                    self.subs.append(Unit(name, [], self.whole(goal, start, end)))
                return [Line("SET", [start, grip]), Line("SET", [end, put]), Line("CALL", [name])]
            case "each":
                return self.sub(goal.part, goal, self.whole(goal, grip, put))
            case _:
                return self.whole(goal, grip, put)

    def again(self, lines: list[Line]) -> list[Line]:
        """Return lines once more, as new ones."""
        return [Line(line.word, [*line.args]) for line in lines]

    def known(self, name: str) -> bool:
        """Return whether there is such a subroutine."""
        return any(unit.name == name for unit in self.subs)

    def heights(self, goal: Goal) -> list[str]:
        """Return heights as arguments."""
        low, high = goal.rise_mm
        return [f"{round((low + self.a.rise * (high - low)) / 10) * 10}"]

    def sub(self, word: str, goal: Goal, lines: list[Line]) -> list[Line]:
        """Put lines into a subroutine of their own, and call it."""
        name = self.names.place(f"{word}.sub", word if not self.a.own_names else "")
        self.subs.append(Unit(name, [], lines + self.ending()))
        return [Line("CALL", [name])]

    def ending(self) -> list[Line]:
        """Return what stands at the end of subroutines."""
        return [Line("RETURN")] if self.a.inner == "return" else []

    def carry(self, name: str, goal: Goal, high: bool) -> Unit:
        """Return a subroutine for the whole way of a thing."""
        start, end = self.names.of("from"), self.names.of("to")
        params = [start, end]
        lines = self.whole(goal, start, end)
        if high:
            params.append(self.names.of("height"))
            up = next(line for line in lines if line.word in ("DEPART", "DEPARTS"))
            up.args = [params[-1]]
        return Unit(name, params, lines + self.ending())

    def lecture(self, goal: Goal, grip: str, put: str) -> list[Line]:
        """Return calls of the lecture's subroutines."""
        units = lecture_units(self.year)
        if not self.known(units[0].name):
            if self.draw.random() < 0.3:  # typed without its comments
                for unit in units:
                    unit.body = [line for line in unit.body if line.word != "NOTE"]
                    for line in unit.body:
                        line.note = ""
            self.subs += units
        safe = [Line("MOVE", [self.safe()])] if self.job.wants_safe else []
        if len(units) == 1:
            if self.job.wants_safe:  # as it stands it would not reach over the oven
                sub = self.known_unit(units[0].name)
                if not any(line.word == "MOVE" for line in sub.body):
                    at = 1 + [line.word for line in sub.body].index("DEPARTS")
                    sub.body.insert(at, Line("MOVE", [self.safe()]))
            return [*safe, Line("CALL", [units[0].name, grip, put])]
        return [
            *safe,
            Line("CALL", [units[0].name, grip]),
            *self.again(safe),
            Line("CALL", [units[1].name, put]),
        ]

    def known_unit(self, name: str) -> Unit:
        """Return a subroutine that is there."""
        return next(unit for unit in self.subs if unit.name == name)

    def by_array(self, goals: list[Goal]) -> list[Line]:
        """Return a loop over things, with what it needs before it."""
        start, end, i = (self.names.of(one) for one in ("from", "to", "count"))
        sets = [
            line
            for k, goal in enumerate(goals, 1)
            for line in (
                Line("SET", [f"{start}[{k}]", self.taught.name(goal.grip)]),
                Line("SET", [f"{end}[{k}]", self.taught.name(goal.put)]),
            )
        ]
        if self.draw.random() < 0.5:
            sets.sort(key=lambda line: line.args[0].startswith(end))
        if self.a.inner == "args":
            name = self.names.of("carry")
            self.subs.append(self.carry(name, goals[0], high=False))
            body = [Line("CALL", [name, f"{start}[{i}]", f"{end}[{i}]"])]
            if self.job.wants_safe:
                body.insert(0, Line("MOVE", [self.safe()]))
        else:
            body = self.whole(goals[0], f"{start}[{i}]", f"{end}[{i}]")
        sets += self.counted(i, len(goals), body)
        for line in sets:
            line.part = "cans"
        return sets

    def counted(self, i: str, count: int, body: list[Line]) -> list[Line]:
        """Return a loop as this author writes loops."""
        more = Line("LET", [i, f"{i}+1"])
        match self.shape:
            case "for":
                loop = self.line("FOR", [i, "1", f"{count}"], "loop")
                loop.body = body
                return [loop]
            case "while":
                loop = self.line("WHILE", [f"{i} <= {count}"], "loop")
                loop.body = [*body, more]
                return [Line("LET", [i, "1"]), loop]
            case _:
                label = self.draw.choice(("10", "100", "1", "20"))
                body[0].label = label
                return [
                    Line("LET", [i, "1"]),
                    *body,
                    more,
                    Line("IFGOTO", [f"{i} <= {count}", label]),
                ]

    def speed(self, which: str) -> list[Line]:
        """Return a change of speed before a motion near things or after it."""
        a = self.a
        about = "fast" if which == "fast" else "slow"
        percent = {"fast": a.fast, "slow": a.slow, "slower": a.slower}[which]
        match a.speeds:
            case "next" if which != "fast":
                return [self.line("SPEED", [f"{percent}"], about)]
            case "switch":
                return [self.line("SPEED", [f"{percent}", "ALWAYS"], about)]
            case "units" if which != "fast":
                return [self.line("SPEED", [f"{percent * 10}", "MMPS"], about)]
            case _:
                return []

    def pick(self, goal: Goal, start: str) -> list[Line]:
        """Return how a thing is fetched."""
        a = self.a
        low, high = goal.rise_mm
        rise = round((low + a.rise * (high - low)) / 10) * 10
        straight = goal.is_straight
        above = a.above_grip if not straight else min(a.above_grip, 150)
        found = self.near(goal, start, above, a.approach, "above")
        if a.opens in ("each", "both"):
            found.insert(self.draw.randrange(2), self.line("OPENI", [], "start"))
        found += self.speed("slow")
        found.append(self.line(a.down if not straight else "MOVES", [start], "down"))
        found += self.hand(a.grips, "grip", goal.part)
        up = "DEPARTS" if straight or goal.part in ("dish", "pizza") else a.up
        found.append(self.line(up, [f"{rise}"], "up"))
        return found + self.speed("fast")

    def place(self, goal: Goal, end: str) -> list[Line]:
        """Return how a thing is set down."""
        a = self.a
        low, high = goal.above_mm
        above = min(max(a.above_put, low), high)
        found: list[Line] = []
        if not goal.lands:
            over = "APPROS" if goal.is_straight else a.approach
            found += self.near(goal, end, above, over, "over")
        found += self.speed("slower")
        down = "MOVES" if goal.part in ("dish", "pizza") or goal.is_straight else a.down
        found.append(self.line(down, [end], "put"))
        found += self.hand("OPENI" if a.grips == "CLOSEI" else "OPEN", "open", goal.part)
        away = a.away if not goal.is_straight else max(a.away, 150)
        found.append(self.line("DEPARTS", [f"{away}"], "away"))
        return found + self.speed("fast")

    def near(self, goal: Goal, name: str, height: int, word: str, about: str) -> list[Line]:
        """Return how one comes near a place."""
        plain = [self.line(word, [name, f"{height}"], about, goal.part)]
        if not self.a.points or goal.is_straight or goal.part in ("dish", "pizza"):
            return plain
        over = self.taught.above(name, height)
        if over:
            return [self.line("MOVE", [over], about, goal.part)]
        over = self.names.of("height")
        by = f"SHIFT({name} BY 0,0,{height})"
        return [Line("SET", [over, by]), self.line("MOVE", [over], about, goal.part)]

    def hand(self, word: str, about: str, part: str) -> list[Line]:
        """Return how the hand is closed or opened."""
        a = self.a
        found = [Line("BREAK")] if a.breaks or word in ("OPEN", "CLOSE") else []
        found.append(self.line(word, [], about, part))
        if word in ("OPEN", "CLOSE"):
            found.append(Line("DELAY", [f"{max(a.pause_s, 0.5):g}"]))
        elif a.pause_s:
            found.append(Line("DELAY", [f"{a.pause_s:g}"]))
        return found

    def whole(self, goal: Goal, start: str, end: str) -> list[Line]:
        """Return the whole way of a thing, from where it is to where it belongs."""
        found = self.pick(goal, start)
        if self.job.wants_safe:
            found.insert(0, Line("MOVE", [self.safe()]))
        if goal.ways:
            if self.a.speeds != "none":
                found.append(Line("SPEED", [f"{min(self.a.fast, 60)}", "ALWAYS"]))
            for key, stops in goal.ways:
                found.append(self.line("MOVES", [self.taught.name(key)]))
                found += [Line("BREAK")] * stops
        elif self.job.wants_safe or (self.a.safe == "between" and self.draw.random() < 0.7):
            found.append(self.line("MOVE", [self.safe()], "safe"))
        found += self.place(goal, end)
        if goal.ways and self.a.speeds != "none":
            found.append(Line("SPEED", [f"{self.a.fast}", "ALWAYS"]))
        return found
