"""Answers as JSON, compressed where that is worth it, and refusals."""

import gzip
from collections.abc import Sequence
from typing import Final

import msgspec
from starlette.requests import Request
from starlette.responses import Response

from vrts.base.diagnostic import Diagnostic
from vrts.desk.front.shapes import with_shapes
from vrts.live.front.bodies import JSON

_SMALL: Final = 1500  # bytes that are not worth compressing
_LEVEL: Final = 3


def told(request: Request, value: object, status: int = 200) -> Response:
    """Return a value as an answer."""
    return told_bytes(request, msgspec.json.encode(value), status)


def told_bytes(request: Request, data: bytes, status: int = 200) -> Response:
    """Return JSON as an answer, with a shape for each character."""
    data = with_shapes(data)
    headers = {"vary": "accept-encoding"}
    if len(data) > _SMALL and "gzip" in request.headers.get("accept-encoding", ""):
        headers["content-encoding"] = "gzip"
        data = gzip.compress(data, _LEVEL, mtime=0)
    return Response(data, status, headers, JSON)


def refusal(status: int, text: str, **more: object) -> Response:
    """Return that something is refused, in one sentence."""
    data = with_shapes(msgspec.json.encode({"error": text, **more}))
    return Response(data, status, media_type=JSON)


def diagnosed(found: Sequence[Diagnostic]) -> Response:
    """Return that something is refused for what it says."""
    wrong = [one for one in found if one.is_error] or list(found)
    lines = [{"headline": one.headline, "help": "; ".join(one.help)} for one in wrong]
    return refusal(422, wrong[0].headline if wrong else "refused", diagnostics=lines)
