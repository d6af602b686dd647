"""The C1 series: evaluation, batches over alpha, all real solutions."""
