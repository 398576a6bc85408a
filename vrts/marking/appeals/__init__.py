"""What a mark rests on, marking again, and who moves when a task is repaired."""
