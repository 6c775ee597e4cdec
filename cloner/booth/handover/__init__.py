"""Delivery to visitors: files on USB sticks, an e-mail, a QR code."""
