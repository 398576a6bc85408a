"""The stages for one request, composed; and the files they need. Writes nothing."""
