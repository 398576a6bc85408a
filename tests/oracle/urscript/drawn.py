"""Programs of VAL-II drawn by chance from a number: calls, loops, jumps, lists, inputs, motions."""

from random import Random

PLACES = """.LOCATIONS
safe 460 50 220 90 90 0
left 440 110 250 85 88 5
right 470 -60 240 95 93 -8
high 430 20 300 90 84 12
turn 12 -9 7 90 -86 6
#j 10 -80 95 -100 -85 5
.END
"""
PUMA560 = """.LOCATIONS
safe 460 -30 0 90 90 0
left 440 120 20 85 88 5
right 470 -180 40 95 93 -8
high 430 -20 60 90 84 12
turn 12 -9 7 90 -86 6
#j 10 -80 100 5 40 5
.END
"""
# of V+: variables of its own, in a program that is called from two places
AUTO = """.PROGRAM main()
  AUTO k, x
  x = 40
  MOVE safe
  FOR k = 1 TO 2
    CALL up(x, k)
    MOVES safe
  END
  CALL up(x, k)
  TYPE x, k
.END
.PROGRAM up(by, n)
  AUTO k, x
  x = 1
  FOR k = 1 TO n
    DEPARTS by / 4
    x = x + k
    by = by + x
  END
.END
.LOCATIONS
safe 460 50 200 0 180 0
.END
"""
NAMES = ("safe", "left", "right", "high")


