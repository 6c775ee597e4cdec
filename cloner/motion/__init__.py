"""Captures read and laid on clones, a walk and an idle of our own, feet that stay where they stand."""
