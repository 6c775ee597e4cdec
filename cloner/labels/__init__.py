"""What each pixel of a photo shows: skin, hair, beard, clothes, shoes, glasses, background."""
