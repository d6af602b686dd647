"""Speed against accuracy: measurements, and the choice of an order by tolerance or budget."""
