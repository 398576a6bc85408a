"""Bodies of requests, read without trust."""

import asyncio
from typing import Final, TypeVar

import msgspec
from starlette.requests import ClientDisconnect, Request
from starlette.responses import Response

from vrts.desk.front.answers import refusal
from vrts.live.front.bodies import JSON

LONGEST: Final = 1_000_000  # bytes
WAIT_S: Final = 20.0  # until a body must have come

Body = TypeVar("Body")


async def read_body(request: Request, kind: type[Body]) -> Body | Response:
    """Return the JSON body of a request, or why it is refused."""
    if request.headers.get("content-type", "").split(";")[0].strip() != JSON:
        return refusal(415, f"the body must be {JSON}")
    data = bytearray()
    try:
        async with asyncio.timeout(WAIT_S):
            async for part in request.stream():
                data += part
                if len(data) > LONGEST:
                    return refusal(413, f"a request has at most {LONGEST:,} bytes")
    except TimeoutError:
        return refusal(408, "the request did not come in time")
    except ClientDisconnect:
        return Response(status_code=400)  # nobody is there to read it
    try:
        return msgspec.json.decode(data, type=kind)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as problem:
        return refusal(422, f"this is no such request: {str(problem)[:200]}", diagnostics=[])
