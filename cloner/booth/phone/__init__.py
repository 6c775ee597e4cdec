"""A page for visitors' phones, served on the booth's own network only while the operator has switched it on."""
