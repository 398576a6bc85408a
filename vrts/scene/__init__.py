"""What stands in the workspace, where a run starts from, and what may happen to it."""
