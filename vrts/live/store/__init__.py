"""What the server keeps: one SQLite file, written by one thread."""
