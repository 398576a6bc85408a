"""Conversation with a controller: what is sent, read back, fetched and compared."""
