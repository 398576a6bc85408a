cycle
cyc:e
