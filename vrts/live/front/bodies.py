"""Bodies of requests, read without trust, and of answers."""

import asyncio
from typing import Final, TypeVar

import msgspec
from starlette.requests import ClientDisconnect, Request
from starlette.responses import Response

from vrts.live.front.guard import refused

LONGEST_BODY: Final = 8 * 1024  # bytes
BODY_S: Final = 10.0  # until a body must have come, and longer for a long one
SLOWEST: Final = 16_000  # bytes a second
JSON: Final = "application/json"

Body = TypeVar("Body")


async def read_body(
    request: Request, kind: type[Body], *, longest: int = LONGEST_BODY, what: str = "body"
) -> Body | Response:
    """Return the JSON body of a request, or why it is refused.

    Args:
        request: The request.
        kind: What it has to be.
        longest: Bytes that are read.
        what: Is too long if there are more.
    """
    if request.headers.get("content-type", "").split(";")[0].strip() != JSON:
        return refused(415, "body", f"the body must be {JSON}")
    data = bytearray()
    try:
        async with asyncio.timeout(BODY_S + longest / SLOWEST):
            async for part in request.stream():
                data += part
                if len(data) > longest:
                    return refused(413, "body", f"the {what} is too long")
    except TimeoutError:
        return refused(408, "body", f"the {what} did not come in time", "try again")
    except ClientDisconnect:
        return Response(status_code=400)  # nobody is there to read it
    try:
        return msgspec.json.decode(data, type=kind)
    except msgspec.DecodeError as problem:
        return refused(400, "body", str(problem))


def as_json(value: object) -> Response:
    """Return an answer."""
    return Response(msgspec.json.encode(value), media_type=JSON)
