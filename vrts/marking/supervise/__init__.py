"""One process for each submission, with limits, so that none can cost the others their marks."""
