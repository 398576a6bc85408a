"""Programs that carry things about, drawn by chance: nearly right, in all that rules depend on."""

from random import Random
from typing import NamedTuple

from tests.whole_programs.settings import setting
from vrts.base.oat import components
from vrts.base.pose import translation
from vrts.scene.model import FaultKind, PlannedFault, Scenario

SCENES = {
    "cans-on-bases": (("can1", "can2"), ("base1", "base2", "can1", "can2")),
    "final-project": (("can1", "can2", "can3", "dish"), ("base1", "base2", "can1", "can2")),
    "dish-on-stand": (("dish",), ("stand",)),
}  # what is taken, what it is put on
HEIGHT = 0.115  # [m] of a can
BESIDE = (0.0, 0.0, 0.0, 0.15, -0.25, 0.5, -0.8, 1.3, -6.0, 25.0)  # [mm] of a grip or a put
ABOVE = (0.0, 0.0, 0.0, -0.1, -0.3, -0.7, -1.15, -1.4, 0.4, 3.0, 40.0)  # [mm]
AWAY = ("OPENI", "BRAKE\nOPENI", "DEPARTS 80", "RELAXI", "HALT", "CLOSEI", "BRAKE\nDEPARTS 30")


class Carried(NamedTuple):
    """A program that carries things about, and what happens meanwhile."""

    text: str
    scene: str
    scenario: Scenario


def carried(number: int) -> Carried:
    """Return the program of a number."""
    draw = Random(f"carried {number}")
    scene = draw.choice((*SCENES, "cans-on-bases"))
    writer = _Writer(draw, scene)
    lines = [f"SPEED {draw.choice((100, 60))} ALWAYS"]
    lines.append(draw.choice(("OPENI", "OPENI", "OPENI", "OPEN")))
    watches = draw.random() < 0.5
    if watches:
        lines.append("REACTI 1001, away")
    for _ in range(draw.randint(1, 3)):
        lines += writer.carry()
    lines.append(draw.choice(("DEPARTS 50", "DEPART 120", "BREAK", "OPENI", "CLOSEI")))
    text = ".PROGRAM main\n" + "\n".join(lines) + "\n.END\n"
    text += f".PROGRAM away\n{draw.choice(AWAY)}\n.END\n"
    text += ".LOCATIONS\n" + "\n".join(writer.places) + "\n.END\n"
    faults: tuple[PlannedFault, ...] = ()
    if draw.random() < 0.15:
        faults = (PlannedFault(draw.uniform(1.0, 8.0), FaultKind.GRIPPER_SLIPS),)
    inputs = ((draw.uniform(0.5, 10.0), 1001, True),) if watches else ()
    speed = draw.choice((100.0, 100.0, 100.0, 100.0, 60.0))
    return Carried(text, scene, Scenario(inputs=inputs, faults=faults, monitor_speed=speed))


class _Writer:
    """Writes ways of things, each between places of its own."""

    def __init__(self, draw: Random, scene: str) -> None:
        self.draw, self.scene = draw, scene
        self.places: list[str] = []

    def carry(self) -> list[str]:
        """Return the lines that carry one thing."""
        draw = self.draw
        takes, puts = SCENES[self.scene]
        thing = draw.choice(takes)
        dish = "stand" if self.scene != "cans-on-bases" else "base1"
        on = dish if thing == "dish" else draw.choice([name for name in puts if name != thing])
        start, goal = self._place(f"{thing}_grip"), self._place(on)
        close = draw.choice(("CLOSEI", "CLOSEI", "CLOSEI", "CLOSE", "GRASP 5"))
        open_ = draw.choice(("OPENI", "OPENI", "OPEN", "RELAXI"))
        lines = [f"APPRO {start}, {draw.choice((120, 60, 150))}", f"MOVES {start}"]
        if draw.random() < 0.2:
            lines[0] = f"APPROS {start}, 90"
        lines += [draw.choice(("BREAK", "")), close, f"DEPARTS {draw.choice((200, 200, 60, 3))}"]
        lines += [f"APPRO {goal}, {draw.choice((120, 120, 40))}", f"MOVES {goal}", open_]
        if draw.random() < 0.2:
            lines.append(draw.choice(("DELAY 0.4", "CLOSEI", "DRIVE 6, 30, 40", "OPENI")))
        lines.append(draw.choice(("DEPARTS 120", "DEPARTS 120", "DEPART 80")))
        return [line for line in lines if line]

    def _place(self, name: str) -> str:
        """Return the name of a place near one of the scene."""
        scene, draw = setting(self.scene).scene, self.draw
        known = scene.locations
        if name == "stand":
            near = known["stand_mid"]
        elif name.endswith("_grip"):
            near = known[name]
        elif f"{name}_put" in known:
            near = known[f"{name}_put"]
        else:
            near = translation(0.0, 0.0, HEIGHT) @ known[f"{name}_grip"]
        beside, above = draw.choice(BESIDE), draw.choice(ABOVE)
        turn = draw.choice((0.0, 0.0, 20.0))
        x, y, z, o, a, t = components(near)
        along = draw.random() < 0.5
        place = (x + along * beside, y + (not along) * beside, z + above, o + turn, a, t)
        self.places.append(f"p{len(self.places)} " + " ".join(f"{n:.4f}" for n in place))
        return f"p{len(self.places) - 1}"
