"""What a comparison of programs says about one student: nobody else is named in it."""

from collections.abc import Collection, Iterator

import msgspec

from vrts.marking.layout import Layout
from vrts.marking.similarity.copies import LARGEST
from vrts.marking.similarity.files import DATA
from vrts.marking.similarity.groups import Group
from vrts.marking.similarity.ranking import Ranking

SOMEBODY = "another student"
ME = "you"


def likeness_of(layout: Layout, ids: Collection[str]) -> dict[str, object] | None:
    """Return the groups and pairs that a student is in; None: nothing was compared.

    Args:
        layout: Of the marking.
        ids: By which the comparison names the student, `FOLDER/ID` where it was a corpus.
    """
    place = layout.staff / DATA
    try:
        if place.is_symlink() or place.stat().st_size > LARGEST:
            return None
        found = msgspec.json.decode(place.read_bytes(), type=Ranking)
    except (OSError, msgspec.MsgspecError):  # it was not compared, or by another vrts
        return None
    return {
        "note": found.note,
        "compared": found.compared,
        "groups": [_group(one, ids) for one in found.groups if set(ids) & {*one.members}],
        "pairs": [
            {"with": SOMEBODY, "score": one.score, "code": one.code, "taught": one.taught}
            for one in found.pairs
            if one.first in ids or one.second in ids
        ],
    }


def _group(group: Group, ids: Collection[str]) -> dict[str, object]:
    return {
        "members": [ME if one in ids else SOMEBODY for one in group.members],
        "score": group.score,
        "strength": group.strength,
        "expected": group.expected,
        "links": list(_links(group, ids)),
    }


def _links(group: Group, ids: Collection[str]) -> Iterator[dict[str, object]]:
    """Yield how much alike two programs are, and what is alike in the student's own."""
    for number, link in enumerate(group.links):
        if link.first not in ids and link.second not in ids:
            continue
        told: dict[str, object] = {
            "with": SOMEBODY,
            "score": link.score,
            "strength": link.strength,
        }
        if number == 0:  # the evidence of a group is that of its strongest link
            first = link.first in ids
            told["alike"] = [
                {
                    "what": one.what,
                    "line": one.first_line if first else one.second_line,
                    "weight": one.weight,
                }
                for one in group.evidence
            ]
        yield told
