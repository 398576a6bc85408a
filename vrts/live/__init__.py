"""Shared sessions in the browser: the server, and a process for each session."""
