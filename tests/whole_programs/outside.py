"""Small programs drawn by chance that look at inputs: they wait, branch, count, react, move."""

from random import Random

PLACES = ".LOCATIONS\na 900 200 100 90 90 0\nb 900 -200 100 90 90 0\nc 900 0 300 90 90 0\n.END\n"
INPUTS = (1001, 1002)


class _Writer:
    def __init__(self, draw: Random) -> None:
        self.draw = draw
        self.loops = 0

    def body(self, depth: int) -> list[str]:
        return [line for _ in range(self.draw.randint(1, 4)) for line in self.step(depth)]

    def condition(self) -> str:
        draw = self.draw
        signal = draw.choice((1001, -1001, 1002, -1002))
        kinds = (
            f"SIG({signal})",
            f"SIG({signal}) AND (n < 2)",
            f"SIG({signal}, 1)",
            "BITS(1001,2) > 1",
        )
        return draw.choice((*kinds, kinds[0], "n > 1"))

    def step(self, depth: int) -> list[str]:
        draw = self.draw
        kind = draw.choice(
            ("if", "if", "wait", "for", "move", "set", "count", "delay", "rest", "bad")
        )
        if kind in ("if", "for") and depth == 0:
            kind = "count"
        match kind:
            case "if":
                other = ["ELSE", *self.body(depth - 1)] if draw.random() < 0.5 else []
                return [f"IF {self.condition()} THEN", *self.body(depth - 1), *other, "END"]
            case "for":
                self.loops += 1
                last = draw.randint(1, 3)
                return [f"FOR i{self.loops} = 1 TO {last}", *self.body(depth - 1), "END"]
            case "wait":
                return [f"WAIT {self.condition()}"]
            case "move":
                return [f"{draw.choice(('MOVE', 'MOVES'))} {draw.choice('abc')}"]
            case "set":
                return [f"SIGNAL {draw.choice((1, -1, 2001, -2001))}"]
            case "count":
                return [draw.choice(("n = n+1", "n = 0", "n = n-1"))]
            case "delay":
                return [f"DELAY {draw.choice((0.02, 0.1))}", "BREAK"]
            case "rest":
                return [draw.choice(("WAIT", "BREAK", "IGNORE 1002"))]
            case _:
                return ["IF n == 3 THEN", "x = 1/(n-3)", "END"]


class _Asker(_Writer):
    """Writes programs that also look at analog inputs, ask, draw and grip."""

    def condition(self) -> str:
        draw = self.draw
        more = (
            "RANDOM > 0.4",
            f"ADC({draw.choice((1, 2))}) {draw.choice('<>')} {draw.choice((-300, 0, 700))}",
            "(ADC(1) > 700) AND SIG(1001)",
            "v > 2.5",
        )
        return draw.choice(more) if draw.random() < 0.5 else super().condition()

    def step(self, depth: int) -> list[str]:
        draw = self.draw
        match draw.choice(("as before",) * 4 + ("ask", "level", "grip", "move")):
            case "ask":
                return ['PROMPT "n ", n']
            case "level":
                return ["v = ADC(1)/204.8"]
            case "move":
                return [f"{draw.choice(('MOVE', 'MOVES'))} {draw.choice('abc')}"]
            case "grip":
                return ["OPENI", "APPRO grip, 60", "MOVES grip", "CLOSEI", "DEPARTS 60"]
            case _:
                return super().step(depth)


GRIP = "grip 800 -450 -225 90 90 0\n"  # a can of the scene `cans-on-bases`


def asking(number: int) -> str:
    """Return the file of a program of a number that also asks, draws and grips."""
    writer = _Asker(Random(f"asking {number}"))
    lines = ["n = 0", "v = 0", *writer.body(1)]
    other = writer.draw.random() < 0.2
    if other:
        lines.insert(2, "PCEXECUTE other")
    programs = [("main", lines)]
    if other:
        programs.append(("other", [f"WAIT {writer.condition()}", "SIGNAL 2001", "n = n+1"]))
    text = "".join(f".PROGRAM {name}\n" + "\n".join(body) + "\n.END\n" for name, body in programs)
    return text + PLACES.replace(".END", f"{GRIP}.END")


def looking(number: int) -> str:
    """Return the file of the program of a number."""
    draw = Random(f"looking {number}")
    writer = _Writer(draw)
    head = ["n = 0"]
    reacts = draw.random() < 0.4
    if reacts:
        head.append(f"{draw.choice(('REACT', 'REACTI'))} 1002, gone")
    other = draw.random() < 0.3
    if other:
        head.append("PCEXECUTE other")
    lines = [*head, *writer.body(2)]
    programs = [("main", lines)]
    if reacts:
        programs.append(("gone", ["n = n+1", *(["HALT"] if draw.random() < 0.3 else [])]))
    if other:
        programs.append(("other", [f"WAIT {writer.condition()}", "SIGNAL 2001", "n = n+1"]))
    text = "".join(f".PROGRAM {name}\n" + "\n".join(body) + "\n.END\n" for name, body in programs)
    return text + PLACES
