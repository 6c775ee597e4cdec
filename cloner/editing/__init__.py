"""What an operator's corrections ask of a finished person, and how skin and pose obey."""
