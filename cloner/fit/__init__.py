"""One fit for all: named unknowns with what is expected of them, evidence as rows, Gauss-Newton, uncertainty."""
