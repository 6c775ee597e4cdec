"""The source's eight group behaviours, one module each; what each selects becomes orders, and feet obey them later."""
