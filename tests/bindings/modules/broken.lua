-- fails when it runs

error("broken on purpose")
