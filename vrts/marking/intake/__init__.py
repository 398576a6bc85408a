"""From the download of a class to one row for each student: who, which file, why, what is wrong."""