class _Writer:
    def __init__(self, draw: Random) -> None:
        self.draw = draw
        self.counters = 0
        self.labels = 0

    def number(self, depth: int = 2) -> str:
        draw = self.draw
        if depth == 0 or draw.random() < 0.4:
            return draw.choice(("x", "y", "m[1]", "m[i]", "2", "0.5", "-3", "7"))
        one, other = self.number(depth - 1), self.number(depth - 1)
        return draw.choice(
            (
                f"({one}+{other})",
                f"({one}-{other})",
                f"({one}*0.5)",
                f"INT({one})",
                f"ABS({one})",
                f"MIN({one},{other})",
                f"MAX({one},{other})",
                f"SIGN({one})",
                f"SIN({one})",
                f"({one} MOD 3)",
                f"({one} > {other})",
                "DX(p)",
                "DISTANCE(p,safe)",
            )
        )

    def small(self) -> str:
        return f"(({self.number(1)}) MOD 9)"

    def place(self) -> str:
        draw = self.draw
        name = draw.choice((*NAMES, "p", "q[1]", "q[i]"))
        return draw.choice(
            (
                name,
                name,
                f"{name}:TRANS({self.small()}, 4, -3, 90, -90, 5)",
                f"SHIFT({name} BY {self.small()}, -6, {self.small()})",
                f"{name}:turn",
                f"{name}:INVERSE(turn)",
            )
        )

    def condition(self) -> str:
        signal = self.draw.choice((1001, -1001, 1002, -1002))
        return self.draw.choice(
            (
                f"SIG({signal})",
                f"SIG({signal}) AND (x > 1)",
                f"x > {self.number(1)}",
                "NOT (y <> 2)",
            )
        )

    def body(self, depth: int, *, args: bool = False) -> list[str]:
        count = self.draw.randint(2, 5)
        return [row for _ in range(count) for row in self.step(depth, args=args)]

    def motion(self) -> list[str]:
        draw = self.draw
        at = draw.choice(
            (
                f"MOVE {self.place()}",
                f"MOVES {self.place()}",
                f"APPRO {draw.choice(NAMES)}, {draw.randint(5, 40)}",
                f"APPROS {draw.choice(NAMES)}, {draw.randint(5, 40)}",
                f"DEPARTS {draw.randint(5, 20)}",
                f"DRAW {draw.randint(-9, 9)}, 5, {draw.randint(0, 9)}",
                "MOVE #j",
                "DELAY 0.2",
            )
        )
        behind = draw.choice(
            ([], [], [f"SIGNAL {draw.choice((1, -1, 2, -2, 2001))}"], [f"x = {self.number()}"])
        )
        return [at, *behind]

    def step(self, depth: int, *, args: bool) -> list[str]:
        draw = self.draw
        kinds = ["move", "move", "move", "set", "set", "place", "signal", "speed", "hand", "type"]
        kinds += ["if", "for", "goto", "case", "do", "call", "wait"] if depth else []
        self.counters += 1
        k = self.counters
        match draw.choice(kinds):
            case "move":
                return self.motion()
            case "set":
                name = draw.choice(("x", "y", "m[1]", "m[i]", *(["n"] if args else [])))
                return [f"{name} = {self.number()}"]
            case "place":
                if args:
                    return [
                        f"SET at = {draw.choice(NAMES)}:TRANS({self.small()}, 0, 5, 90, -90, 0)"
                    ]
                name = draw.choice(("p", "q[1]", "q[i]"))
                return [f"SET {name} = SHIFT({draw.choice(NAMES)} BY {self.small()}, 3, 8)"]
            case "signal":
                return ["BREAK", f"SIGNAL {draw.choice((1, -1, 2, -2, 3))}"]
            case "speed":
                return [draw.choice(("SPEED 70", "SPEED 120 MMPS", "SPEED 50 ALWAYS"))]
            case "hand":
                return [draw.choice(("OPENI", "RELAXI"))]
            case "type":
                return [f"TYPE {self.number()}", 'TYPE "here"']
            case "if":
                other = ["ELSE", *self.body(depth - 1, args=args)] if draw.random() < 0.6 else []
                then = self.body(depth - 1, args=args)
                return ["BREAK", f"IF {self.condition()} THEN", *then, *other, "END"]
            case "for":
                ends = draw.choice(("1 TO 3", "3 TO 1 STEP -1", "0 TO 2 STEP 2"))
                return [f"FOR k{k} = {ends}", *self.body(depth - 1, args=args), "END"]
            case "goto":
                self.labels += 10
                label = self.labels
                inner = self.body(depth - 1, args=args)
                if draw.random() < 0.5:
                    again = [f"c{k} = c{k} + 1", f"IF c{k} < 3 GOTO {label}"]
                    return [f"c{k} = 0", f"{label} {inner[0]}", *inner[1:], *again]
                return ["BREAK", f"IF {self.condition()} GOTO {label}", *inner, f"{label} y = y+1"]
            case "case":
                groups = [row for n in (1, 2) for row in (f"VALUE {n}:", *self.body(0, args=args))]
                return ["CASE INT(x) OF", *groups, "ANY", *self.body(0, args=args), "END"]
            case "do":
                inner = self.body(depth - 1, args=args)
                return [f"c{k} = 0", "DO", *inner, f"c{k} = c{k}+1", f"UNTIL c{k} > 1"]
            case "call" if not args:
                first = draw.choice(("u", "w", f"({self.number()}+0)"))
                second = draw.choice(("g", "g", "safe:turn"))
                return [f"CALL part({first}, {second})"]
            case "wait":
                return ["BREAK", "WAIT SIG(1003)"]
            case _:
                return self.motion()


def drawn(number: int, places: str = PLACES) -> str:
    """Return the file of the program of a number, with the places that an arm reaches."""
    writer = _Writer(Random(f"urscript {number}"))
    begun = [
        "x = 1",
        "y = 2",
        "u = 3",
        "w = 1",
        "SET g = high",
        "i = 2",
        "m[1] = 1",
        "m[2] = 2",
        "SET p = safe",
    ]
    begun += ["SET q[1] = left", "SET q[2] = right", "SPEED 60 ALWAYS", "OPENI", "MOVE safe"]
    main = [*begun, *(row for _ in range(3) for row in writer.body(2)), "MOVE g", "TYPE u, w, x"]
    writer.labels = 0
    part = ["MOVES at:TRANS(0, 0, -5, 90, -90, 0)", *writer.body(1, args=True), "n = n + 1"]
    rows = [".PROGRAM main", *main, ".END", ".PROGRAM part(n, at)", *part, ".END"]
    return "\n".join(rows) + "\n" + places
