"""What is done: decisions are written, submissions marked again."""

import asyncio
from typing import Annotated, Final, Literal, TypeVar

from msgspec import Meta, Struct
from starlette.requests import Request
from starlette.responses import Response

from vrts.desk.adding.asked import Body
from vrts.desk.again.marking import Marking
from vrts.desk.desk import Desk, Moved
from vrts.desk.front.answers import diagnosed, refusal, told
from vrts.desk.front.bodies import read_body
from vrts.desk.upkeep import Upkeep
from vrts.live.lasting.clock import steady
from vrts.live.limits import Bucket
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused

DEEDS: Final = (20.0, 200.0)  # a second, and at once

Asked = TypeVar("Asked")
Who = Annotated[str, Meta(max_length=200)]


class Wanted(Struct, frozen=True, forbid_unknown_fields=True):
    """What `POST /api/mark` takes."""

    students: Literal["all"] | Annotated[list[Who], Meta(min_length=1, max_length=10_000)]


class DeedPages:
    """The handlers."""

    def __init__(self, desk: Desk, marking: Marking, upkeep: Upkeep) -> None:
        """Serve a desk."""
        self._desk = desk
        self._marking = marking
        self._upkeep = upkeep
        self._bucket = Bucket(*DEEDS)

    async def records(self, request: Request) -> Response:
        """Write decisions: all of them, or none."""
        body = await self._body(request, Body)
        if isinstance(body, Response):
            return body

        def made() -> Response:
            try:
                return told(request, self._desk.add(body, self._upkeep.wanted))
            except Moved as problem:
                return refusal(409, str(problem), revision=self._desk.now().revision)
            except Refused as problem:
                return diagnosed(problem.diagnostics)
            except CannotRead as problem:
                return refusal(422, problem.message, diagnostics=[])
            except OSError as problem:
                reason = (problem.strerror or "it failed").lower()
                return refusal(507, f"nothing was decided, the folder cannot be written: {reason}")

        return await asyncio.to_thread(made)

    async def mark(self, request: Request) -> Response:
        """Begin to mark again."""
        body = await self._body(request, Wanted)
        if isinstance(body, Response):
            return body
        students = None if body.students == "all" else list(dict.fromkeys(body.students))

        def made() -> Response:
            book = self._desk.now().book
            unknown = [name for name in students or () if name not in book.by_id]
            if unknown:
                return refusal(404, f"there is no student `{unknown[0][:80]}` in this class")
            try:
                if not self._marking.begin(book.opened, students):
                    return refusal(409, "a marking goes on already: wait until it has ended")
            except Refused as problem:
                return diagnosed(problem.diagnostics)
            except OSError as problem:
                return refusal(507, f"cannot mark: {(problem.strerror or 'it failed').lower()}")
            return told(request, self._marking.told(book.opened), 202)

        return await asyncio.to_thread(made)

    async def cancel(self, request: Request) -> Response:
        """End marking again; what is marked is kept."""
        if not self._marking.cancel():
            return refusal(409, "this desk is not marking")
        book = (await asyncio.to_thread(self._desk.now)).book
        return told(request, self._marking.told(book.opened), 202)

    async def _body(self, request: Request, kind: type[Asked]) -> Asked | Response:
        if not self._bucket.take(steady()):
            return refusal(429, "too many requests: wait a moment")
        return await read_body(request, kind)
