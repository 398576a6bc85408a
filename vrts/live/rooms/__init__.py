"""Rooms and the people in them: who may command, and what becomes of a command.

In: messages that were let in. Out: orders to sessions, messages to everybody.
Knows neither HTTP nor sockets.
"""
