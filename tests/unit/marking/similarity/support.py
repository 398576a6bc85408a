"""Programs for tests of similarity: a program, copies in disguise, and others."""

from pathlib import Path

from vrts.pipeline.files import CHECKOUT

EXAMPLES = CHECKOUT / "examples"

ORIGINAL = """\
.PROGRAM main()
        SPEED 80 ALWAYS
        OPENI
        MOVE safe
        FOR i = 1 TO 3
          IF SIG(1001) THEN
            CALL fetch(part[i], 120)
            CALL place(tray:slot[i], 60)
          ELSE
            TYPE "nothing there", i
            DELAY 0.5
          END
        END
        MOVE safe
.END
.PROGRAM fetch(start, height)
        APPRO start, height
        SPEED 20
        MOVES start
        CLOSEI
        IF HAND < 12 THEN
          TYPE "missed it"
          GOTO 50
        END
        DEPARTS height
   50   RETURN
.END
.PROGRAM place(goal, height)
        x = DX(goal)+20
        y = DY(goal)-4
        SET above = TRANS(x,y,200,90,90,0)
        MOVE above
        WHILE SIG(1002) DO
          DELAY 0.1
        END
        APPROS goal, height
        SPEED 10
        MOVES goal
        OPENI
        DEPARTS 2*height
.END
.LOCATIONS
safe   905.00  35.00 100.00 90.00 90.00 0.00
tray   512.30 -81.70 -20.00 45.00 90.00 0.00
.END
"""


def disguised() -> str:
    """Return the original with other names, numbers and order, and with comments."""
    head, _, rest = ORIGINAL.partition(".PROGRAM fetch")
    fetch, _, rest = rest.partition(".PROGRAM place")
    place, _, locations = rest.partition(".LOCATIONS")
    text = f".PROGRAM place{place}.PROGRAM fetch{fetch}{head}.LOCATIONS{locations}"
    names = {"fetch": "hole", "place": "stelle", "start": "von", "goal": "nach", "height": "hoch"}
    names |= {"above": "drueber", "part": "teil", "tray": "brett", "slot": "platz", "safe": "weg"}
    for old, new in names.items():
        text = text.replace(old, new)
    numbers = {"120": "135", " 60": " 70", "0.5": "0.7", "512.30": "500.00", "-81.70": "-80.00"}
    for old, new in numbers.items():
        text = text.replace(old, new)
    text = text.replace("\n", "\n\n").replace("OPENI\n", "openi   ; let it go\n")
    return text.replace("MOVES ", "MOVES    ")


def independent() -> dict[str, bytes]:
    """Return the solutions of the examples: programs for other tasks, by other means."""
    return {path.parent.name: path.read_bytes() for path in _solutions()}


def _solutions() -> list[Path]:
    return sorted(EXAMPLES.glob("*/solution.v2"))
