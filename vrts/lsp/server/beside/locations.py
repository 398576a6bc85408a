"""Locations that are dragged beside the text: whether the arm gets there, and the edit at the end.

Both name a location by the program it is used in, the file with its numbers, name and subscripts.
"""

import math
import re
from typing import Any, NamedTuple, cast

from lsprotocol import types
from pygls.exceptions import JsonRpcInvalidParams

from vrts.base.pose import Vector
from vrts.ir.module import Datum
from vrts.lang.names import key
from vrts.lsp.answers.placing import CannotMove, datum_of, moved, pose_at
from vrts.lsp.documents.documents import Document
from vrts.lsp.server.session import Session

_NEAR = "with the hand open, "


class _Asked(NamedTuple):
    uri: str
    file: str
    name: str
    subscripts: tuple[int, ...]
    at: Vector  # [mm]


def register(session: Session) -> None:
    """Answer what is asked while somebody drags."""

    @session.feature("vrts/reach")
    async def reach(server: Session, params: object) -> dict[str, Any]:
        """Return whether the tool gets to a location at another place, and how."""
        asked = _asked("vrts/reach", params)
        document = server.document(asked.uri)
        try:
            X_WT = pose_at(_found(server, document, asked)[1], asked.at)
        except CannotMove as problem:
            return {"reached": None, "text": str(problem)}
        text = await server.aside(lambda: server.reaching.text(document.path, X_WT))
        if not text:
            return {"reached": None, "text": "no task says in which scene"}
        first, *rest = text.splitlines()
        near = [row.removeprefix(_NEAR) for row in rest if row.startswith(_NEAR)]
        told = "; ".join((re.split("[;,]", first)[0], *near))
        return {"reached": first.startswith("reachable"), "text": told}

    @session.feature("vrts/moved")
    def move(server: Session, params: object) -> dict[str, Any]:
        """Return the edits that put a location elsewhere; the client carries them out."""
        asked = _asked("vrts/moved", params)
        try:
            document, datum = _found(server, server.document(asked.uri), asked)
            found = moved(datum, asked.at)
        except CannotMove as problem:
            return {"why": str(problem)}
        places = server.places(document)
        edits = [
            types.TextEdit(places.range(start, end), text) for start, end, text in found.changes
        ]
        return {
            "uri": server.uri(document),
            "version": server.version_of(document),
            "edits": edits,
            "numbers": list(found.numbers),
            "line": found.line,
        }


def _found(server: Session, document: Document, asked: _Asked) -> tuple[Document, Datum]:
    """Return the file of a location, which belongs to the program, and its line there."""
    group = [document] if asked.file == document.path else server.group(document)
    home = next((one for one in group if one.path == asked.file), None)
    if home is None:
        raise CannotMove("the file with its numbers does not belong to this program any more")
    return home, datum_of(home, asked.name, asked.subscripts)


def _asked(method: str, params: object) -> _Asked:
    """Return what is asked.

    Raises:
        JsonRpcInvalidParams: Something is missing, or is no name or number.
    """
    if not isinstance(params, dict):
        raise JsonRpcInvalidParams(f"`{method}`: what is asked is no object")
    given = cast("dict[str, Any]", params)
    texts = [given.get(field) for field in ("uri", "file", "name")]
    if not all(isinstance(text, str) and text and "\0" not in text for text in texts):
        raise JsonRpcInvalidParams(f"`{method}`: uri, file and name are texts")
    uri, file, name = cast("list[str]", texts)
    at, subscripts = _list(given.get("at")), _list(given.get("subscripts", []))
    if at is None or len(at) != 3 or not all(map(_is_number, at)):
        raise JsonRpcInvalidParams(f"`{method}`: at is three numbers of mm")
    if subscripts is None or not all(type(number) is int for number in subscripts):
        raise JsonRpcInvalidParams(f"`{method}`: subscripts are whole numbers")
    x, y, z = (float(number) for number in cast("list[float]", at))
    return _Asked(uri, file, key(name), tuple(cast("list[int]", subscripts)), (x, y, z))


def _list(value: object) -> list[object] | None:
    return cast("list[object]", value) if isinstance(value, list) else None


def _is_number(value: object) -> bool:
    number = isinstance(value, int | float) and not isinstance(value, bool)
    return number and math.isfinite(cast("float", value))
