"""Patches of what certifies motion that futures share: a fault would call what touches free."""

from tests.sabotage.patch import Patch

ROOM = "vrts/prove/certify/"
HOPES = "tests/unit/prove/certify/test_hopes.py"
BESIDE = "tests/unit/prove/explore/test_beside.py"
SEEN = "tests/unit/prove/certify/test_seen.py"

CERTIFIED: tuple[Patch, ...] = (
    Patch(
        "fingers that let go never come free",
        ROOM + "parting.py",
        "if self._gap(machine, one, time_s) > SEPARATED:",
        "if self._gap(machine, one, time_s) > 1.0:",
        (HOPES,),
    ),
    Patch(
        "fingers are free as soon as they let go",
        ROOM + "parting.py",
        "if self._gap(machine, one, time_s) > SEPARATED:",
        "if self._gap(machine, one, time_s) > -1.0:",
        (HOPES,),
    ),
    Patch(
        "pads may press into what the closing hand may not grasp",
        ROOM + "laying.py",
        "            if not allowed:\n",
        "            if not allowed and not closing:\n",
        (HOPES,),
    ),
    Patch(
        "what is held may press on all that it may come to stand on",
        ROOM + "laying.py",
        "parts = other.body in (body.before, body.after)",
        "parts = other.still",
        (HOPES,),
    ),
    Patch(
        "a touch that may be excused is not told of futures that come later",
        ROOM + "certifier.py",
        "if situation.hopes:",
        "if situation.hopes and not self._hopes:",
        (HOPES,),
    ),
    Patch(
        "what is pressed too deep is excused too",
        ROOM + "looking.py",
        "hits += _lowered(new, some, hits)",
        "pass",
        (HOPES,),
    ),
    Patch(
        "what is excused later is not told where it was certified late",
        ROOM + "certifier.py",
        "return way in self._open or way in self._open_away or way in self._hoped",
        "return way in self._open or way in self._hoped",
        (HOPES,),
    ),
    Patch(
        "a search goes on for longer where something was certified late",
        "vrts/prove/explore/touches.py",
        "self.wrong_since = min(self.wrong_since, states)",
        "pass",
        (BESIDE,),
    ),
    Patch(
        "what falls is not looked at",
        ROOM + "situation.py",
        "        if one.still:\n            continue\n        supports",
        "        if one.lie is not Lie.HELD:\n            continue\n        supports",
        (HOPES,),
    ),
    Patch(
        "a part that was looked at in one place is looked at nowhere else",
        ROOM + "seen.py",
        "if part in its:",
        "if its:",
        (SEEN,),
    ),
    Patch(
        "motions laid end to end hide each other's touches",
        "vrts/check/collision/search/known_events.py",
        "return group * (len(self.begins) + 1) + since",
        "return group",
        ("tests/unit/check/collision/search/test_search_begins.py",),
    ),
)
