"""What visitors take home: files on sticks, an e-mail, a code to scan."""
