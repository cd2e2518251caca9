"""What a command returns to the shell."""

HOLDS, FAILS, REFUSED, INTERRUPTED = 0, 1, 2, 130
