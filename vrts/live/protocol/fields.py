"""What fields of messages may hold."""

from typing import Annotated, Literal

from msgspec import Meta

VERSION = 1
LONGEST_MESSAGE = 256 * 1024  # bytes; of a text frame from a client
LONGEST_CHAT = 1000  # characters
LONGEST_NOTE = 200  # characters

Id = Annotated[str, Meta(max_length=64)]
Text = Annotated[str, Meta(max_length=LONGEST_CHAT)]
Count = Annotated[int, Meta(ge=0, le=2**53)]
Rate = Annotated[int, Meta(ge=1, le=60)]
Of = Annotated[int, Meta(ge=0, le=2**31)]  # the sender's own number, named in the answer
Role = Literal["viewer", "operator", "supervisor"]
