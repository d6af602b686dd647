"""What is measured of the paper's oscillator alone: digits, trade, printed equations."""
