"""Machines, ours and others: what is lacking, processes, a cluster and its certificates."""
