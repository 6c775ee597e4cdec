"""The event: settings, consent, trash, the operator's number, and the numbers of a day."""
