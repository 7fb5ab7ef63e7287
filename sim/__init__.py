"""The world: a MuJoCo car with cameras on procedurally generated streets. Truth lives here."""
