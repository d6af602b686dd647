"""Bodies from event to event: forms along a phase, their first zero, states and switches."""
