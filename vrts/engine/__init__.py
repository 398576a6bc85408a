"""IR, scene and scenario to a Run: memory, threads, scheduler, motion, timeline and grasp."""
