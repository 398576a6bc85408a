"""One student in markings: handed out whole; forgotten, while all others keep what they have."""
