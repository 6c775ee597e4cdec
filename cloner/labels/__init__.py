"""Per-pixel labels of a photo: skin, hair, beard, clothes, shoes, glasses, background."""
