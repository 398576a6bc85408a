"""What a real robot did, beside what was simulated."""
