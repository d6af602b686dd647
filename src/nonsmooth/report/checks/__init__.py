"""What each claim of the paper is held against: numbers, each with what it decides."""
