"""Messages with joint states of a bag in SQLite, as ROS 2 wrote it until Humble."""

import sqlite3
from collections.abc import Iterator
from contextlib import closing

from vrts.validate.log.bags.faults import KIND, MOST_BYTES, MOST_MESSAGE, MOST_MESSAGES, BagFault

MAGIC = b"SQLite format 3\0"
WRITTEN_AS = "cdr"
STEPS = 200_000_000  # of SQLite's machine, after which a query is given up
QUERY = """
SELECT topics.name, messages.timestamp, messages.data FROM messages
JOIN topics ON topics.id = messages.topic_id
WHERE topics.type = ? AND topics.serialization_format = ? AND length(messages.data) <= ?
ORDER BY messages.timestamp, messages.id
"""


def sqlite_messages(data: bytes) -> Iterator[tuple[str, int, bytes]]:
    """Return topic, time of the log [ns] and bytes of each message with joint states, in order.

    Raises:
        BagFault: The file is damaged, or there is too much in it.
    """
    if len(data) > MOST_BYTES:
        raise BagFault(f"it has {len(data):,} bytes, more than {MOST_BYTES:,}")
    try:
        yield from _queried(data)
    except (sqlite3.Error, UnicodeDecodeError, OverflowError) as problem:
        raise BagFault(f"it is damaged: {' '.join(str(problem).split())[:80]}") from problem


def _queried(data: bytes) -> Iterator[tuple[str, int, bytes]]:
    with closing(sqlite3.connect(":memory:")) as bag:
        bag.deserialize(data)
        bag.execute("PRAGMA trusted_schema = OFF")  # views and triggers of a stranger do nothing
        bag.execute("PRAGMA query_only = ON")
        left = [STEPS]

        def give_up() -> int:
            left[0] -= 10_000
            return int(left[0] < 0)

        bag.set_progress_handler(give_up, 10_000)
        rows = bag.execute(QUERY, (KIND, WRITTEN_AS, MOST_MESSAGE))
        for count, (topic, time_ns, message) in enumerate(rows, 1):
            if count > MOST_MESSAGES:
                raise BagFault(f"it has more than {MOST_MESSAGES:,} messages")
            if not (isinstance(topic, str) and isinstance(time_ns, int)):
                raise BagFault("it is damaged: a topic or a time is none")
            if not isinstance(message, bytes):
                raise BagFault("it is damaged: a message is no bytes")
            yield topic, time_ns, message
