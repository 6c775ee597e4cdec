"""Machines: requirements, worker processes, a cluster and its certificates."""
