"""Details that photos show badly: eyes, hands, ears, lids, nostrils, glasses, collars."""
