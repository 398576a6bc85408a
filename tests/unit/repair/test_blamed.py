"""The line of the mistake is blamed: not one that makes up for it elsewhere."""

from pathlib import Path

import pytest

from tests.golden.examples import EXAMPLES
from tests.mutants.given import FOLDER
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.mending.behaviour import mended
from vrts.pipeline.request import Request
from vrts.pipeline.settings import load_task

OTHERS = FOLDER / "solutions"
CANS, DISH, WAY, PROJECT = (EXAMPLES[n] / "solution.v2" for n in range(4))
WRONG = {  # of a program: what is right there, what is written instead, and what mends it
    "where a straight way begins": (
        *(WAY, "105.00  -180.00    90.00    90.00", "105.00  -180.00   -90.00    90.00"),
        "90",
    ),
    "how a thing is held that touches something": (
        DISH,
        "-227.00  -268.00",
        "-227.00  -258.00",
        "-268",
    ),
    "a step that comes to another place": (
        *(DISH, "        MOVES dish_grip", "        READY\n        MOVES dish_grip"),
        "",
    ),
    "where a thing stands as the scene says": (
        *(PROJECT, "pizza            1080.00  -350.00", "pizza            1080.00  -365.00"),
        "-350",
    ),
    "a subscript below the first": (PROJECT, "SET goal[1]", "SET goal[0]", "1"),
    "a distance with the other sign": (
        PROJECT,
        "stand_mid:rim, 250)",
        "stand_mid:rim, -250)",
        "250",
    ),
    "a shift along another axis": (PROJECT, "BY 0,0,20)", "BY 0,20,0)", "0, 20"),
    "one header, and not all calls": (
        CANS,
        "carry(start, goal)",
        "carry(goal, start)",
        "start, goal",
    ),
    "what counts": (OTHERS / "01-while.v2", "n = n+1\n", "n = n+10\n", "1"),
    "where a way out begins before a straight way": (
        *(
            WAY,
            "850.00  -430.00  -225.00    90.00    90.00",
            "850.00  -430.00  -225.00   -90.00    90.00",
        ),
        "90",
    ),
    "one more call of a program": (
        *(CANS, "        CALL carry(can2_grip, base1_put)\n", ""),
        "CALL carry(can2_grip, base1_put)",
    ),
    "an element among others": (
        *(OTHERS / "03-corners.v2", "        SET way[2] = gap1\n", ""),
        "SET way[2] = gap1",
    ),
    "a call in a loop that counts": (
        *(OTHERS / "04-lists.v2", "          CALL carry(i)\n", ""),
        "CALL carry(i)",
    ),
    "a compound whose first part is missing": (
        *(OTHERS / "04-lists.v2", "stone:INVERSE(pizza):pizza_grip", "INVERSE(pizza):pizza_grip"),
        "stone:INVERSE(pizza):pizza_grip",
    ),
}
CHEAP = 3  # of them in the usual run


@pytest.mark.thorough
@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=() if k < CHEAP else pytest.mark.thorough)
        for k, name in enumerate(WRONG)
    ],
)
def test_the_mistake_is_mended_where_it_is(name: str) -> None:
    program, right, wrong, new = WRONG[name]
    text = program.read_text(encoding="utf-8")
    assert text.count(right) >= 1
    found = mended(_request(program, text.replace(right, wrong, 1)))
    best = found.repairs[0].change
    assert best.new == new
    assert abs(best.line - text[: text.index(right)].count("\n") - 1) <= 1


def _request(program: Path, text: str) -> Request:
    number = program.stem[:2] if program.parent == OTHERS else program.parent.name[:2]
    example = next(each for each in EXAMPLES if each.name.startswith(number))
    return Request(ProgramFile(text.encode(), "p.v2"), load_task(example / "task.toml"))
