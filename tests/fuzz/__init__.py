"""Coverage-guided fuzzing of the front end; run by hand, not part of the tests."""
