"""Several things that a connection waits for at once: the first that ends, ends the others."""

import asyncio
from collections.abc import Coroutine
from typing import Any, TypeVar

Why = TypeVar("Why")


async def first_ended(*parts: Coroutine[Any, Any, Why | None]) -> Why | None:
    """Return why the first part ended that says why; None: none does. No part goes on."""
    tasks = {asyncio.ensure_future(part) for part in parts}
    try:
        done, _ = await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
        return next((found for task in done if (found := task.result()) is not None), None)
    finally:
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
