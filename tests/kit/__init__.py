"""What tests share: known people, a camera to photograph them, and errors in mm."""
