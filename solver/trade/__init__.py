"""Speed against accuracy: measured, and the order that a tolerance or a budget comes to."""
