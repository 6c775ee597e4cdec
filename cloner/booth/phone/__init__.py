"""A page for visitors' telephones, served on the booth's own network only while the operator has it switched on."""
