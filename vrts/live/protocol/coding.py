"""Messages to JSON and back."""

import msgspec

from vrts.live.protocol.from_clients import FromClient

encode = msgspec.json.Encoder().encode
decode = msgspec.json.Decoder(FromClient).decode
