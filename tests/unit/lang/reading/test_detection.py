"""Which language a file is in: its text decides, not the end of its name."""

import pytest

from vrts.base.source import SourceFile
from vrts.lang.reading.detection import detect
from vrts.lang.reading.evidence import MOST_TEXT

VAL2_TEXT = """.PROGRAM main
        SPEED 50 ALWAYS
        FOR i = 1 TO 3
          APPRO part:grip, 50
          MOVES part:grip
          CLOSEI
          DEPARTS 50
        END
        IF SIG(1001) THEN
          SET q = SHIFT(part BY 1, 2, 3)
        END
.END
.LOCATIONS
part 1 2 3 90 -90 0
.END
"""
VPLUS_TEXT = """.PROGRAM server()
        AUTO lun, $text
        ATTACH (lun, 4) "TCP"
        FOPEN (lun, 16) "/LOCAL_PORT 43"
        READ (lun) $text
        MOVES part
.END
"""
AS_TEXT = """.PROGRAM pick(.n) #12
  SPEED 100 MM/S ALWAYS
  .x = DX(HERE)
  JMOVE #[0,0,-90,0,-90,0]
  LMOVE part + TRANS(0,0,50)
  SWAIT 1001
.END
"""
VAL_TEXT = """.PROGRAM OLD
   SETI N = 0
10 APPRO FEED,50
   GOSUB GRIP
   SETI N = N+1
   IF N LT 5 THEN 10
   TYPEI N
.END
"""
TEXTS = {"val2": VAL2_TEXT, "vplus": VPLUS_TEXT, "as": AS_TEXT, "val": VAL_TEXT}


@pytest.mark.parametrize("name", ["main.v2", "main.pg", "main.as", "main", "main.txt"])
@pytest.mark.parametrize("dialect", TEXTS)
def test_the_text_decides(dialect: str, name: str) -> None:
    found, note = detect(SourceFile(name, TEXTS[dialect]))
    assert found.name == dialect
    assert (note is None) is (dialect == "val2")


def test_the_end_of_a_name_breaks_ties() -> None:
    text = "inTool = 1009\n"
    assert detect(SourceFile("signals.as", text))[0].name == "as"
    assert detect(SourceFile("signals.v2", text))[0].name == "val2"


def test_where_it_is_close_both_readings_are_said() -> None:
    found, note = detect(SourceFile("main.v2", ".PROGRAM main()\n  ATTACH\n  n = 1\n.END\n"))
    assert found.name == "val2"
    assert note is not None
    assert note.help == ("`--dialect vplus` reads it as V+, `--dialect val2` as VAL-II",)


def test_words_in_remarks_and_strings_tell_nothing() -> None:
    text = VAL2_TEXT.replace(".END\n", '; LMOVE a\n  TYPE "JMOVE #[1,2]"\n.END\n', 1)
    assert detect(SourceFile("main.v2", text)) == (detect(SourceFile("x.v2", VAL2_TEXT))[0], None)


def test_a_long_file_is_told_by_its_beginning() -> None:
    text = VAL2_TEXT + ";\n" * MOST_TEXT + AS_TEXT
    assert detect(SourceFile("main.v2", text))[0].name == "val2"
