"""One session: a controller whose run grows with the clock, in a process of its own."""
