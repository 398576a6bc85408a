"""Messages with joint states of an MCAP file [https://mcap.dev/spec]."""

import struct
from collections.abc import Iterator
from io import BytesIO

import lz4.frame
import zstandard
from mcap.exceptions import McapError
from mcap.records import Channel, Chunk, McapRecord, Message, Schema
from mcap.stream_reader import StreamReader, breakup_chunk

from vrts.validate.log.bags.faults import (
    KIND,
    MOST_BYTES,
    MOST_CHUNK,
    MOST_MESSAGES,
    MOST_UNPACKED,
    BagFault,
)

MAGIC = b"\x89MCAP0\r\n"
WRITTEN_AS = "cdr"
DAMAGED = (McapError, struct.error, ValueError, EOFError, IndexError, OverflowError)


def mcap_messages(data: bytes) -> Iterator[tuple[str, int, bytes]]:
    """Return topic, time of the log [ns] and bytes of each message with joint states, as they lie.

    Raises:
        BagFault: The file is damaged, or there is too much in it.
    """
    if len(data) > MOST_BYTES:
        raise BagFault(f"it has {len(data):,} bytes, more than {MOST_BYTES:,}")
    schemas: set[int] = set()
    topics: dict[int, str] = {}
    count = 0
    for record in _records(data):
        match record:
            case Schema(id=number, name=name) if name == KIND:
                schemas.add(number)
            case Channel(id=number, schema_id=kind, message_encoding=form, topic=topic):
                if kind in schemas and form == WRITTEN_AS:
                    topics[number] = topic
            case Message(channel_id=channel, log_time=time_ns, data=message) if channel in topics:
                count += 1
                if count > MOST_MESSAGES:
                    raise BagFault(f"it has more than {MOST_MESSAGES:,} messages")
                yield topics[channel], time_ns, message
            case _:
                pass


def _records(data: bytes) -> Iterator[McapRecord]:
    """Return the records of a file, those in chunks too."""
    unpacked = 0
    try:
        stream = StreamReader(BytesIO(data), emit_chunks=True, record_size_limit=len(data))
        for record in stream.records:
            if not isinstance(record, Chunk):
                yield record
                continue
            inside = _unpacked(record)
            unpacked += len(inside)
            if unpacked > MOST_UNPACKED:
                raise BagFault(f"it unpacks to more than {MOST_UNPACKED:,} bytes")
            record.compression, record.data = "", inside
            yield from breakup_chunk(record)
    except DAMAGED as problem:
        raise BagFault(f"it is damaged: {_words(problem)}") from problem


def _unpacked(chunk: Chunk) -> bytes:
    """Return what is in a chunk, unpacked no further than is allowed."""
    try:
        match chunk.compression:
            case "":
                found = chunk.data
            case "zstd":
                with zstandard.ZstdDecompressor().stream_reader(BytesIO(chunk.data)) as stream:
                    found = stream.read(MOST_CHUNK + 1)
            case "lz4":
                found = lz4.frame.LZ4FrameDecompressor().decompress(chunk.data, MOST_CHUNK + 1)
            case other:
                raise BagFault(f"it is packed as `{other[:20]}`; zstd and lz4 are read")
    except (zstandard.ZstdError, RuntimeError) as problem:
        raise BagFault("it is damaged: a chunk cannot be unpacked") from problem
    if len(found) > MOST_CHUNK:
        raise BagFault(f"a chunk of it unpacks to more than {MOST_CHUNK:,} bytes")
    if len(found) != chunk.uncompressed_size:
        raise BagFault("it is damaged: a chunk has another size than it says")
    return found


def _words(problem: Exception) -> str:
    return " ".join(str(problem).split())[:80] or "it ends too early"
